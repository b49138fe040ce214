// A block with a corner cut off, in metres, its region without a name: gmsh l_shape.geo -3 -format msh22 -o l_shape.msh
SetFactory("OpenCASCADE");
Box(1) = {-0.02, -0.01, -0.04, 0.04, 0.02, 0.04};
Box(2) = {0, -0.01, -0.02, 0.02, 0.02, 0.02};
BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Mesh.MeshSizeMin = 0.007;
Mesh.MeshSizeMax = 0.007;
