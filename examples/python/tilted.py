"""A tilted penetrometer in space: a free rigid body falls on sand with one end ahead. Gives: 18 mm down after 0.05 s, turning at -0.76 rad/s."""

import numpy as np

import arenite as ar

sand = ar.MohrCoulomb(density=1540, young=2e6, poisson=0.3, friction=np.radians(35))
capsule = ar.Capsule((-0.03, 0.23, 0), (0.03, 0.20, 0), 0.02)  # tilted; its centre of mass in the middle
mass = 0.2
scene = ar.Scene(ar.ThreeDimensional(), ar.CartesianGrid((-0.12, 0, -0.08), (0.12, 0.28, 0.08), cell=0.02),
                 ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                 bodies=[ar.fill("sand", ar.Box((-0.12, 0, -0.08), (0.12, 0.16, 0.08)), sand, per_cell=8)],
                 walls=[ar.bottom("fixed"), ar.left("roller"), ar.right("roller"), ar.front("roller"), ar.back("roller")],
                 gravity=(0, -9.81, 0),
                 rigids=[ar.Rigid(capsule, ar.Free(mass=mass, inertia=1e-4, centre=(0, 0.215, 0), velocity=(0, -2, 0)),
                                  friction=np.radians(20), name="penetrometer")])
ar.run(scene, end=0.05)
body = scene.rigids["penetrometer"]
print(f"it went {1000 * body.displacement[1]:.1f} mm and turns at {body.spin[2]:.2f} rad/s")
