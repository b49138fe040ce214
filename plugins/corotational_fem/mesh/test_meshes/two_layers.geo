// A block of two layers, in millimetres. Written in every form that is read:
// gmsh two_layers.geo -3 -format msh22 [-bin] -o two_layers_22[_binary].msh, and with msh41.
SetFactory("OpenCASCADE");
Box(1) = {-20, -15, -8, 40, 30, 8};
Box(2) = {-20, -15, -24, 40, 30, 16};
Coherence;
Mesh.MeshSizeMin = 9;
Mesh.MeshSizeMax = 9;
Physical Volume("skin") = {1};
Physical Volume("muscle") = {2};
Physical Surface("lid") = Surface In BoundingBox {-21, -16, -0.1, 21, 16, 0.1};
