"""The manufactured solution of a square at a stretch of 1 %."""

import functools

import manufactured
from manufactured import CELLS, CELLS_ARE, ERROR, ORDER  # noqa: F401

TITLE = "Manufactured solution, small stretch"
KIND = "small strain"
SOURCE = manufactured.source(0.01)
solve = functools.partial(manufactured.solve, 0.01)
