"""Co-simulation: a spring outside of the scene drives the cone; between two steps Python takes the force of the sand and gives
the velocity. Gives: 32 mm deep after 0.05 s, on its way back at 1.0 m/s."""

import numpy as np

import arenite as ar

sand = ar.MohrCoulomb(density=1540, young=5e6, poisson=0.33, friction=np.radians(35))
velocity = ar.Signal(0, -2, 0)
cone = ar.Rigid(ar.ConeCylinder(radius=0.02, apex=np.radians(60), length=0.3, tip=0.2), ar.Prescribed(velocity),
                friction=np.radians(20), name="cone")
scene = ar.Scene(ar.Axisymmetric(), ar.CartesianGrid((0, 0), (0.15, 0.3), cell=0.01), ar.Numerics(ar.QuadraticBSpline),
                 bodies=[ar.fill("sand", ar.Box((0, 0), (0.15, 0.2)), sand)], walls=[ar.bottom("fixed"), ar.right("roller")],
                 gravity=(0, -9.81), rigids=[cone])

mass, stiffness, speed = 1.0, 2e3, -2.0  # kg, N/m, m/s
for dt in scene.steps(end=0.05):
    body = scene.rigids["cone"]
    force = body.force[1] - stiffness * body.displacement[1] - mass * 9.81  # the spring hangs the cone up
    speed += dt * force / mass
    velocity.set(0, speed, 0)
print(f"after {scene.time:.3f} s the cone lies {-scene.rigids['cone'].displacement[1]:.4f} m deep and moves at {speed:.3f} m/s")
