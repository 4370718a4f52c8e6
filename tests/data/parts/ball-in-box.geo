// A ball of one region in a box of another.
SetFactory("OpenCASCADE");
Box(1) = {-1, -1, -1, 2, 2, 2};
Sphere(2) = {.1, 0, 0, .5};
BooleanFragments{ Volume{1}; Delete; } { Volume{2}; Delete; }
Mesh.MeshSizeFromCurvature = 12;
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.5;
