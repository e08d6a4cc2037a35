"""Generalised vortex, a manufactured solution."""

import numpy as np

import manufactured as solution

TITLE = "Generalised vortex"
KIND = "large shear"
SOURCE = """The circles of a ring, 0.75 m < R < 1.25 m, turn by A sin(pi t) h(R), h = ((4 R - 3)(4 R - 5))^2, A = 0.25 rad, so that its edges stay and carry
no load (Kamojjala, Brannon, Sadeghirad and Guilkey 2015, Engineering with Computers 31, 199-213; the solid of the square). A whole period; shear to 1.5,
points cross up to ten of the finest cells."""
ERROR = "the greatest root mean square over the run of the points' distances from where they should be, over 0.25 m"
CELLS, ORDER = (26, 52, 104), 2
CELLS_ARE = "along a side of 2.6 m"
A = 0.25
TIME = 1.0


def profile(x):
    r = np.sqrt((x**2).sum(axis=1))
    return ((4 * r - 3) * (4 * r - 5))**2


def position(x, t):
    angle = A * np.sin(np.pi * t) * profile(x)
    cos, sin = np.cos(angle), np.sin(angle)
    return np.stack([cos * x[:, 0] - sin * x[:, 1], sin * x[:, 0] + cos * x[:, 1]], axis=1)


def velocity(x):
    return (np.pi * A * profile(x))[:, None] * np.stack([-x[:, 1], x[:, 0]], axis=1)


def inside(x):
    return np.abs(np.sqrt((x**2).sum(axis=1)) - 1) < 0.25


def solve(composition, cells, per_cell, courant, clock):
    return solution.solve(composition, (-1.3, -1.3), (1.3, 1.3), 2.6 / cells, per_cell, courant, clock, inside, True, A, 0.25, position, velocity,
                          TIME)
