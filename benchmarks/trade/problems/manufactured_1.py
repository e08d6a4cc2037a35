"""The manufactured solution of a square at a stretch of 1 %."""

import functools

import manufactured
from manufactured import CELLS, CELLS_ARE, ERROR, ORDER  # noqa: F401

TITLE = "Manufactured solution, small stretch"
KIND = "small strain"
SOURCE = """A unit square of a neo-Hookean solid (E = 1 kPa, nu = 0.3, 1,000 kg/m3) between rollers moves by u = A sin(pi X) sin(pi t),
v = -A sin(pi Y) sin(pi t) under the body force that this takes (Wallstedt and Guilkey 2008, doi:10.1016/j.jcp.2008.07.019). A = 3.2 mm: stretch up to
1 %, and points move by up to 0.1 of the finest cells. Half a period. The law is computed number by number, which levels costs."""
solve = functools.partial(manufactured.solve, 0.01)
