"""A soft elastic column settles under its weight, through several cells."""

import numpy as np

import arenite as ar
from common import Points, come_to_rest, elastic_scene

TITLE = "Column that settles"
KIND = "rest"
SOURCE = """Equilibrium: sigma_yy = -rho g (H - Y) of the height Y at the start, whatever the law: between smooth walls the matter above a point
stays above it. The top sinks by some 0.1 H, 1.6, 3 and 6 cells; local and kinetic damping, four periods."""
ERROR = "RMS over the points of the difference of sigma_yy from the exact one, over rho g H"
CELLS, ORDER = (16, 32, 64), 2
CELLS_ARE = "over the height"
HEIGHT, G = 1.0, 10.0
LAW = ar.LinearElastic(density=1000, young=4e4, poisson=0.25)
MODULUS = LAW.young * (1 - LAW.poisson) / (1 + LAW.poisson) / (1 - 2 * LAW.poisson)
TIME = 4 * HEIGHT / np.sqrt(MODULUS / LAW.density)


def solve(composition, cells, per_cell, courant, clock):
    h, wide = HEIGHT / cells, HEIGHT / 4
    scene = elastic_scene(composition, TIME, (0, 0), (wide, HEIGHT + 4 * h), h, per_cell, ar.Box((0, 0), (wide, HEIGHT)), LAW,
                          walls=[ar.left("roller"), ar.right("roller"), ar.bottom("roller")], gravity=(0, -G), damping=0.7)
    start = Points(scene)
    come_to_rest(scene, clock, TIME, courant, periods=4)
    end = Points(scene)
    exact = -LAW.density * G * (HEIGHT - start.position[:, 1])
    scale = LAW.density * G * HEIGHT
    sunk = (start.position - end.position)[:, 1].max() / HEIGHT
    return {"error": np.sqrt(((end.stress[:, 1] - exact)**2).mean()) / scale, "settlement": sunk,
            "largest": np.abs(end.stress[:, 1] - exact).max() / scale}
