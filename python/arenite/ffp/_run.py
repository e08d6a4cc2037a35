"""A run of the program in its folder: what drops and pushes share."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Mapping, Optional, Union

from .._errors import Error
from .._files import read_json
from .._folder import Folder, PathLike
from ._columns import Columns

__all__ = ["Run"]


class Run:
    """`history` and `summary` are what the program wrote; names of numbers end with their units."""

    #: What it is, and a key of its inputs that no other kind has.
    _kind = ("run", "")

    def __init__(self, folder: Union[PathLike, Folder], options: Optional[Mapping[str, object]] = None) -> None:
        self._folder = folder if isinstance(folder, Folder) else Folder(folder)
        #: What it was told, as keywords; of a folder that was only read nothing (see `summary["inputs"]`).
        self.options: Dict[str, object] = dict(options or {})
        self._was_told = options is not None
        kind, key = self._kind
        try:
            #: The fields of summary.json: results, inputs, steps, warnings; None where there is no number.
            self.summary: Dict[str, Any] = read_json(self.folder / "summary.json")
            if key and key not in self.summary.get("inputs", {key: ""}):
                raise ValueError("this one is of another kind of run")
        except (OSError, ValueError) as problem:
            raise Error(f"{self.folder}: must be the folder of a {kind}, with its summary.json ({problem})") from None
        #: Columns of history.csv by name, arrays [rows].
        self.history = Columns(self._folder, "history.csv")

    @property
    def folder(self) -> Path:
        """Where its files lie, the fields for ParaView too; a temporary folder goes with this object."""
        return self._folder.path

    def __fspath__(self) -> str:
        """Its folder: a run goes wherever a path does."""
        return str(self.folder)

    @property
    def status(self) -> str:
        """"done"; or "failed", "interrupted", "disk-full", "running", and in a sweep "refused"."""
        return str(self.summary["status"])

    @property
    def failure(self) -> str:
        """When, what and where, if it is not done; else empty."""
        return str(self.summary.get("failure", ""))

    @property
    def uncertainty(self) -> Optional[Dict[str, Any]]:
        """With `error_bar=True`: of each result that has one the "value", its uncertainty "u" (None: a part is unknown) and what that is
        made of: of "final_penetration_m" and "peak_deceleration_g" of a drop, "net_resistance_kPa" of a push. Else None."""
        found: Optional[Dict[str, Any]] = self.summary.get("uncertainty")
        return found
