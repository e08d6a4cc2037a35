"""Bodies: regions filled with points of a law."""

from __future__ import annotations

from typing import Any, Callable, Dict, Optional, Sequence, Union

from . import _recipes
from ._recipe import plain
from .laws import Law
from .shapes import Region, region_value


class Geostatic(_recipes.Geostatic):
    def value(self) -> Any:
        return {"geostatic": super().value()}


class Fill(_recipes.Fill):
    def cpp(self) -> str:
        return f"Fill<{self.law.cpp()}>"

    def value(self) -> Any:
        return {"region": region_value(self.region), "law": self.law.value(), "options": self._options()}

    def _options(self) -> Dict[str, Any]:
        names = ("per_cell", "velocity", "stress", "may_be_empty", "history", "jitter", "seed", "even", "exact_volume")
        return {name: plain(getattr(self, name)) for name in names}

    def rules(self) -> str:
        return "Fill"

    def checked(self) -> Any:
        """Options without functions of positions, which the scene calls."""
        options = {name: given for name, given in self._options().items() if not callable(given)}
        return {**options, "history": {name: given for name, given in options["history"].items() if not callable(given)}}


Field = Union[Sequence[float], Callable[[Any], Any]]


def fill(name: str, region: Region, law: Law, per_cell: Optional[int] = None, velocity: Field = (0.0, 0.0, 0.0),
         stress: Union[Geostatic, Callable[[Any], Any], None] = None, may_be_empty: bool = False,
         history: Optional[Dict[str, Any]] = None, jitter: float = 0.0, seed: int = 0, even: bool = False,
         exact_volume: bool = False) -> Fill:
    """Fills a region with points of a law.

    region: a shape, `Cells`, or a test of positions [n, 2 or 3], m, that returns [n] booleans; velocity, m/s: a
    vector, or a function of positions that returns [n, 2 or 3]; stress, Pa: `Geostatic`, or a function of positions
    that returns [n, 6] (xx, yy, zz, xy, yz, zx); history: numbers, or functions of positions that return [n], by the
    name of the law's history. Each function is called once, with all positions.

    A point stands for all of its sub-cell, if the middle of that lies in the region; with `exact_volume` for the part that
    lies in it, so that the mass is that of the region, which must be a shape. A scene warns where the two differ by 2 %."""
    return Fill(name, region, law, per_cell, velocity, stress, may_be_empty, dict(history or {}), jitter, seed, even, exact_volume)


fill.__doc__ = "\n\n".join([fill.__doc__ or "", (_recipes.Fill.__doc__ or "").partition("\n\n")[2]])


__all__ = ["Fill", "Geostatic", "fill"]
