"""The exact surface of example 5.2 of Dobrzynski and Frey 2008: r = 0.45 + 0.3 sin(3 phi), phi the latitude. numpy only.

It is a surface of revolution around z, so distances reduce to its meridian, a curve in the half plane (s, z), s >= 0 the
distance from the axis: s = r cos(phi), z = r sin(phi), phi in [-pi/2, pi/2].
"""
import sys

import numpy as np

import gmf

POLES = (-np.pi / 2, np.pi / 2)


def radius(phi):
    return 0.45 + 0.3 * np.sin(3 * phi)


def latitude(points):
    return np.arctan2(points[:, 2], np.hypot(points[:, 0], points[:, 1]))


def level(points):
    """The level-set function: |x| - r(phi(x)), negative inside."""
    return np.linalg.norm(points, axis=1) - radius(latitude(points))


def meridian(phi):
    """Points (s, z) of the meridian and their first two derivatives by phi."""
    r, dr, ddr = radius(phi), 0.9 * np.cos(3 * phi), -2.7 * np.sin(3 * phi)
    c, s = np.cos(phi), np.sin(phi)
    at = np.stack([r * c, r * s], axis=-1)
    first = np.stack([dr * c - r * s, dr * s + r * c], axis=-1)
    second = np.stack([(ddr - r) * c - 2 * dr * s, (ddr - r) * s + 2 * dr * c], axis=-1)
    return at, first, second


def distance(points, nodes=1024, chunk=4096, candidates=4):
    """The distance of each point to the surface, to rounding.

    Newton's method starts at the nearest of many nodes of the meridian and ends inside the interval between its neighbours.
    The closest point may lie near another node that is hardly farther, so the nearest few local minima are all tried.
    """
    flat = np.stack([np.hypot(points[:, 0], points[:, 1]), points[:, 2]], axis=1)
    phi = np.linspace(*POLES, nodes)
    curve = meridian(phi)[0]
    return np.concatenate([_distance(flat[i:i + chunk], phi, curve, candidates) for i in range(0, len(flat), chunk)]
                          or [np.empty(0)])


def _distance(flat, phi, curve, candidates):
    squares = ((flat[:, None] - curve) ** 2).sum(axis=2)
    padded = np.pad(squares, ((0, 0), (1, 1)), constant_values=np.inf)
    is_minimum = (squares <= padded[:, :-2]) & (squares <= padded[:, 2:])
    minima = np.where(is_minimum, squares, np.inf)
    starts = np.argpartition(minima, candidates, axis=1)[:, :candidates]
    step = phi[1] - phi[0]
    best = np.full(len(flat), np.inf)
    for start in starts.T:
        low, high = np.maximum(phi[start] - step, POLES[0]), np.minimum(phi[start] + step, POLES[1])
        best = np.minimum(best, _newton(flat, phi[start], low, high))
    return best


def _newton(flat, t, low, high):
    for _ in range(12):
        at, first, second = meridian(t)
        away = at - flat
        slope = (away * first).sum(axis=1)
        curvature = (away * second).sum(axis=1) + (first * first).sum(axis=1)
        t = np.clip(t - slope / np.where(curvature > 0, curvature, (first * first).sum(axis=1)), low, high)
    return np.linalg.norm(meridian(t)[0] - flat, axis=1)


def triangulated(tolerance=2e-6):
    """A closed triangulation with its vertices on the surface, outward, no farther from it than about `tolerance`.

    Rings of vertices around the axis, one for each of some latitudes, and a vertex at each pole. The sag of the meridian
    sets the distance of rings, the sag of the circles their numbers of vertices.
    """
    rows = _rows(tolerance)
    at, _, _ = meridian(rows)
    counts = [1 if k in (0, len(rows) - 1) else _around(at[k, 0], tolerance) for k in range(len(rows))]
    points = [_ring(s, z, n) for (s, z), n in zip(at, counts)]
    starts = np.concatenate([[0], np.cumsum(counts)])
    bands = [_band(starts[k], counts[k], starts[k + 1], counts[k + 1]) for k in range(len(rows) - 1)]
    return gmf.Mesh(np.concatenate(points), np.empty((0, 4), np.int64), np.concatenate(bands))


def _rows(tolerance):
    """Latitudes between which the sag of the meridian is a quarter of the tolerance."""
    phi = np.linspace(*POLES, 200001)
    _, first, second = meridian(phi)
    speed = np.linalg.norm(first, axis=1)
    curvature = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / speed ** 3
    longest = np.sqrt(8 * tolerance / 4 / np.maximum(curvature, 1))
    number = np.concatenate([[0], np.cumsum(np.diff(phi) * (speed / longest)[1:])])
    return np.interp(np.linspace(0, number[-1], int(np.ceil(number[-1])) + 1), number, phi)


def _around(s, tolerance):
    """The number of vertices on a circle of radius s with a sag of half of the tolerance."""
    return max(8, int(np.ceil(np.pi / np.sqrt(tolerance / max(s, tolerance)))))


def _ring(s, z, n):
    theta = 2 * np.pi * np.arange(n) / n
    radius_here = s if n > 1 else 0.0
    return np.stack([radius_here * np.cos(theta), radius_here * np.sin(theta), np.full(n, z)], axis=1)


def _band(below, m, above, n):
    """The triangles between two rings of m and n vertices: the ring whose next vertex comes first moves on."""
    if m == 1 or n == 1:
        return _fan(below, m, above, n)
    keys = np.concatenate([(np.arange(m) + 0.5) / m, (np.arange(n) + 0.5) / n])
    is_above = np.concatenate([np.zeros(m, bool), np.ones(n, bool)])[np.argsort(keys, kind="stable")]
    j = np.cumsum(is_above) - is_above
    i = np.cumsum(~is_above) - ~is_above
    a, b = below + i % m, above + j % n
    third = np.where(is_above, above + (j + 1) % n, below + (i + 1) % m)
    return np.stack([a, third, b], axis=1)


def _fan(below, m, above, n):
    k = np.arange(max(m, n))
    following = (k + 1) % len(k)
    if m == 1:
        return np.stack([np.full_like(k, below), above + following, above + k], axis=1)
    return np.stack([below + k, below + following, np.full_like(k, above)], axis=1)


def main():
    """usage: true_surface.py OUT.meshb [TOLERANCE]"""
    mesh = triangulated(float(sys.argv[2]) if len(sys.argv) > 2 else 2e-6)
    gmf.write_mesh(sys.argv[1], mesh)
    print(f"{sys.argv[1]}: {len(mesh.points):,} points, {len(mesh.triangles):,} triangles")


if __name__ == "__main__":
    main()
