"""A slope fails as it is dug: a trench with vertical sides in clay, in stages, each brought to rest. Gives: it stands at
rho g H / c = 3.92 and fails at 4.17; limit analysis has 3.76 to 3.79 (Pastor, Thai and Francescato 2000).

excavation.py [PICTURE]"""

import sys

import numpy as np

import arenite as ar

depth, width, strength, density, g = 6.0, 12.0, 20e3, 2000.0, 9.81
clay = ar.MohrCoulomb(density=density, young=20e6, poisson=0.3, friction=0, cohesion=strength)
scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (width, depth), cell=0.25), ar.Numerics(ar.QuadraticBSpline),
                 bodies=[ar.fill("clay", ar.Box((0, 0), (width, depth)), clay, stress=ar.Geostatic(surface=depth, k0=1))],
                 walls=[ar.left("roller"), ar.right("roller"), ar.bottom("fixed")], gravity=(0, -g), parts=[ar.LocalDamping()])

cut, stood, failed = 0.0, 0.0, 0.0
while not failed:
    cut += 1 if cut < 3 else 0.25
    ar.remove_points(scene, "clay", ar.Box((width / 2, depth - cut), (width, 2 * depth)))
    try:
        ar.settle(scene, end=scene.time + 3, courant=0.7)
        stood = cut
    except ar.RunError:  # it still moves after 3 s
        failed = cut
    print(f"{cut:.2f} m deep, rho g H / c = {density * g * cut / strength:.2f}: {'fails' if failed else 'stands'}")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    body = scene.bodies["clay"]
    x, moved = np.asarray(body.position), 1e3 * np.linalg.norm(body.velocity, axis=1)
    figure, axes = plt.subplots(figsize=(7, 3), constrained_layout=True)
    dots = axes.scatter(x[:, 0], x[:, 1], c=moved, s=4)
    figure.colorbar(dots, label="speed [mm/s]")
    axes.plot([width / 2, width / 2, width], [depth, depth - failed, depth - failed], "k:")
    axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title=f"the side of {failed:.2f} m fails")
    figure.savefig(sys.argv[1])
