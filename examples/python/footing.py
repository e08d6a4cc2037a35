"""A strip footing is pushed into weightless clay: a driven wall, its reaction, and local damping. Gives: the mean pressure
at failure of Prandtl (1920), (2 + pi) c, within 2 %.

footing.py [PICTURE]"""

import sys

import numpy as np

import arenite as ar

half, strength, speed, end = 0.5, 20e3, 0.01, 0.45  # of the footing m; Pa, m/s, s
clay = ar.MohrCoulomb(density=2000, young=1e4 * strength, poisson=0.3, friction=0, cohesion=strength)


def below(x):
    return (x[:, 0] <= half * (1 + 1e-9)) & (x[:, 1] > 2 - 1e-9)


footing = ar.where(below, ar.symmetry((0, 1, 0))).named("footing")  # smooth
scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (3, 2), cell=0.125), ar.Numerics(ar.QuadraticBSpline),
                 bodies=[ar.fill("clay", ar.Box((0, 0), (3, 2)), clay)],
                 walls=[ar.left("roller"), ar.right("roller"), ar.bottom("fixed")],
                 parts=[ar.Driven(footing, ar.Scaled((0, -speed, 0), ar.Ramp(over=0.2 * end))), ar.LocalDamping()], reactions=True)
curve = []  # time, impulse
for part in (0.9, 1):
    ar.run(scene, end=part * end, courant=0.9, after_step=lambda s: curve.append((s.time, s.reaction("footing").impulse[1])))
t, impulse = np.array(curve).T
pressure = -np.diff(impulse) / np.diff(t) / half / strength
last = t[1:] > 0.9 * end * (1 + 1e-9)
found, exact = np.average(pressure[last], weights=np.diff(t)[last]), 2 + np.pi
print(f"pressure {found:.3f} c, exact {exact:.3f} c, {100 * (found / exact - 1):+.2f} %")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    body = scene.bodies["clay"]
    x, shown = np.asarray(body.position), np.linalg.norm(body.velocity, axis=1) / speed
    figure, (side, history) = plt.subplots(1, 2, figsize=(7, 3), constrained_layout=True)
    dots = side.scatter(x[:, 0], x[:, 1], c=shown, s=6)
    figure.colorbar(dots, label="speed over that of the footing")
    side.plot([0, half], [2.03, 2.03], "k", lw=4)
    side.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title="how the clay gives way")
    history.plot(1e3 * speed * np.where(t < 0.2 * end, t**2 / (0.4 * end), t - 0.1 * end)[1:], pressure, label="computed")
    history.axhline(exact, color="k", ls="--", lw=0.8, label="(2 + $\\pi$) c")
    history.set(xlabel="settlement [mm]", ylabel="pressure over c", ylim=(0, 6))
    history.legend(loc="lower right")
    figure.savefig(sys.argv[1])
