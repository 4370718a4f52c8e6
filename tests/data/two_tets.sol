# A metric on the five points of two_tets.mesh: xx, xy, yy, xz, yz, zz.
MeshVersionFormatted 2
Dimension 3
SolAtVertices
5
1 3
1 0.5 2 0 0 3
4 0 5 0.25 0 6
7 0 8 0 0.125 9
1 0 1 0 0 1
1e6 0 1 0 0 1e-3
End
