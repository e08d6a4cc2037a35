"""Columns of sand collapse; their run-outs beside experiments."""

import functools

import numpy as np

import arenite as ar
from common import soil_scene

TITLE = "Columns of sand that collapse"
KIND = "flow"
SOURCE = """Run-outs of plane columns over their width, 1.2 a for ratios of height and width a < 1.8 and 1.9 a^(2/3) from 2.8 on (Lube, Huppert, Sparks
and Freundt 2005, Phys. Rev. E 72, 041301; between the two the second stands here). a = 0.5, 1 and 2 at a width of 0.1 m; angle of friction 31 deg,
E = 1 MPa, until 5 sqrt(H / g). The front is where the deposit is a fortieth of the width deep."""
ERROR = """the mean over the three columns of the relative difference of the run-out from the measured one. It contains the error of the law, which
does not fall with the cells; the two may cancel"""
CELLS, ORDER = (5, 10, 20), "none, the exact solution of the model is not known"
CELLS_ARE = "over the width"
WIDTH, G, RATIOS = 0.1, 9.81, (0.5, 1.0, 2.0)
TIME = 0.1
LAW = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=np.radians(31))


def measured(a):
    return 1.2 * a if a < 1.8 else 1.9 * a**(2 / 3)


def run_out(body):
    """The front over the width, less 1: of columns of a tenth of the width the last one without a gap that is deep enough."""
    wide = WIDTH / 10
    x, volume = np.asarray(body.position)[:, 0], np.asarray(body.volume)
    number = (x / wide).astype(int)
    deep = np.bincount(number, weights=volume) >= wide * WIDTH / 40
    shallow = np.flatnonzero(~deep[1:])
    last = shallow[0] if len(shallow) else len(deep) - 1
    return x[number == last].max() / WIDTH - 1


def solve_ratios(ratios, composition, cells, per_cell, courant, clock):
    h, found = WIDTH / cells, {}
    for a in ratios:
        high = a * WIDTH
        reach = [np.ceil(q / h - 1e-9) * h for q in (WIDTH * (2 + 1.3 * measured(a)), 1.2 * high + 2 * h)]
        scene = soil_scene(composition, TIME, (0, 0), tuple(reach), h, per_cell, ar.Box((0, 0), (WIDTH, high)), LAW,
                           [ar.bottom("fixed"), ar.left("roller")], gravity=(0, -G))
        clock.run(scene, 5 * np.sqrt(high / G), courant)
        found[f"run-out at {a:g}"] = run_out(scene.bodies["body"])
    errors = [abs(q / measured(a) - 1) for a, q in zip(ratios, found.values())]
    return {"error": np.mean(errors), **found}


solve = functools.partial(solve_ratios, RATIOS)
