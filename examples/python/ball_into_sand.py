"""A steel ball falls into loose glass beads: a rigid body that is free along the axis. Gives: the depth that was measured,
0.14 / mu (rho_ball / rho_beads)^(1/2) D^(2/3) H^(1/3) (Uehara, Ambroso, Ojha and Durian 2003), within 15 %.

ball_into_sand.py [PICTURE]"""

import sys

import numpy as np

import arenite as ar

g, diameter, height, cell = 9.81, 0.0254, 0.2, 0.0254 / 10
repose = np.radians(24)  # of the beads; taken for both angles of friction
beads = ar.MohrCoulomb(density=1520, young=1e6, poisson=0.3, friction=repose)
mass = 7800 * np.pi / 6 * diameter**3
deep = 40 * cell
scene = ar.Scene(ar.Axisymmetric(), ar.CartesianGrid((0, -deep), (40 * cell, 20 * cell), cell=cell),
                 ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                 bodies=[ar.fill("beads", ar.Box((0, -deep), (40 * cell, 0)), beads, stress=ar.Geostatic(surface=0, k0=0.5))],
                 walls=[ar.bottom("fixed"), ar.left("roller"), ar.right("roller")], gravity=(0, -g),
                 rigids=[ar.Rigid(ar.Ball((0, diameter / 2), diameter / 2),
                                  ar.Guided(mass=mass, velocity=-np.sqrt(2 * g * height)), friction=repose, name="ball")])
ball = scene.rigids["ball"]
way = []  # time, depth


def watch(s):
    way.append((s.time, -ball.displacement[1]))
    return ar.STOP if ball.velocity[1] >= 0 else None


ar.run(scene, end=1, courant=0.8, after_step=watch)
depth, measured = way[-1][1], height
for _ in range(100):  # H counts from the rest of the ball
    measured = 0.14 / np.tan(repose) * np.sqrt(7800 / 1520) * diameter**(2 / 3) * np.cbrt(height + measured)
print(f"depth {1e3 * depth:.1f} mm, measured {1e3 * measured:.1f} mm, {100 * (depth / measured - 1):+.1f} %; "
      f"at rest after {scene.time:.3f} s")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt
    from matplotlib.patches import Circle

    x, pressure = np.asarray(scene.bodies["beads"].position), -np.asarray(scene.bodies["beads"].stress)[:, :3].mean(axis=1)
    figure, (side, history) = plt.subplots(1, 2, figsize=(7, 3), constrained_layout=True)
    for sign in (-1, 1):
        dots = side.scatter(1e3 * sign * x[:, 0], 1e3 * x[:, 1], c=pressure / 1e3, s=1, vmax=10)
    figure.colorbar(dots, label="mean pressure [kPa]")
    side.add_patch(Circle((0, 1e3 * (diameter / 2 - depth)), 1e3 * diameter / 2, color="grey"))
    side.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", ylim=(-102, 22), title="at rest")
    history.plot(*(1e3 * np.array(way)).T, label="computed")
    history.axhline(1e3 * measured, color="k", ls="--", lw=0.8, label="Uehara et al. 2003")
    history.set(xlabel="time [ms]", ylabel="depth [mm]", ylim=(50, 0))
    history.legend(fontsize="small", loc="lower left")
    figure.savefig(sys.argv[1])
