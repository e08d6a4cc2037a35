"""The manufactured solution of a square at a stretch of 5 %."""

import functools

import manufactured
from manufactured import CELLS, CELLS_ARE, ERROR, ORDER  # noqa: F401

TITLE = "Manufactured solution, moderate stretch"
KIND = "moderate strain"
SOURCE = manufactured.source(0.05)
solve = functools.partial(manufactured.solve, 0.05)
