"""A penetrometer pushed into the ground: the program's command `push`."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Mapping, Optional, Union

from .._errors import Error
from .._files import read_json
from .._folder import Folder, PathLike
from .._optional import need
from ._columns import Columns
from ._device import with_device
from ._driver import Runs
from ._text import keywords, quantity
from ._words import values_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Push", "push"]


class Push:
    """A push that was run, by `push` or on the command line: `Push("out/push")` reads the folder of one.

    `history` and `summary` are what the program wrote; names of numbers end with their units.
    """

    def __init__(self, folder: Union[PathLike, Folder], options: Optional[Mapping[str, object]] = None) -> None:
        self._folder = folder if isinstance(folder, Folder) else Folder(folder)
        #: What it was told, as keywords; of a folder that was only read nothing (see `summary["inputs"]`).
        self.options: Dict[str, object] = dict(options or {})
        self._was_told = options is not None
        try:
            #: The fields of summary.json: resistance, theory beside it, inputs, warnings; None where there is no number.
            self.summary: Dict[str, Any] = read_json(self.folder / "summary.json")
            if "ground" not in self.summary["inputs"]:
                raise ValueError("that of a drop")
        except (OSError, ValueError, KeyError) as problem:
            raise Error(f"{self.folder}: must be the folder of a push, with its summary.json ({problem})") from None
        #: A row each twentieth of a diameter: `history["q_c_kPa"]` is an array [rows], means over that way.
        self.history = Columns(self._folder, "history.csv")

    @property
    def folder(self) -> Path:
        """Where its files lie; a temporary folder goes with this object."""
        return self._folder.path

    def __fspath__(self) -> str:
        """Its folder: a push goes wherever a path does."""
        return str(self.folder)

    @property
    def status(self) -> str:
        """"done"; or "failed", "interrupted", "disk-full", "running"."""
        return str(self.summary["status"])

    @property
    def failure(self) -> str:
        """When, what and where, if it is not done; else empty."""
        return str(self.summary.get("failure", ""))

    @property
    def uncertainty(self) -> Optional[Dict[str, Any]]:
        """With `error_bar=True`: of "net_resistance_kPa" the "value", its uncertainty "u" (None: a part is unknown) and its parts. Else None."""
        found: Optional[Dict[str, Any]] = self.summary.get("uncertainty")
        return found

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
        warnings.warn(text, stacklevel=2)
    return done
