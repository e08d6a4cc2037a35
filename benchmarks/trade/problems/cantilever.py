"""A cantilever that hangs far under its weight."""

import numpy as np

import arenite as ar
from common import Points, come_to_rest, elastic_scene, elastica

TITLE = "Cantilever that hangs far"
KIND = "bending"
SOURCE = """The elastica (Bisshopp and Drucker 1945, Q. Appl. Math. 3, 272-275, for a load at the tip; here for a weight of q L^3 / EI = 2
along it, integrated by Runge-Kutta and checked on their tip loads), with the shear of a section of L / 6. Kinetic damping, two periods."""
ERROR = "RMS distance of the points from where the beam's sections take them, over the fall of the tip"
CELLS, ORDER = (2, 4, 8), 2
CELLS_ARE = "over the thickness"
LENGTH, THICK, G, WEIGHT = 1.0, 1 / 6, 10.0, 2.0
LAW = ar.LinearElastic(density=1000, young=12 * 1000 * G * LENGTH**3 / (WEIGHT * THICK**2), poisson=0.0)
SHEAR = (THICK / LENGTH)**2 / 5  # EI / (5/6 G A L^2), G = E / 2
TIME = 2 * np.pi / 1.8751**2 * np.sqrt(12 * LAW.density * LENGTH**4 / (LAW.young * THICK**2))


def solve(composition, cells, per_cell, courant, clock):
    h = THICK / cells
    lower, upper = (0, -0.75 * LENGTH), (1.25 * LENGTH, 0.25 * LENGTH)
    scene = elastic_scene(composition, TIME, lower, upper, h, per_cell, ar.Box((0, -THICK / 2), (LENGTH, THICK / 2)), LAW,
                          walls=[ar.left("fixed")], gravity=(0, -G))
    start = Points(scene)
    come_to_rest(scene, clock, TIME, courant)
    end = Points(scene)
    s, x, y, angle = elastica(WEIGHT, 0.0, SHEAR).T
    along, across = start.position.T
    a = np.interp(along, s, angle)
    exact = np.stack([np.interp(along, s, x) - across * np.sin(a), np.interp(along, s, y) + across * np.cos(a)], axis=1)
    speed = np.sqrt((end.velocity**2).sum(axis=1).mean()) * TIME / LENGTH
    return {"error": np.sqrt(((end.position - exact)**2).sum(axis=1).mean()) / -y[-1], "rest": speed,
            "fall": (end.position - start.position)[:, 1].min() / (exact - start.position)[:, 1].min()}
