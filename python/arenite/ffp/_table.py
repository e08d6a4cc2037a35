"""The results of a sweep of drops as a table."""

from __future__ import annotations

from typing import Any, Dict, Sequence, Tuple

from .._rows import Rows
from ._drop import Drop

__all__ = ["Table"]


class Table(Rows):
    """A row a drop. `table["final_penetration_m"]` is a column as an array [rows]; iteration gives rows as dicts; numbers that a drop
    does not have are NaN. `to_pandas()` gives the pandas.DataFrame, `plot()` a picture over what was swept."""

    KIND = "drop"

    def __init__(self, rows: Sequence[Dict[str, Any]], drops: Sequence[Drop], swept: Sequence[str], results: Sequence[str],
                 bars: Sequence[str] = ()) -> None:
        super().__init__(rows, swept, results, bars)
        self.drops: Tuple[Drop, ...] = tuple(drops)  #: the drops of the rows, in their order
