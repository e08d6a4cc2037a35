#!/usr/bin/env python3
"""Runs the drop at four resolutions, each with all of its cells half as large as those before, and prints for each quantity the
order of its change and the value at which it would end, as Markdown. Drops that are there are not run again.

    resolution.py --picture resolution.png                 --law linear-rate, 16 points a cell, delta 20 and 40 deg; results in out/resolution
    resolution.py --options "--law log-rate" --levels 3    another law, without the finest cells

Build the driver first (examples/ffp/run.sh does). The picture needs matplotlib, the rest the standard library alone.
"""

import argparse
import itertools
import math
import os

import study
from regular_file import read_table

# Edges of the cells in general and at the cone, m: 1 : 2.5, from the coarsest on.
LEVELS = [(0.02, 0.008), (0.01, 0.004), (0.005, 0.002), (0.0025, 0.001)]
MESHES = {"fitted": "", "grid": "--mesh-kind grid"}
QUANTITIES = {"depth at 40 ms, m": 4, "final depth, m": 4, "peak, g": 2}  # decimals


def depth_at(place, time):
    """Depth in a drop's folder at a time of its run, m, between the rows around it."""
    table = read_table(os.path.join(place, "history.csv"), "time_s", "penetration_m")
    for (t0, depth0), (t1, depth1) in itertools.pairwise(zip(table["time_s"], table["penetration_m"])):
        if t1 >= time:
            return depth0 + (time - t0) / (t1 - t0) * (depth1 - depth0)
    raise SystemExit(f"resolution.py: {place}: the run ended before {time} s")


def convergence(values, ratio=2):
    """Order, limit and bar of the last of some values at sizes that fall by `ratio`: p = ln(d1 / d2) / ln(ratio) of the last two
    changes; limit = last + d2 / (ratio^p - 1), bar = 1.25 |d2| / (ratio^p - 1) where the changes have one sign and p lies in
    [0.5, 2], else no limit and 3 times the spread of the three. Repeats the library's error_bar/convergence.hpp for equal ratios;
    one set of numbers tests both."""
    a, b, c = values[-3:]
    first, second = b - a, c - b
    order = math.log(first / second) / math.log(ratio) if second and first / second > 0 else None
    if order is None or not 0.5 <= order <= 2:
        return order, None, 3 * (max(a, b, c) - min(a, b, c))
    rest = second / (ratio**order - 1)
    return order, c + rest, 1.25 * abs(rest)


def numbers(runs, options):
    """The quantities of one drop, in their order."""
    found = runs.drop(options)
    if found["status"] != "done":
        raise SystemExit(f"resolution.py: {runs.place(options)}: the run stopped: {found['failure']}")
    return [depth_at(runs.place(options), 0.04), found["final_penetration_m"], found["peak_deceleration_g"]]


def line(name, quantity, values):
    digits = QUANTITIES[quantity]
    order, limit, bar = convergence(values)
    change = 100 * abs(values[-1] / values[-2] - 1)
    shown = " | ".join(f"{v:.{digits}f}" for v in values)
    return (f"| {name} | {quantity} | {shown} | {change:.1f} | {'-' if order is None else f'{order:.2f}'} | "
            f"{'-' if limit is None else f'{limit:.{digits}f}'} | {bar:.{digits}f}{'' if limit is not None else ', not converged'} |")


def draw(found, sizes, path):
    pictures = study.drawing()
    figure, panels = pictures.pyplot.subplots(1, 3, figsize=(12, 4.2), constrained_layout=True)
    looks = {name: ("o-" if "fitted" in name else "s--", pictures.COLOURS[" 20 " not in name]) for name in found}
    for axes, (k, quantity) in zip(panels, enumerate(QUANTITIES)):
        for name, rows in found.items():
            marks, colour = looks[name]
            values = [row[k] for row in rows]
            axes.plot([100 * h for h in sizes], values, marks, color=colour, label=name, linewidth=1.4)
            _, limit, bar = convergence(values)
            axes.errorbar([100 * sizes[-1]], [values[-1]], yerr=bar, color=colour, capsize=4, linewidth=1)
            if limit is not None:
                axes.plot([0], [limit], "*", color=colour, markersize=11, clip_on=False)
        axes.set(xlabel="cells at the cone [cm]", ylabel=quantity, xlim=(0, None))
        axes.spines[["top", "right"]].set_visible(False)
    pictures.legend_below(figure, panels[0], 4, 0.08)
    pictures.save(figure, path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    study.add_run_arguments(parser, os.path.join("out", "resolution"))
    parser.add_argument("--levels", type=int, default=len(LEVELS), choices=range(3, len(LEVELS) + 1),
                        help=f"resolutions, from the coarsest on [{len(LEVELS)}]")
    parser.add_argument("--meshes", nargs="+", choices=list(MESHES), default=list(MESHES), help="discretisations [all]")
    parser.add_argument("--deltas", nargs="+", type=float, default=[20, 40], help="friction between sand and penetrometer, deg [20 40]")
    parser.add_argument("--picture", metavar="FILE", help="draw the values over the cells, with limits and bars")
    parser.set_defaults(options="--law linear-rate --points-per-element 16")
    arguments = parser.parse_args()
    if arguments.picture:
        study.drawing()  # or the end, before the drops are run
    runs = study.runs_of(arguments)
    levels = LEVELS[:arguments.levels]
    found = {}
    for mesh in arguments.meshes:
        for delta in arguments.deltas:
            name = f"{mesh}, {delta:g} deg"
            found[name] = [numbers(runs, f"{MESHES[mesh]} --delta {delta:g} --cell {cell} --cell-at-cone {fine}".strip())
                           for cell, fine in levels]
    print("| | | " + " | ".join(f"{100 * fine:g} cm" for _, fine in levels) + " | last change, % | order | limit | bar |")
    print("|" + "---|" * (len(levels) + 6))
    for quantity_number, quantity in enumerate(QUANTITIES):
        for name, rows in found.items():
            print(line(name, quantity, [row[quantity_number] for row in rows]))
    if arguments.picture:
        draw(found, [fine for _, fine in levels], arguments.picture)


if __name__ == "__main__":
    main()
