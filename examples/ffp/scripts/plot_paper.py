#!/usr/bin/env python3
"""Draws figures 3 to 6 of the paper from the cases that `arenite-ffp paper` ran, laid out like the paper's, as PNG and SVG:

    figure3    depth and reaction against time: rigid and elastic, 20 deg and fully rough
    figure4    deviatoric strain at 0, 0.02, 0.04 and 0.08 s, rigid, 20 deg
    figure5    depth against time for six angles of friction between sand and penetrometer
    figure6    velocity and deceleration against depth for the same, with the experiment's numbers

Those of another law of the sand, and those of the slice, have its name behind theirs. Cases that are not there are left out.
Needs numpy and matplotlib.

    plot_paper.py out/paper
"""

import argparse
import os
import sys

from pictures import COLOURS, REFERENCE, pyplot, save_pictures
from plot import FIELD_SHARES, STRAIN_TOP, Drop, level, nearest_fields, paint
from regular_file import read_json

EXPERIMENT_PEAK = 19.4  # g
IMPACT_VELOCITY = 5.6  # m/s


class Paper:
    """The cases in a folder, by what tells them apart."""

    def __init__(self, folder):
        self.folder = folder
        try:
            self.found = read_json(os.path.join(folder, "paper.json"))
        except (OSError, ValueError) as problem:
            sys.exit(f"plot_paper.py: {folder}: must hold paper.json ({problem})")
        self.drops = {}
        for case in self.found["cases"]:
            if case["status"] == "done":
                key = (case["kinematics"], case["device"], case["delta_deg"], case["law"])
                self.drops[key] = Drop(os.path.join(folder, case["name"]))

    def of(self, kinematics, device, law):
        """{delta: drop}, ascending."""
        return {key[2]: drop for key, drop in sorted(self.drops.items(), key=lambda item: item[0][2])
                if (key[0], key[1], key[3]) == (kinematics, device, law)}


def finish(axes, x, y, letter=""):
    axes.set(xlabel=x, ylabel=y)
    axes.spines[["top", "right"]].set_visible(False)
    if letter:
        axes.set_title(letter, loc="left", fontsize=11)


def contact(delta):
    return "fully rough" if delta == 40 else f"δ = {delta:g}°"


def figure_3(paper, kinematics, law):
    runs = [(device, delta, drops[delta]) for device in ("rigid", "elastic") for drops in [paper.of(kinematics, device, law)]
            for delta in (20, 40) if delta in drops]
    if not any(device == "elastic" for device, *_ in runs):
        return None
    figure, (depth, reaction) = pyplot.subplots(1, 2, figsize=(11, 4.6), constrained_layout=True)
    for device, delta, drop in runs:
        style = {"color": COLOURS[0 if delta == 20 else 1], "linestyle": "-" if device == "rigid" else "--"}
        depth.plot(drop.time, drop.depth * 100, label=f"{device}, {contact(delta)}", **style)
        reaction.plot(drop.time, drop.reaction / 1e3, **style)
    depth.set_ylim(1.08 * max(21, depth.dataLim.y1), 0)
    level(depth, 20, "paper,\n20°:\n20 cm")
    level(depth, 14, "paper,\nrough:\n14 cm")
    level(reaction, runs[0][2].inputs["mass_kg"] * 9.81 / 1e3, "weight")
    for axes in (depth, reaction):
        axes.set_xlim(left=0)
    finish(depth, "time [s]", "penetration depth [cm]", "a)")
    finish(reaction, "time [s]", "vertical reaction, 2 ms mean [kN]", "b)")
    depth.legend(frameon=False)
    return figure


def figure_4(paper, kinematics, law):
    drop = paper.of(kinematics, "rigid", law).get(20)
    shown = nearest_fields(drop, FIELD_SHARES) if drop else []
    if not shown:
        return None
    figure, rows = pyplot.subplots(1, len(shown), figsize=(3.2 * len(shown) + 1, 3.6), squeeze=False, sharey=True,
                                   constrained_layout=True, dpi=130)
    for axes, (time, *_) in zip(rows[0], shown):
        axes.set(xlim=(-0.4, 0.4), ylim=(-0.4, 0.2), aspect="equal", xticks=[-0.3, 0, 0.3])
        axes.set_title(f"t = {time:.2f} s", fontsize=11)
        axes.set_xlabel("[m]")
    rows[0][0].set_ylabel("[m]")
    bar = figure.colorbar(pyplot.cm.ScalarMappable(pyplot.Normalize(0, STRAIN_TOP), "magma_r"), ax=rows[0], extend="max", shrink=0.8)
    bar.set_label("deviatoric strain [-]")
    figure.canvas.draw()  # fixes the sizes, which the markers follow
    for axes, field in zip(rows[0], shown):
        paint(axes, drop, field)
    return figure


def figure_5(paper, kinematics, law):
    drops = paper.of(kinematics, "rigid", law)
    if len(drops) < 3:
        return None
    figure, axes = pyplot.subplots(figsize=(7, 4.8), constrained_layout=True)
    for (delta, drop), colour in zip(drops.items(), COLOURS):
        label = contact(delta) + (" (the experiment's depth in the paper)" if delta == 32 else "")
        axes.plot(drop.time, drop.depth * 100, color=colour, label=label)
    axes.set_ylim(1.08 * max(21, axes.dataLim.y1), 0)
    axes.set_xlim(left=0)
    level(axes, 20, "paper,\n20°")
    level(axes, 14, "paper,\nrough")
    finish(axes, "time [s]", "penetration depth [cm]")
    axes.legend(frameon=False)
    return figure


def figure_6(paper, kinematics, law):
    drops = paper.of(kinematics, "rigid", law)
    if len(drops) < 3:
        return None
    figure, (velocity, deceleration) = pyplot.subplots(1, 2, figsize=(11, 5.2), sharey=True, constrained_layout=True)
    for (delta, drop), colour in zip(drops.items(), COLOURS):
        last = int(drop.depth.argmax()) + 1  # a rebound would go back over the same depths
        velocity.plot(drop.velocity[:last], drop.depth[:last] * 100, color=colour, label=contact(delta))
        deceleration.plot(drop.deceleration[:last], drop.depth[:last] * 100, color=colour)
    velocity.plot([IMPACT_VELOCITY], [0], "k*", markersize=11, clip_on=False, label="experiment: impact")
    velocity.set_ylim(1.08 * max(21, velocity.dataLim.y1), 0)
    velocity.set_xlim(left=0)
    deceleration.axvspan(17, 23, color="#b9b9b9", alpha=0.35, linewidth=0, zorder=0)
    level(deceleration, EXPERIMENT_PEAK, f"experiment: {EXPERIMENT_PEAK} g", vertical=True)
    deceleration.text(21.2, 0.02, "the paper's\npeaks", fontsize=8, color=REFERENCE, ha="center", transform=deceleration.get_xaxis_transform())
    finish(velocity, "velocity [m/s]", "penetration depth [cm]", "a)")
    finish(deceleration, "deceleration, 2 ms mean [g]", "", "b)")
    velocity.legend(frameon=False, loc="upper left")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="DIR", help="folder of arenite-ffp paper; the figures go there")
    folder = parser.parse_args().folder
    paper = Paper(folder)
    laws = dict.fromkeys(["mohr-coulomb", paper.found["law"]])
    drawn = 0
    for number, draw in ((3, figure_3), (4, figure_4), (5, figure_5), (6, figure_6)):
        for kinematics, law in [*(("axisymmetric", law) for law in laws), ("slice", "mohr-coulomb")]:
            figure = draw(paper, kinematics, law)
            if figure is None:
                continue
            model = "half-section" if kinematics == "axisymmetric" else "20° slice"
            named = "Mohr-Coulomb" if law == "mohr-coulomb" else law
            figure.suptitle(f"As the paper's figure {number}: {model}, {named}", fontsize=11)
            behind = ("_slice" if kinematics == "slice" else "") + ("" if law == "mohr-coulomb" else f"_{law}")
            for path in save_pictures(figure, folder, f"figure{number}{behind}"):
                print(path)
            drawn += 1
    if not drawn:
        sys.exit(f"plot_paper.py: {folder}: no case that is done, so nothing to draw")


if __name__ == "__main__":
    main()
