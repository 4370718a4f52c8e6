// Two spheres in a box, one above the other, whose poles face each other.
//
// References: surfaces 1 walls, 2 lower sphere (radius .5, centre (0, 0, -1.1)), 3 upper sphere (radius .4, centre
// (0, 0, 0.8)); volume 10. Units are arbitrary.
// Spheres have a vertex at each pole, so the gap between their triangles is that between the true spheres.
//
// gmsh -3 -o pinch.mesh pinch.geo
SetFactory("OpenCASCADE");

edge = 0.1;  // of the triangles of the spheres
lower = 0.5; upper = 0.4;  // radii

Box(1) = {-1.2, -1.2, -2.2, 2.4, 2.4, 4};
Sphere(2) = {0, 0, -1.1, lower};
Sphere(3) = {0, 0, 0.8, upper};
BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{2:3}; Delete; };

e = 0.01;
s2() = Surface In BoundingBox {-lower - e, -lower - e, -1.1 - lower - e, lower + e, lower + e, -1.1 + lower + e};
s3() = Surface In BoundingBox {-upper - e, -upper - e, 0.8 - upper - e, upper + e, upper + e, 0.8 + upper + e};
walls() = Boundary{ Volume{4}; };
walls() -= {s2(), s3()};
Physical Surface(1) = {walls()};
Physical Surface(2) = {s2()};
Physical Surface(3) = {s3()};
Physical Volume(10) = {4};

// Fine on the spheres, growing with the distance from their centres.
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.3*(sqrt(x^2 + y^2 + (z + 1.1)^2) - %g)", edge, lower);
Field[2] = MathEval;
Field[2].F = Sprintf("%g + 0.3*(sqrt(x^2 + y^2 + (z - 0.8)^2) - %g)", edge, upper);
Field[3] = Min;
Field[3].FieldsList = {1, 2};
Background Field = 3;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.SaveElementTagType = 2; // physical groups become references
