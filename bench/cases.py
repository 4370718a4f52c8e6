#!/usr/bin/env python3
"""Whole runs at several sizes, and the same with mmg3d_O3 if it is on PATH.

Each run starts from a grid of a cube and adapts it ADAPTATIONS times to an analytic metric, which is evaluated anew on each mesh.
The seconds are those of all adaptations and include the files; the rate is the number of tetrahedra of the last mesh, per second
of one adaptation.
"""
import argparse
import itertools
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "examples"))
import fields  # noqa: E402
import gmf  # noqa: E402
import grids  # noqa: E402
import measures  # noqa: E402
import outer_loop  # noqa: E402

DOMAINS = {"shock": (-1.0, 1.0), "linear": (0.0, 1.0)}
DIVISORS = [1.0, 1.7, 2.75, 3.5]  # of the sizes: about 50 k, 230 k, 0.95 M and 2 M tetrahedra


def programs(taut):
    yield "taut", outer_loop.taut_command(taut)
    peer = shutil.which("mmg3d_O3")
    if peer:
        yield "mmg3d", lambda mesh, metric, out: [peer, "-v", "0", "-hgrad", "-1", "-in", mesh, "-sol", metric, "-out", out]


def measured(taut, command, case, divisor, grid, adaptations):
    """The figures of one run, quality as taut measures it."""
    field = lambda points: getattr(fields, case)(points, divisor)
    with tempfile.TemporaryDirectory() as folder:
        start, out = pathlib.Path(folder, "start.meshb"), pathlib.Path(folder, "out.meshb")
        gmf.write_mesh(start, grids.cube(grid, *DOMAINS[case]))
        metric, seconds, peak = outer_loop.run(command, start, field, adaptations, out)
        report = subprocess.run([taut, "quality", out, "--metric", metric, "--json"], check=True, stdout=subprocess.PIPE)
        figures = json.loads(report.stdout)["quality"]
    figures.update(seconds=seconds, rate=figures["tetrahedra"] * adaptations / seconds, peak=peak / figures["tetrahedra"])
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("taut")
    parser.add_argument("--cases", nargs="+", choices=DOMAINS, default=list(DOMAINS))
    parser.add_argument("--divisors", nargs="+", type=float, default=DIVISORS, help="numbers that divide all sizes")
    parser.add_argument("--grid", type=int, default=10, help="boxes along a side of the first mesh")
    parser.add_argument("--adaptations", type=int, default=2, help="number of adaptations, one after another")
    options = parser.parse_args()
    print(f"{'case':8}{'sizes /':>8} {'program':8}{'tets':>10}{'tau':>7}{'unit %':>8}{'Q<=3 %':>8}{'worst Q':>9}{'s':>8}"
          f"{'ktets/s':>9}{'peak B/tet':>11}{'time ratio':>11}")
    for case, divisor in itertools.product(options.cases, options.divisors):
        ours = None
        for name, command in programs(options.taut):
            f = measured(options.taut, command, case, divisor, options.grid, options.adaptations)
            ours = ours or f["seconds"]
            print(f"{case:8}{divisor:8g} {name:8}{f['tetrahedra']:10,}{f['tau']:7.3f}{100 * f['unit_edges']:8.2f}"
                  f"{100 * f['Q_up_to_3']:8.2f}{f['Q_max']:9.3g}{f['seconds']:8.2f}{f['rate'] / 1000:9.1f}{f['peak']:11.0f}"
                  f"{f['seconds'] / ours:11.2f}", flush=True)


if __name__ == "__main__":
    main()
