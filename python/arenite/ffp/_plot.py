"""The picture of a drop: depth and deceleration against time, measured ones beside it. Needs matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy

from .._errors import Error
from ._curve import Curve
from ._optional import need

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["draw"]

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")  # Okabe and Ito


def draw(curves: Sequence[Curve], ax: Any = None) -> Figure:
    """Draws curves into two axes, of a new figure unless given; into one, depth alone. Returns the figure."""
    pyplot = need("matplotlib.pyplot", "plot()")
    if ax is None:
        _, ax = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    axes = list(numpy.ravel(ax))
    if not 1 <= len(axes) <= 2 or not all(hasattr(one, "plot") for one in axes):
        raise Error("plot.ax: must be one pair of axes of matplotlib, or two of them for depth and deceleration")
    draw_depth(curves, axes[0])
    if len(axes) == 2:
        draw_deceleration(curves, axes[1])
    figure: Figure = axes[0].figure
    return figure


def draw_depth(curves: Sequence[Curve], axes: Any) -> None:
    for k, curve in enumerate(curves):
        axes.plot(curve.time * 1e3, curve.depth * 1e2, color=COLOURS[k % len(COLOURS)], label=curve.name)
    axes.set(xlabel="time [ms]", ylabel="depth [cm]")
    axes.spines[["top", "right"]].set_visible(False)
    if not axes.yaxis_inverted():
        axes.invert_yaxis()
    axes.legend(frameon=False, fontsize=9)


def draw_deceleration(curves: Sequence[Curve], axes: Any) -> None:
    for k, curve in enumerate(curves):
        colour = COLOURS[k % len(COLOURS)]
        axes.plot(curve.time * 1e3, curve.deceleration, color=colour, alpha=0.3, linewidth=0.6)
        axes.plot(curve.time * 1e3, curve.mean, color=colour)
    # The raw deceleration chatters with the contact: the mean decides what is shown.
    lowest, greatest = min(float(numpy.nanmin(c.mean)) for c in curves), max(float(numpy.nanmax(c.mean)) for c in curves)
    room = max(0.25 * (greatest - lowest), 1)
    axes.set(xlabel="time [ms]", ylabel="deceleration [g], its mean as a line", ylim=(lowest - room, greatest + room))
    axes.axhline(0, color="#b9b9b9", linewidth=0.8, zorder=0)
    axes.spines[["top", "right"]].set_visible(False)
