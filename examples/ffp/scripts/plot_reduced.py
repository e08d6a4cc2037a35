#!/usr/bin/env python3
"""Draws what `arenite-ffp reduce` wrote as practitioners are used to see it, depth downward: deceleration and velocity, and beside
them the bearing resistance with its bands of K. Needs numpy and matplotlib.

    plot_reduced.py out/ffp                    reduced.png and reduced.svg into the folder, from reduced.csv and reduced.json
    plot_reduced.py out/ffp measured --out a   two records in the same axes; the bands are those of the first
"""

import argparse
import os
import sys

import numpy

from pictures import COLOURS, REFERENCE, device_name, pyplot, save_pictures
from regular_file import read_json, read_table


class Reduced:
    """The results of one folder."""

    def __init__(self, folder):
        self.folder = folder
        try:
            self.found = read_json(os.path.join(folder, "reduced.json"))
            table = read_table(os.path.join(folder, "reduced.csv"), "depth_m")
        except (OSError, ValueError) as problem:
            sys.exit(f"plot_reduced.py: {folder}: must hold reduced.csv and reduced.json ({problem})")
        last = int(numpy.argmax(table["depth_m"])) + 1  # a rebound would go back over the same depths
        self.table = {name: numpy.array(values[:last]) for name, values in table.items()}
        self.depth = self.table["depth_m"] * 100

    def label(self):
        """Name of the record."""
        file = self.found["file"]
        return os.path.basename(os.path.abspath(self.folder) if file == "history.csv" else file)


def column(reduced, k, form=""):
    """q_sbc by a K."""
    return reduced.table[f"q_sbc_{form}K{k}_kPa"]


def bands(found):
    """[(text, name of the low K, name of the high K, whether it is for this drop)]."""
    pairs = {}
    for one in found["q_sbc"]:
        name = "air" if one["band"] == "air" else f"{one['K']:g}"
        pairs.setdefault(one["band"], []).append((name, one["K"], one["within_range"]))
    result = []
    for band, ends in pairs.items():
        text = f"K = {ends[0][1]:.2f}" if band == "air" else f"K = {band}"
        result.append((text, ends[0][0], ends[-1][0], ends[0][2]))
    return result


def draw(records, target):
    """Draws the picture; returns the paths."""
    figure, (motion, resistance) = pyplot.subplots(1, 2, figsize=(10, 6), sharey=True, constrained_layout=True)
    velocity = motion.twiny()
    for record, colour in zip(records, COLOURS * len(records)):
        motion.plot(record.table["deceleration_g"], record.depth, color=colour, alpha=0.3, linewidth=0.6)
        motion.plot(record.table["filtered_deceleration_g"], record.depth, color=colour, label=record.label())
        velocity.plot(record.table["velocity_m_s"], record.depth, color=colour, linestyle="--", linewidth=1.2)
    motion.set(xlabel="deceleration [g], line", ylabel="depth [cm]")
    velocity.set_xlabel("velocity [m/s], dashes")
    first = records[0]
    area = first.found["settings"]["area_of_q_sbc"]
    for record, colour in zip(records, COLOURS * len(records)):
        resistance.plot(record.table[f"q_dyn_{area}_kPa"], record.depth, color=colour,
                        label=f"q_dyn, {record.label()}" if len(records) > 1 else "q_dyn")
    drawn = [band for band in bands(first.found) if band[3]] or bands(first.found)
    for (text, low, high, _), colour in zip(drawn, COLOURS[1:] * len(drawn)):
        if low == high:
            resistance.plot(column(first, low), first.depth, color=colour, label=f"q_sbc, {text}")
        else:
            resistance.fill_betweenx(first.depth, column(first, high), column(first, low), color=colour, alpha=0.4, linewidth=0,
                                     label=f"q_sbc, {text}")
    resistance.set_xlabel(f"bearing resistance on the {'mantle' if area == 'mantle' else 'section'} of the tip [kPa]")
    for axes in (motion, velocity, resistance):
        axes.set_xlim(left=min(0, axes.get_xlim()[0]) if axes is motion else 0)
    motion.axvline(0, color="#b9b9b9", linewidth=0.8, zorder=0)
    motion.set_ylim(1.05 * max(numpy.nanmax(record.depth) for record in records), 0)
    for axes in (motion, resistance):
        axes.spines[["top" if axes is resistance else "right", "right"]].set_visible(False)
        axes.legend(loc="lower right" if axes is motion else "best", frameon=False, fontsize=9)
    window = first.found["settings"]["window_s"] * 1e3
    filtered = f"; deceleration: mean over {window:g} ms" if window else ""
    figure.supxlabel(f"{device_name(first.found)}; impact at {first.found['impact_velocity_m_s']:.2f} m/s{filtered}", color=REFERENCE, fontsize=8)
    return save_pictures(figure, target, "reduced")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="DIR", help="folder with reduced.csv and reduced.json")
    parser.add_argument("--out", metavar="DIR", help="where the pictures go [the first folder]")
    arguments = parser.parse_args()
    for path in draw([Reduced(folder) for folder in arguments.folders], arguments.out or arguments.folders[0]):
        print(path)


if __name__ == "__main__":
    main()
