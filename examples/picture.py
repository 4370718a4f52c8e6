"""Pictures of tetrahedral meshes: cuts by a plane, and histograms of quality and length."""
from dataclasses import dataclass

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize


QUALITY = ScalarMappable(Normalize(1, 3), LinearSegmentedColormap.from_list("quality", [
    (0, "#f3f8fc"), (0.12, "#cfe3f2"), (0.25, "#93c4e4"), (0.5, "#3787c0"), (0.8, "#0b3c74"), (1, "#d1495b")]))
SOLUTION = ScalarMappable(Normalize(-1, 1), LinearSegmentedColormap.from_list("solution", ["#7fb2d9", "#fbfaf7", "#e8a06a"]))
SURFACE = np.array([0.93, 0.90, 0.84])
INK = "#1d2b3a"
FRAME = "#e07a1f"

plt.rcParams.update({"font.family": "DejaVu Sans", "font.size": 10, "text.color": INK, "axes.labelcolor": INK,
                     "axes.edgecolor": INK, "xtick.color": INK, "ytick.color": INK, "axes.titlesize": 11})


@dataclass
class Plane:
    """A cut: the part of the mesh on the side of the normal is removed."""
    origin: tuple
    normal: tuple

    def heights(self, points):
        normal = np.array(self.normal, float)
        heights = (points - np.array(self.origin, float)) @ (normal / np.linalg.norm(normal))
        tiny = 1e-12 * np.abs(heights).max()
        return np.where(np.abs(heights) < tiny, -tiny, heights)  # no vertex lies on the plane


def _crossings(points, heights, above, below):
    """Where the segments from vertices `above` to vertices `below` meet the plane."""
    share = (heights[above] / (heights[above] - heights[below]))[..., None]
    return points[above] + share * (points[below] - points[above])


def section(mesh, plane):
    """Polygons in which the plane cuts tetrahedra, and the index of the tetrahedron for each."""
    heights = plane.heights(mesh.points)
    above = heights[mesh.tetrahedra] > 0
    cut = np.flatnonzero(above.any(axis=1) & ~above.all(axis=1))
    corners = mesh.tetrahedra[cut]
    corners = np.take_along_axis(corners, np.argsort(-heights[corners], axis=1), axis=1)  # highest first
    positive = (heights[corners] > 0).sum(axis=1)
    polygons, sources = [], []
    for count, above, below in ((1, [0, 0, 0], [1, 2, 3]), (2, [0, 0, 1, 1], [2, 3, 3, 2]), (3, [0, 1, 2], [3, 3, 3])):
        rows = positive == count
        polygons += list(_crossings(mesh.points, heights, corners[rows][:, above], corners[rows][:, below]))
        sources.append(cut[rows])
    return polygons, np.concatenate(sources)


def remaining_surface(mesh, plane):
    """Polygons of the surface below the plane, and their outward unit normals."""
    heights = plane.heights(mesh.points)
    p = mesh.points[mesh.triangles]
    normals = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    below = (heights[mesh.triangles] <= 0).sum(axis=1)
    polygons = list(p[below == 3])
    for triangle in mesh.triangles[(below == 1) | (below == 2)]:
        polygon = []
        for a, b in zip(triangle, np.roll(triangle, -1)):
            if heights[a] <= 0:
                polygon.append(mesh.points[a])
            if (heights[a] <= 0) != (heights[b] <= 0):
                polygon.append(_crossings(mesh.points, heights, a, b))
        polygons.append(np.array(polygon))
    return polygons, np.concatenate([normals[below == 3], normals[(below == 1) | (below == 2)]])


class View:
    """Orthographic projection, seen from the direction `towards`; z is up."""

    def __init__(self, towards):
        self.towards = np.array(towards, float) / np.linalg.norm(towards)
        right = np.cross((0, 0, 1), self.towards)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.towards, self.right)

    def flatten(self, polygons):
        axes = np.stack([self.right, self.up], axis=1)
        return [polygon @ axes for polygon in polygons]

    def back_to_front(self, polygons):
        return np.argsort([polygon.mean(axis=0) @ self.towards for polygon in polygons])


@dataclass
class Window:
    """A rectangle in space, seen face on: its centre, its right and upward half axes."""
    centre: tuple
    right: tuple
    up: tuple

    def corners(self):
        centre, right, up = (np.array(v, float) for v in (self.centre, self.right, self.up))
        return np.array([centre - right - up, centre + right - up, centre + right + up, centre - right + up])


def draw_cut(axes, mesh, values, plane, view, line=0.25, window=None, scale=QUALITY):
    """Draws the part below the plane: its surface shaded, the section coloured by the values of its tetrahedra.

    With a window, draws only what lies in it.
    """
    surface, normals = remaining_surface(mesh, plane)
    front = np.flatnonzero(normals @ view.towards > 0)
    order = front[view.back_to_front([surface[i] for i in front])]
    light = view.towards + 0.5 * view.up - 0.4 * view.right
    brightness = 0.62 + 0.38 * np.clip(normals[order] @ (light / np.linalg.norm(light)), 0, 1)
    axes.add_collection(PolyCollection(view.flatten([surface[i] for i in order]), linewidths=0.6 * line,
                                       edgecolors="#8d8676", facecolors=brightness[:, None] * SURFACE))
    # The section is drawn last: nothing that remains is between the viewer and it.
    polygons, sources = section(mesh, plane)
    axes.add_collection(PolyCollection(view.flatten(polygons), linewidths=line, edgecolors=INK,
                                       facecolors=scale.to_rgba(values[sources])))
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.autoscale_view()
    if window is not None:
        low, _, high, _ = view.flatten([window.corners()])[0]
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))


def mark_window(axes, view, window):
    """Frames the part that another picture shows enlarged."""
    axes.add_patch(plt.Polygon(view.flatten([window.corners()])[0], fill=False, edgecolor=FRAME, linewidth=1.5, zorder=5))


def frame(axes):
    """Frames an enlargement, in the colour of its mark."""
    axes.add_patch(plt.Rectangle((0, 0), 1, 1, transform=axes.transAxes, fill=False, edgecolor=FRAME, linewidth=2))


def quality_bar(figure, axes):
    bar(figure, axes, QUALITY, "quality Q in the metric (1 is regular)", extend="max")


def bar(figure, axes, scale, label, extend="neither"):
    colours = figure.colorbar(scale, ax=axes, shrink=0.6, pad=0.02, aspect=28, extend=extend)
    colours.set_label(label)
    colours.outline.set_visible(False)


def save_histograms(path, quality, lengths, title):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.8), layout="constrained")
    bins = np.linspace(1, 3, 41)
    inside = np.floor(1e4 * np.mean(quality <= 3)) / 100
    left.hist(np.minimum(quality, 2.999), bins, weights=np.full(len(quality), 100 / len(quality)), color="#2b7bba")
    left.set(xlim=(1, 3), xlabel="quality Q (1 is regular)", ylabel="% of tetrahedra",
             title=f"{inside:.2f} % of {len(quality):,} tetrahedra with Q in [1, 3]")
    right.axvspan(0.5 ** 0.5, 2 ** 0.5, color="#e4eef6", zorder=0)
    right.hist(np.clip(lengths, 0.301, 1.999), np.linspace(0.3, 2, 69), weights=np.full(len(lengths), 100 / len(lengths)),
               color="#2b7bba")
    left.set_xticks([1, 1.5, 2, 2.5, 3], ["1", "1.5", "2", "2.5", "≥ 3"])
    right.set_xticks([0.3, 0.5, 1, 1.5, 2], ["≤ 0.3", "0.5", "1", "1.5", "≥ 2"])
    right.set(xlim=(0.3, 2), xlabel="edge length in the metric (shaded: unit edges)", ylabel="% of edges",
              title=f"lengths of {len(lengths):,} edges")
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
    figure.suptitle(title, fontsize=12)
    figure.savefig(path, dpi=120)
    plt.close(figure)
