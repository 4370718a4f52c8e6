#!/usr/bin/env python3
"""A known front in [0, 1]^3, u = tanh(50 (x + 0.3 sin 2y - 0.2 z)), on meshes that make its interpolation error least.

usage: run.py TAUT FOLDER [--full]

Each iteration evaluates u at the vertices of the mesh. taut recovers the Hessian from these values, makes the metric with the
least error in an L^p norm at a given complexity, and adapts the mesh to it; until the L2 error changes by less than 5 %, at most 12
times. The first complexity starts from a uniform mesh, each other one from the mesh of the one before. Prints the error of the
piecewise linear interpolant on each mesh, and writes the last mesh for p = 2 and two pictures to FOLDER. --full takes more
complexities and finer uniform meshes, which takes about 20 minutes of processor time.
"""
import math
import pathlib
import resource
import subprocess
import sys
from dataclasses import dataclass

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent))
import gmf  # noqa: E402
import grids  # noqa: E402
import interpolation  # noqa: E402
import numpy as np  # noqa: E402
import picture  # noqa: E402

HMAX = 1  # as the domain: u does not change along (0.2, 0, 1), so that the error alone asks for no end of the elements there
START = 12  # boxes along a side of the first mesh
SETTLED, MOST = 0.05, 12  # a fixed point: the L2 error changes by less than this; the most iterations to it
PICTURED = 1000  # complexity of the mesh in the picture
QUICK = {2: [1000, 2000, 4000, 8000], 1: [2000], 4: [2000]}  # complexities by p
FULL = {2: [1000 * 2 ** k for k in range(9)], 1: [1000 * 2 ** k for k in range(7)], 4: [1000 * 2 ** k for k in range(7)]}
COLOURS = {1: "#6aa84f", 2: "#2b7bba", 4: "#8e5ea2"}


@dataclass
class Level:
    """A mesh and its errors; uniform meshes have no p, complexity, iterations and time."""
    vertices: int
    tetrahedra: int
    errors: interpolation.Errors
    norm: int = 0
    complexity: int = 0
    iterations: int = 0
    cpu_seconds: float = 0.0  # per iteration


def front(points):
    x, y, z = np.moveaxis(points, -1, 0)
    return np.tanh(50 * (x + 0.3 * np.sin(2 * y) - 0.2 * z))


def adapt(taut, file, complexity, norm):
    """Adapts the mesh in the file once."""
    field, metric = file.with_suffix(".u.solb"), file.with_suffix(".metric.solb")
    gmf.write_solution(field, front(gmf.read_mesh(file).points))
    subprocess.run([taut, "metric", "lp", file, field, "--complexity", str(complexity), "--norm", str(norm), "--hmax", str(HMAX),
                    "-o", metric, "--quiet"], check=True)
    subprocess.run([taut, "adapt", file, "--metric", metric, "-o", file, "--quiet"], check=True)


def cpu_seconds():
    """Of all runs of taut that have ended, on all threads: on a shared machine they vary less than the time that passes."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def fixed_point(taut, file, complexity, norm):
    """Adapts the mesh in the file until its error stays."""
    before, began = math.inf, cpu_seconds()
    for iteration in range(1, MOST + 1):
        adapt(taut, file, complexity, norm)
        mesh = gmf.read_mesh(file)
        errors = interpolation.errors(mesh, front)
        if abs(errors.l2 - before) < SETTLED * errors.l2:
            break
        before = errors.l2
    return Level(len(mesh.points), len(mesh.tetrahedra), errors, norm, complexity, iteration,
                 (cpu_seconds() - began) / iteration)


def series(taut, folder, norm, complexities):
    file = folder / f"smooth-front-p{norm}.meshb"
    gmf.write_mesh(file, grids.cube(START, 0.0, 1.0))
    levels = []
    for complexity in complexities:
        levels.append(fixed_point(taut, file, complexity, norm))
        print_level(levels[-1], levels[-2:-1])
        if norm == 2 and complexity == PICTURED:
            save_cut(folder / "smooth-front-cut.png", gmf.read_mesh(file))
    return levels


def uniform(cells):
    """The errors on cells^3 boxes, which are measured layer by layer."""
    layers = (grids.box((1, cells, cells), (i / cells, 0, 0), ((i + 1) / cells, 1, 1)) for i in range(cells))
    errors = sum((interpolation.errors(layer, front) for layer in layers), interpolation.Errors())
    return Level((cells + 1) ** 3, 6 * cells ** 3, errors)


def order(fine, coarse):
    """Of the L2 error in the number of vertices^(-1/3)."""
    return 3 * math.log(coarse.errors.l2 / fine.errors.l2) / math.log(fine.vertices / coarse.vertices)


def print_header():
    print(f"\nA smooth front, --hmax {HMAX:g}: errors of the interpolant, processor seconds of an iteration, order of L2\n"
          f"{'p':>7}{'complexity':>12}{'vertices':>11}{'tetrahedra':>12}{'iterations':>12}{'CPU s':>8}{'L1':>10}{'L2':>10}"
          f"{'largest':>10}{'order':>7}")


def print_level(level, before):
    of_series = f"{level.norm:7}{level.complexity:12,}" if level.norm else f"{'uniform':>7}{'':12}"
    effort = f"{level.iterations:12}{level.cpu_seconds:8.1f}" if level.norm else f"{'':20}"
    errors = level.errors
    print(f"{of_series}{level.vertices:11,}{level.tetrahedra:12,}{effort}{errors.l1:10.2e}{errors.l2:10.2e}{errors.worst:10.2e}"
          + "".join(f"{order(level, coarse):7.2f}" for coarse in before), flush=True)


def print_comparison(adapted, grid):
    """Against a uniform mesh with 50 times the vertices: by order 2 from the finest that was measured."""
    vertices = 50 * adapted.vertices
    error = grid.errors.l2 * (grid.vertices / vertices) ** (2 / 3)
    print(f"\nA uniform mesh of {vertices:,} vertices, 50 times those of complexity {adapted.complexity:,}, has an L2 error of "
          f"{error:.1e}\n(by order 2 from {grid.vertices:,} vertices): {error / adapted.errors.l2:.0f} times the error.")


def save_errors(path, adapted, grids_measured):
    figure, axes = picture.plt.subplots(figsize=(8, 5), layout="constrained")
    for norm, levels in adapted.items():
        draw_series(axes, levels, COLOURS[norm], f"adapted, p = {norm}", "o")
    draw_series(axes, grids_measured, picture.FRAME, "uniform", "s")
    finest = grids_measured[-1]
    reach = np.array([1, (50 * adapted[2][-1].vertices / finest.vertices) ** (1 / 3)])
    axes.plot(edge(finest) * reach, finest.errors.l2 / reach ** 2, "--", color=picture.FRAME, label="uniform, by order 2")
    for levels in (adapted[2], grids_measured):
        last = levels[-1]
        axes.annotate(f"order {order(last, levels[-3]):.1f}", (edge(last), last.errors.l2), (8, 6), textcoords="offset points")
    axes.set(xscale="log", yscale="log", xlabel="(number of vertices)$^{1/3}$", ylabel="L2 error of the interpolant",
             title="u = tanh(50 (x + 0.3 sin 2y $-$ 0.2 z))")
    axes.xaxis.set_major_formatter(picture.plt.ScalarFormatter())
    axes.xaxis.set_minor_formatter(picture.plt.NullFormatter())
    axes.set_xticks([10, 20, 40, 80, 160, 320])
    axes.grid(alpha=0.3)
    axes.legend(frameon=False, loc="lower left")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=120)


def edge(level):
    return level.vertices ** (1 / 3)


def draw_series(axes, levels, colour, label, marker):
    axes.plot([edge(level) for level in levels], [level.errors.l2 for level in levels], marker + "-", color=colour, label=label)


def save_cut(path, mesh):
    figure, (whole, detail) = picture.plt.subplots(1, 2, figsize=(11, 5.6), width_ratios=[1.18, 1], layout="constrained")
    plane = picture.Plane(origin=(0, 0, 0.9), normal=(0, 0, 1))
    window = picture.Window(centre=(0.12, 0.1, 0.9), right=(0.045, 0, 0), up=(0, 0.045, 0))
    values = front(mesh.points)[mesh.tetrahedra].mean(axis=1)
    view = picture.View((-0.35, -0.8, 1))
    picture.draw_cut(whole, mesh, values, plane, view, line=0.15, scale=picture.SOLUTION)
    picture.mark_window(whole, view, window)
    whole.set_title(f"{len(mesh.tetrahedra):,} tetrahedra, cut at z = 0.9")
    above = picture.View((0, -1e-6, 1))  # not quite, because up is z
    picture.draw_cut(detail, mesh, values, plane, above, line=0.25, window=window, scale=picture.SOLUTION)
    picture.frame(detail)
    picture.bar(figure, [whole, detail], picture.SOLUTION, "u")
    figure.savefig(path, dpi=120)
    picture.plt.close(figure)


def main():
    taut, folder, full = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:] == ["--full"]
    print_header()
    adapted = {norm: series(taut, folder, norm, complexities) for norm, complexities in (FULL if full else QUICK).items()}
    measured = []
    for cells in (16, 32, 64, 128) if full else (12, 24, 48):
        measured.append(uniform(cells))
        print_level(measured[-1], measured[-2:-1])
    print_comparison(adapted[2][-1], measured[-1])
    save_errors(folder / "smooth-front.png", adapted, measured)
    print("", *(folder / name for name in ("smooth-front-p2.meshb", "smooth-front.png", "smooth-front-cut.png")), sep="\n")


if __name__ == "__main__":
    main()
