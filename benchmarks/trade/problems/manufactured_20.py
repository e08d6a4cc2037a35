"""The manufactured solution of a square at a stretch of 20 %."""

import functools

import manufactured
from manufactured import CELLS, CELLS_ARE, ERROR, ORDER  # noqa: F401

TITLE = "Manufactured solution, large stretch"
KIND = "large strain"
SOURCE = """The solution of the small stretch with A = 64 mm: stretch up to 20 %, and points move by up to 2.0 of the finest cells."""
solve = functools.partial(manufactured.solve, 0.2)
