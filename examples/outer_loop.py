"""Adaptation to an analytic metric that is evaluated anew on each mesh."""
import subprocess
import sys

import gmf

# Runs in a small process of its own, because the peak memory of a child includes what its parent held.
_MEASURE = """
import resource, subprocess, sys, time
began = time.monotonic()
status = subprocess.call(sys.argv[1:], stdout=subprocess.DEVNULL)
print(status, time.monotonic() - began, 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
"""


def taut_command(taut, *options):
    """The command for run() that calls taut with these options."""
    return lambda mesh, metric, out: [taut, "adapt", mesh, "--metric", metric, "-o", out, "--quiet", *options]


def run(command, start, field, adaptations, out):
    """Calls the program command(mesh, metric, out) `adaptations` times; the last mesh is then in `out`, a .meshb.

    Returns the file of the metric on that mesh, the seconds in the program, including its files, and its peak memory in bytes.
    """
    metric = out.with_suffix(".metric.solb")
    mesh, seconds, peak = start, 0.0, 0
    for _ in range(adaptations):
        gmf.write_solution(metric, field(gmf.read_mesh(mesh).points))
        words = command(mesh, metric, out)
        measure = subprocess.run([sys.executable, "-c", _MEASURE, *words], check=True, stdout=subprocess.PIPE, text=True)
        status, took, held = measure.stdout.split()
        if status != "0":
            sys.exit(f"{words[0]} ended with status {status}")
        seconds += float(took)
        peak = max(peak, int(held))
        mesh = out
    gmf.write_solution(metric, field(gmf.read_mesh(mesh).points))
    return metric, seconds, peak
