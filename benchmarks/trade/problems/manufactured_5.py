"""The manufactured solution of a square at a stretch of 5 %."""

import functools

import manufactured
from manufactured import CELLS, CELLS_ARE, ERROR, ORDER  # noqa: F401

TITLE = "Manufactured solution, moderate stretch"
KIND = "moderate strain"
SOURCE = """The solution of the small stretch with A = 16 mm: stretch up to 5 %, and points move by up to 0.5 of the finest cells."""
solve = functools.partial(manufactured.solve, 0.05)
