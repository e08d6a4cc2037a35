"""A cone pushed into sand at constant speed: a rigid body with a shape and a prescribed motion, and its force as a history.
Gives: 50 to 76 N at 45 to 50 mm; contact at nodes makes it rise and fall as nodes are passed.

cone.py [PICTURE]"""

import sys

import numpy as np

import arenite as ar

sand = ar.MohrCoulomb(density=1540, young=5e6, poisson=0.33, friction=np.radians(35), cohesion=100)
cone = ar.ConeCylinder(radius=0.02, apex=np.radians(60), length=0.3, tip=0.2)
scene = ar.Scene(ar.Axisymmetric(), ar.CartesianGrid((0, 0), (0.15, 0.3), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Flip(0.99)),
                 bodies=[ar.fill("sand", ar.Box((0, 0), (0.15, 0.2)), sand, stress=ar.Geostatic(surface=0.2, k0=0.43))],
                 walls=[ar.bottom("fixed"), ar.right("roller")], gravity=(0, -9.81),
                 rigids=[ar.Rigid(cone, ar.Prescribed((0, -1)), friction=np.radians(20), name="cone")])
forces = []


def show(s):
    body = s.rigids["cone"]
    forces.append((-1e3 * body.displacement[1], body.force[1]))
    print(f"depth {-body.displacement[1]:.4f} m  force {body.force[1]:8.1f} N")


ar.run(scene, end=0.05, every={0.005: show})

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    body, tip = scene.bodies["sand"], 1e3 * (0.2 + scene.rigids["cone"].displacement[1])
    x, pressure = 1e3 * np.asarray(body.position), -np.asarray(body.stress)[:, :3].mean(axis=1) / 1e3
    figure, (side, history) = plt.subplots(1, 2, figsize=(7, 3), constrained_layout=True)
    for sign in (-1, 1):
        dots = side.scatter(sign * x[:, 0], x[:, 1], c=pressure, s=8, vmax=10)
    figure.colorbar(dots, label="mean pressure [kPa]")
    high = tip + 20 / np.tan(np.radians(30))
    side.fill([0, 20, 20, -20, -20, 0], [tip, high, 300, 300, high, tip], color="grey")
    side.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", ylim=(0, 260))
    history.plot(*np.array(forces).T, "o-")
    history.set(xlabel="depth [mm]", ylabel="force [N]")
    figure.savefig(sys.argv[1])
