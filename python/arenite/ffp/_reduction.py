"""Bearing resistance, density and strength read off a record of deceleration: the program's command `reduce`."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterator, Mapping, Optional

from .._errors import Error, UnknownName
from .._files import read_json
from .._folder import Folder, PathLike
from . import _driver
from ._columns import Columns
from ._device import with_device
from ._plot import draw_resistance
from ._text import quantity
from ._words import values_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Reduction", "reduce", "reduction_in"]


class Reduction(Mapping[str, Any]):
    """What a record of deceleration comes to: the fields of the program's reduced.json, as `reduction["impact_velocity_m_s"]`;
    names end with the unit. Bearing resistances are under "q_dyn" and "q_sbc", with the K, source and range of each."""

    def __init__(self, folder: Folder, found: Dict[str, Any]) -> None:
        self._folder, self._found = folder, found
        #: The record from the impact on, a row a sample: "time_s", "depth_m", "velocity_m_s", "deceleration_g",
        #: "q_dyn_mantle_kPa", "q_sbc_K1_kPa" and so on.
        self.table = Columns(folder, "reduced.csv")

    @property
    def folder(self) -> Path:
        """Where reduced.json and reduced.csv lie; a temporary folder goes with this object."""
        return self._folder.path

    @property
    def estimates(self) -> Dict[str, Dict[str, Any]]:
        """What is read off the record, by name, such as "firmness factor": each with "value" (None: the formula has no answer),
        "unit", "source", "range", "within_range", and "outside", which says why if it is not."""
        return {one["quantity"]: {key: one[key] for key in one if key != "quantity"} for one in self._found["estimates"]}

    def plot(self, ax: Any = None) -> Axes:
        """Draws q_dyn and q_sbc, kPa, against the depth, cm; returns the axes. Needs matplotlib.

        ax  axes to draw into; without, those of a new figure"""
        return draw_resistance(self, self.table, ax)

    def __getitem__(self, name: str) -> Any:
        if name not in self._found:
            raise UnknownName(f"{name}: no such number; there are {', '.join(self._found)}")
        return self._found[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def __repr__(self) -> str:
        lines = [f"Reduction of {self['file']}",
                 f"  impact             {quantity(self['impact_velocity_m_s'], 'm/s')} ({self['impact_velocity_from']})",
                 f"  depth              {quantity(self['depth_cm'], 'cm')}",
                 f"  peak deceleration  {quantity(self['peak_deceleration_g'], 'g')} at {quantity(self['peak_depth_cm'], 'cm')}"]
        for name, estimate in self.estimates.items():
            unit = "" if estimate["unit"] == "1" else estimate["unit"]
            outside = "" if estimate["within_range"] else f"; outside its range: {estimate['outside']}"
            lines.append(f"  {name}: {quantity(estimate['value'], unit).strip()} ({estimate['source']}{outside})")
        lines += [f"  warning: {text}" for text in self.get("warnings", [])]
        return "\n".join(lines)


def reduction_in(folder: Folder) -> Optional[Reduction]:
    """The reduction that lies in a folder; None if there is none."""
    path = folder.path / "reduced.json"
    try:
        return Reduction(folder, read_json(path))
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as problem:
        raise Error(f"{path}: cannot be read: {problem}") from None


def reduce(file_or_drop: PathLike, *, out: Optional[PathLike] = None, quiet: bool = True, **options: object) -> Reduction:
    """Reads bearing resistance, density and strength off a record, as `arenite-ffp reduce` does.

    file_or_drop  a table with time and deceleration (CSV), the probe's raw record (.bin), the folder of a drop, or a `Drop`; a
                  drop's inputs then stand for the options that are not given
    out           folder of reduced.json and reduced.csv; without, a temporary one that goes with the result
    quiet         False: the program's table goes to standard error
    options       of `arenite.ffp.help("reduce")`: `mass=7.71`, `unit_weight=15100`, `medium="water"`; `scale={"18g": 1.6e5}`;
                  of a table `column="Acc Z (g)"` or `column=3`, `rate=2000`; `column=("ax_g", "ay_g", "az_g"), reads="proper"`.
                  `penetrometer` takes a `Device`, too

    What the record and the options do not agree in is issued as warnings, and is in `reduction["warnings"]`. Raises `Error` if an
    option or the record cannot be used.
    """
    file = os.fspath(file_or_drop)
    folder = Folder(out)
    values = values_of("reduce", {"no_picture": True, **with_device(options), "out": folder.path, "quiet": bool(quiet)})
    _driver.run({"command": "reduce", "file": file, "options": values}, quiet).check()
    found = reduction_in(folder)
    if found is None:
        raise Error(f"{folder.path}: there is no reduced.json")
    for text in found["warnings"]:
        warnings.warn(text, stacklevel=3)
    return found
