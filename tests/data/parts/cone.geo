// A cone, whose tip is on no ridge.
SetFactory("OpenCASCADE");
Cone(1) = {0, 0, 0, 0, 0, 1.5, .8, 0};
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.18;
