"""Axis-aligned displacements in a square, a manufactured solution."""

import numpy as np

import arenite as ar
import manufactured as solution

TITLE = "Manufactured solution in a square"
KIND = "large strain"
SOURCE = """A unit square of a neo-Hookean solid (E = 1 kPa, nu = 0.3, 1,000 kg/m3) between rollers moves by u = A sin(pi X) sin(pi t),
v = -A sin(pi Y) sin(pi t) under the body force that this takes (Wallstedt and Guilkey 2008, doi:10.1016/j.jcp.2008.07.019). A = 50 mm: points cross up
to 1.6 cells. Half a period. The law is computed number by number, which levels costs."""
ERROR = "the greatest root mean square over the run of the points' distances from where they should be, over A"
CELLS, ORDER = (8, 16, 32), 2
CELLS_ARE = "along a side"
A = 0.05
TIME = 1.0


def position(x, t):
    return x + A * np.sin(np.pi * t) * np.sin(np.pi * x) * (1, -1)


def velocity(x):
    return np.pi * A * np.sin(np.pi * x) * (1, -1)


def solve(composition, cells, per_cell, courant, clock):
    return solution.solve(composition, (0, 0), (1, 1), 1 / cells, per_cell, courant, clock, ar.Box((0, 0), (1, 1)), False, A, A, position, velocity,
                          TIME)
