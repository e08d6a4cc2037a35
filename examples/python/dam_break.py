"""A dam breaks: water as a law out of a C++ header. Gives: Ritter's shallow wave (1892), which is 4/9 of the depth
where the dam was, and 8/27 h sqrt(g h) of water a second that passes there.

dam_break.py [PICTURE]"""

import sys
from pathlib import Path

import numpy as np

import arenite as ar

Water = ar.compile(law=Path(__file__).parents[1] / "extend" / "laws" / "newtonian_fluid.hpp")

depth, g, cell = 0.2, 9.81, 0.0125
wave = np.sqrt(g * depth)  # m/s
water = Water(density=1000, bulk=1000 * (20 * wave)**2, viscosity=1e-3)  # sound much faster than the wave
reservoir = 5 * depth
time = 4 * depth / wave  # s, before the wave that runs back reaches the reservoir's end
scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((-reservoir, 0), (9 * depth, 1.25 * depth), cell=cell),
                 ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                 bodies=[ar.fill("water", ar.Box((-reservoir, 0), (0, depth)), water, stress=ar.Geostatic(surface=depth, k0=1, may_move=True))],
                 walls=[ar.bottom("roller"), ar.left("roller")], gravity=(0, -g))
ar.run(scene, end=time)
body = scene.bodies["water"]
x, area = np.asarray(body.position), np.asarray(body.mass) / water.parameters["density"]
there = np.abs(x[:, 0]) < 2 * cell  # water per length, m2/m
found, passed = area[there].sum() / (4 * cell * depth), area[x[:, 0] > 0].sum() / (time * wave * depth)
print(f"at the dam {found:.3f} of the depth, theory {4 / 9:.3f}; flow {passed:.3f} h sqrt(g h), theory {8 / 27:.3f}")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    ritter = np.linspace(-wave * time, 2 * wave * time, 100)  # where the wave is
    figure, axes = plt.subplots(figsize=(7, 3), constrained_layout=True)
    dots = axes.scatter(x[:, 0], x[:, 1], c=np.asarray(body.velocity)[:, 0], s=3)
    figure.colorbar(dots, label="velocity along x [m/s]")
    axes.plot(ritter, (2 * wave - ritter / time)**2 / (9 * g), "k--", lw=1, label="Ritter 1892")
    axes.plot([-reservoir, 0, 0], [depth, depth, 0], ":", color="grey", label="at the start")
    axes.set(xlabel="x [m]", ylabel="y [m]", ylim=(0, 0.27), title=f"at {scene.time:.2f} s, heights exaggerated")
    axes.legend(loc="upper right")
    figure.savefig(sys.argv[1])
