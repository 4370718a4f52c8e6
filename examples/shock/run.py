#!/usr/bin/env python3
"""Example 5.1 of Dobrzynski and Frey 2008, a planar shock in [-1, 1]^3.

usage: run.py TAUT FOLDER

Adapts start.meshb, which is adapted on the surface and has few vertices inside, five times with the surface fixed. The analytic
metric is evaluated anew on each mesh. Writes the last mesh and two pictures to FOLDER.
"""
import json
import math
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent))
import fields  # noqa: E402
import gmf  # noqa: E402
import measures  # noqa: E402
import outer_loop  # noqa: E402
import picture  # noqa: E402

ADAPTATIONS = 5


def percent(share):
    return f"{math.floor(1e4 * share) / 100:.2f} %"  # never rounded up to 100


def print_figures(taut, mesh, metric, seconds):
    run = subprocess.run([taut, "quality", mesh, "--metric", metric, "--json"], check=True, stdout=subprocess.PIPE)
    ours = json.loads(run.stdout)["quality"]
    rows = [
        ("tetrahedra", "51,440", f"{ours['tetrahedra']:,}"),
        ("efficiency index tau", "0.87", f"{ours['tau']:.3f}"),
        ("elements with Q in [1, 3]", "99.96 %", percent(ours["Q_up_to_3"])),
        ("largest Q", "", f"{ours['Q_max']:.2f}"),
        ("unit edges", "", percent(ours["unit_edges"])),
        ("seconds", "", f"{seconds:.1f}"),
    ]
    print(f"\nExample 5.1, planar shock, surface fixed, {ADAPTATIONS} adaptations")
    print(f"{'':28}{'paper':>12}{'taut':>12}")
    for name, paper, measured in rows:
        print(f"{name:28}{paper or '-':>12}{measured:>12}")


def save_cut(path, mesh, quality):
    figure, (whole, detail) = picture.plt.subplots(1, 2, figsize=(11, 5.6), width_ratios=[1.18, 1], layout="constrained")
    plane = picture.Plane(origin=(0, 0, 0), normal=(0, -1, 0))
    window = picture.Window(centre=(0.5, 0, 0), right=(0.2, 0, 0), up=(0, 0, 0.2))
    view = picture.View((0.42, -1, 0.38))
    picture.draw_cut(whole, mesh, quality, plane, view, line=0.15)
    picture.mark_window(whole, view, window)
    whole.set_title(f"{len(mesh.tetrahedra):,} tetrahedra, cut at y = 0")
    picture.draw_cut(detail, mesh, quality, plane, picture.View((0, -1, 0)), line=0.4, window=window)
    picture.frame(detail)
    picture.quality_bar(figure, [whole, detail])
    figure.savefig(path, dpi=120)


def main():
    taut, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    file, cut, histogram = (folder / name for name in ("shock.meshb", "shock-cut.png", "shock-histogram.png"))
    command = outer_loop.taut_command(taut, "--surface", "fixed")
    metric_file, seconds, _ = outer_loop.run(command, here / "start.meshb", fields.shock, ADAPTATIONS, file)
    print_figures(taut, file, metric_file, seconds)
    mesh = gmf.read_mesh(file)
    metric = fields.shock(mesh.points)
    quality = measures.qualities(mesh, metric)
    save_cut(cut, mesh, quality)
    picture.save_histograms(histogram, quality, measures.edge_lengths(mesh, metric), "Planar shock (example 5.1)")
    print("", file, cut, histogram, sep="\n")


if __name__ == "__main__":
    main()
