"""A composition for a kind of problem and an error, out of the measured table of docs/trade.md."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List

from . import numerics as _numerics
from ._errors import Error
from ._html import members
from .numerics import Numerics


@dataclass(frozen=True)
class Recommended:
    """What was the cheapest on one measured problem: `numerics`, the `dtype` of the mesh, points a cell (`per_cell`), the `courant` number and `cells`, counted as `cells_are` says; its
    `error` there and on finer cells, -, and the `seconds` of one core that it took there. `title`: of the problem on the page docs/trade.md; `measured`: what the problem
    is. Cells, error and seconds are those of that problem, not of yours; `print(arenite.recommend(..))` says so in words."""

    numerics: Numerics
    dtype: str
    per_cell: int
    courant: float
    cells: int
    cells_are: str
    error: float
    seconds: float
    title: str
    measured: str

    def __str__(self) -> str:
        return (f"{self.numerics}, dtype {self.dtype}, {self.per_cell} point{'s' * (self.per_cell != 1)} a cell, Courant number {self.courant:g}: the cheapest on \"{self.title}\" "
                f"(docs/trade.md): {self.measured}\nThere, and on that problem alone, {self.cells} cells {self.cells_are} had an error of {100 * self.error:.2g} % in "
                f"{self.seconds:.2g} s. Your problem has another geometry, law, weight or load: take the numerics to begin with, and refine cells until "
                "your result no longer changes.")

    def _repr_html_(self) -> str:
        return members(self, self.__dataclass_fields__)


def recommend(problem: str, error: float) -> Recommended:
    """The cheapest composition that kept to an error, -, on the measured problem of a kind: vibration, waves, impact, rotation, bending,
    rest, collision, sliding, small strain, moderate strain, large strain, large shear, bearing, flow, fall, penetration or free fall. The cells are those of that problem, given in `title` and
    `measured` (the footing of "bearing" stands on soil without weight, for one), and do not carry over: begin with the numerics, and refine cells until your result no
    longer changes. Raises `Error` for a kind that is not in the table, and where none is as exact."""
    with open(Path(__file__).parent / "_trade.csv", newline="", encoding="utf-8") as file:
        rows: List[Dict[str, str]] = list(csv.DictReader(file))
    kinds = list(dict.fromkeys(row["problem"] for row in rows))
    if problem not in kinds:
        raise Error(f"problem = {problem}: must be one of {', '.join(kinds)}")
    if not error > 0:
        raise Error(f"error = {error:g}: must be positive")
    of = [row for row in rows if row["problem"] == problem]
    enough = [row for row in of if float(row["error"]) <= error]
    if not enough:
        raise Error(f"error = {error:g}: none of the table is as exact on {problem}; the least there is {min(float(r['error']) for r in of):g}")
    best = min(enough, key=lambda row: float(row["seconds"]))
    values = {name: float(value) for name, value in (word.split("=") for word in best["values"].split())}
    shape, order, average = (getattr(_numerics, best[k]) for k in ("shape", "order", "average"))
    return Recommended(Numerics(shape, getattr(_numerics, best["transfer"])(**values), order, average), best["dtype"], int(best["per_cell"]),
                       float(best["courant"]), int(best["cells"]), best["cells_are"], float(best["error"]), float(best["seconds"]), best["title"], best["measured"])


__all__ = ["Recommended", "recommend"]
