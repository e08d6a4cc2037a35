"""A law without a scene: drained triaxial tests of sand, and the strength of Mohr-Coulomb's closed form."""

import numpy as np

import arenite as ar

phi = np.radians(35)
sand = ar.MohrCoulomb(density=1540, young=20e6, poisson=0.3, friction=phi, dilatancy=np.radians(5))
for pressure in (50e3, 100e3, 200e3):
    path = ar.drive(sand, ar.triaxial(pressure=pressure, axial=-0.05, steps=200))
    strength = pressure * np.tan(np.pi / 4 + phi / 2) ** 2 - pressure
    print(f"cell pressure {pressure / 1e3:5.0f} kPa: q = {path.q[-1] / 1e3:7.2f} kPa, closed form {strength / 1e3:7.2f} kPa, "
          f"volume {100 * path.strain[-1, :3].sum():+.2f} %")
