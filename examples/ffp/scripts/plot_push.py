#!/usr/bin/env python3
"""Draws a push as a cone penetration test is drawn: resistance, sleeve friction and friction ratio, depth downward, with what theory
says and the uncertainty where there is one. Needs numpy and matplotlib.

    plot_push.py out/push [another ..]      push.png and push.svg into the first folder, of history.csv and summary.json
"""

import argparse
import os
import sys

import numpy

from pictures import COLOURS, REFERENCE, pyplot, save_pictures
from regular_file import read_json, read_table


def read(folder):
    try:
        found = read_json(os.path.join(folder, "summary.json"))
        table = read_table(os.path.join(folder, "history.csv"), "depth_m")
    except (OSError, ValueError) as problem:
        sys.exit(f"plot_push.py: {folder}: must hold history.csv and summary.json of a push ({problem})")
    return found, {name: numpy.array(values, float) for name, values in table.items()}


def label(found, folder):
    ground = found["inputs"]["ground"]
    return f"{found['penetrometer']['name']} in {ground}, {os.path.basename(os.path.abspath(folder))}"


def draw(folders):
    figure, axes = pyplot.subplots(1, 3, figsize=(10, 6), sharey=True, constrained_layout=True, gridspec_kw={"width_ratios": [2, 1, 1]})
    for folder, colour in zip(folders, COLOURS):
        found, table = read(folder)
        depth = table["depth_m"] * 100
        axes[0].plot(table["q_c_kPa"] / 1e3, depth, color=colour, label=label(found, folder))
        axes[0].plot(table["vertical_stress_kPa"] / 1e3, depth, color=colour, linewidth=0.8, linestyle=":")
        axes[1].plot(table["f_s_kPa"], depth, color=colour)
        axes[2].plot(table["friction_ratio_percent"], depth, color=colour)
        for form in found.get("closed_forms", []) if folder == folders[0] else []:
            above = table["vertical_stress_kPa"] if found["inputs"]["ground"] == "clay" else 0 * depth
            axes[0].plot((form["kPa"] + above) / 1e3, depth, color=REFERENCE, linestyle="--", label=f"{form['source']}, {form['name']}")
        bar = found.get("uncertainty", {}).get("net_resistance_kPa", {}).get("u")
        if bar:
            axes[0].errorbar(found["q_c_kPa"] / 1e3, found["depth_m"] * 100, xerr=bar / 1e3, color=colour, capsize=4)
    for ax, text in zip(axes, ("q_c, MPa (dotted: vertical stress at rest)", "f_s, kPa", "friction ratio, %")):
        ax.set_xlabel(text)
        ax.set_xlim(left=0)
        ax.grid(True, linewidth=0.3)
    axes[0].set_ylabel("depth of the tip, cm")
    axes[0].invert_yaxis()
    axes[0].legend(loc="lower left", fontsize="small")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="+")
    given = parser.parse_args()
    for path in save_pictures(draw(given.folder), given.folder[0], "push"):
        print(path)


if __name__ == "__main__":
    main()
