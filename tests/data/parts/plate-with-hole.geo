// A plate, 0.1 thick.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 4, 3, .1};
Cylinder(2) = {2, 1.5, -1, 0, 0, 3, .6};
BooleanDifference(3) = { Volume{1}; Delete; } { Volume{2}; Delete; };
Mesh.MeshSizeFromCurvature = 12;
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.45;
