#!/usr/bin/env python3
"""Example 5.4 of Dobrzynski and Frey 2008: a propeller turns 3.6 degrees a step, by flips and relocation alone.

usage: run.py TAUT FOLDER [STEPS] [--large]

Needs the program taut_propeller, which is built beside TAUT, and gmsh. Does one turn, 100 steps, or STEPS steps, of a mesh with about
50,000 tetrahedra, or 300,000 with --large. Writes meshes, a plot and a picture to FOLDER.
"""
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent))
import picture  # noqa: E402
import steps  # noqa: E402

PAPER = {"tetrahedra, first and last": "3e5", "tau, least and last": "0.85", "Q in [1, 3], least": "above 98 %"}
TURN = 100  # steps


def compute(taut, start, count, folder):
    program = taut.parent.parent.parent / "examples" / "taut_propeller"
    subprocess.run([str(word) for word in (program, start, count, folder)], check=True)
    return steps.read(folder)


def main():
    words = [word for word in sys.argv[1:] if word != "--large"]
    taut, folder = pathlib.Path(words[0]), pathlib.Path(words[1])
    count = int(words[2]) if len(words) > 2 else TURN
    size = 0.52 if "--large" in sys.argv else 1
    start, plot, cuts = (folder / name for name in ("propeller.mesh", "propeller-steps.png", "propeller-cuts.png"))
    subprocess.run(["gmsh", "-3", "-v", "2", "-setnumber", "size", str(size), "-o", start, here / "propeller.geo"], check=True)
    run = compute(taut, start, count, folder)
    steps.print_figures(f"Example 5.4, propeller, {count} steps of 3.6 degrees", ["taut"], PAPER, [run])
    ends = [f"{run['tau'][step]:.4f}" for step in range(TURN, count + 1, TURN)]
    steps.print_row("tau after each turn", "-", " ".join(ends))
    steps.save_plot(plot, run, "Propeller (example 5.4)")
    kept = [step for step in (0, 8, 17, TURN) if step <= count]
    steps.save_cuts(cuts, folder, kept, picture.Plane(origin=(0, 0, 0.003), normal=(0, 0, 1)),
                    picture.View((0.001, -0.35, 1)), size=(4.3 * len(kept), 4.6), line=0.15)
    print("", plot, cuts, sep="\n")


if __name__ == "__main__":
    main()
