"""Axis-aligned displacements in a square, a manufactured solution."""

from pathlib import Path

import numpy as np

import arenite as ar
from common import IDS, begin_with, farthest_off, mesh

HERE = Path(__file__).resolve().parents[1]
NeoHookean = ar.compile(law=HERE.parents[1] / "examples" / "extend" / "laws" / "neo_hookean.hpp")
LAW = NeoHookean(density=1000, young=1000, poisson=0.3)
SHEAR, LAME = 1 / 2.6, 0.3 / (1.3 * 0.4)  # over the density, m2/s2

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
    cell = 1 / cells
    force = ar.OwnPart("ManufacturedForce", str(HERE / "manufactured.hpp"), {"amplitude": A, "shear": SHEAR, "lame": LAME})
    scene = ar.Scene(ar.PlaneStrain(), mesh(composition, (0, 0), (1, 1), cell), composition.numerics(TIME), energy=False,
                     bodies=[ar.fill("body", ar.Box((0, 0), (1, 1)), LAW, per_cell=per_cell, velocity=velocity)],
                     walls=[side("roller") for side in (ar.left, ar.right, ar.bottom, ar.top)], parts=[IDS, force])
    begin_with(scene, velocity, cell)
    return {"error": farthest_off(scene, clock, courant, TIME, position) / A}
