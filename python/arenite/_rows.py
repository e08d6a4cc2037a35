"""The results of a sweep as a table: of any function, or of drops of the penetrometer."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union

import numpy
from numpy.typing import NDArray

from ._errors import Error, UnknownName
from ._files import replaced
from ._folder import PathLike
from ._html import table
from ._optional import need

__all__ = ["Rows"]

SHOWN_ROWS = 30
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")  #: Okabe and Ito


class Rows:
    """Rows with named columns."""

    KIND = "row"  #: what a row is

    def __init__(self, rows: Sequence[Dict[str, Any]], swept: Sequence[str], results: Sequence[str], bars: Sequence[str] = ()) -> None:
        self._rows = [dict(row) for row in rows]
        self._swept, self._results = tuple(swept), tuple(results)
        self._shown = (*swept, "status", *results, *bars)
        self.columns: Tuple[str, ...] = tuple(dict.fromkeys(name for row in rows for name in row))

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name not in self.columns:
            raise UnknownName(f"{name}: no such column; there are {', '.join(self.columns)}")
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
        """A pandas.DataFrame with a row a row. Needs pandas."""
        return need("pandas", "to_pandas()").DataFrame({name: self[name] for name in self.columns})

    def to_csv(self, path: PathLike) -> None:
        """Writes a line of names and a line a row; a field without a value is empty."""
        with replaced(Path(path)) as file:
            writer = csv.DictWriter(file, self.columns)
            writer.writeheader()
            writer.writerows(self._rows)

    def plot(self, x: Optional[str] = None, y: Union[None, str, Sequence[str]] = None, ax: Any = None) -> Any:
        """Draws columns against a swept one, a line for each combination of the others that were swept, with the error bars that
        there are. Returns the axes: one, or an array [y]. Needs matplotlib.

        x   a column; by default the first swept one of numbers
        y   one or more columns; by default the results
        ax  axes to draw into, as many as y; without, those of a new figure"""
        pyplot = need("matplotlib.pyplot", "plot()")
        numbers = [name for name in self._swept if self[name].dtype.kind in "if"]
        if x is None and not numbers:
            raise Error(f"plot: x: must be given: none of the swept columns ({', '.join(self._swept) or 'there is none'}) holds numbers")
        across = numbers[0] if x is None else x
        names = [y] if isinstance(y, str) else [name for name in self._results if self[name].dtype.kind in "if"] if y is None else list(y)
        for name in (across, *names):
            if name not in self.columns or self[name].dtype.kind not in "if":
                raise Error(f"plot: {name}: must be a column of numbers; there are "
                            f"{', '.join(c for c in self.columns if self[c].dtype.kind in 'if')}")
        if not names:
            raise Error("plot: y: must be given: the results are no numbers")
        if ax is None:
            _, ax = pyplot.subplots(1, len(names), figsize=(5 * len(names), 4), constrained_layout=True, squeeze=len(names) == 1)
            ax = ax if len(names) == 1 else ax[0]
        all_axes = list(numpy.ravel(ax))
        if len(all_axes) != len(names) or not all(hasattr(one, "errorbar") for one in all_axes):
            raise Error(f"plot.ax: must be {len(names)} pair{'s' * (len(names) > 1)} of axes of matplotlib, one a column")
        others = [name for name in self._swept if name != across]
        lines: Dict[Tuple[Any, ...], List[int]] = {}
        for k, row in enumerate(self._rows):
            lines.setdefault(tuple(_field(row.get(name)) for name in others), []).append(k)
        for axes, name in zip(all_axes, names):
            bars = self[f"u_{name}"] if f"u_{name}" in self.columns else None
            for number, (told, rows) in enumerate(lines.items()):
                at = numpy.array(rows)[numpy.argsort(self[across][rows], kind="stable")]
                axes.errorbar(self[across][at], self[name][at], None if bars is None else bars[at], marker="o", markersize=4, capsize=3,
                              color=COLOURS[number % len(COLOURS)], label=", ".join(f"{o} = {t}" for o, t in zip(others, told)))
            axes.set(xlabel=across, ylabel=name)
            axes.spines[["top", "right"]].set_visible(False)
            if others:
                axes.legend(frameon=False, fontsize=9)
        return ax

    def __repr__(self) -> str:
        head = f"Table of {len(self)} {self.KIND if len(self) == 1 else self.KIND + 's'}"
        lines = [list(self._shown), *([_field(row.get(name)) for name in self._shown] for row in self._rows[:SHOWN_ROWS])]
        widths = [max(map(len, column)) for column in zip(*lines)]
        body = ["  ".join(field.rjust(width) for field, width in zip(line, widths)) for line in lines]
        if len(self) > SHOWN_ROWS:
            body.append(f".. {len(self) - SHOWN_ROWS} more")
        others = [name for name in self.columns if name not in self._shown and any(row.get(name) not in (None, "") for row in self._rows)]
        return "\n".join([head, *body, *(["and " + ", ".join(others)] if others else [])])

    def _repr_html_(self) -> str:
        rows = ([row.get(name) for name in self._shown] for row in self._rows[:SHOWN_ROWS])
        others = [name for name in self.columns if name not in self._shown]
        more = [f".. {len(self) - SHOWN_ROWS} more rows"] if len(self) > SHOWN_ROWS else []
        return table(f"{len(self)} {self.KIND if len(self) == 1 else self.KIND + 's'}", self._shown, rows,
                     ", ".join([*more, *(["and " + ", ".join(others)] if others else [])]))


def _field(value: Any) -> str:
    return "-" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)
