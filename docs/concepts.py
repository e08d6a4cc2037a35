#!/usr/bin/env python3
"""Draws the pictures of docs/concepts.md: a step of MPM, and the shape functions along an axis.

    concepts.py     writes images/concepts_step.png and images/concepts_shapes.png

Needs matplotlib."""

import numpy as np

from validation import COLOURS, HERE, pyplot

GREY = "#c8c8c8"


def grid(axes, moved=None):
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    if moved is not None:
        x, y = x + moved[0], y + moved[1]
    for a, b in ((x, y), (x.T, y.T)):
        axes.plot(a, b, color=GREY, linewidth=1, zorder=0)
    axes.plot(x, y, "s", color="#707070", markersize=4, zorder=2)
    axes.set(aspect="equal", xlim=(-0.5, 3.5), ylim=(-0.9, 3.4))
    axes.axis("off")
    return x, y


def points():
    """Nine points of a body that spins, and their velocities."""
    x, y = (c.ravel() for c in np.meshgrid([0.75, 1.25, 1.75, 2.25], [0.75, 1.25, 1.75, 2.25]))
    inside = np.hypot(x - 1.5, y - 1.5) < 1
    x, y = x[inside], y[inside]
    return x, y, -(y - 1.5), x - 1.5


def draw_step(path):
    figure, panels = pyplot.subplots(1, 4, figsize=(11, 3.1), constrained_layout=True)
    x, y, u, v = points()
    node = (2.0, 2.0)
    for axes, title in zip(panels, ("P2G", "grid update", "G2P", "points move")):
        axes.set_title(title, fontsize=11)
    near = (np.abs(x - node[0]) < 1) & (np.abs(y - node[1]) < 1)
    axes = panels[0]
    grid(axes)
    axes.plot(x, y, "o", color=COLOURS[0], markersize=5)
    for a, b in zip(x[near], y[near]):
        axes.annotate("", node, (a, b), arrowprops=dict(arrowstyle="->", color=COLOURS[1]))
    axes.text(1.5, -0.65, "mass, momentum, force\ncollected by a node", ha="center", va="center", fontsize=8)
    axes = panels[1]
    nx, ny = grid(axes)
    axes.quiver(nx, ny, -(ny - 1.5), nx - 1.5, color=COLOURS[1], scale=24, width=0.012)
    axes.text(1.5, -0.65, "velocities of nodes: forces,\nwalls, contact", ha="center", va="center", fontsize=8)
    axes = panels[2]
    grid(axes)
    axes.plot(x, y, "o", color=COLOURS[0], markersize=5)
    for a in (1, 2):
        for b in (1, 2):
            axes.annotate("", (1.75, 1.75), (a, b), arrowprops=dict(arrowstyle="->", color=COLOURS[1]))
    axes.text(1.5, -0.65, "velocity and its gradient at a point;\nstrain, stress by the law", ha="center", va="center", fontsize=8)
    axes = panels[3]
    grid(axes)
    axes.plot(x, y, "o", color=GREY, markersize=5)
    axes.plot(x + 0.3 * u, y + 0.3 * v, "o", color=COLOURS[0], markersize=5)
    axes.quiver(x, y, u, v, color=COLOURS[0], angles="xy", scale_units="xy", scale=1 / 0.3, width=0.008)
    axes.text(1.5, -0.65, "the grid keeps nothing;\nthe next step begins anew", ha="center", va="center", fontsize=8)
    figure.savefig(path, dpi=110, bbox_inches="tight")


def spline(x, degree):
    """Cardinal B-spline about 0, in cells (Cox and de Boor)."""
    knots = np.arange(degree + 2) - (degree + 1) / 2
    values = [((x >= a) & (x < b)) * 1.0 for a, b in zip(knots, knots[1:])]
    for k in range(1, degree + 1):
        values = [(x - knots[i]) / k * values[i] + (knots[i + k + 1] - x) / k * values[i + 1] for i in range(len(values) - 1)]
    return values[0]


def draw_shapes(path):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.0), constrained_layout=True)
    x = np.linspace(-2.2, 2.2, 1761)
    smooth = np.convolve(spline(x, 1), np.full(200, 1 / 200), "same")  # uGIMP, points of half a cell
    for k, (name, values) in enumerate((("LinearGrid, LinearSimplex", spline(x, 1)), ("UGimp<2>", smooth),
                                        ("QuadraticBSpline", spline(x, 2)), ("CubicBSpline", spline(x, 3)))):
        left.plot(x, values, color=COLOURS[k], label=name, linewidth=1.5)
        right.plot(x, np.gradient(values, x), color=COLOURS[k], linewidth=1.5)
    left.set(title="value N", xlabel="distance from the node [cells]")
    right.set(title="slope dN/dx", xlabel="distance from the node [cells]")
    left.legend(frameon=False, fontsize=8)
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    draw_step(HERE / "images" / "concepts_step.png")
    draw_shapes(HERE / "images" / "concepts_shapes.png")
