"""Axis-aligned displacements in a square or a cube, a manufactured solution of any stretch."""

from pathlib import Path

import numpy as np

import arenite as ar
from common import IDS, begin_with, farthest_off, mesh

HERE = Path(__file__).resolve().parent
NeoHookean = ar.compile(law=HERE.parents[1] / "examples" / "extend" / "laws" / "neo_hookean.hpp")
LAW = NeoHookean(density=1000, young=1000, poisson=0.3)
SHEAR, LAME = 1 / 2.6, 0.3 / (1.3 * 0.4)  # over the density, m2/s2
ERROR = "the greatest root mean square over the run of the points' distances from where they should be, over A"
CELLS, ORDER = (8, 16, 32), 2
CELLS_ARE = "along a side"
TIME = 1.0


def source(stretch):
    return f"""A unit square of a neo-Hookean solid (E = 1 kPa, nu = 0.3, 1,000 kg/m3) between rollers moves by u = A sin(pi X) sin(pi t),
v = -A sin(pi Y) sin(pi t) under the body force that this takes (Wallstedt and Guilkey 2008, doi:10.1016/j.jcp.2008.07.019). A = {1e3 * stretch / np.pi:.2g} mm: stretch up to
{100 * stretch:.0f} %, and points move by up to {32 * stretch / np.pi:.1f} of the finest cells. Half a period. The law is computed number by number, which levels costs."""


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
