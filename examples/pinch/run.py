#!/usr/bin/env python3
"""Two spheres approach each other until the gap is a tenth of their edges, and leave again; then one is driven into the wall.

usage: run.py TAUT FOLDER

Needs the program taut_pinch, which is built beside TAUT, and gmsh. Goes there and back in 40 steps, with a metric that does not know of
the gap and with one that asks for a layer of tetrahedra in it. Writes meshes, plots and pictures to FOLDER.
"""
import pathlib
import subprocess
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent))
import picture  # noqa: E402
import steps  # noqa: E402

CUTS = [0, 10, 15, 20, 40]
PLANE = picture.Plane(origin=(0, 0.003, 0), normal=(0, -1, 0))
VIEW = picture.View((0, -1, 0))
WHOLE = picture.Window(centre=(0, 0, -0.2), right=(1.25, 0, 0), up=(0, 0, 2.05))


def compute(taut, start, run, folder):
    folder = folder / run
    folder.mkdir(exist_ok=True)
    program = taut.parent.parent.parent / "examples" / "taut_pinch"
    subprocess.run([str(word) for word in (program, start, run, folder)], check=True)
    return steps.read(folder), np.genfromtxt(folder / "checks.csv", delimiter=",", names=True)


def print_checks(checks):
    rows = {
        "least gap / edge": lambda c: f"{c['gap'].min() / 0.1:.4f}",
        "least gap to the wall / edge": lambda c: f"{c['gap_to_wall'].min() / 0.1:.4f}",
        "defects, sum": lambda c: f"{c['defects'].sum():.0f}",
        "place of vertices, error": lambda c: f"{c['place_error'].max():.0e}",
        "volume, error": lambda c: f"{c['volume_error'].max():.0e}",
    }
    for name, value in rows.items():
        steps.print_row(name, "-", *(value(check) for check in checks))


def print_steps(run, checks):
    print(f"\n{'step':>4}{'gap':>9}{'Q max':>8}{'Q <= 3':>11}{'tau':>8}{'vertices':>10}{'parts':>7}{'seconds':>9}")
    for step, check in zip(run, checks):
        print(f"{step['step']:4.0f}{check['gap']:9.4f}{step['Q_max']:8.2f}{steps.percent(step['Q_up_to_3']):>11}{step['tau']:8.4f}"
              f"{step['vertices']:10.0f}{step['parts']:7.0f}{step['seconds']:9.3f}")


def at_height(z, half):
    return picture.Window(centre=(0, 0, z), right=(half, 0, 0), up=(0, 0, half))


def main():
    taut, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    start = folder / "pinch.mesh"
    subprocess.run(["gmsh", "-3", "-v", "2", "-o", start, here / "pinch.geo"], check=True)
    names = {"gap": "one size", "layer": "layer", "wall": "into the wall"}
    done = {run: compute(taut, start, run, folder) for run in names}
    runs, checks = ([pair[i] for pair in done.values()] for i in (0, 1))
    steps.print_figures("Pinch: two spheres there and back, and one into the wall", list(names.values()), {}, runs)
    print_checks(checks)
    print_steps(*done["gap"])
    for run in ("gap", "layer"):
        steps.save_plot(folder / f"pinch-{run}-steps.png", done[run][0], f"Pinch, {names[run]}")
        steps.save_cuts(folder / f"pinch-{run}-cuts.png", folder / run, CUTS, PLANE, VIEW, size=(15, 5.5), window=WHOLE)
        steps.save_cuts(folder / f"pinch-{run}-gap.png", folder / run, CUTS[1:4], PLANE, VIEW, size=(15, 5), line=0.5,
                        window=at_height(-0.1, 0.22))
    last = int(done["wall"][0]["step"][-1])
    steps.save_cuts(folder / "pinch-wall.png", folder / "wall", [10, 15, last], PLANE, VIEW, size=(15, 5), line=0.5,
                    window=at_height(1.55, 0.3))
    print("", *sorted(folder.glob("pinch-*.png")), sep="\n")


if __name__ == "__main__":
    main()
