"""Two elastic discs collide and part: initial velocities, contact of bodies, momentum. Gives: momentum kept to 1e-14, and
0.86 of the speed after the collision.

discs.py [PICTURE]"""

import sys

import numpy as np

import arenite as ar

rubber = ar.LinearElastic(density=1000, young=1e6, poisson=0.3)
scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1, 1), cell=0.02), ar.Numerics(ar.QuadraticBSpline),
                 bodies=[ar.fill("left", ar.Ball((0.3, 0.3), 0.15), rubber, velocity=(1, 1)),
                         ar.fill("right", ar.Ball((0.7, 0.7), 0.15), rubber, velocity=(-1, -1))],
                 contact=ar.Coulomb(friction=0.0))


def momentum():
    return sum((np.asarray(b.velocity) * np.asarray(b.mass)[:, None]).sum(axis=0) for b in scene.bodies.values())


before = scene.energy.kinetic
kept = momentum()
ar.run(scene, end=0.11)  # pressed together
met = [(np.asarray(b.position), -np.asarray(b.stress)[:, :3].mean(axis=1)) for b in scene.bodies.values()]
ar.run(scene, end=0.4)
size = np.sqrt(2 * before * sum(b.mass.sum() for b in scene.bodies.values()))
print(f"change of momentum {np.abs(momentum() - kept).max() / size:.1e} of m v; "
      f"the left disc flies off at {scene.bodies['left'].velocity.mean(axis=0)} m/s")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(7, 3), sharex=True, sharey=True, constrained_layout=True)
    x, pressure = (np.concatenate(of) for of in zip(*met))
    dots = axes[0].scatter(x[:, 0], x[:, 1], c=pressure / 1e3, s=3, vmin=-50, vmax=100)
    for body in scene.bodies.values():
        x = np.asarray(body.position)
        axes[1].scatter(x[:, 0], x[:, 1], s=3)
        axes[1].quiver(*x.mean(axis=0), *body.velocity.mean(axis=0), scale=6)
    figure.colorbar(dots, label="mean pressure [kPa]")
    axes[0].set(aspect="equal", xlabel="x [m]", ylabel="y [m]", xlim=(0, 1), ylim=(0, 1), title="at 0.11 s")
    axes[1].set(aspect="equal", xlabel="x [m]", title="at 0.4 s")
    figure.savefig(sys.argv[1])
