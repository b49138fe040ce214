// A ball of something hard in a block, in millimetres: gmsh stiff_ball.geo -3 -format msh41 -o stiff_ball.msh
SetFactory("OpenCASCADE");
Box(1) = {-15, -15, -30, 30, 30, 30};
Sphere(2) = {2, 1, -12, 5};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Mesh.MeshSizeMin = 5;
Mesh.MeshSizeMax = 10;
Physical Volume("tumour") = {2};
Physical Volume("gel") = {3};
