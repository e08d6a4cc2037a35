"""A CSV file of numbers as a mapping from the names of its columns to arrays."""

from __future__ import annotations

import csv
from typing import Any, Dict, Iterator, List, Mapping, Optional

import numpy
from numpy.typing import NDArray

from .._errors import Error, UnknownName
from .._files import MOST_TABLE, read_text
from .._folder import Folder
from .._optional import need

__all__ = ["Columns"]


class Columns(Mapping[str, "NDArray[numpy.float64]"]):
    """Columns of a CSV file by the names in its first line, which hold the units: `columns["time_s"]` is an array [n] of floats,
    one value a row; empty fields are NaN. The file is read once, when the first column is asked for; arrays are read-only."""

    def __init__(self, folder: Folder, name: str) -> None:
        self._folder, self._name = folder, name
        self._columns: Optional[Dict[str, NDArray[numpy.float64]]] = None

    def _read(self) -> Dict[str, NDArray[numpy.float64]]:
        if self._columns is None:
            path = self._folder.path / self._name
            try:
                text = read_text(path, MOST_TABLE)
            except OSError as problem:
                raise Error(f"{path}: cannot be read: {problem.strerror}") from None
            except UnicodeDecodeError:
                raise Error(f"{path}: must be text in UTF-8") from None
            whole = text[:text.rfind("\n") + 1]  # the last row of a run that was killed may be cut
            rows: List[List[str]] = list(csv.reader(whole.splitlines()))
            if not rows:
                raise Error(f"{path}: must hold a line that names the columns")
            for line, row in enumerate(rows[1:], 2):
                if len(row) != len(rows[0]):
                    raise Error(f"{path}: line {line}, number of fields = {len(row)}: must be {len(rows[0])}, as in the header")
            try:
                table = numpy.array([[float(field or "nan") for field in row] for row in rows[1:]]).reshape(len(rows) - 1, len(rows[0]))
            except ValueError as problem:
                raise Error(f"{path}: must be a table of numbers ({problem})") from None
            table.setflags(write=False)
            self._columns = {name: table[:, k] for k, name in enumerate(rows[0])}
        return self._columns

    def __getitem__(self, name: str) -> NDArray[numpy.float64]:
        columns = self._read()
        if name not in columns:
            raise UnknownName(f"{name}: no such column; there are {', '.join(columns)}")
        return columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._read())

    def __len__(self) -> int:
        """Number of columns."""
        return len(self._read())

    def __contains__(self, name: object) -> bool:
        return name in self._read()

    def __repr__(self) -> str:
        columns = self._read()
        rows = len(next(iter(columns.values()), []))
        return f"{type(self).__name__}({self._name}, {rows} rows): {', '.join(columns)}"

    def _ipython_key_completions_(self) -> List[str]:
        return list(self._read())

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row a row and a column a column. Needs pandas."""
        return need("pandas", "to_pandas()").DataFrame({name: column.copy() for name, column in self._read().items()})
