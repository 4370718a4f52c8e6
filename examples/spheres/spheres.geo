// Two spheres in a box: both start above the layer z = -4 and can travel down through it, one past the other.
//
// References: surfaces 1 walls, 2 large sphere (radius .5, centre (0, 0, 0)), 3 small sphere (radius .3, centre
// (0, 4, 0)); volume 10. Units are arbitrary.
// The spheres are fine already, since curved surfaces stay as they are; `taut adapt` adapts the walls, which are planar.
//
// gmsh -3 -o spheres.mesh spheres.geo, with -setnumber size 0.5 for smaller tetrahedra away from the spheres.
SetFactory("OpenCASCADE");

DefineConstant[ size = {1, Name "Size at the walls"} ];
large = 0.5; small = 0.3; // radii

Box(1) = {-2, -2, -10, 4, 8, 11.5};
Sphere(2) = {0, 0, 0, large};
Sphere(3) = {0, 4, 0, small};
BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{2:3}; Delete; };

e = 0.01;
s2() = Surface In BoundingBox {-large - e, -large - e, -large - e, large + e, large + e, large + e};
s3() = Surface In BoundingBox {-small - e, 4 - small - e, -small - e, small + e, 4 + small + e, small + e};
walls() = Boundary{ Volume{4}; };
walls() -= {s2(), s3()};
Physical Surface(1) = {walls()};
Physical Surface(2) = {s2()};
Physical Surface(3) = {s3()};
Physical Volume(10) = {4};

// Fine on the spheres, growing with the distance from their centres.
Field[1] = MathEval;
Field[1].F = Sprintf("0.12 + 0.3*(sqrt(x^2 + y^2 + z^2) - %g)", large);
Field[2] = MathEval;
Field[2].F = Sprintf("0.08 + 0.3*(sqrt(x^2 + (y - 4)^2 + z^2) - %g)", small);
Field[3] = MathEval;
Field[3].F = Sprintf("%g", size);
Field[4] = Min;
Field[4].FieldsList = {1, 2, 3};
Background Field = 4;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.SaveElementTagType = 2; // physical groups become references
