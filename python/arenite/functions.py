"""Functions of time for loads and motions, and signals that change between steps."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Sequence, Tuple

from . import _core, _recipes
from ._recipe import Recipe, function_value


deg = math.pi / 180  #: a degree, rad: `35 * ar.deg`


class Ramp(_recipes.Ramp):
    def value(self) -> Any:
        return {"ramp": {"to": self.to, "over": self.over, "from": self.start_value, "start": self.start}}


@dataclass(frozen=True)
class Table(Recipe):
    """Linear between rows (time in s, value), constant before the first and behind the last.

    parameter  unit    range               default  meaning
    rows       s, any  (time, value) each  needed   times that do not fall"""

    rows: Sequence[Tuple[float, float]]

    def value(self) -> Any:
        return {"table": [list(row) for row in self.rows]}


@dataclass(frozen=True)
class Scaled(Recipe):
    """A direction times a function of time, or of place and time.

    parameter  unit  range                                               default
    direction  any   up to 3 numbers                                     needed
    factor     any   a number, a function of time, or of place and time  needed"""

    direction: Sequence[float]
    factor: Any

    def value(self) -> Any:
        return {"direction": list(self.direction), "factor": function_value(self.factor)}


class Signal(Recipe):
    """Three numbers that may be changed between two steps: a velocity, m/s, or a force, N, of a co-simulation.
    The next step reads them without calling Python."""

    def __init__(self, *components: float) -> None:
        self._core = _core.Signal()
        self.set(*components)

    def set(self, *components: float) -> None:
        """Up to three components; those left out are zero."""
        self._core.set((list(components) + [0.0] * 3)[:3])

    @property
    def components(self) -> Tuple[float, float, float]:
        x, y, z = self._core.get()
        return x, y, z

    def value(self) -> Any:
        return self._core

    def __getstate__(self) -> Any:
        return self.components

    def __setstate__(self, state: Any) -> None:
        self.__init__(*state)  # type: ignore[misc]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Signal) and self.components == other.components

    def __repr__(self) -> str:
        return f"Signal{self.components}"
