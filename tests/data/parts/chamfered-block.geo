// A block with two chamfered edges: planar faces only.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 1, 1};
c() = Boundary{ Surface{6};};
Chamfer{1} {8, 4} {6, 6} {.2, .3}
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.36;
