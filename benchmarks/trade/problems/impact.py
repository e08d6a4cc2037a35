"""A bar hits a rigid wall."""

import numpy as np

import arenite as ar
from common import Points, elastic_scene
from problems.bar import LAW, LENGTH, WAVE

TITLE = "Bar that hits a wall"
KIND = "impact"
SOURCE = """A bar between smooth walls flies at v0 = 0.001 of the wave speed c against a rigid wall. A step of the stress, rho c v0, runs to its free end and
back, and at 2 L / c, when it would leave the wall, all of it flies back at v0 without stress (d'Alembert). The momentum
that is not back yet, and what oscillates behind the step, are missing."""
ERROR = "relative difference of the momentum of the rebound at 2 L / c (L: length, c: wave speed) from the exact one"
CELLS, ORDER = (32, 64, 128), "2/3, that of the width of a jump that a scheme of the second order disperses"
CELLS_ARE = "along the bar"
SPEED = 1e-3 * WAVE
TIME = 2 * LENGTH / WAVE


def solve(composition, cells, per_cell, courant, clock):
    h, high = LENGTH / cells, LENGTH / 4

    def velocity(x):
        return np.stack([-SPEED + 0 * x[:, 0], 0 * x[:, 0]], axis=1)

    scene = elastic_scene(composition, TIME, (0, 0), (LENGTH + 4 * h, high), h, per_cell, ar.Box((0, 0), (LENGTH, high)), LAW,
                          walls=[ar.left("roller"), ar.bottom("roller"), ar.top("roller")], velocity=velocity)
    clock.run(scene, TIME, courant)
    end = Points(scene)
    v, s = end.velocity[:, 0] / SPEED, end.stress[:, 0] / (LAW.density * WAVE * SPEED)
    return {"error": abs(v.mean() - 1), "restitution": v.mean(), "distance": np.sqrt(((v - 1)**2 + s**2).mean())}
