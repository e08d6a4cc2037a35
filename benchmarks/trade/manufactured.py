"""Scenes of manufactured solutions: a motion, the body force that it takes, and the points' distances from it."""

from pathlib import Path

import numpy as np

import arenite as ar
from common import IDS, Points, begin_with, mesh

HERE = Path(__file__).resolve().parent
NeoHookean = ar.compile(law=HERE.parent.parent / "examples" / "extend" / "laws" / "neo_hookean.hpp")
LAW = NeoHookean(density=1000, young=1000, poisson=0.3)
SHEAR, LAME = 1 / 2.6, 0.3 / (1.3 * 0.4)  # over the density, m2/s2


def solve(composition, lower, upper, cell, per_cell, courant, clock, region, vortex, amplitude, scale, position, velocity, end):
    """The greatest root mean square over the run of the points' distances from where the motion takes them, over `scale`."""
    force = ar.OwnPart("ManufacturedForce", str(HERE / "manufactured.hpp"),
                       {"vortex": float(vortex), "amplitude": amplitude, "shear": SHEAR, "lame": LAME})
    scene = ar.Scene(ar.PlaneStrain(), mesh(composition, lower, upper, cell), composition.numerics(end), energy=False,
                     bodies=[ar.fill("body", region, LAW, per_cell=per_cell, velocity=velocity)],
                     walls=[side("roller") for side in (ar.left, ar.right, ar.bottom, ar.top)], parts=[IDS, force])
    begin_with(scene, velocity, cell)
    start, worst = Points(scene).position, 0.0
    for k in range(1, 21):
        clock.run(scene, k * end / 20, courant)
        off = Points(scene).position - position(start, scene.time)
        worst = max(worst, np.sqrt((off**2).sum(axis=1).mean()) / scale)
    return {"error": worst}
