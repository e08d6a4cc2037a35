#!/usr/bin/env python3
"""What tiles on ranks of MPI cost, and what a model makes of it for many machines.

    ranks.py PROGRAM [--points 2e4,1e5,4e5] [--steps 50] [--latency 2e-6] [--bandwidth 1e10]

PROGRAM is benchmark.ranks. Prints a table of measurements on this machine's ranks and, from their constants, the share of linear speed-up on
up to 10,000 ranks. --latency, s, and --bandwidth, bytes/s: of a message between machines, which one machine does not tell."""

import argparse
import json
import math
import os
import subprocess

ENVIRONMENT = {**os.environ, "ARENITE_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1"}
EXCHANGES, REDUCTIONS = 7, 1  # a step of this scene
LANES = 8  # numbers a node of an exchange
LAYERS = 3  # of nodes that two portions have in common


def measure(program, ranks, tiles, points, steps):
    """The median of three, by the time of a step."""
    command = ["mpiexec", "-n", str(ranks), program, str(tiles), str(points), str(steps)]
    rows = [json.loads(subprocess.run(command, check=True, capture_output=True, text=True, env=ENVIRONMENT).stdout) for _ in range(3)]
    return sorted(rows, key=lambda r: r["step"])[1]


def shared_by_cube(points):
    """Shared nodes of a portion of so many points between others on all six sides: cubes of six tetrahedra with ten points each."""
    return 6 * LAYERS * (points / 60) ** (2 / 3)


def modelled(points, ranks, per_point, per_copy, latency, bandwidth):
    """Seconds of a step of so many points a rank."""
    if ranks == 1:
        return points * per_point
    copies = shared_by_cube(points)
    exchange = latency + per_copy * copies + 8 * LANES * copies / bandwidth
    return points * per_point + EXCHANGES * exchange + REDUCTIONS * latency * math.log2(ranks)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--points", default="2e4,1e5,4e5")
    parser.add_argument("--steps", type=int, default=50)
    parser.add_argument("--latency", type=float, default=2e-6)
    parser.add_argument("--bandwidth", type=float, default=1e10)
    given = parser.parse_args()
    print("| points | ranks x tiles | step, ms | of one rank | shared copies a rank | exchange, microseconds | ns a copy | exchanges of the step |")
    print("|---|---|---|---|---|---|---|---|")
    per_point, per_copy, changes = [], [], []
    for points in (float(p) for p in given.points.split(",")):
        alone = None
        for ranks, tiles in ((1, 1), (2, 2), (1, 8), (2, 8), (2, 16)):
            row = measure(given.program, ranks, tiles, points, given.steps)
            alone = alone or row["step"]
            copies, exchange = row["copies"], row["exchange"]
            if tiles == 1:
                per_point.append(row["step"] / row["points"])
            if ranks == tiles == 2:
                per_copy.append(exchange / copies)
            if tiles > 1:
                relocation = row["find"] + row["regroup"]
                still = f"{row['still']:.1f}, {row['before']:.2f} to {row['after']:.2f}" if row["moved_tiles"] else ""
                changes.append(f"| {row['points']} | {ranks} x {tiles // ranks} | {100 * row['migrating']:.2g} % | {1e6 * row['move']:.3g} | "
                               f"{1e6 * relocation:.3g} | {still} |")
            cells = "| | |" if tiles == 1 else f"{copies:.0f} | {1e6 * exchange:.3g} | {1e9 * exchange / copies:.0f} |"
            share = "" if tiles == 1 else f"{100 * EXCHANGES * exchange / row['step']:.2g} %"
            print(f"| {row['points']} | {ranks} x {tiles // ranks} | {1e3 * row['step']:.3g} | {row['step'] / alone:.2f} | {cells} {share} |", flush=True)
    print("\nPoints that change tiles, and tiles that change ranks; microseconds of the first tile:\n")
    print("| points | ranks x tiles | change tiles in a step | the exchange | relocation | standstill, steps, and fullest rank over the mean |")
    print("|---|---|---|---|---|---|\n" + "\n".join(changes))
    point, copy = sorted(per_point)[len(per_point) // 2], sorted(per_copy)[len(per_copy) // 2]
    print(f"\nConstants: {1e9 * point:.3g} ns a point and step, {1e9 * copy:.3g} ns a shared copy and exchange; {1e6 * given.latency:g} microseconds and "
          f"{given.bandwidth:g} bytes/s a message between machines.\n")
    counts = (1, 10, 100, 1000, 10000)
    print("| | " + " | ".join(f"{n:,} ranks" for n in counts) + " |\n|---|" + "---|" * len(counts))
    for name, of in (("weak, 1e5 points a rank", lambda n: 1e5), ("strong, 1e8 points in all", lambda n: 1e8 / n), ("strong, 1e9 points in all", lambda n: 1e9 / n)):
        shares = [of(n) * point / modelled(of(n), n, point, copy, given.latency, given.bandwidth) for n in counts]
        print(f"| {name} | " + " | ".join(f"{s:.2f}" for s in shares) + " |")


if __name__ == "__main__":
    main()
