// A quarter of a pipe's bend, with a wall 0.08 thick.
SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, .3};
Disk(2) = {0, 0, 0, .22};
BooleanDifference(3) = { Surface{1}; Delete; } { Surface{2}; Delete; };
Extrude{{0, 1, 0}, {1, 0, 0}, Pi/2} { Surface{3};}
Mesh.MeshSizeFromCurvature = 12;
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.19;
