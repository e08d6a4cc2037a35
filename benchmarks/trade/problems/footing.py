"""A smooth strip footing is pushed into weightless Tresca soil."""

import numpy as np

import arenite as ar
from common import soil_scene

TITLE = "Strip footing on Tresca soil"
KIND = "bearing"
SOURCE = """Failure at a mean pressure of (2 + pi) c (Prandtl 1920; Hill 1949), after 4 mm, a smooth footing of 1 m, half of which is computed:
3 m x 2 m without weight, c = 20 kPa, E = 10,000 c, nu = 0.3. The pressure is that of the last tenth of the time. Where functions are as wide as one cell (linear
ones, uGIMP, triangles), the last driven node bears half a cell beyond the footing, which counts as its width."""
ERROR = "relative difference of the pressure from (2 + pi) c. It may change its sign with the cells, so that an order is no measure here"
CELLS, ORDER = (2, 4, 8), "none, the pressure jumps at the edge"
CELLS_ARE = "below the half footing"
HALF, STRENGTH, WIDTH, DEPTH, SPEED, END = 0.5, 20e3, 3.0, 2.0, 0.01, 0.45
TIME = 0.2 * END  # in which the footing gets its speed
LAW = ar.MohrCoulomb(density=2000, young=1e4 * STRENGTH, poisson=0.3, friction=0, cohesion=STRENGTH)


def solve(composition, cells, per_cell, courant, clock):
    h = HALF / cells

    def below(x):
        return (x[:, 0] <= HALF * (1 + 1e-9)) & (x[:, 1] > DEPTH - 1e-9)

    wall = ar.where(below, ar.symmetry((0, 1, 0))).named("footing")
    scene = soil_scene(composition, TIME, (0, 0), (WIDTH, DEPTH), h, per_cell, ar.Box((0, 0), (WIDTH, DEPTH)), LAW,
                       [ar.left("roller"), ar.right("roller"), ar.bottom("fixed")], driven=(wall, (0, -SPEED, 0)), damping=0.7)
    clock.run(scene, 0.9 * END, courant)
    before, begin = scene.reaction("footing").impulse[1], scene.time
    clock.run(scene, END, courant)
    force = (before - scene.reaction("footing").impulse[1]) / (scene.time - begin)
    bears = HALF + (h / 2 if composition.shape in ("linear", "uGIMP", "triangles") else 0)
    pressure = force / bears / STRENGTH
    return {"error": abs(pressure / (2 + np.pi) - 1), "pressure over c": pressure}
