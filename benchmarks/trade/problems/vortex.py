"""A ring that is twisted in its middle and back, a manufactured solution with large rotations and shear."""

import numpy as np

import arenite as ar
from common import IDS, begin_with, corner, farthest_off, mesh
from manufactured import HERE, LAW, SHEAR

TITLE = "Generalised vortex"
KIND = "large shear"
SOURCE = """A ring of a neo-Hookean solid (E = 1 kPa, nu = 0.3, 1,000 kg/m3) between radii of 0.75 and 1.25 m, free at both, is turned at each radius R by the angle
A (1 - 16 (R - 1)^2)^2 sin(pi t), A = 0.2: shear up to 1.24 at constant volume, under the body force that this takes (Brannon, Kamojjala and Sadeghirad 2011;
Kamojjala, Brannon, Sadeghirad and Guilkey 2015, doi:10.1007/s00366-013-0342-x). One second, there and back. The law is computed number by number, which
levels costs."""
ERROR = "the greatest RMS distance during the run of the points from their exact positions, over the greatest displacement"
CELLS, ORDER = (8, 16, 32), "2, less by the boundary of the ring, which is none of the cells"
CELLS_ARE = "across the ring"
INNER, OUTER, ANGLE, TIME = 0.75, 1.25, 0.2, 1.0


def profile(r):
    return (1 - 16 * (r - 1)**2)**2


def position(x, t):
    r, angle = np.hypot(*x.T), np.arctan2(x[:, 1], x[:, 0])
    turned = angle + ANGLE * np.sin(np.pi * t) * profile(r)
    return np.stack([r * np.cos(turned), r * np.sin(turned)], axis=1)


def velocity(x):
    return ANGLE * np.pi * profile(np.hypot(*x.T))[:, None] * np.stack([-x[:, 1], x[:, 0]], axis=1)


def solve(composition, cells, per_cell, courant, clock):
    cell, reach = (OUTER - INNER) / cells, 1.5
    force = ar.OwnPart("VortexForce", str(HERE / "manufactured.hpp"), {"amplitude": ANGLE, "shear": SHEAR})
    ring = ar.Ball((0, 0), OUTER) - ar.Ball((0, 0), INNER)
    scene = ar.Scene(ar.PlaneStrain(), mesh(composition, (-reach, -reach), (reach, reach), cell), composition.numerics(TIME), energy=False,
                     bodies=[ar.fill("body", ring, LAW, per_cell=per_cell, velocity=velocity)], walls=[corner((-reach, -reach))],
                     parts=[IDS, force])
    begin_with(scene, velocity, cell)
    return {"error": farthest_off(scene, clock, courant, TIME, position) / ANGLE}
