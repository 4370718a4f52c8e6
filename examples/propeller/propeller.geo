// A rotor in a sphere of fluid: three twisted blades on a hub, which can turn about the z axis.
//
// References: surfaces 1 outer sphere, 2 rotor (hub and blades); volume 10. Unit: the radius of the rotor is 1.
//
// gmsh -3 -o propeller.mesh propeller.geo gives about 50,000 tetrahedra; with -setnumber size 0.52, about 300,000.
SetFactory("OpenCASCADE");

DefineConstant[ size = {1, Name "Factor of all sizes"} ];
blades = 3;
hub = 0.2; hub_half = 0.25;       // radius and half of the length of the hub
root = 0.12; tip = 1;             // the blade begins inside the hub
chord = 0.36; thick = 0.07;       // at the root; the tip has the share `taper` of both
taper = 0.5;
pitch_root = 50*Pi/180; pitch_tip = 18*Pi/180; // angle between the chord and the plane of rotation
outer = 2;

// Sections of a blade across the x axis: two curves from its leading to its trailing edge, which are sharp.
sections = 5;
loops() = {};
curves() = {};
For i In {0:sections - 1}
  s = i/(sections - 1);
  x = root + (tip - root)*s;
  scale = 1 - (1 - taper)*s;
  pitch = pitch_root + (pitch_tip - pitch_root)*s;
  half = scale*chord/2; above = 0.8*scale*thick; below = -0.2*scale*thick;
  p = newp;
  Point(p) = {x, half*Cos(pitch), half*Sin(pitch)};
  Point(p + 1) = {x, -above*Sin(pitch), above*Cos(pitch)};
  Point(p + 2) = {x, -half*Cos(pitch), -half*Sin(pitch)};
  Point(p + 3) = {x, -below*Sin(pitch), below*Cos(pitch)};
  c = newl;
  Spline(c) = {p, p + 1, p + 2};
  Spline(c + 1) = {p + 2, p + 3, p};
  l = newll;
  Curve Loop(l) = {c, c + 1};
  loops() += l;
  curves() += {c, c + 1};
EndFor
ThruSections(1) = {loops()};
For b In {1:blades - 1}
  copy() = Rotate{{0, 0, 1}, {0, 0, 0}, 2*Pi*b/blades}{ Duplicata{ Volume{1}; } };
EndFor
v = newv;
Cylinder(v) = {0, 0, -hub_half, 0, 0, 2*hub_half, hub};
Recursive Delete{ Curve{curves()}; }
rotor() = BooleanUnion{ Volume{v}; Delete; }{ Volume{1:blades}; Delete; };
v = newv;
Sphere(v) = {0, 0, 0, outer};
fluid() = BooleanDifference{ Volume{v}; Delete; }{ Volume{rotor()}; Delete; };

e = 0.01;
outside() = Surface In BoundingBox {-outer - e, -outer - e, -outer - e, outer + e, outer + e, outer + e};
inside() = Surface In BoundingBox {-1.5, -1.5, -1.5, 1.5, 1.5, 1.5};
outside() -= {inside()};
Physical Surface(1) = {outside()};
Physical Surface(2) = {inside()};
Physical Volume(10) = {fluid()};

// Fine on the rotor, growing to the outer sphere.
Field[1] = Distance;
Field[1].SurfacesList = {inside()};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = 0.03*size; Field[2].SizeMax = 0.3*size;
Field[2].DistMin = 0; Field[2].DistMax = 1;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.SaveElementTagType = 2; // physical groups become references
