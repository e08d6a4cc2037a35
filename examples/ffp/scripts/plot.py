#!/usr/bin/env python3
"""Draws one or several drops: histories.png (depth, velocity, deceleration, reaction) and strain.png (deviatoric strain of
the sand at the paper's times). Drops that failed or were interrupted are drawn as far as they came. Needs numpy and matplotlib.

    plot.py out/ffp                              pictures of one drop, into its folder
    plot.py out/delta20 out/delta40 --out docs   several drops in the same pictures
    plot.py out/ffp --cover drop.png             one drop at a glance, in one picture
"""

import argparse
import glob
import os
import sys
import textwrap

import numpy

from pictures import COLOURS, REFERENCE, device_name, is_of_paper, matplotlib, pyplot, save
from read_vtu import read_pvd, read_vtu
from regular_file import read_json, read_table

GRAVITY = 9.81
WINDOW = 2e-3  # s, of the moving average; as in summary.json
FIELD_SHARES = [0.0, 0.2, 0.4, 0.8]  # of the time of a drop; the paper's figure 4 has 0.1 s
STRAIN_TOP = 1.0
SOURCE = ("Paper: simulation of a free-fall penetrometer (FFP) dropped into dry sand with the material point method, 2nd International "
          "Conference on the Material\nPoint Method for Modelling Soil-Water-Structure Interaction. Experiment: BlueDrop FFP in a "
          "calibration chamber, as the paper reports it.")


class Drop:
    """The results of one output folder."""

    def __init__(self, folder):
        self.folder = folder
        try:
            self.summary = read_json(os.path.join(folder, "summary.json"))
            columns = read_table(os.path.join(folder, "history.csv"), "time_s", "penetration_m", "velocity_m_s", "acceleration_m_s2",
                                 "reaction_N")
        except (OSError, ValueError) as problem:
            sys.exit(f"plot.py: {folder}: must hold summary.json and history.csv of a drop ({problem})")
        table = {name: numpy.array(values) for name, values in columns.items()}
        if len(table["time_s"]) < 1:
            sys.exit(f"plot.py: {folder}/history.csv: holds no row")
        self.time = table["time_s"]
        self.depth = table["penetration_m"]
        self.velocity = table["velocity_m_s"]
        self.raw = table["acceleration_m_s2"] / GRAVITY
        self.deceleration = moving_average(self.time, self.raw)
        self.reaction = moving_average(self.time, table["reaction_N"])
        self.inputs = self.summary["inputs"]
        self.of_paper = is_of_paper(self.inputs)
        self.name = device_name(self.summary)
        self.chamber = self.summary.get("chamber", {"radius_m": 0.4, "soil_depth_m": 0.4})
        self.in_space = self.inputs["kinematics"] == "space"
        if self.in_space:
            turns = read_table(os.path.join(folder, "history.csv"), "tilt_deg", "aside_m")
            self.tilt, self.aside = (numpy.array(turns[name]) for name in ("tilt_deg", "aside_m"))

    def label(self, drops):
        """What tells this drop from the others: contact first, then every input that differs."""
        parts = self.parts()
        differs = [i for i, part in enumerate(parts) if any(drop.parts()[i] != part for drop in drops)]
        words = [parts[i] for i in sorted({0, *differs, *([] if self.of_paper else [3])})]
        if self.summary["status"] != "done":
            words.append(self.summary["status"])
        named = {"no_slip", "delta_deg", "kinematics", "device", "tip", "end_s", "fields_every_s", "penetrometer", "device_file", "device_profile"}
        if any(drop.inputs["kinematics"] != self.inputs["kinematics"] for drop in drops):
            named.add("points_per_element")  # its default goes with the kinematics
        for key, value in self.inputs.items():
            if key not in named and any(drop.inputs.get(key) != value for drop in drops):
                words.append(f"{key} {value:g}" if isinstance(value, (int, float)) else f"{key} {value}")
        return ", ".join(words)

    def parts(self):
        """The words that every label is made of."""
        contact = "no slip" if self.inputs["no_slip"] else f"δ = {self.inputs['delta_deg']:g}°"
        return [contact, self.inputs["kinematics"], f"{self.inputs['device']} FFP", self.name]

    def fields(self):
        """[(time, [files])] of all series in the folder, in the order of time."""
        found = {}
        for series in sorted(glob.glob(os.path.join(glob.escape(self.folder), "*.pvd"))):
            for time, path in read_pvd(series):
                found.setdefault(time, []).append(path)
        return sorted(found.items())

    def hop(self):
        """Start and end of the longest time, s, that it flies free after its greatest depth: net acceleration within 0.2 g of -1 g.
        None if that is no longer than 5 ms."""
        free = (abs(self.deceleration + 1) < 0.2) & (self.time >= self.time[numpy.argmax(self.depth)])
        edges = numpy.flatnonzero(numpy.diff(numpy.concatenate([[0], free.astype(int), [0]])))
        flights = [(self.time[a], self.time[b - 1]) for a, b in zip(edges[::2], edges[1::2])]
        longest = max(flights, key=lambda flight: flight[1] - flight[0], default=(0, 0))
        return longest if longest[1] - longest[0] > 5e-3 else None

    def outline(self, time):
        """Section of the device at a time: [x, y]."""
        line = numpy.array(self.summary["device_outline_m"])
        x, y = numpy.concatenate([line * (-1, 1), line[::-1]]).T
        if self.in_space:
            tilt = numpy.radians(numpy.interp(time, self.time, self.tilt))
            x, y = numpy.cos(tilt) * x - numpy.sin(tilt) * y, numpy.sin(tilt) * x + numpy.cos(tilt) * y
            x += numpy.interp(time, self.time, self.aside)
        return x, y - numpy.interp(time, self.time, self.depth)


def moving_average(time, value):
    """Centred mean over WINDOW of a history that is constant over each step; exact for uneven steps."""
    if len(time) < 2:
        return value.copy()
    integral = numpy.concatenate([[0.0], numpy.cumsum(value[1:] * numpy.diff(time))])
    start = numpy.maximum(time - WINDOW / 2, time[0])
    end = numpy.minimum(time + WINDOW / 2, time[-1])
    return (numpy.interp(end, time, integral) - numpy.interp(start, time, integral)) / (end - start)


def level(axes, value, text, vertical=False):
    """A reference line, with its text outside of the axes, where no curve is."""
    draw = axes.axvline if vertical else axes.axhline
    draw(value, color=REFERENCE, linewidth=1, linestyle=(0, (5, 3)), zorder=1)
    if vertical:
        axes.text(value, 1.01, text, color=REFERENCE, fontsize=8, ha="center", va="bottom", transform=axes.get_xaxis_transform())
    else:
        axes.text(1.01, value, text, color=REFERENCE, fontsize=8, ha="left", va="center", transform=axes.get_yaxis_transform())


def band(axes):
    """The paper's range of peak decelerations and the experiment's peak."""
    axes.axhspan(17, 23, color="#b9b9b9", alpha=0.35, linewidth=0, zorder=0)
    level(axes, 19.4, "peaks\npaper (grey):\n17 to 23 g\nexperiment:\n19.4 g")


def note_hop(axes, drop, values):
    """Says what the plateau after the rebound is, beside it, with a line to it. The axes must have their limits and size."""
    flight = drop.hop()
    if flight is None:
        return
    middle = (flight[0] + flight[1]) / 2
    target = (middle * 1e3, numpy.interp(middle, drop.time, values))
    note = axes.annotate("free flight after\nthe rebound:\nreaction 0, -1 g", target, (0.5, 0.5), textcoords="axes fraction", fontsize=8,
                         color="#333333", ha="center", va="center",
                         arrowprops={"arrowstyle": "-", "color": "#333333", "linewidth": 0.7, "shrinkB": 2})
    x, y = axes.transAxes.inverted().transform(axes.transData.transform(target))
    places = [(x + dx, y + dy) for dy in (0.22, 0.3, 0.4, 0.5, 0.6) for dx in (0.0, 0.02, 0.04, 0.06, 0.1, -0.05, -0.1)]
    for place in places:
        note.set_position(place)
        if is_free(axes, note):
            return


def is_free(axes, text):
    """Whether an annotation's text lies on no curve and on no other text of its axes, and within them."""
    renderer = axes.figure.canvas.get_renderer()
    text.update_positions(renderer)
    box = matplotlib.text.Text.get_window_extent(text, renderer).padded(3)
    if box.x1 > axes.bbox.x1 + 3:
        return False
    for other in axes.texts:
        if other is not text and box.overlaps(other.get_window_extent(renderer)):
            return False
    for line in axes.get_lines():
        if box.width > 0 and line.get_path().transformed(line.get_transform()).intersects_bbox(box, filled=False):
            return False
    return True


def greatest(values):
    """The greatest of the finite values; 0 if there is none."""
    finite = values[numpy.isfinite(values)]
    return numpy.max(finite) if len(finite) else 0.0


def draw_histories(drops, path):
    figure, rows = pyplot.subplots(2, 3, figsize=(13.5, 7.4), constrained_layout=True)
    depth, velocity, deceleration = rows[0]
    reaction, velocity_down, deceleration_down = rows[1]
    for drop, colour in zip(drops, COLOURS * len(drops)):
        ms, cm = drop.time * 1e3, drop.depth * 1e2
        style = {"color": colour, "linewidth": 1.8}
        depth.plot(ms, cm, label=drop.label(drops), **style)
        velocity.plot(ms, drop.velocity, **style)
        if len(drops) == 1:
            deceleration.plot(ms, drop.raw, color=colour, alpha=0.3, linewidth=0.6, zorder=1)
            deceleration_down.plot(cm, drop.raw, color=colour, alpha=0.3, linewidth=0.6, zorder=1)
        deceleration.plot(ms, drop.deceleration, **style)
        reaction.plot(ms, drop.reaction / 1e3, **style)
        velocity_down.plot(cm, drop.velocity, **style)
        deceleration_down.plot(cm, drop.deceleration, **style)
    of_paper = any(drop.of_paper for drop in drops)
    top, deepest = max(greatest(drop.deceleration) for drop in drops), max(greatest(drop.depth) * 1e2 for drop in drops)
    for axes in (deceleration, deceleration_down):
        if of_paper:
            band(axes)
        axes.set_ylim(-3, 1.15 * max(23 if of_paper else 1, top))
    depth.set_ylim(1.12 * max(21 if of_paper else 0.1, deepest), 0)
    if of_paper:
        level(depth, 20, "paper,\nδ = 20°:\n20 cm")
        level(depth, 14, "paper,\nfully rough:\n14 cm")
        level(velocity_down, 20, "paper,\nδ = 20°", vertical=True)
        level(velocity_down, 14, "paper,\nfully rough", vertical=True)
    for axes in (velocity, velocity_down):
        axes.axhline(0, color="#b9b9b9", linewidth=0.8, zorder=0)
    weight = drops[0].inputs["mass_kg"] * GRAVITY / 1e3
    level(reaction, weight, "weight")
    for axes, x, y in (
        (depth, "time [ms]", "depth [cm]"),
        (velocity, "time [ms]", "velocity [m/s]"),
        (deceleration, "time [ms]", "deceleration, 2 ms mean [g]"),
        (reaction, "time [ms]", "reaction, 2 ms mean [kN]"),
        (velocity_down, "depth [cm]", "velocity [m/s]"),
        (deceleration_down, "depth [cm]", "deceleration, 2 ms mean [g]"),
    ):
        axes.set_xlabel(x)
        axes.set_ylabel(y)
        axes.set_xlim(0, 1.02 * max(axes.dataLim.x1, 1e-9))
        axes.spines[["top", "right"]].set_visible(False)
    handles, labels = depth.get_legend_handles_labels()
    columns = min(len(drops), max(1, int(165 / (8 + max(map(len, labels))))))
    figure.legend(handles, labels, loc="upper center", ncol=columns, frameon=False)
    foot = [textwrap.fill(f"{drop.folder}: {drop.summary['status']}, {drop.summary.get('failure', 'no end was written')}", 190)
            for drop in drops if drop.summary["status"] != "done"]
    foot = "\n".join([*foot, *([SOURCE] if of_paper else [])])
    figure.text(0.01, 0.008, foot, color=REFERENCE, fontsize=8, ha="left", va="bottom")
    below, above = 0.012 + 0.0185 * (1 + foot.count("\n")), 0.01 + 0.035 * -(-len(drops) // columns)
    figure.get_layout_engine().set(rect=(0, below, 1, 1 - below - above))
    figure.canvas.draw()  # fixes the sizes, which the notes need
    for drop in drops:
        if drop.hop() is not None:
            note_hop(deceleration, drop, drop.deceleration)
            note_hop(reaction, drop, drop.reaction / 1e3)
            break
    save(figure, path, dpi=130)
    pyplot.close(figure)


def nearest_fields(drop, shares=FIELD_SHARES):
    """The drop's fields at these shares of its end: [(time, r, y, strain)], those that there are; in space of the plane of symmetry, r along it."""
    series = drop.fields()
    if not series:
        return []
    times = numpy.array([time for time, _ in series])
    chosen, end = [], drop.inputs["end_s"]
    for share in shares:
        i = int(numpy.argmin(abs(times - share * end)))
        if abs(times[i] - share * end) < 0.05 * end and i not in chosen:
            chosen.append(i)
    shown = []
    if drop.summary["status"] != "done" and len(series) - 1 not in chosen:
        chosen.append(len(series) - 1)  # the state at which it was stopped
    for i in chosen or range(min(4, len(series))):
        for path in series[i][1]:
            data = read_vtu(path)
            if "deviatoric_strain" in data["point_data"]:
                x, strain = data["points"], data["point_data"]["deviatoric_strain"]
                if drop.in_space:
                    near = x[:, 2] < drop.inputs["cell_m"] / 2
                    shown.append((times[i], x[near, 0], x[near, 1], strain[near]))
                else:
                    shown.append((times[i], numpy.hypot(x[:, 0], x[:, 2]), x[:, 1], strain))
                break
    return shown


def paint(axes, drop, field):
    """The sand and the device of one time on a pair of axes whose size is known; returns the image for a colour bar."""
    time, r, y, strain = field
    wide = 2.5 * drop.chamber["radius_m"]
    inside = (abs(r) < wide) & (abs(y) < wide) & numpy.isfinite(strain)  # what a failed run has thrown out is not drawn
    r, y, strain = r[inside], y[inside], strain[inside]
    order = numpy.argsort(strain)  # the sheared points on top
    r, y, strain = r[order], y[order], strain[order]
    box = axes.get_window_extent()
    scale = 72 / axes.figure.dpi * box.height / numpy.ptp(axes.get_ylim())  # points of 1/72 inch a metre
    image = None
    for side in (1,) if drop.in_space else (-1, 1):
        image = axes.scatter(side * r, y, c=strain, s=(1.5 * scale * spacing(r, y, 0.05 * drop.chamber["radius_m"])) ** 2, marker="s", linewidths=0, cmap="magma_r",
                             vmin=0, vmax=STRAIN_TOP, rasterized=True)
    x, height = drop.outline(time)
    axes.fill(x, height, facecolor="#d9dde1", edgecolor="#333333", linewidth=0.9, zorder=3)
    axes.set_aspect("equal")
    axes.spines[["top", "right"]].set_visible(False)
    return image


def spacing(r, y, edge):
    """Distance between neighbours at each point, m, from the number of points in boxes of this edge, m."""
    place = numpy.floor(numpy.column_stack([r, y]) / edge).astype(int)
    _, box, count = numpy.unique(place, axis=0, return_inverse=True, return_counts=True)
    distance = edge / numpy.sqrt(count[box.ravel()])
    return numpy.minimum(distance, 1.6 * numpy.median(distance))  # grains thrown out are no larger


def draw_strain(drops, path):
    """Panels of the deviatoric strain, a row a drop; returns whether there was anything to draw."""
    shares = FIELD_SHARES if len(drops) == 1 else FIELD_SHARES[1:]  # at the start there is nothing to compare
    rows = [(drop, shown) for drop in drops if (shown := nearest_fields(drop, shares))]
    if not rows:
        return False
    columns = max(len(shown) for _, shown in rows)
    wide, deep = (max(drop.chamber[key] for drop, _ in rows) for key in ("radius_m", "soil_depth_m"))
    figure, grid = pyplot.subplots(len(rows), columns, figsize=(3.3 * columns + 1, 2.45 * len(rows) + 0.5), squeeze=False,
                                   sharex=True, sharey=True, constrained_layout=True, dpi=130)
    heads = [time for time, *_ in rows[0][1]]
    for line, (drop, shown) in zip(grid, rows):
        for axes in line[len(shown):]:
            axes.set_axis_off()
        for column, (axes, (time, *_)) in enumerate(zip(line, shown)):
            axes.set(xlim=(-wide, wide), ylim=(-deep, wide / 2), aspect="equal", xticks=[-0.75 * wide, 0, 0.75 * wide])
            if line[0] is grid[0, 0] or column >= len(heads) or abs(time - heads[column]) > 5e-4:
                axes.set_title(f"{time * 1e3:.0f} ms", fontsize=11)
        line[0].set_ylabel((drop.label(drops).replace(", ", "\n") + "\n" if len(rows) > 1 else "") + "height [m]", fontsize=9)
    for k in range(columns):
        lowest = [line[k] for line, (_, shown) in zip(grid, rows) if len(shown) > k][-1]
        lowest.set_xlabel("distance from the axis [m]", fontsize=9)
        lowest.tick_params(labelbottom=True)
    bar = figure.colorbar(matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, STRAIN_TOP), "magma_r"), ax=grid, extend="max",
                          shrink=0.9 if len(rows) == 1 else 0.5, aspect=20 if len(rows) == 1 else 40, pad=0.01)
    bar.set_label("deviatoric strain [-]")
    figure.canvas.draw()  # fixes the sizes, which the markers follow
    for line, (drop, shown) in zip(grid, rows):
        for axes, field in zip(line, shown):
            paint(axes, drop, field)
    save(figure, path)
    pyplot.close(figure)
    return True


def draw_cover(drop, path):
    """One drop at a glance: the sand half-way, depth and deceleration. Needs fields."""
    shown = nearest_fields(drop)
    if not shown:
        sys.exit(f"plot.py: {drop.folder}: a cover needs field files (--fields-every)")
    figure = pyplot.figure(figsize=(10, 4.4), dpi=120)
    sand = figure.add_axes([0.01, 0.02, 0.56, 0.96])
    wide = 0.75 * drop.chamber["radius_m"]
    sand.set(xlim=(-wide, wide), ylim=(-wide, wide / 2), aspect="equal")
    sand.set_axis_off()
    figure.canvas.draw()
    field = min(shown, key=lambda one: abs(one[0] - 0.4 * drop.inputs["end_s"]))
    image = paint(sand, drop, field)
    inset = sand.inset_axes([0.72, 0.93, 0.26, 0.025])
    bar = figure.colorbar(image, cax=inset, orientation="horizontal", extend="max", ticks=[0, STRAIN_TOP / 2, STRAIN_TOP])
    bar.ax.tick_params(labelsize=8)
    bar.set_label(f"deviatoric strain at {field[0] * 1e3:.0f} ms", fontsize=9)
    for bottom, values, label, colour in ((0.57, drop.depth * 1e2, "depth [cm]", COLOURS[0]),
                                          (0.11, drop.deceleration, "deceleration [g]", COLOURS[1])):
        axes = figure.add_axes([0.64, bottom, 0.34, 0.39])
        axes.plot(drop.time * 1e3, values, color=colour, linewidth=2)
        axes.set_ylabel(label)
        axes.set_xlim(0, drop.time[-1] * 1e3)
        axes.spines[["top", "right"]].set_visible(False)
        if bottom > 0.5:
            axes.set_ylim(1.15 * greatest(values), 0)
        else:
            axes.set_xlabel("time [ms]")
            axes.axhline(0, color="#b9b9b9", linewidth=0.8, zorder=0)
            note_hop(axes, drop, values)
    save(figure, path)
    pyplot.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="DIR", help="output folder of arenite-ffp drop")
    parser.add_argument("--out", metavar="DIR", help="where the pictures go [the first folder]")
    parser.add_argument("--cover", metavar="FILE", help="one picture of the first drop instead")
    arguments = parser.parse_args()
    target = arguments.out or arguments.folders[0]
    drops = [Drop(folder) for folder in arguments.folders]
    try:
        draw(arguments, drops, target)
    except OSError as problem:
        sys.exit(f"plot.py: {problem.filename}: cannot be written or read: {problem.strerror}")


def draw(arguments, drops, target):
    if arguments.cover:
        draw_cover(drops[0], arguments.cover)
        print(arguments.cover)
        return
    os.makedirs(target, exist_ok=True)
    histories = os.path.join(target, "histories.png")
    draw_histories(drops, histories)
    print(histories)
    strain = os.path.join(target, "strain.png")
    if draw_strain(drops, strain):
        print(strain)
    else:
        print("plot.py: no field files with deviatoric_strain, so no picture of them (--fields-every)", file=sys.stderr)


if __name__ == "__main__":
    main()
