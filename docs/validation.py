#!/usr/bin/env python3
"""Brings docs/validation.md up to date: tables and pictures of what the tests computed beside the exact values.

    validation.py FOLDER     FOLDER holds the working folders of tests and examples: a build, or tests/scratch in it

A test writes validation_<case>.csv (columns composition, quantity, unit, computed, exact, or another word for what it is held against) and
validation_<case>_curves.csv (curve, x, y, exact; the heads of x and y label the axes): tests/support/validation.hpp;
validation_<case>_map.csv (x, y, value; the heads label axes and colours) is drawn as points.
In validation.md the lines between <!-- case: NAME --> and <!-- end: NAME --> are replaced. To add a case write the two
comments and a paragraph, and run the test and this script. Needs matplotlib."""

import argparse
import csv
import pathlib
import re
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("validation.py: needs matplotlib; on Debian: apt install python3-matplotlib")

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot  # noqa: E402

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]  # Okabe and Ito
HERE = pathlib.Path(__file__).resolve().parent


def rows_of(folder, name):
    """Header and rows of the one file of that name below a folder; none: nothing."""
    found = sorted(folder.rglob(name))
    if len(found) > 1:
        sys.exit(f"validation.py: {found[0]}, {found[1]}: two tests write one case")
    if not found:
        return [], []
    with open(found[0], newline="") as file:
        rows = list(csv.reader(file))
    return rows[0], rows[1:]


def table(header, rows):
    lines = [f"| composition | quantity | computed | {header[-1]} | error |", "|---|---|---|---|---|"]
    for composition, quantity, unit, computed, exact in rows:
        a, b = float(computed), float(exact)
        unit = "" if unit == "-" else f" {unit}"
        error = f"{100 * (a / b - 1):+.2f} %" if b != 0 else f"{a:+.2g}{unit}"
        lines.append(f"| {composition} | {quantity} | {a:.5g}{unit} | {b:.5g}{unit} | {error} |")
    return lines


def draw(header, rows, path):
    """A panel for each curve: computed points over the line that they are held against."""
    names = list(dict.fromkeys(row[0] for row in rows))
    across = min(2, len(names))
    down = -(-len(names) // across)
    figure, axes = pyplot.subplots(down, across, figsize=(4.6 * across, 2.6 * down), sharex=True, sharey=True,
                                   squeeze=False, constrained_layout=True)
    for place in list(axes.flat)[len(names):]:
        place.set_axis_off()
    for place, name, colour in zip(axes.flat, names, COLOURS * len(names)):
        points = sorted(tuple(map(float, row[1:])) for row in rows if row[0] == name)
        x, y, exact = zip(*points)
        place.plot(x, exact, color="#6b6b6b", linewidth=1.2, label=header[-1])
        place.plot(x, y, ".", color=colour, markersize=2.5 if len(x) > 20 else 7, label="computed")
        place.set_title(name, fontsize=10)
        place.spines[["top", "right"]].set_visible(False)
        place.legend(frameon=False, fontsize=8)
    for place in axes[-1]:
        place.set_xlabel(header[1])
    for place in axes[:, 0]:
        place.set_ylabel(header[2])
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def draw_map(header, rows, path):
    """Points in the plane, coloured by a value."""
    x, y, value = (list(map(float, column)) for column in zip(*rows))
    extent = [max(x) - min(x), max(y) - min(y)]
    figure, axes = pyplot.subplots(figsize=(7, 7 * extent[1] / extent[0] + 0.6), constrained_layout=True)
    size = 0.8 * (7 * 72) ** 2 / len(x) * extent[1] / extent[0]
    dots = axes.scatter(x, y, c=value, s=size, marker="s", linewidths=0, cmap="viridis")
    axes.set_aspect("equal")
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel(header[0])
    axes.set_ylabel(header[1])
    figure.colorbar(dots, label=header[2], shrink=0.8)
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    page = HERE / "validation.md"
    text = page.read_text()

    def block(match):
        name = match.group(1)
        lines = [match.group(0).splitlines()[0], ""]
        head, values = rows_of(folder, f"validation_{name}.csv")
        header, points = rows_of(folder, f"validation_{name}_curves.csv")
        map_header, cells = rows_of(folder, f"validation_{name}_map.csv")
        if not values and not points and not cells:
            print(f"validation.py: {name}: no file of it in {folder}; left as it was", file=sys.stderr)
            return match.group(0)
        if values:
            lines += table(head, values) + [""]
        if points:
            picture = f"images/validation_{name}.png"
            draw(header, points, HERE / picture)
            lines += [f"![{name.replace('_', ' ')}: computed and {header[-1]}]({picture})", ""]
        if cells:
            picture = f"images/validation_{name}_map.png"
            draw_map(map_header, cells, HERE / picture)
            lines += [f"![{name.replace('_', ' ')}: {map_header[2]}]({picture})", ""]
        print(name)
        return "\n".join(lines + [f"<!-- end: {name} -->"])

    page.write_text(re.sub(r"<!-- case: (\w+) -->\n.*?<!-- end: \1 -->", block, text, flags=re.DOTALL))


if __name__ == "__main__":
    main()
