#!/usr/bin/env python3
"""Times the steps of one scene from Python and from C++, in turns in one run, and prints the median of the ratios.

    python_steps.py [--pairs 15] [--cell 0.002]     with a Python that has the package arenite, and its compiler
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import arenite as ar
from arenite import _compile, _plugins

PROGRAM = Path(__file__).resolve().parent.parent / "python" / "tests" / "column.cpp"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pairs", type=int, default=15)
    parser.add_argument("--cell", type=float, default=0.002, help="edge of a cell, m: 4 points each [0.002]")
    parser.add_argument("--end", type=float, default=0.02, help="s [0.02]")
    arguments = parser.parse_args()
    sand = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=np.radians(35))
    ratios, loops, steps = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        program = os.path.join(folder, "column")
        subprocess.run([*_compile.compiler(), "-std=c++20", "-O3", "-DNDEBUG", *_plugins.WIDTHS[_plugins.width()]["flags"],
                        *(f"-isystem{f}" for f in _compile.include_folders()), str(PROGRAM), "-o", program, "-pthread"],
                       check=True)
        for _ in range(arguments.pairs):
            said = subprocess.run([program, str(arguments.end), str(arguments.cell)], check=True, capture_output=True,
                                  text=True).stdout.split()
            there, steps = float(said[0]), int(said[1])
            for step_by_step, into in ((False, ratios), (True, loops)):
                scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=arguments.cell),
                                 ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                                 bodies=[ar.fill("sand", ar.Box((0, 0), (0.1, 0.15)), sand)],
                                 walls=[ar.bottom("fixed"), ar.left("roller")], gravity=(0, -9.81))
                begin = time.perf_counter()
                if step_by_step:
                    for _ in scene.steps(end=arguments.end):
                        pass
                else:
                    ar.run(scene, end=arguments.end)
                into.append((time.perf_counter() - begin) / there)
                assert scene.step_count == steps
    print(f"{len(scene.bodies['sand'])} points, {steps} steps, {arguments.pairs} pairs: ar.run takes "
          f"{statistics.median(ratios):.3f} of the time of C++, a loop over scene.steps {statistics.median(loops):.3f}")


if __name__ == "__main__":
    sys.exit(main())
