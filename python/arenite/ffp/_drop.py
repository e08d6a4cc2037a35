"""One drop of the penetrometer: the program's command `drop`."""

from __future__ import annotations

import warnings
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Mapping, Optional, Sequence, Union

from .._errors import Error
from .._files import read_json
from .._folder import Folder, PathLike
from ._columns import Columns
from ._curve import Curve
from ._device import with_device
from ._driver import Runs
from ._mean import moving_mean
from ._plot import draw
from ._record import Record
from ._reduction import Reduction, reduction_in
from ._text import keywords, quantity
from ._words import values_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Drop", "drop", "run_drop"]

GRAVITY = 9.81  # m/s^2, the program's


class Drop:
    """A drop that was run, by `drop` or on the command line: `Drop("out/ffp")` reads the folder of one.

    `history` and `summary` are what the program wrote; names of numbers end with their units.
    """

    def __init__(self, folder: Union[PathLike, Folder], options: Optional[Mapping[str, object]] = None) -> None:
        self._folder = folder if isinstance(folder, Folder) else Folder(folder)
        #: What it was told, as keywords; of a folder that was only read nothing (see `summary["inputs"]`).
        self.options: Dict[str, object] = dict(options or {})
        self._was_told = options is not None
        path = self.folder / "summary.json"
        try:
            #: The fields of summary.json: results, inputs, steps, warnings; None where there is no number.
            self.summary: Dict[str, Any] = read_json(path)
        except (OSError, ValueError) as problem:
            raise Error(f"{self.folder}: must be the folder of a drop, with its summary.json ({problem})") from None
        #: A row at the start and one after each step: `history["penetration_m"]` is an array [steps + 1].
        self.history = Columns(self._folder, "history.csv")

    @property
    def folder(self) -> Path:
        """Where its files lie, the fields for ParaView too; a temporary folder goes with this object."""
        return self._folder.path

    def __fspath__(self) -> str:
        """Its folder: a drop goes wherever a path does."""
        return str(self.folder)

    @property
    def status(self) -> str:
        """"done"; or "failed", "interrupted", "disk-full", "running", and in a sweep "refused"."""
        return str(self.summary["status"])

    @property
    def failure(self) -> str:
        """When, what and where, if it is not done; else empty."""
        return str(self.summary.get("failure", ""))

    @property
    def uncertainty(self) -> Optional[Dict[str, Any]]:
        """With `error_bar=True`: for "final_penetration_m" and "peak_deceleration_g" the "value", its uncertainty "u" (None: a part is
        unknown) and what that is made of. Else None."""
        found: Optional[Dict[str, Any]] = self.summary.get("uncertainty")
        return found

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
