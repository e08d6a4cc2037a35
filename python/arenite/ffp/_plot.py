"""Pictures: a drop's depth and deceleration against time, measured ones beside it; what a record is reduced to. Needs matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Sequence

import numpy

from .._errors import Error
from .._optional import need
from .._rows import COLOURS
from ._curve import Curve

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw", "draw_resistance"]



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


def draw_resistance(reduction: Mapping[str, Any], table: Mapping[str, Any], ax: Any = None) -> Axes:
    """Draws bearing resistances against depth, down to the deepest point; q_sbc between the ends of each range of K that is meant for
    the record, of all if none is."""
    pyplot = need("matplotlib.pyplot", "plot()")
    if ax is None:
        _, ax = pyplot.subplots(constrained_layout=True)
    if not hasattr(ax, "fill_betweenx"):
        raise Error("plot.ax: must be one pair of axes of matplotlib")
    area = reduction["settings"]["area_of_q_sbc"]
    down = slice(int(numpy.argmax(table["depth_m"])) + 1)  # a rebound would go back over the same depths
    depth = table["depth_m"][down] * 1e2
    ax.plot(table[f"q_dyn_{area}_kPa"][down], depth, color=COLOURS[0], label="q_dyn")
    bands: Dict[str, List[Mapping[str, Any]]] = {}
    for one in reduction["q_sbc"]:
        bands.setdefault(one["band"], []).append(one)
    meant = {band: ends for band, ends in bands.items() if ends[0]["within_range"]} or bands
    for k, (band, ends) in enumerate(meant.items()):
        colour = COLOURS[(k + 1) % len(COLOURS)]
        low, high = (table[f"q_sbc_K{'air' if band == 'air' else format(end['K'], 'g')}_kPa"][down] for end in (ends[0], ends[-1]))
        if len(ends) == 1:
            ax.plot(low, depth, color=colour, label=f"q_sbc, K = {ends[0]['K']:.2f}")
        else:
            ax.fill_betweenx(depth, high, low, color=colour, alpha=0.4, linewidth=0, label=f"q_sbc, K = {band}")
    ax.set(xlabel=f"bearing resistance on the {'mantle' if area == 'mantle' else 'section'} of the tip [kPa]", ylabel="depth [cm]")
    ax.set_xlim(left=0)
    if not ax.yaxis_inverted():
        ax.invert_yaxis()
    ax.spines[["top", "right"]].set_visible(False)
    ax.legend(frameon=False, fontsize=9)
    drawn: Axes = ax
    return drawn
