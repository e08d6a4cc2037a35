"""The results of a sweep as a table."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any, Dict, Iterator, List, Sequence, Tuple

import numpy
from numpy.typing import NDArray

from ._drop import Drop
from ._files import replaced
from ._folder import PathLike
from ._optional import need

__all__ = ["Table"]

SHOWN_ROWS = 30
WIDE = ("failure", "folder")  # columns that a repr leaves out


class Table:
    """A row a drop. `table["final_penetration_m"]` is a column as an array [rows]; iteration gives rows as dicts; numbers that a drop
    does not have are NaN. `to_pandas()` gives the pandas.DataFrame."""

    def __init__(self, rows: Sequence[Dict[str, Any]], drops: Sequence[Drop], shown: Sequence[str]) -> None:
        self._rows = [dict(row) for row in rows]
        self._shown = tuple(shown)
        self.drops: Tuple[Drop, ...] = tuple(drops)  #: the drops of the rows, in their order
        self.columns: Tuple[str, ...] = tuple(dict.fromkeys(name for row in rows for name in row))

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name not in self.columns:
            raise KeyError(f"{name}: no such column; there are {', '.join(self.columns)}")
        values = [row.get(name) for row in self._rows]
        numeric = all(value is None or isinstance(value, (int, float)) and not isinstance(value, bool) for value in values)
        if numeric and any(value is None for value in values):
            return numpy.array([numpy.nan if value is None else value for value in values], dtype=float)
        return numpy.array(values, dtype=None if numeric or all(isinstance(value, (bool, str)) for value in values) else object)

    def __len__(self) -> int:
        """Number of rows."""
        return len(self._rows)

    def __iter__(self) -> Iterator[Dict[str, Any]]:
        return (dict(row) for row in self._rows)

    def _ipython_key_completions_(self) -> List[str]:
        return list(self.columns)

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row a drop. Needs pandas."""
        return need("pandas", "to_pandas()").DataFrame({name: self[name] for name in self.columns})

    def to_csv(self, path: PathLike) -> None:
        """Writes a line of names and a line a drop; a field without a value is empty."""
        with replaced(Path(path)) as file:
            writer = csv.DictWriter(file, self.columns)
            writer.writeheader()
            writer.writerows(self._rows)

    def __repr__(self) -> str:
        head = f"Table of {len(self)} {'drop' if len(self) == 1 else 'drops'}"
        lines = [list(self._shown), *([_field(row.get(name)) for name in self._shown] for row in self._rows[:SHOWN_ROWS])]
        widths = [max(map(len, column)) for column in zip(*lines)]
        body = ["  ".join(field.rjust(width) for field, width in zip(line, widths)) for line in lines]
        if len(self) > SHOWN_ROWS:
            body.append(f".. {len(self) - SHOWN_ROWS} more")
        others = [name for name in self.columns if name not in self._shown]
        return "\n".join([head, *body, *(["and " + ", ".join(others)] if others else [])])


def _field(value: Any) -> str:
    return "-" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)
