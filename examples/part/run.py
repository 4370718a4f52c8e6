#!/usr/bin/env python3
"""Real input: a bearing bracket from CAD, meshed by gmsh, and refined around a ring inside the wall of its boss.

usage: run.py TAUT FOLDER

The ring stands for something that a simulation has to resolve, for example the front of a crack around the bore. The surface stays
as gmsh made it. Writes the meshes and a picture to FOLDER.
"""
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent))
import gmf  # noqa: E402
import measures  # noqa: E402
import numpy as np  # noqa: E402
import outer_loop  # noqa: E402
import picture  # noqa: E402

RING_RADIUS, RING_HEIGHT = 15.0, 20.0  # in the middle of the boss's wall
ADAPTATIONS = 3  # the first one sees the ring only where gmsh happened to put a vertex
FINEST, COARSEST, GROWTH = 0.2, 2.5, 0.45


def wanted_sizes(points):
    from_ring = np.hypot(np.hypot(points[:, 0], points[:, 1]) - RING_RADIUS, points[:, 2] - RING_HEIGHT)
    return np.minimum(FINEST + GROWTH * from_ring, COARSEST)


def save_cut(path, before, after):
    figure, panels = picture.plt.subplot_mosaic([["whole", "before"], ["whole", "after"]], figsize=(11, 5.8),
                                                width_ratios=[2.1, 1], layout="constrained")
    plane = picture.Plane(origin=(0, 0, 0), normal=(1, 0, 0))
    window = picture.Window(centre=(0, RING_RADIUS, RING_HEIGHT), right=(0, 5, 0), up=(0, 0, 5))
    view = picture.View((1, -0.5, 0.55))
    for name, mesh, title in (("before", before, "from gmsh"), ("after", after, "adapted")):
        quality = measures.qualities(mesh, wanted_sizes(mesh.points))
        picture.draw_cut(panels[name], mesh, quality, plane, picture.View((1, 0, 0)), line=0.4, window=window)
        picture.frame(panels[name])
        panels[name].set_title(f"{title}: {len(mesh.tetrahedra):,} tetrahedra")
    picture.draw_cut(panels["whole"], after, quality, plane, view)
    picture.mark_window(panels["whole"], view, window)
    picture.quality_bar(figure, list(panels.values()))
    figure.savefig(path, dpi=120)


def main():
    taut, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    start, adapted = folder / "part.mesh", folder / "part-adapted.meshb"
    subprocess.run(["gmsh", "-3", "-v", "2", "-o", start, here / "part.geo"], check=True)
    before = gmf.read_mesh(start)
    command = outer_loop.taut_command(taut, "--surface", "fixed")
    _, seconds, _ = outer_loop.run(command, start, wanted_sizes, ADAPTATIONS, adapted)
    after = gmf.read_mesh(adapted)
    print(f"\nA bracket from CAD: {len(before.tetrahedra):,} tetrahedra from gmsh, {len(after.tetrahedra):,} after "
          f"{ADAPTATIONS} adaptations in {seconds:.1f} s")
    save_cut(folder / "part-cut.png", before, after)
    print("", adapted, folder / "part-cut.png", sep="\n")


if __name__ == "__main__":
    main()
