#!/usr/bin/env python3
"""Example 5.2 of Dobrzynski and Frey 2008: the interface r = 0.45 + 0.3 sin(3 phi), phi the latitude.

usage: run.py TAUT FOLDER

Needs the program taut_interface, which is built beside TAUT. Adapts a uniform mesh eight times to the metric of the level set:
as in the paper, at two resolutions; then with fewer elements across the surface and vertices placed on it. Measures the distance
between the piecewise linear surface and the exact one, both ways. Writes the last mesh and two pictures to FOLDER.
"""
import json
import pathlib
import subprocess
import sys
from dataclasses import dataclass

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent))
import gmf  # noqa: E402
import picture  # noqa: E402
import true_surface  # noqa: E402

REFERENCE = 4e-6  # distance of the reference triangulation from the exact surface, at most


@dataclass
class Case:
    """What interface.cpp is asked for."""
    name: str
    error: float
    growth: float
    across: float
    deviation: float


CASES = [Case("the paper's metric", 0.95e-3, 1, 0, 0), Case("twice as fine", 0.485e-3, 1, 0, 0),
         Case("vertices placed on it", 1e-3, 1, 0.5, 7e-5)]


def compute(taut, case, folder):
    """The seconds of the eight adaptations; the mesh and the values on it are then in the folder."""
    program = taut.parent.parent.parent / "examples" / "taut_interface"
    words = [program, case.error, case.growth, case.across, case.deviation, folder]
    run = subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE)
    return float(run.stdout)


def measure(taut, folder, exact):
    """Worst and mean distance between the reconstruction and the exact surface, both ways, sampled densely."""
    report = folder / "surface.json"
    subprocess.run([taut, "levelset", "extract", folder / "mesh.meshb", folder / "u.solb", "-o", folder / "surface.meshb",
                    "--compare", exact, "--report", report, "--quiet"], check=True)
    distance = json.loads(report.read_text())["distance"]
    ways = distance["to_other"], distance["from_other"]
    return max(way["worst"] for way in ways), max(way["mean"] for way in ways)


def print_row(name, vertices, worst, mean, seconds):
    print(f"{name:24}{vertices:>10}{worst:>12}{mean:>12}{seconds:>9}", flush=True)


def save_cut(path, mesh, values):
    """A cut through the axis, whole and enlarged; colours are those of the two sides."""
    inside = values[mesh.tetrahedra].mean(axis=1) < 0
    colours = np.where(inside, 1.4, 1.1)
    figure, (whole, detail) = picture.plt.subplots(1, 2, figsize=(11, 5.6), width_ratios=[1, 1], layout="constrained")
    plane = picture.Plane(origin=(0, 0, 0), normal=(0, -1, 0))
    window = picture.Window(centre=(0.2, 0, -0.15), right=(0.15, 0, 0), up=(0, 0, 0.15))
    view = picture.View((0, -1, 0))
    picture.draw_cut(whole, mesh, colours, plane, view, line=0.1)
    picture.mark_window(whole, view, window)
    whole.set_title(f"{len(mesh.points):,} vertices, cut at y = 0")
    picture.draw_cut(detail, mesh, colours, plane, view, line=0.4, window=window)
    picture.frame(detail)
    figure.savefig(path, dpi=120)


def main():
    taut, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    exact = folder / "exact.meshb"
    gmf.write_mesh(exact, true_surface.triangulated(REFERENCE))
    print("\nExample 5.2, interface, 8 adaptations; distances both ways")
    print_row("", "vertices", "worst", "mean", "seconds")
    print_row("paper", "1e5", "below 1e-4", "-", "-")
    for case in CASES:
        seconds = compute(taut, case, folder)
        worst, mean = measure(taut, folder, exact)
        mesh = gmf.read_mesh(folder / "mesh.meshb")
        print_row(case.name, f"{len(mesh.points):,}", f"{worst:.2e}", f"{mean:.2e}", f"{seconds:.1f}")
    save_cut(folder / "interface-cut.png", mesh, true_surface.level(mesh.points))
    print("", folder / "mesh.meshb", folder / "interface-cut.png", sep="\n")


if __name__ == "__main__":
    main()
