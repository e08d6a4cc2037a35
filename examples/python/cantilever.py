"""A cantilever swings under its weight, which is put on at once: elastic matter, a clamped end, and a history of each step.
Gives: the period of Euler and Bernoulli's beam, 2 pi / 1.8751^2 sqrt(rho A L^4 / (E' I)), within 2 %.

cantilever.py [PICTURE]"""

import sys

import numpy as np

import arenite as ar

length, thick, g = 1.0, 0.1, 9.81
rubber = ar.LinearElastic(density=1000, young=4e7, poisson=0.3)
scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, -0.3), (1.1, 0.2), cell=0.025), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                 bodies=[ar.fill("beam", ar.Box((0, 0), (length, thick)), rubber)], walls=[ar.left("fixed")], gravity=(0, -g))

stiffness = rubber.young / (1 - rubber.poisson**2)  # in plane strain, Pa
period = 2 * np.pi / 1.8751**2 * np.sqrt(12 * rubber.density * length**4 / (stiffness * thick**2))
middle = [(0.0, thick / 2)]  # time and height of the centre of mass
ar.run(scene, end=3.5 * period, after_step=lambda s: middle.append((s.time, s.bodies["beam"].position[:, 1].mean())))

t, y = np.array(middle).T
rest = y[t < 3 * period].mean()
down = np.flatnonzero((y[:-1] > rest) & (y[1:] <= rest))  # it passes the middle of its swing on the way down
swings = t[down] + (y[down] - rest) / (y[down] - y[down + 1]) * (t[down + 1] - t[down])
found = (swings[-1] - swings[0]) / (len(swings) - 1)
print(f"period {found:.4f} s, beam theory {period:.4f} s, {100 * (found / period - 1):+.2f} %")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    x, stress = np.asarray(scene.bodies["beam"].position), np.asarray(scene.bodies["beam"].stress)[:, 0]
    figure, (side, history) = plt.subplots(1, 2, figsize=(7, 3), constrained_layout=True)
    dots = side.scatter(x[:, 0], x[:, 1], c=stress / 1e3, s=4, cmap="coolwarm")
    figure.colorbar(dots, label="stress along the beam [kPa]", orientation="horizontal")
    side.set(aspect="equal", ylim=(-0.15, 0.15), xlabel="x [m]", ylabel="y [m]", title=f"at {scene.time:.2f} s")
    history.plot(t, 1e3 * (y - y[0]), label="computed")
    history.plot(t, 1e3 * (rest - y[0]) * (1 - np.cos(2 * np.pi * t / period)), "k--", lw=0.8, label="beam theory's period")
    history.set(xlabel="time [s]", ylabel="centre of mass [mm]", ylim=(None, 18))
    history.legend(loc="upper right", ncols=2, fontsize="x-small")
    figure.savefig(sys.argv[1])
