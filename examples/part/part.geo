// A bearing bracket in millimetres: a base plate with four bolt holes, a bored boss with a rounded foot, two ribs.
SetFactory("OpenCASCADE");

length = 90; width = 56; plate = 9;
boss = 19; height = 34; bore = 11; // outer radius, height over the floor, inner radius
bolt = 4.2; inset = 10;            // radius, distance of the axis from the plate's sides
e = 0.01;

Box(1) = {-length/2, -width/2, 0, length, width, plate};
corners() = {};
For sx In {-1:1:2}
  For sy In {-1:1:2}
    x = sx*length/2; y = sy*width/2;
    corners() += Curve In BoundingBox {x - e, y - e, -e, x + e, y + e, plate + e};
  EndFor
EndFor
Fillet{1}{corners()}{inset - 1}

Cylinder(2) = {0, 0, 0, 0, 0, height, boss};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
foot() = Curve In BoundingBox {-boss - e, -boss - e, plate - e, boss + e, boss + e, plate + e};
rounded() = Fillet{3}{foot()}{4};

Box(4) = {-length/2 + 18, -3.5, plate - 1, length - 36, 7, 13};
BooleanUnion(5) = { Volume{rounded()}; Delete; }{ Volume{4}; Delete; };

Cylinder(10) = {0, 0, -1, 0, 0, height + 2, bore};
Cylinder(11) = {0, 0, height - 5, 0, 0, 6, bore + 3};
n = 12;
For sx In {-1:1:2}
  For sy In {-1:1:2}
    Cylinder(n) = {sx*(length/2 - inset), sy*(width/2 - inset), -1, 0, 0, plate + 2, bolt};
    n++;
  EndFor
EndFor
BooleanDifference(6) = { Volume{5}; Delete; }{ Volume{10:n - 1}; Delete; };

Mesh.MeshSizeMin = 2;
Mesh.MeshSizeMax = 2;
