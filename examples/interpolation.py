"""The error of the piecewise linear interpolant of a known function. numpy only."""
from dataclasses import dataclass

import measures
import numpy as np

_BATCH = 2048  # tetrahedra whose points fit into the cache


@dataclass
class Errors:
    """Norms of the error; add those of the parts of a domain to have those of the whole."""
    l1: float = 0.0
    l2: float = 0.0
    worst: float = 0.0

    def __add__(self, other):
        return Errors(self.l1 + other.l1, np.hypot(self.l2, other.l2), max(self.worst, other.worst))


def rule(order):
    """Barycentric coordinates and weights of points in a tetrahedron: order^3 Gauss points of a cube, folded, exact to degree
    2 order - 3; and the middles of the edges, where an error is often largest, with weight 0."""
    ticks, weights = np.polynomial.legendre.leggauss(order)
    u, v, w = (x.ravel() for x in np.meshgrid(*[(ticks + 1) / 2] * 3, indexing="ij"))
    inside = np.stack([u, (1 - u) * v, (1 - u) * (1 - v) * w, (1 - u) * (1 - v) * (1 - w)], axis=1)
    weight = np.einsum("i,j,k->ijk", *[weights / 2] * 3).ravel() * 6 * (1 - u) ** 2 * (1 - v)
    middles = np.array([(np.eye(4)[i] + np.eye(4)[j]) / 2 for i, j in measures.EDGES])
    return np.concatenate([inside, middles]), np.concatenate([weight, np.zeros(len(middles))])


def errors(mesh, function, order=4):
    """Of the interpolant of function(points) at the vertices, by order^3 points in each tetrahedron."""
    places, weights = rule(order)
    values, volumes = function(mesh.points), measures.volumes(mesh)
    total = Errors()
    for begin in range(0, len(mesh.tetrahedra), _BATCH):
        corners = mesh.tetrahedra[begin:begin + _BATCH]
        error = np.abs(function(places @ mesh.points[corners]) - values[corners] @ places.T)
        volume = volumes[begin:begin + _BATCH]
        total += Errors(volume @ (error @ weights), np.sqrt(volume @ (error ** 2 @ weights)), error.max())
    return total
