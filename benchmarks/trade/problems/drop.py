"""A penetrometer is dropped into dry sand; its depth beside that on cells half as wide as the finest here."""

import numpy as np

import arenite as ar
from common import fall_to_rest

TITLE = "Penetrometer that is dropped"
KIND = "free fall"
FINEST = 0.2058  # m, on 80 cells
SOURCE = """A free-fall penetrometer of 7.71 kg, 87.5 mm wide with a cone of 60 deg, hits dry sand (40 deg, E = 5 MPa, 1,540 kg/m3) at 5.6 m/s; 20 deg between
them. Axisymmetric, a chamber of 0.4 m, a grid or triangles that do not move with it. The law has no length, so that shear bands are as thin as the cells allow
([accuracy of the drop](ffp_accuracy.md)); triangles with both averages come to a depth nevertheless (0.149, 0.190, 0.200, 0.206 m on 10, 20, 40 and 80 cells; 0.20 m
is published), others do not (quadratic B-splines with FLIP and MUSL 0.142, 0.177, 0.221, 0.275 m)."""
ERROR = """relative difference of the depth at which it first rests from 0.2058 m, that of `triangles; FLIP; MUSL; nodal and element average` on 80 cells
(3 % more than on 40)"""
CELLS, ORDER = (10, 20, 40), "none, the law has no length"
CELLS_ARE = "over the depth of the sand"
SIZE, RADIUS = 0.4, 0.04375
LAW = ar.MohrCoulomb(density=1540, young=5e6, poisson=0.33, friction=np.radians(40))


def solve(composition, cells, per_cell, courant, clock):
    depth = fall_to_rest(composition, clock, SIZE / cells, per_cell, courant, SIZE, SIZE / 2, LAW, 1 - np.sin(np.radians(40)),
                         ar.ConeCylinder(radius=RADIUS, apex=np.radians(60), length=0.631, tip=0), 7.71, 5.6, np.radians(20), 0.2)
    return {"error": abs(depth / FINEST - 1), "depth": depth}
