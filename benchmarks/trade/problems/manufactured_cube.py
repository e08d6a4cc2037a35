"""The manufactured solution of a cube at a stretch of 5 %."""

import functools

import manufactured
from manufactured import CELLS_ARE, ERROR, ORDER  # noqa: F401

TITLE = "Manufactured solution in space"
KIND = "strain in space"
SOURCE = """The solution of the moderate stretch in a unit cube, w = A sin(pi Z) sin(pi t) along the third axis; "triangles" are six tetrahedra a cube."""
CELLS, DIMENSION = (8, 16, 32), 3
solve = functools.partial(manufactured.solve, 0.05, dimension=3)
