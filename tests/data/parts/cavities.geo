// A block with a notch and a hollow corner; half a ball of another region ends at its face x = 1.2.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1.2, .8, .8};
Box(2) = {0, 0, .6, .5, .3, .2};
BooleanDifference(3) = { Volume{1}; Delete; } { Volume{2}; Delete; };
Sphere(4) = {0, .8, 0, .35};
BooleanDifference(6) = { Volume{3}; Delete; } { Volume{4}; Delete; };
Sphere(7) = {1.2, .4, .4, .3};
BooleanIntersection(8) = { Volume{7}; Delete; } { Volume{6};};
BooleanFragments{ Volume{6}; Delete; } { Volume{8}; Delete; }
Mesh.MeshSizeFromCurvature = 12;
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.3;
