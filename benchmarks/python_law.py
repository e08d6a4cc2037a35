#!/usr/bin/env python3
"""Times `law.update` of Mohr-Coulomb, and beside it what a law in NumPy would need first: the principal stresses
(`numpy.linalg.eigh`). Prints the medians, ns a state.

    python_law.py [--states 1000000] [--repeats 9]     with a Python that has the package arenite"""

import argparse
import statistics
import time

import numpy as np

import arenite as ar


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--states", type=int, default=1_000_000)
    parser.add_argument("--repeats", type=int, default=9)
    arguments = parser.parse_args()
    n = arguments.states
    sand = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=np.radians(35))
    random = np.random.default_rng(1)
    stress = np.zeros((n, 6))
    stress[:, :3] = -1e4
    strain = 1e-2 * random.standard_normal((n, 6))
    full = random.standard_normal((n, 3, 3))
    full += full.transpose(0, 2, 1)
    times: dict = {"law.update": [], "numpy.linalg.eigh": []}
    for _ in range(arguments.repeats):
        for name, call in (("law.update", lambda: sand.update(stress, strain)), ("numpy.linalg.eigh", lambda: np.linalg.eigh(full))):
            start = time.perf_counter()
            call()
            times[name].append((time.perf_counter() - start) / n * 1e9)
    for name, values in times.items():
        print(f"{name}: {statistics.median(values):.1f} ns a state")


if __name__ == "__main__":
    main()
