"""Measured records of deceleration."""

from __future__ import annotations

import os
from typing import Any, Iterator, List, Mapping

import numpy
from numpy.typing import NDArray

from .._errors import UnknownName
from .._folder import PathLike
from ._curve import Curve
from ._reduction import Reduction, reduce

__all__ = ["Record", "record"]


class Record(Mapping[str, "NDArray[numpy.float64]"]):
    """A measured drop from the impact on, a value a sample, arrays [n]: "time_s" (0 at the impact), "depth_m", "velocity_m_s",
    "deceleration_g" (net, positive when it slows the penetrometer) and "filtered_deceleration_g" (its mean over a window)."""

    NAMES = ("time_s", "depth_m", "velocity_m_s", "deceleration_g", "filtered_deceleration_g")

    def __init__(self, name: str, reduction: Reduction) -> None:
        self.name = name  #: of its file
        self.reduction = reduction  #: bearing resistance, density and strength of the same record

    def __getitem__(self, name: str) -> NDArray[numpy.float64]:
        if name not in self.NAMES:
            raise UnknownName(f"{name}: no such column (others are in reduction.table); there are {', '.join(self.NAMES)}")
        return self.reduction.table[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.NAMES)

    def __len__(self) -> int:
        """Number of columns."""
        return len(self.NAMES)

    def __repr__(self) -> str:
        return f"Record({self.name!r}, {len(self['time_s'])} samples since the impact)\n{self.reduction!r}"

    def _ipython_key_completions_(self) -> List[str]:
        return list(self.NAMES)

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row a sample. Needs pandas."""
        return self.reduction.table.to_pandas()[list(self.NAMES)]

    def _curve(self) -> Curve:
        return Curve(self.name, *(self[name] for name in ("time_s", "depth_m", "deceleration_g", "filtered_deceleration_g")))


def record(path: PathLike, **options: object) -> Record:
    """Reads a measured record: a table (CSV) with a time and a deceleration, whose columns are found by their names ("time_s",
    "t [ms]", "deceleration_g", "Acceleration (m/s^2)") or told (`column`, `time_column`, `rate`), or the probe's raw .bin. Impact, velocity and depth are found as in `reduce`,
    whose options it takes: `time_unit="ms"`, `reads="proper"`, `impact_velocity=5.6`, `calibration="probe.json"`."""
    return Record(os.path.basename(os.fspath(path)), reduce(path, **options))  # type: ignore[arg-type]
