"""A tall column of sand collapses; its run-out beside experiments."""

import functools

from problems.collapse import CELLS_ARE, ORDER, solve_ratios  # noqa: F401

TITLE = "Tall column of sand that collapses"
KIND = "fall"
SOURCE = """As the columns above, with a ratio of height and width of 5: most of it falls before it flows. Measured run-out: 1.9 a^(2/3) = 5.6 widths. Two sizes of cells, for
five times the cost of the others."""
ERROR = "relative difference of the run-out from the measured one. It contains the error of the law, which does not fall with the cells"
CELLS = (5, 10)
solve = functools.partial(solve_ratios, (5.0,))
