"""A penetrometer is dropped into dry sand; its depth beside that of cells half as wide as the finest here."""

import numpy as np

import arenite as ar
from common import fall_to_rest

TITLE = "Penetrometer that is dropped"
KIND = "free fall"
FINEST = {"grid": 0.0, "triangles": 0.0}  # m
SOURCE = f"""A free-fall penetrometer of 7.71 kg, 87.5 mm wide with a cone of 60 deg, hits dry sand (40 deg, E = 5 MPa, 1,540 kg/m3) at 5.6 m/s; 20 deg between them.
Axisymmetric, a chamber of 0.4 m, a grid or triangles that do not move with it; contact at nodes, as a rule acts a part of a cell away from the surface. The law has no
length, so that shear bands are as thin as the cells allow ([accuracy of the drop](ffp_accuracy.md))."""
ERROR = f"""the depth at which it first rests, over that on 80 cells, less 1, without its sign: {FINEST['grid']:.4g} m by `quadratic; FLIP; MUSL`
for all grids and {FINEST['triangles']:.4g} m by `triangles; FLIP; MUSL; nodal and element average` for all triangles"""
CELLS, ORDER = (10, 20, 40), "none, the law has no length"
CELLS_ARE = "over the depth of the sand"
SIZE, RADIUS = 0.4, 0.04375
LAW = ar.MohrCoulomb(density=1540, young=5e6, poisson=0.33, friction=np.radians(40))


def solve(composition, cells, per_cell, courant, clock):
    depth = fall_to_rest(composition, clock, SIZE / cells, per_cell, courant, SIZE, SIZE / 2, LAW, 1 - np.sin(np.radians(40)),
                         ar.ConeCylinder(radius=RADIUS, apex=np.radians(60), length=0.631, tip=0), 7.71, 5.6, np.radians(20), 0.2)
    finest = FINEST["grid" if composition.on_grid() else "triangles"]
    return {"error": abs(depth / finest - 1), "depth": depth}
