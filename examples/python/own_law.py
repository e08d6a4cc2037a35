"""A law of one's own: the metal with linear hardening of own_law.hpp, sheared. Gives: beyond the yield stress in shear
G H / (3 G + H) of the strain, to 1e-12.

own_law.py [PICTURE]"""

import sys
from pathlib import Path

import numpy as np

import arenite as ar

Metal = ar.compile(law=Path(__file__).parents[1] / "own_law.hpp")

shear, strength, hardening, gamma = 43e9, 400e6, 100e6, 0.1  # copper, Pa
copper = Metal(density=8930, young=2 * 1.35 * shear, poisson=0.35, strength=strength, hardening=hardening)
path = ar.drive(copper, ar.Stage(strains=(0, 0, 0, gamma / 2, 0, 0), steps=100))

tangent = shear * hardening / (3 * shear + hardening)
exact = strength / np.sqrt(3) + tangent * (gamma - strength / np.sqrt(3) / shear)
found = path.stress[-1, 3]
print(f"sheared by {gamma}: {found / 1e6:.6f} MPa, exact {exact / 1e6:.6f} MPa; off by {abs(found / exact - 1):.0e}")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 3), constrained_layout=True)
    axes.plot(2 * path.strain[:, 3], path.stress[:, 3] / 1e6, ".", ms=4, label="own_law.hpp")
    axes.plot([0, strength / np.sqrt(3) / shear, gamma], [0, strength / np.sqrt(3) / 1e6, exact / 1e6], "k--", lw=0.8, label="closed form")
    axes.set(xlabel="shear strain $\\gamma$", ylabel="shear stress [MPa]")
    axes.legend(loc="lower right")
    figure.savefig(sys.argv[1])
