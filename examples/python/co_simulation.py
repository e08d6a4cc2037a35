"""Co-simulation: a spring outside of the scene drives the cone; between two steps Python takes the force of the sand and gives
the velocity. Gives: 32 mm deep after 0.05 s, on its way back at 1.0 m/s.

co_simulation.py [PICTURE]"""

import sys

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
way = []  # time, depth, force of the sand, force of the spring
for dt in scene.steps(end=0.05):
    body = scene.rigids["cone"]
    force = body.force[1] - stiffness * body.displacement[1] - mass * 9.81  # the spring hangs the cone up
    speed += dt * force / mass
    velocity.set(0, speed, 0)
    way.append((scene.time, -body.displacement[1], body.force[1], -stiffness * body.displacement[1]))
print(f"after {scene.time:.3f} s the cone lies {-scene.rigids['cone'].displacement[1]:.4f} m deep and moves at {speed:.3f} m/s")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    t, depth, sand_force, spring_force = np.array(way).T
    figure, axes = plt.subplots(1, 2, figsize=(7, 3), sharex=True, constrained_layout=True)
    axes[0].plot(1e3 * t, 1e3 * depth)
    axes[0].set(xlabel="time [ms]", ylabel="depth of the cone [mm]", ylim=(45, 0))
    axes[1].plot(1e3 * t, sand_force, lw=0.8, label="of the sand, from the scene")
    axes[1].plot(1e3 * t, spring_force, label="of the spring, outside of it")
    axes[1].set(xlabel="time [ms]", ylabel="force on the cone [N]")
    axes[1].legend(fontsize="small")
    figure.savefig(sys.argv[1])
