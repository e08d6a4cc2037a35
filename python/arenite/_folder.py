"""Folders of results: the user's, or temporary ones that go with the last object that reads them."""

from __future__ import annotations

import os
import shutil
import tempfile
import weakref
from pathlib import Path
from typing import Optional, Union

from ._errors import Error

__all__ = ["Folder", "PathLike"]

PathLike = Union[str, "os.PathLike[str]"]


class Folder:
    """A folder that the user names; without a name a temporary one, which is removed when nothing holds this object any more."""

    def __init__(self, path: Optional[PathLike] = None) -> None:
        if path is not None and not (isinstance(path, (str, os.PathLike)) and os.fspath(path)):
            raise Error(f"out = {path!r}: must be the name of a folder")
        self.path = Path(tempfile.mkdtemp(prefix="arenite-") if path is None else path)
        if path is None:
            weakref.finalize(self, _remove, self.path, os.getpid())


def _remove(path: Path, owner: int) -> None:
    if os.getpid() == owner:  # a forked process has a copy of the object, but not the folder
        shutil.rmtree(path, ignore_errors=True)
