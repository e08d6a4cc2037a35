"""A cone pushed into sand at constant speed: a rigid body with a shape and a prescribed motion, and its force as a history.
Gives: 50 to 76 N at 45 to 50 mm; contact at nodes makes it rise and fall as nodes are passed."""

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
    forces.append(body.force[1])
    print(f"depth {-body.displacement[1]:.4f} m  force {body.force[1]:8.1f} N")


ar.run(scene, end=0.05, every={0.005: show})
