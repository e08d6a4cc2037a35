"""A steel ball falls into glass beads; its depth beside an experiment."""

import numpy as np

import arenite as ar
from common import fall_to_rest

TITLE = "Ball that falls into beads"
KIND = "penetration"
SOURCE = """A steel ball of 25.4 mm falls by 0.2 m into loose glass beads. Measured depth: 0.14 / mu (rho_ball / rho_beads)^(1/2) D^(2/3) H^(1/3), H from
where it comes to rest (Uehara, Ambroso, Ojha and Durian 2003, Phys. Rev. Lett. 90, 194301). Axisymmetric, a cylinder of beads of 0.1 m, angle of repose 24 deg for
both angles of friction, E = 1 MPa."""
ERROR = "relative difference of the depth from the measured one. It contains the error of the law, which does not fall with the cells"
CELLS, ORDER = (5, 10, 20), "none, the exact solution of the model is not known"
CELLS_ARE = "over the diameter"
DIAMETER, HEIGHT, G, REPOSE = 0.0254, 0.2, 9.81, np.radians(24)
LAW = ar.MohrCoulomb(density=1520, young=1e6, poisson=0.3, friction=REPOSE)


def measured():
    depth = 0.0
    for _ in range(100):
        depth = 0.14 / np.tan(REPOSE) * np.sqrt(7800 / LAW.density) * DIAMETER**(2 / 3) * np.cbrt(HEIGHT + depth)
    return depth


def solve(composition, cells, per_cell, courant, clock):
    depth = fall_to_rest(composition, clock, DIAMETER / cells, per_cell, courant, 4 * DIAMETER, 2 * DIAMETER, LAW, 0.5,
                         ar.Ball((0, DIAMETER / 2), DIAMETER / 2), 7800 * np.pi / 6 * DIAMETER**3, np.sqrt(2 * G * HEIGHT), REPOSE, 0.2)
    return {"error": abs(depth / measured() - 1), "depth": depth}
