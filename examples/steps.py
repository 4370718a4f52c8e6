"""The steps of a moving mesh: what steps.hpp has written, as a table and a plot."""
import math

import gmf
import measures
import numpy as np
import picture

PHASES = ["solve", "move", "optimise", "result"]
COLOURS = ["#0b3c74", "#93c4e4", "#3787c0", "#9aa5b1"]


def read(folder):
    return np.genfromtxt(folder / "steps.csv", delimiter=",", names=True)


def percent(share):
    return f"{math.floor(1e4 * share) / 100:.2f} %"  # never rounded up to 100


def print_head(title, names):
    print(f"\n{title}\n{'':30}" + "".join(f"{name:>16}" for name in names))


def print_row(name, *values):
    print(f"{name:30}" + "".join(f"{value:>16}" for value in values), flush=True)


def print_figures(title, names, paper, runs):
    """The paper's figures beside those of runs: arrays as read() returns them, from the start mesh on."""
    print_head(title, ["paper", *names])
    rows = {
        "tetrahedra, first and last": lambda s: f"{s['tetrahedra'][0]:,.0f} {s['tetrahedra'][-1]:,.0f}",
        "vertices, first and last": lambda s: f"{s['vertices'][0]:,.0f} {s['vertices'][-1]:,.0f}",
        "vertices, most": lambda s: f"{s['vertices'].max():,.0f}",
        "tau, start": lambda s: f"{s['tau'][0]:.4f}",
        "tau, least and last": lambda s: f"{s['tau'].min():.4f} {s['tau'][-1]:.4f}",
        "Q in [1, 3], least": lambda s: percent(s["Q_up_to_3"].min()),
        "largest Q": lambda s: f"{s['Q_max'].max():.2f}",
        "parts, sum": lambda s: f"{s['parts'].sum():.0f}",
        "seconds a step": lambda s: f"{s['seconds'][1:].mean():.3f}",
        "processor seconds a step": lambda s: f"{s['busy'][1:].mean():.3f}",
    }
    for phase in PHASES:
        rows[f"    {phase}"] = lambda s, phase=phase: f"{s[phase][1:].mean():.3f}"
    for name, value in rows.items():
        print_row(name, paper.get(name, "-"), *(value(run) for run in runs))


def save_plot(path, steps, title):
    """Worst quality, share of good tetrahedra, tau, vertices, and seconds by phase over the steps."""
    figure, rows = picture.plt.subplots(2, 2, figsize=(11, 6), sharex=True, layout="constrained")
    (worst, tau), (vertices, seconds) = rows
    x = steps["step"]
    worst.plot(x, steps["Q_max"], color="#0b3c74")
    worst.set(title="largest Q, and % of tetrahedra with Q above 3", ylim=(1, max(6, 1.1 * steps["Q_max"].max())))
    beside = worst.twinx()
    beside.plot(x, 100 * (1 - steps["Q_up_to_3"]), color=picture.FRAME)
    beside.set(ylim=(0, 0.2))
    beside.tick_params(colors=picture.FRAME)
    tau.plot(x, steps["tau"], color="#0b3c74")
    tau.set(title="efficiency index tau", ylim=(0.84, 0.92))
    vertices.plot(x, steps["vertices"], color="#0b3c74")
    vertices.set(title="vertices", xlabel="step", ylim=(0, 1.2 * steps["vertices"].max()))
    seconds.stackplot(x[1:], [steps[phase][1:] for phase in PHASES], labels=PHASES, colors=COLOURS)
    seconds.set(title="seconds", xlabel="step", ylim=0)
    seconds.legend(frameon=False, fontsize=8, ncols=3)
    for axes in rows.flat:
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(alpha=0.3)
    figure.suptitle(title, fontsize=12)
    figure.savefig(path, dpi=120)
    picture.plt.close(figure)


def save_cuts(path, folder, numbers, plane, view, size, line=0.2, window=None):
    """The meshes after the steps with these numbers, cut, coloured by quality."""
    figure, panels = picture.plt.subplots(1, len(numbers), figsize=size, layout="constrained")
    for axes, number in zip(panels, numbers):
        mesh = gmf.read_mesh(folder / f"mesh-{number}.meshb")
        quality = measures.qualities(mesh, gmf.read_solution(folder / f"mesh-{number}.solb"))
        picture.draw_cut(axes, mesh, quality, plane, view, line=line, window=window)
        axes.set_title(f"step {number}: {len(mesh.points):,} vertices")
    picture.quality_bar(figure, list(panels))
    figure.savefig(path, dpi=120)
    picture.plt.close(figure)
