"""Lengths and qualities in a metric, for the pictures (Dobrzynski and Frey 2008, 2.2 and 2.3). numpy only."""
import numpy as np

EDGES = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]


def tensors(metric):
    """Tensors, shape (n, 3, 3), of a metric that is given as tensors or as sizes, shape (n,)."""
    return metric if metric.ndim == 3 else np.eye(3) / metric[:, None, None] ** 2


def edge_lengths(mesh, metric):
    """Length of each edge: the logarithmic mean of its lengths in the metrics of its end points."""
    pairs = np.unique(np.sort(np.concatenate([mesh.tetrahedra[:, e] for e in EDGES]), axis=1), axis=0)
    metric = tensors(metric)
    vectors = mesh.points[pairs[:, 1]] - mesh.points[pairs[:, 0]]
    a, b = (np.sqrt(np.einsum("ni,nij,nj->n", vectors, metric[pairs[:, k]], vectors)) for k in (0, 1))
    close = np.abs(a - b) < 1e-6 * a
    ratio = np.where(close, 2, a / b)
    return np.where(close, (a + b) / 2, (a - b) / np.log(ratio))


def volumes(mesh):
    p = mesh.points[mesh.tetrahedra]
    return np.linalg.det(p[:, 1:] - p[:, :1]) / 6


def qualities(mesh, metric):
    """Q of each tetrahedron in the mean of its four metrics: 1 is regular, larger is worse."""
    mean = tensors(metric)[mesh.tetrahedra].mean(axis=1)
    p = mesh.points[mesh.tetrahedra]
    vectors = np.stack([p[:, j] - p[:, i] for i, j in EDGES], axis=1)
    squares = np.einsum("nki,nij,nkj->n", vectors, mean, vectors)
    return squares ** 1.5 / (72 * np.sqrt(3) * volumes(mesh) * np.sqrt(np.linalg.det(mean)))
