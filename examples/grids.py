"""Uniform tetrahedral meshes of boxes. numpy only."""
import itertools

import gmf
import numpy as np

FACES = [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)]


def cube(cells, low, high):
    """The cube [low, high]^3 in cells^3 boxes."""
    return box((cells,) * 3, (low,) * 3, (high,) * 3)


def box(cells, low, high):
    """What lies between two corners, in cells[0] x cells[1] x cells[2] boxes of six tetrahedra each.

    The sides have the references 1 to 6.
    """
    ticks = [np.linspace(*ends, count + 1) for *ends, count in zip(low, high, cells)]
    points = np.stack(np.meshgrid(*ticks, indexing="ij"), axis=-1).reshape(-1, 3)
    mesh = gmf.Mesh(points, _tetrahedra(cells))
    faces = np.concatenate([mesh.tetrahedra[:, face] for face in FACES])
    sides = [np.all(points[faces][:, :, axis] == end[axis], axis=1) for axis in range(3) for end in (low, high)]
    mesh.triangles = np.concatenate([faces[side] for side in sides])
    mesh.triangle_refs = np.repeat(np.arange(1, 7), [side.sum() for side in sides])
    return mesh


def _tetrahedra(cells):
    ids = np.arange(np.prod(np.add(cells, 1))).reshape(np.add(cells, 1))
    corner = lambda offset: ids[tuple(slice(o, count + o) for o, count in zip(offset, cells))].ravel()
    tetrahedra = []
    for walk in itertools.permutations(np.eye(3, dtype=int)):  # from the lowest corner of a box to its highest
        path = np.cumsum([np.zeros(3, int), *walk], axis=0)
        if np.linalg.det(walk) < 0:
            path = path[[0, 2, 1, 3]]
        tetrahedra.append(np.stack([corner(offset) for offset in path], axis=1))
    return np.concatenate(tetrahedra)
