"""Run by test_asan.py with a scene compiled under the address sanitizer: takes views, lets points move, uses what is left."""

import gc

import numpy as np

import arenite as ar

sand = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=0.6)


def make():
    return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.02), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                    bodies=[ar.fill("sand", lambda x: (x[:, 0] < 0.1) & (x[:, 1] < 0.15), sand)],
                    walls=[ar.bottom("fixed"), ar.left("roller")], gravity=(0, -9.81), energy=False)


scene = make()
refused = 0
for _ in range(20):
    body = scene.bodies["sand"]
    views = [body.position, body.velocity, body.velocity[:, 0], body.stress, body.mass]
    views[1][:, 0] *= 1.0
    views[3][np.asarray(body.mass) > 0] *= 1.0
    ar.run(scene, end=scene.time + 5e-3)  # points change places
    for view in views:
        try:
            np.asarray(view).sum()
        except ar.Error:
            refused += 1
assert refused == 100, refused
other = scene.copy()
columns = [other.bodies["sand"].position, other.bodies["sand"].stress]
velocity = scene.bodies["sand"].velocity
del scene, body
gc.collect()
print(velocity[:, 0].max(), [np.asarray(c).sum() for c in columns])  # a view keeps its scene
print("done")
