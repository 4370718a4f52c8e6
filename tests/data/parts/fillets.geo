// A cube with fillets on all edges: faces meet smoothly and differ by reference.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Fillet{1} {1:12} {.3}
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.17;
