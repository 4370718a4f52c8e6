#!/usr/bin/env python3
"""How much faster one adaptation is on several threads, pass by pass, and what blocks cost.

Adapts a grid of a cube to a planar shock, with all sizes divided by DIVISOR, and then adapts the result twice more to the same
metric, evaluated anew. Efficiency is the time on one thread, divided by the number of threads and by the time on them. Idle is
the share of a pass, in the last run, in which threads waited for others. All meshes of a step must have the same hash. Each step
is then repeated on one thread with the mesh as a single block: cost is the time with blocks, divided by the time without. Seconds
are medians of RUNS runs; "all" is the whole process and includes the files.
"""
import argparse
import collections
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "examples"))
import cases  # noqa: E402
import fields  # noqa: E402
import gmf  # noqa: E402
import grids  # noqa: E402

PARALLEL = ["build", "geometry", "metric", "cut", "order", "result", "read", "write"]


def adapt(taut, mesh, metric, out, threads, *options):
    """The report of one run, with the seconds of the process as `all`."""
    report = out.with_suffix(".json")
    words = [taut, "adapt", mesh, "--metric", metric, "-o", out, "--report", report, "--quiet", "--threads", str(threads)]
    began = time.monotonic()
    subprocess.run([*words, *options], check=True)
    took = time.monotonic() - began
    return {"all": took, **json.loads(report.read_text())}


def phases(report):
    """Seconds by phase: each pass, their sum, each phase outside the passes, and the whole process."""
    seconds = collections.OrderedDict((p["name"], p["seconds"]) for p in report["passes"] if p["seconds"] > 0)
    seconds["passes"] = sum(seconds.values())
    seconds.update((name, report["seconds"][name]) for name in PARALLEL)
    seconds["all"] = report["all"]
    return seconds


def idle(report):
    """For each pass, the share of the threads' time that was spent waiting."""
    shares = {}
    for p in report["passes"]:
        if p["seconds"] > 0:
            shares[p["name"]] = 1 - p["busy_seconds"] / (report["threads"] * p["seconds"])
    return shares


def medians(reports):
    lists = [phases(report) for report in reports]
    return {name: statistics.median(seconds[name] for seconds in lists) for name in lists[0]}


def check_hash(report, hashes):
    hashes.add(report["hash"])
    if len(hashes) > 1:
        sys.exit(f"the mesh depends on the threads: hashes {hashes}")


def print_row(threads, seconds, base, waits):
    print(f"\n{threads} threads" if threads > 1 else "\n1 thread")
    print(f"  {'phase':12}{'s':>9}{'speed-up':>10}{'efficiency':>12}{'idle':>8}")
    for name, taken in seconds.items():
        if base[name] < 1e-3:
            continue
        faster = base[name] / taken if taken > 0 else float("inf")
        wait = f"{100 * waits[name]:7.1f}%" if name in waits else ""
        print(f"  {name:12}{taken:9.3f}{faster:10.2f}{100 * faster / threads:11.1f}%{wait}", flush=True)


def measure(taut, mesh, metric, out, counts, runs, block_size):
    """Prints a table for each number of threads; returns the medians on one thread."""
    base, hashes = None, set()
    size_words = ["--block-size", block_size] if block_size else []
    for threads in counts:
        reports = [adapt(taut, mesh, metric, out, threads, *size_words) for _ in range(runs)]
        for report in reports:
            check_hash(report, hashes)
        seconds = medians(reports)
        base = base or seconds
        print_row(threads, seconds, base, idle(reports[-1]))
    print(f"\n{reports[-1]['quality']['tetrahedra']:,} tetrahedra, {reports[-1]['blocks']} blocks in the last of"
          f" {reports[-1]['rounds']} rounds, hash {hashes.pop()}")
    for p in reports[-1]["passes"]:
        print(f"  {p['name']:12}{p['tried']:>12,} tried{p['accepted']:>12,} accepted{p['put_off']:>12,} put off")
    return base


def print_cost(taut, mesh, metric, out, runs, base):
    single = medians([adapt(taut, mesh, metric, out, 1, "--block-size", "0") for _ in range(runs)])
    print(f"\none thread, blocks against one block: passes and cuts {base['passes'] + base['cut']:.2f} s against"
          f" {single['passes'] + single['cut']:.2f} s, cost {(base['passes'] + base['cut']) / (single['passes'] + single['cut']):.2f};"
          f" all {base['all']:.2f} s against {single['all']:.2f} s, cost {base['all'] / single['all']:.2f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("taut")
    parser.add_argument("--divisor", type=float, default=2.75, help="divides all sizes; 2.75 gives a million tetrahedra")
    parser.add_argument("--grid", type=int, default=20, help="boxes along a side of the first mesh")
    parser.add_argument("--threads", nargs="+", type=int, help="numbers of threads besides 1; by default 2, 4, ... up to the number of cores")
    parser.add_argument("--runs", type=int, default=3, help="runs per time")
    parser.add_argument("--block-size", help="vertices per block; by default that of taut")
    options = parser.parse_args()
    counts = options.threads or [min(2**k, os.cpu_count()) for k in range(os.cpu_count().bit_length() + 1)]
    counts = sorted({1, *counts})
    with tempfile.TemporaryDirectory() as folder:
        mesh, metric, out = (pathlib.Path(folder, name) for name in ("0.meshb", "0.solb", "1.meshb"))
        gmf.write_mesh(mesh, grids.cube(options.grid, *cases.DOMAINS["shock"]))
        for title in ("from the grid", "from the mesh of step 1", "from the mesh of step 2, converged"):
            print(f"\n== {title}")
            gmf.write_solution(metric, fields.shock(gmf.read_mesh(mesh).points, options.divisor))
            base = measure(options.taut, mesh, metric, out, counts, options.runs, options.block_size)
            print_cost(options.taut, mesh, metric, out.with_name("single.meshb"), options.runs, base)
            mesh.write_bytes(out.read_bytes())


if __name__ == "__main__":
    main()
