"""Files in and out by the program's rules: regular ones alone are read, up to a size; a link at a name is replaced, not followed.
Standard library only."""

import json
import os
import stat
from contextlib import contextmanager

MOST_JSON = 16 << 20  # bytes, the program's
MOST_TABLE = 64 << 30  # bytes of a history or of fields


def opened(path, most=MOST_TABLE, mode="r", **how):
    """A file, open for reading as `open` gives it. Raises ValueError for a pipe, a device, a folder, or more than `most` bytes, and
    OSError."""
    number = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))  # waits for no writer
    try:
        found = os.fstat(number)
        if not stat.S_ISREG(found.st_mode):
            raise ValueError(f"{path}: must be a regular file, not a pipe, a device or a folder")
        if found.st_size > most:
            raise ValueError(f"{path}: has {found.st_size} bytes; must have at most {most}")
        return open(number, mode, **how)
    except BaseException:
        os.close(number)
        raise


def read_json(path):
    """The value in a JSON file. Raises ValueError also if it is none."""
    with opened(path, MOST_JSON, encoding="utf-8") as file:
        try:
            return json.load(file)
        except RecursionError:
            raise ValueError(f"{path}: is nested too deeply for JSON of the program") from None


def read_table(path, *needed):
    """Columns of a table as the program writes it, {name: [numbers]}; NaN for an empty field. A last line without its end, which a run
    that was killed may have cut, is left out. Raises ValueError, with the line, for anything else, and for a needed column that
    is not there, and OSError."""
    with opened(path, encoding="utf-8", newline="\n") as file:
        names = file.readline().rstrip("\n").split(",")
        for name in needed:
            if name not in names:
                raise ValueError(f"{path}: must have a column {name}, and commas between the columns, as the program writes it")
        rows = []
        for number, line in enumerate(file, 2):
            if not line.endswith("\n"):
                break
            fields = line[:-1].split(",")
            if len(fields) != len(names):
                raise ValueError(f"{path}: line {number}, number of fields = {len(fields)}: must be {len(names)}, as in the header")
            try:
                rows.append([float(field or "nan") for field in fields])
            except ValueError as problem:
                raise ValueError(f"{path}: line {number}: must be numbers ({problem})") from None
    return {name: [row[k] for row in rows] for k, name in enumerate(names)}


@contextmanager
def replaced(path, mode="xb"):
    """A new file to write to, made under a temporary name, which takes the place of `path` at the end."""
    part = f"{path}.part"
    if os.path.lexists(part):
        os.remove(part)
    with open(part, mode) as file:
        yield file
    os.replace(part, path)
