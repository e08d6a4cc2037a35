"""A column of dry sand collapses, plane strain: the smallest whole scene. Gives: the toe at x = 0.263 m.

column_collapse.py [PICTURE]"""

import sys

import numpy as np

import arenite as ar

sand = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=np.radians(35))
scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01),
                 ar.Numerics(ar.QuadraticBSpline, ar.Flip(time=0.1)),
                 bodies=[ar.fill("sand", ar.Box((0, 0), (0.1, 0.15)), sand, per_cell=4)],
                 walls=[ar.bottom("fixed"), ar.left("roller"), ar.right("roller")], gravity=(0, -9.81))
ar.run(scene, end=0.4, courant=0.8)
body = scene.bodies["sand"]
print(f"the toe of the heap lies at x = {body.position[:, 0].max():.3f} m after {scene.step_count} steps")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    x, pressure = np.asarray(body.position), -np.asarray(body.stress)[:, :3].mean(axis=1)
    figure, axes = plt.subplots(figsize=(7, 3), constrained_layout=True)
    dots = axes.scatter(x[:, 0], x[:, 1], c=pressure / 1e3, s=8)
    figure.colorbar(dots, label="mean pressure [kPa]")
    axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
    figure.savefig(sys.argv[1])
