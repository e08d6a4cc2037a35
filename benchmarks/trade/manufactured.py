"""Axis-aligned displacements in a square or a cube, a manufactured solution of any stretch."""

from pathlib import Path

import numpy as np

import arenite as ar
from common import IDS, begin_with, farthest_off, mesh

HERE = Path(__file__).resolve().parent
NeoHookean = ar.compile(law=HERE.parents[1] / "examples" / "extend" / "laws" / "neo_hookean.hpp")
LAW = NeoHookean(density=1000, young=1000, poisson=0.3)
SHEAR, LAME = 1 / 2.6, 0.3 / (1.3 * 0.4)  # over the density, m2/s2
ERROR = "the greatest RMS distance during the run of the points from their exact positions, over the amplitude A"
CELLS, ORDER = (8, 16, 32), 2
CELLS_ARE = "along a side"
TIME = 1.0


def solve(stretch, composition, cells, per_cell, courant, clock, dimension=2):
    a, signs = stretch / np.pi, np.array((1, -1, 1))[:dimension]

    def position(x, t):
        return x + a * np.sin(np.pi * t) * np.sin(np.pi * x) * signs

    def velocity(x):
        return np.pi * a * np.sin(np.pi * x) * signs

    cell, sides = 1 / cells, (ar.left, ar.right, ar.bottom, ar.top, ar.front, ar.back)[:2 * dimension]
    lower, upper, kinematics = (0,) * dimension, (1,) * dimension, {2: ar.PlaneStrain, 3: ar.ThreeDimensional}[dimension]
    force = ar.OwnPart("ManufacturedForce", str(HERE / "manufactured.hpp"), {"amplitude": a, "shear": SHEAR, "lame": LAME})
    scene = ar.Scene(kinematics(), mesh(composition, lower, upper, cell), composition.numerics(TIME), energy=False,
                     bodies=[ar.fill("body", ar.Box(lower, upper), LAW, per_cell=per_cell, velocity=velocity)],
                     walls=[side("roller") for side in sides], parts=[IDS, force])
    begin_with(scene, velocity, cell)
    return {"error": farthest_off(scene, clock, courant, TIME, position) / a}
