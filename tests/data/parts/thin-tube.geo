// A tube with a wall 0.03 thick.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, .6, .5};
Cylinder(2) = {0, 0, 0, 0, 0, .6, .47};
BooleanDifference(3) = { Volume{1}; Delete; } { Volume{2}; Delete; };
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.14;
