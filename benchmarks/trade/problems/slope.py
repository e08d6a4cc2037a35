"""A block on a slope with friction."""

import numpy as np

import arenite as ar
from common import Points, elastic_scene

TITLE = "Block on a slope"
KIND = "sliding"
SOURCE = """A block of 0.4 m x 0.1 m (E = 10 MPa, nu = 0.3, 2,000 kg/m3) on a wall with a friction of 30 deg; gravity is tilted by 20, 30 and 40 deg instead
of the wall. It starts at rest with the stresses of its weight, and after 0.3 s has travelled g (sin a - mu cos a) t^2 / 2, 88.5 mm at 40 deg, or nothing where it
sticks. At 30 deg, where it would just stick, each wave of the elastic block moves it on: that travel is in the table, not in the error."""
ERROR = "the greater difference of the travels at 20 and 40 deg from the exact ones, over the exact one at 40 deg"
CELLS, ORDER = (2, 4, 8), "none, the solution of a rigid block, from which the elastic one differs by its waves"
CELLS_ARE = "over the height"
LAW = ar.LinearElastic(density=2000, young=1e7, poisson=0.3)
WIDTH, HEIGHT, FRICTION, G, TIME = 0.4, 0.1, np.radians(30), 9.81, 0.3
SLOPES = (20, 30, 40)  # deg


def exact(slope):
    return max(0.0, G * (np.sin(slope) - np.tan(FRICTION) * np.cos(slope)) * TIME**2 / 2)


def solve(composition, cells, per_cell, courant, clock):
    h, found, errors = HEIGHT / cells, {}, []
    for degrees in SLOPES:
        slope = np.radians(degrees)
        ends = [np.ceil(x / 0.05) * 0.05 for x in (WIDTH + 2 * exact(slope) + 0.2, 2 * HEIGHT)]
        scene = elastic_scene(composition, TIME, (0, 0), tuple(ends), h, per_cell, ar.Box((0.1, 0), (0.1 + WIDTH, HEIGHT)), LAW,
                              gravity=(G * np.sin(slope), -G * np.cos(slope)), parts=[ar.FrictionalWall(ar.bottom(), FRICTION)])
        body = scene.bodies["body"]
        deep = LAW.density * G * (HEIGHT - np.asarray(body.position)[:, 1])
        shear = min(np.sin(slope), np.tan(FRICTION) * np.cos(slope))  # over the weight: what the wall can hold
        for name, part in (("yy", -np.cos(slope)), ("zz", -LAW.poisson * np.cos(slope)), ("xy", shear)):
            body.column(f"stress/{name}")[:] = part * deep
        start = Points(scene)
        clock.run(scene, TIME, courant)
        travel = (Points(scene).position - start.position)[:, 0].mean()
        found[f"travel at {degrees} deg"] = travel
        if slope != FRICTION:
            errors.append(abs(travel - exact(slope)))
    return {"error": max(errors) / exact(np.radians(SLOPES[-1])), **found}
