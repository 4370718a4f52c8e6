#!/usr/bin/env python3
"""Example 5.3 of Dobrzynski and Frey 2008: two spheres travel down through a planar layer, one past the other.

usage: run.py TAUT FOLDER

Needs the program taut_spheres, which is built beside TAUT, and gmsh. The 34 steps are done twice, with three and with six rounds of
optimisation after each. Writes meshes, a plot and a picture to FOLDER.
"""
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent))
import picture  # noqa: E402
import steps  # noqa: E402

PAPER = {"vertices, first and last": "12,200 11,282", "tau, least and last": "0.86"}
CUTS = [0, 8, 16, 24, 34]


def compute(taut, start, rounds, folder):
    folder.mkdir(exist_ok=True)
    program = taut.parent.parent.parent / "examples" / "taut_spheres"
    subprocess.run([str(word) for word in (program, start, rounds, folder)], check=True)
    return steps.read(folder)


def main():
    taut, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    start, plot, cuts = (folder / name for name in ("spheres.mesh", "spheres-steps.png", "spheres-cuts.png"))
    subprocess.run(["gmsh", "-3", "-v", "2", "-o", start, here / "spheres.geo"], check=True)
    runs = {rounds: compute(taut, start, rounds, folder / f"rounds-{rounds}") for rounds in (3, 6)}
    steps.print_figures("Example 5.3, moving spheres, 34 steps", [f"{rounds} rounds" for rounds in runs], PAPER,
                        list(runs.values()))
    steps.save_plot(plot, runs[3], "Moving spheres (example 5.3), three rounds a step")
    steps.save_cuts(cuts, folder / "rounds-3", CUTS, picture.Plane(origin=(0.01, 0, 0), normal=(1, 0, 0)),
                    picture.View((1, -0.2, 0.15)), size=(17, 6))
    print("", plot, cuts, sep="\n")


if __name__ == "__main__":
    main()
