"""Analytic metric fields: arrays of tensors, shape (n, 3, 3), at points of shape (n, 3)."""
import numpy as np


def of_sizes(*sizes):
    """The metric of these sizes along the axes; each is a number or an array of n."""
    metric = np.zeros((max(np.size(h) for h in sizes), 3, 3))
    for axis, size in enumerate(sizes):
        metric[:, axis, axis] = np.asarray(size, float) ** -2
    return metric


def shock(points, divisor=1):
    """A planar shock at x = 0.5 in [-1, 1]^3 (Dobrzynski and Frey 2008, 5.1), all sizes divided by `divisor`."""
    hmax = 0.2
    h1 = hmax * np.abs(1 - np.exp(-np.abs(points[:, 0] - 0.5))) + 0.003
    return of_sizes(h1 / divisor, hmax / divisor, hmax / divisor)


def linear(points, divisor=1):
    """Size growing linearly from z = 0.5 in [0, 1]^3 (Unstructured Grid Adaptation Working Group, cube-linear)."""
    h3 = 0.001 + 2 * 0.099 * np.abs(points[:, 2] - 0.5)
    return of_sizes(0.1 / divisor, 0.1 / divisor, h3 / divisor)
