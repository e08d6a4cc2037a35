"""A square block spins freely."""

import numpy as np

import arenite as ar
from common import Points, elastic_scene

TITLE = "Block that spins"
KIND = "rotation"
SOURCE = """A rigid rotation: one turn; the middle of a side goes at 0.03 of the wave speed, so that the block swells by some 0.0005 of its
size, which is where errors end."""
ERROR = "RMS distance of the points from where the rotation takes them, over that from the middle"
CELLS, ORDER = (8, 16, 32), 2
CELLS_ARE = "along a side"
LAW = ar.LinearElastic(density=1000, young=1e5, poisson=0.3)
SIDE = 1.0
WAVE = np.sqrt(LAW.young * (1 - LAW.poisson) / (1 + LAW.poisson) / (1 - 2 * LAW.poisson) / LAW.density)
RATE = 0.03 * WAVE / (SIDE / 2)
TIME = 2 * np.pi / RATE


def solve(composition, cells, per_cell, courant, clock):
    def velocity(x):
        return RATE * np.stack([-x[:, 1], x[:, 0]], axis=1)

    scene = elastic_scene(composition, TIME, (-SIDE, -SIDE), (SIDE, SIDE), SIDE / cells, per_cell,
                          ar.Box((-SIDE / 2, -SIDE / 2), (SIDE / 2, SIDE / 2)), LAW, velocity=velocity)
    start = Points(scene)
    clock.run(scene, TIME, courant)
    end, angle = Points(scene), RATE * scene.time
    turned = start.position @ np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])

    def momentum(p):
        return (p.mass * (p.position[:, 0] * p.velocity[:, 1] - p.position[:, 1] * p.velocity[:, 0])).sum()

    def energy(p):
        return (p.mass * (p.velocity**2).sum(axis=1)).sum()

    lag = np.arctan2((turned[:, 0] * end.position[:, 1] - turned[:, 1] * end.position[:, 0]).sum(), (turned * end.position).sum())
    return {"error": np.sqrt(((end.position - turned)**2).sum() / (start.position**2).sum()), "angle": 1 + lag / angle,
            "energy": energy(end) / energy(start), "angular momentum": momentum(end) / momentum(start)}
