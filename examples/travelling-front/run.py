#!/usr/bin/env python3
"""A front that runs through a cube from a corner, u = tanh(40 (|x| - 0.2 - 0.8 t)), on meshes that are adapted in time.

usage: run.py TAUT FOLDER

Needs the program taut_travelling_front, which is built beside TAUT. Cuts the time into 8 sub-intervals with one mesh each, and again
into one, for the same complexity in space and time: the sum over 40 time steps. Each iteration computes the whole time on meshes
that are adapted to the solution of the one before. Prints the error of the piecewise linear interpolant in space and time: the
first iteration's is that of a uniform mesh. Writes the meshes and two pictures to FOLDER.
"""
import pathlib
import subprocess
import sys
from dataclasses import dataclass

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent))
import gmf  # noqa: E402
import interpolation  # noqa: E402
import picture  # noqa: E402

STEPS = 40  # as in the program
COMPLEXITY = 2000 * STEPS
TIMES = (np.arange(2 * STEPS) + 0.5) / (2 * STEPS)  # two in each step
SUB_INTERVALS, ITERATIONS = 8, 4
COLOURS = ["#9aa5b1", "#93c4e4", "#3787c0", "#0b3c74"]  # by iteration


@dataclass
class Iteration:
    """The meshes of all sub-intervals, and the L2 error in space at each of the TIMES."""
    meshes: list
    errors: np.ndarray

    def vertices(self):
        return [len(mesh.points) for mesh in self.meshes]

    def vertices_in_time(self):
        return sum(self.vertices()) * STEPS // len(self.meshes)

    def error(self):
        return np.sqrt(np.mean(self.errors ** 2))


def front(points, time):
    return np.tanh(40 * (np.linalg.norm(points, axis=-1) - 0.2 - 0.8 * time))


def compute(taut, folder, sub_intervals):
    """The complexity of the metrics that the solution of each iteration asked for; the meshes are then in the folder."""
    folder.mkdir(exist_ok=True)
    program = taut.parent.parent.parent / "examples" / "taut_travelling_front"
    words = [program, sub_intervals, ITERATIONS, COMPLEXITY, folder]
    run = subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE)
    asked = [float(word) for word in run.stdout.split()]
    return [float("nan")] * (ITERATIONS - len(asked)) + asked  # those before an interruption are not known


def measure(folder, sub_intervals, number):
    meshes = [gmf.read_mesh(folder / f"mesh-{number}-{index}.meshb") for index in range(sub_intervals)]
    errors = [interpolation.errors(meshes[int(time * sub_intervals)], lambda points: front(points, time), order=3).l2
              for time in TIMES]
    return Iteration(meshes, np.array(errors))


def print_row(name, number, complexity, found):
    meshes = " ".join(f"{count:6,}" for count in found.vertices())
    print(f"{name:>10}{number:>10}{complexity:>12}{found.vertices_in_time():>18,}{found.error():>10.2e}   {meshes}", flush=True)


def series(taut, folder, sub_intervals, numbers):
    """The iterations with these numbers, which are printed."""
    complexities = [COMPLEXITY, *compute(taut, folder, sub_intervals)]
    found = []
    for number in numbers:
        found.append(measure(folder, sub_intervals, number))
        print_row(sub_intervals if number else "uniform", number + 1, f"{complexities[number]:,.0f}", found[-1])
    return found


def save_errors(path, adapted, single):
    figure, (left, right) = picture.plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    bounds = np.linspace(0, 1, SUB_INTERVALS + 1)
    for number, (found, colour) in enumerate(zip(adapted, COLOURS)):
        name = f"iteration {number + 1}" if number else "uniform"
        left.stairs(found.vertices(), bounds, baseline=None, color=colour, linewidth=2)
        right.semilogy(TIMES, found.errors, color=colour, label=name)
    left.stairs(single.vertices(), [0, 1], baseline=None, color=picture.FRAME, linewidth=2)
    right.semilogy(TIMES, single.errors, color=picture.FRAME, label="one mesh for all times")
    left.set(xlabel="time", ylabel="vertices of the mesh", title=f"complexity {COMPLEXITY:,} over {STEPS} time steps", ylim=0)
    right.set(xlabel="time", title="L2 error of the interpolant", ylim=(1e-3, 0.3))
    right.grid(alpha=0.3)
    right.legend(frameon=False, fontsize=8, ncols=2)
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=120)
    picture.plt.close(figure)


def save_cuts(path, meshes):
    """The meshes of every other sub-interval, with the front in the middle of it."""
    figure, rows = picture.plt.subplots(1, 4, figsize=(15, 4.4), layout="constrained")
    plane, view = picture.Plane(origin=(0, 0.1, 0), normal=(0, -1, 0)), picture.View((0.3, -1, 0.35))
    for axes, index in zip(rows, range(0, len(meshes), 2)):
        mesh, time = meshes[index], (index + 0.5) / len(meshes)
        values = front(mesh.points, time)[mesh.tetrahedra].mean(axis=1)
        picture.draw_cut(axes, mesh, values, plane, view, line=0.2, scale=picture.SOLUTION)
        axes.set_title(f"t = {index / len(meshes):g} to {(index + 1) / len(meshes):g}: {len(mesh.points):,} vertices")
    picture.bar(figure, list(rows), picture.SOLUTION, "u")
    figure.savefig(path, dpi=120)
    picture.plt.close(figure)


def main():
    taut, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    print(f"\nA travelling front, {STEPS} time steps, complexity {COMPLEXITY:,} in space and time\n"
          f"{'meshes':>10}{'iteration':>10}{'complexity':>12}{'vertices x steps':>18}{'L2 error':>10}   vertices of each mesh")
    adapted = series(taut, folder / "adapted", SUB_INTERVALS, range(ITERATIONS))
    [single] = series(taut, folder / "single", 1, [ITERATIONS - 1])
    save_errors(folder / "travelling-front.png", adapted, single)
    save_cuts(folder / "travelling-front-cuts.png", adapted[-1].meshes)
    print("", *(folder / name for name in ("adapted", "travelling-front.png", "travelling-front-cuts.png")), sep="\n")


if __name__ == "__main__":
    main()
