"""A penetrometer pushed into the ground: the program's command `push`."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Optional

from .._folder import Folder, PathLike
from .._optional import need
from ._device import with_device
from ._driver import Runs
from ._run import Run
from ._text import keywords, quantity
from ._words import values_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Push", "push"]


class Push(Run):
    """A push that was run, by `push` or on the command line: `Push("out/push")` reads the folder of one.

    `history` and `summary` are what the program wrote; names of numbers end with their units. `history` has a row each twentieth of a
    diameter: `history["q_c_kPa"]` is an array [rows], means over that way.
    """

    _kind = ("push", "ground")

    def plot(self, ax: Any = None) -> Figure:
        """Draws the resistance q_c, MPa, over the depth of the tip, cm, downward, and returns the figure. Needs matplotlib.

        ax  axes to draw into; without, a new figure
        """
        pyplot = need("matplotlib.pyplot", "plot")
        if ax is None:
            ax = pyplot.subplots(constrained_layout=True)[1]
            ax.invert_yaxis()
        ax.plot(self.history["q_c_kPa"] / 1e3, self.history["depth_m"] * 100, label=keywords(self.options) or "push")
        ax.set_xlabel("q_c, MPa")
        ax.set_ylabel("depth of the tip, cm")
        ax.legend()
        figure: Figure = ax.figure
        return figure

    def __repr__(self) -> str:
        who = keywords(self.options) if self._was_told else repr(str(self.folder))
        lines = [f"Push({who}): {self.status}" + (f", {self.failure}" if self.failure else "")]
        if "q_c_kPa" in self.summary:
            found, bar = self.summary, (self.uncertainty or {}).get("net_resistance_kPa", {}).get("u")
            lines += [f"  net resistance  {quantity(found['net_resistance_kPa'], 'kPa', bar)} at {quantity(found['depth_m'], 'm')}",
                      f"  sleeve          {quantity(found['f_s_kPa'], 'kPa')}"]
        return "\n".join(lines)


def push(*, out: Optional[PathLike] = None, quiet: bool = True, **options: object) -> Push:
    """Pushes a penetrometer into clay or sand, as `arenite-ffp push` does; without options a standard cone into clay, which takes
    about a minute.

    out      folder of the results; what an earlier run left there is removed. Without, a temporary folder that goes with the result
    quiet    False: the program's progress goes to standard error
    options  of `arenite.ffp.help("push")`, with units and limits: `ground="sand"`, `overburden=1e5` (Pa), `rigidity_index=300`,
             `error_bar=True`; None is an option that is not given. `penetrometer` takes a `Device`, too

    Raises `Error` if an option or the folder cannot be used, and `RunError` if the push fails on its way; what it wrote until then stays
    in `out`. What it warns of is issued as warnings.
    """
    folder = Folder(out)
    values = values_of("push", {"no_picture": True, **with_device(options), "out": folder.path, "quiet": bool(quiet)})
    Runs().run({"command": "push", "options": values}, quiet).check()
    done = Push(folder, options)
    for text in done.summary.get("warnings", []):
        warnings.warn(text, stacklevel=3)
    return done
