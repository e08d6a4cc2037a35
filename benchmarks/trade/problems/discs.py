"""Two discs that collide."""

import numpy as np

import arenite as ar
from common import Points, elastic_scene

TITLE = "Two discs that collide"
KIND = "collision"
SOURCE = """Two elastic discs fly at each other along the diagonal of a square and rebound, by the grid alone (Sulsky, Chen and Schreyer 1994,
doi:10.1016/0045-7825(94)90112-0): radii of 0.2 m, centres at (0.3, 0.3) and (0.7, 0.7) m, E = 1 MPa, nu = 0.3, 1,000 kg/m3, each at 0.02 of the wave speed in
both directions, until 2.5 times the time in which they would meet. Nothing dissipates: the kinetic and elastic energy of the start is there at the end."""
ERROR = "relative difference of the energy at the end from that at the start"
CELLS, ORDER = (8, 16, 32), "none, contact by the grid begins a cell before the discs touch"
CELLS_ARE = "along a radius"
LAW = ar.LinearElastic(density=1000, young=1e6, poisson=0.3)
RADIUS, CENTRES = 0.2, ((0.3, 0.3), (0.7, 0.7))
WAVE = np.sqrt(LAW.young * (1 - LAW.poisson) / (1 + LAW.poisson) / (1 - 2 * LAW.poisson) / LAW.density)
SPEED = 0.02 * WAVE
TIME = 2.5 * (np.sqrt(2) * 0.4 - 2 * RADIUS) / (2 * np.sqrt(2) * SPEED)


def lower(x):
    return x.sum(axis=1) < 1


def velocity(x):
    return np.where(lower(x), SPEED, -SPEED)[:, None] * np.ones(2)


def energy(p, volume):
    """Kinetic and elastic, J/m."""
    xx, yy, zz, xy = p.stress[:, 0], p.stress[:, 1], p.stress[:, 2], p.stress[:, 3]
    elastic = ((1 + LAW.poisson) * (xx**2 + yy**2 + zz**2 + 2 * xy**2) - LAW.poisson * (xx + yy + zz)**2) / (2 * LAW.young)
    return (p.mass * (p.velocity**2).sum(axis=1)).sum() / 2 + (volume * elastic).sum()


def solve(composition, cells, per_cell, courant, clock):
    discs = ar.Ball(CENTRES[0], RADIUS) | ar.Ball(CENTRES[1], RADIUS)
    scene = elastic_scene(composition, TIME, (0, 0), (1, 1), RADIUS / cells, per_cell, discs, LAW, velocity=velocity)
    body, start = scene.bodies["body"], Points(scene)
    first = lower(start.position)
    before = energy(start, start.mass / LAW.density)
    clock.run(scene, TIME, courant)
    end = Points(scene)
    after = energy(end, np.asarray(body.volume)[np.argsort(np.asarray(body.column("id")))])
    back = -(end.mass[:, None] * end.velocity)[first].sum() / (end.mass[first].sum() * 2 * SPEED)
    return {"error": abs(after / before - 1), "energy": after / before, "restitution": back}
