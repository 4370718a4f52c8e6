// A cube within a sphere, with three holes: the faces around the holes are 0.05 wide.
SetFactory("OpenCASCADE");
Box(1) = {-1, -1, -1, 2, 2, 2};
Sphere(2) = {0, 0, 0, 1.25};
BooleanIntersection(3) = { Volume{1}; Delete; } { Volume{2}; Delete; };
Cylinder(4) = {-2, 0, 0, 4, 0, 0, .7};
Cylinder(5) = {0, -2, 0, 0, 4, 0, .7};
Cylinder(6) = {0, 0, -2, 0, 0, 4, .7};
BooleanUnion(7) = { Volume{4}; Delete; } { Volume{5, 6}; Delete; };
BooleanDifference(8) = { Volume{3}; Delete; } { Volume{7}; Delete; };
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.34;
