// A smooth surface without ridges.
SetFactory("OpenCASCADE");
Torus(1) = {0, 0, 0, 1, .35};
Mesh.MeshSizeFromCurvature = 10;
Mesh.SaveAll = 1;
Mesh.MeshSizeMax = 0.23;
