// A cube with a line and a square inside, which part nothing.
h = .2;
Point(1) = {0, 0, 0, h}; Point(2) = {1, 0, 0, h}; Point(3) = {1, 1, 0, h}; Point(4) = {0, 1, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Extrude{0, 0, 1} { Surface{1};}
Point(50) = {.3, .3, .3, h}; Point(51) = {.7, .4, .6, h};
Line(60) = {50, 51};
Curve{60} In Volume{1};
Point(70) = {.2, .6, .5, h}; Point(71) = {.8, .6, .5, h}; Point(72) = {.8, .9, .5, h}; Point(73) = {.2, .9, .5, h};
Line(71) = {70, 71}; Line(72) = {71, 72}; Line(73) = {72, 73}; Line(74) = {73, 70};
Curve Loop(70) = {71:74};
Plane Surface(70) = {70};
Surface{70} In Volume{1};
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.22;
