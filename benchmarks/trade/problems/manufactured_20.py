"""The manufactured solution of a square at a stretch of 20 %."""

import functools

import manufactured
from manufactured import CELLS, CELLS_ARE, ERROR, ORDER  # noqa: F401

TITLE = "Manufactured solution, large stretch"
KIND = "large strain"
SOURCE = manufactured.source(0.2)
solve = functools.partial(manufactured.solve, 0.2)
