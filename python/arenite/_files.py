"""Files in and out by the program's rules: regular ones alone are read, up to a size; a link at a name is replaced, not followed."""

from __future__ import annotations

import json
import os
import stat
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any, Iterator

from ._errors import Error

__all__ = ["MOST_JSON", "MOST_TABLE", "read_bytes", "read_json", "read_text", "replaced"]

MOST_JSON = 16 << 20  #: bytes, the program's
MOST_TABLE = 64 << 30  #: bytes of a history


def read_text(path: Path, most: int) -> str:
    """The text of a file. Raises `Error` for a pipe, a device, a folder, or more than `most` bytes, and `OSError`."""
    return read_bytes(path, most).decode("utf-8")


def read_bytes(path: Path, most: int) -> bytes:
    """The content of a file, as `read_text`."""
    with open(os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0)), "rb") as file:  # waits for no writer
        found = os.fstat(file.fileno())
        if not stat.S_ISREG(found.st_mode):
            raise Error(f"{path}: must be a regular file, not a pipe or a device")
        if found.st_size > most:
            raise Error(f"{path}: has {found.st_size} bytes; must have at most {most}")
        return file.read()


def read_json(path: Path) -> Any:
    """The value in a file. Raises `Error` as `read_text` does, `OSError`, and `ValueError` if it is no JSON."""
    try:
        return json.loads(read_text(path, MOST_JSON))
    except RecursionError:
        raise Error(f"{path}: is nested too deeply for JSON of the program") from None


@contextmanager
def replaced(path: Path, binary: bool = False) -> Iterator[IO[Any]]:
    """A new file to write to, which takes the place of `path` at the end; if that is not reached, nothing has changed."""
    if path.exists() and not path.is_file():
        raise Error(f"{path}: must be a regular file, a link, or nothing")
    part = path.with_name(path.name + ".part")
    part.unlink(missing_ok=True)
    try:
        with open(part, "xb") if binary else open(part, "x", newline="", encoding="utf-8") as file:  # x: made anew
            yield file
        os.replace(part, path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise
