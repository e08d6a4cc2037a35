"""A bar between smooth walls, clamped at one end, swings in its first mode."""

import numpy as np

import arenite as ar
from common import Points, elastic_scene

TITLE = "Vibrating bar, small motion"
KIND = "vibration"
SOURCE = """Closed form: v = v0 sin(pi X / 2 L) cos(w t), w = pi / (2 L) sqrt(M / rho), of uniaxial strain (M: the modulus of pressure waves). Five
periods at strains of 1e-4: no point changes its cell."""
ERROR = "RMS over the points of the distance from the exact state in the phase plane (displacement; velocity over frequency w), over that of the mode"
CELLS, ORDER = (16, 32, 64), 2
CELLS_ARE = "along the bar"
PERIODS, STRAIN, LENGTH = 5, 1e-4, 1.0
LAW = ar.LinearElastic(density=1000, young=1e6, poisson=0.3)
WAVE = np.sqrt(LAW.young * (1 - LAW.poisson) / (1 + LAW.poisson) / (1 - 2 * LAW.poisson) / LAW.density)
W = np.pi * WAVE / (2 * LENGTH)
TIME = 2 * np.pi / W


def solve(composition, cells, per_cell, courant, clock):
    h, high = LENGTH / cells, LENGTH / 4

    def shape(x):
        return np.sin(np.pi * x[:, 0] / (2 * LENGTH))

    def velocity(x):
        return np.stack([STRAIN * WAVE * shape(x), 0 * x[:, 0]], axis=1)

    scene = elastic_scene(composition, TIME, (0, 0), (LENGTH + 4 * h, high), h, per_cell, ar.Box((0, 0), (LENGTH, high)), LAW,
                          walls=[ar.left("roller"), ar.bottom("roller"), ar.top("roller")], velocity=velocity)
    start = Points(scene)
    clock.run(scene, PERIODS * TIME, courant)
    end, t = Points(scene), scene.time
    mode = STRAIN * WAVE / W * shape(start.position)
    u = end.position[:, 0] - start.position[:, 0] - mode * np.sin(W * t)
    v = end.velocity[:, 0] / W - mode * np.cos(W * t)
    error = np.sqrt((u**2 + v**2).mean() / (mode**2).mean())
    along = [(mode * q).sum() / (mode**2).sum() for q in (end.position[:, 0] - start.position[:, 0], end.velocity[:, 0] / W)]
    phase = (np.arctan2(*along) - W * t + np.pi) % (2 * np.pi) - np.pi
    return {"error": error, "frequency": 1 + phase / (W * t), "energy": along[0]**2 + along[1]**2}
