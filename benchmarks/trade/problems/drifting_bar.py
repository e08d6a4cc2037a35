"""A free bar between smooth walls swings in its first mode while it drifts through the mesh."""

import numpy as np

import arenite as ar
from common import Points, elastic_scene
from problems.bar import LAW, LENGTH, STRAIN, WAVE

TITLE = "Vibrating bar that drifts"
KIND = "waves"
SOURCE = """Closed form: u = V t + A cos(pi X / L) sin(w t), w = pi / L sqrt(M / rho). Three periods at strains of 1e-4, while the bar drifts
by half of its length: points cross 8, 16 and 32 cells."""
ERROR = "as for the vibrating bar, in the frame that drifts along"
CELLS, ORDER = (16, 32, 64), 2
CELLS_ARE = "along the bar"
PERIODS = 3
W = np.pi * WAVE / LENGTH
TIME = 2 * np.pi / W
DRIFT = 0.5 * LENGTH / (PERIODS * TIME)


def solve(composition, cells, per_cell, courant, clock):
    h, high = LENGTH / cells, LENGTH / 4

    def shape(x):
        return np.cos(np.pi * x[:, 0] / LENGTH)

    def velocity(x):
        return np.stack([DRIFT + STRAIN * WAVE * shape(x), 0 * x[:, 0]], axis=1)

    scene = elastic_scene(composition, TIME, (-0.25 * LENGTH, 0), (1.75 * LENGTH, high), h, per_cell, ar.Box((0, 0), (LENGTH, high)), LAW,
                          walls=[ar.bottom("roller"), ar.top("roller")], velocity=velocity)
    start = Points(scene)
    clock.run(scene, PERIODS * TIME, courant)
    end, t = Points(scene), scene.time
    mode = STRAIN * WAVE / W * shape(start.position)
    u = end.position[:, 0] - start.position[:, 0] - DRIFT * t
    v = (end.velocity[:, 0] - DRIFT) / W
    error = np.sqrt(((u - mode * np.sin(W * t))**2 + (v - mode * np.cos(W * t))**2).mean() / (mode**2).mean())
    a, b = ((mode * q).sum() / (mode**2).sum() for q in (u, v))
    return {"error": error, "energy": a**2 + b**2}
