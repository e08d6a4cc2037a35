"""One drop of the penetrometer: the program's command `drop`."""

from __future__ import annotations

import warnings
from functools import cached_property
from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Union

from .._folder import Folder, PathLike
from ._curve import Curve
from ._device import with_device
from ._driver import Runs
from ._mean import moving_mean
from ._plot import draw
from ._record import Record
from ._reduction import Reduction, reduction_in
from ._run import Run
from ._text import keywords, quantity
from ._words import values_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Drop", "drop", "run_drop"]

GRAVITY = 9.81  # m/s^2, the program's


class Drop(Run):
    """A drop that was run, by `drop` or on the command line: `Drop("out/ffp")` reads the folder of one.

    `history` and `summary` are what the program wrote; names of numbers end with their units. `history` has a row at the start and
    one after each step: `history["penetration_m"]` is an array [steps + 1].
    """

    _kind = ("drop", "")

    @cached_property
    def reduction(self) -> Optional[Reduction]:
        """Bearing resistance, density and strength as practitioners read them off its deceleration; None if it was too short."""
        return reduction_in(self._folder)

    def plot(self, ax: Any = None, *, beside: Union[None, Drop, Record, Sequence[Union[Drop, Record]]] = None) -> Figure:
        """Draws depth, cm, and deceleration, g, against time since the impact, ms; returns the figure. Needs matplotlib.

        ax      axes to draw into, [2] for depth and deceleration, or one for the depth alone; without, a new figure
        beside  a measured record, another drop, or several, in the same axes
        """
        others = [] if beside is None else [beside] if isinstance(beside, (Drop, Record)) else list(beside)
        return draw([one._curve() for one in (self, *others)], ax)

    def _curve(self) -> Curve:
        time, deceleration = self.history["time_s"], self.history["acceleration_m_s2"] / GRAVITY
        return Curve(keywords(self.options) or "drop", time, self.history["penetration_m"], deceleration, moving_mean(time, deceleration))

    def __repr__(self) -> str:
        who = keywords(self.options) if self._was_told else repr(str(self.folder))
        lines = [f"Drop({who}): {self.status}"]
        if self.failure:
            lines[0] += f", {self.failure}"
        if "final_penetration_m" in self.summary:
            found, bars = self.summary, self.uncertainty or {}
            depth, peak = (quantity(found[name], unit, bars.get(name, {}).get("u"))
                           for name, unit in (("final_penetration_m", "m"), ("peak_deceleration_g", "g")))
            lines += [f"  final penetration  {depth} at {quantity(found['end_s'] * 1e3, 'ms')} "
                      f"(deepest: {quantity(found['max_penetration_m'], 'm')})",
                      f"  peak deceleration  {peak} at {quantity(found['peak_time_s'] * 1e3, 'ms')} (mean over 2 ms)"]
        return "\n".join(lines)


def drop(*, out: Optional[PathLike] = None, quiet: bool = True, **options: object) -> Drop:
    """Drops the penetrometer into sand, as `arenite-ffp drop` does; without options the paper's case, which takes seconds.

    out      folder of the results. One that holds the finished drop of the same inputs is read and nothing is run; one that was
             interrupted goes on; what any other drop left there is removed. Without, a temporary folder that goes with the result
    quiet    False: the program's progress goes to standard error
    options  of `arenite.ffp.help("drop")`, with units and limits: `delta=32` (deg), `cell=0.005` (m), `tip="blunt"`, `error_bar=True`;
             flags and options of on and off take True and False, None is an option that is not given. `resume=False` runs anew
             whatever `out` holds, `resume=True` refuses a folder of other inputs. `penetrometer` takes a `Device`, too

    Raises `Error` if an option or the folder cannot be used, and `RunError` if the drop fails on its way; what it wrote until then stays
    in `out`. What it warns of is issued as warnings. Ctrl-C ends it after its step, and the same call with `out` goes on from there.
    """
    done = run_drop(Runs(), Folder(out), options, quiet, keeps=out is not None)
    for text in done.summary.get("warnings", []):
        warnings.warn(text, stacklevel=3)
    return done


def run_drop(runs: Runs, folder: Folder, options: Mapping[str, object], quiet: bool, keeps: bool) -> Drop:
    """The drop in a folder, run or found there. `keeps`: the folder may hold an earlier one."""
    values = values_of("drop", {**with_device(options), "out": folder.path, "quiet": bool(quiet)})
    tries = [values]
    if keeps and options.get("resume") is None:
        tries.insert(0, {**values, "resume": True})
    for attempt in tries:
        ending = runs.run({"command": "drop", "options": attempt}, quiet)
        # Of other inputs, or no drop: then it is run anew.
        if not (ending.code == 2 and ending.sentence.startswith("--resume: ")):
            break
    ending.check()
    return Drop(folder, options)
