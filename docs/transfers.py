#!/usr/bin/env python3
"""Draws the pictures of docs/transfers.md from the tables that stand there: what studies/transfers.cpp printed.

    transfers.py     writes images/transfers_disc.png and images/transfers_orders.png

Run it after the tables have changed. Needs matplotlib."""

import re

from validation import COLOURS, HERE, pyplot

FAMILIES = ["FLIP", "APIC", "AFLIP", "TPIC", "XPIC", "FMPM"]
ORDERS = ["USL", "MUSL", "USF"]


def tables(text):
    """Each table as its header and rows of cells, in the order of the page."""
    found = []
    for block in re.findall(r"(?:^\|.*\n)+", text, flags=re.MULTILINE):
        header, _, *rows = [[cell.strip() for cell in line.strip("|\n").split("|")] for line in block.splitlines()]
        found.append((header, rows))
    return found


def colour(transfer):
    return COLOURS[FAMILIES.index(re.match(r"[A-Z]+", transfer).group())]


def clean(axes):
    axes.spines[["top", "right"]].set_visible(False)


def draw_disc(rows, path):
    """Energy over angular momentum at the end of ten turns: a panel for each mesh and order, a dot for each transfer."""
    figure, panels = pyplot.subplots(2, 3, figsize=(10.5, 6.6), sharex=True, sharey=True, constrained_layout=True)
    for line, mesh in zip(panels, ("B-splines", "triangles")):
        for axes, order in zip(line, ORDERS):
            axes.axhline(1, color="#d0d0d0", linewidth=0.8, zorder=0)
            axes.axvline(1, color="#d0d0d0", linewidth=0.8, zorder=0)
            dots = []
            for composition, turns, energy, _, _, momentum, _ in rows:
                there, of_order, transfer = composition.split("; ")
                if (there, of_order) != (mesh, order):
                    continue
                whole = float(turns) == 10
                x, y = float(momentum), float(energy)
                axes.plot(x, y, "o", markersize=6, color=colour(transfer), markerfacecolor=None if whole else "none")
                dots.append((y, x, transfer.replace(", time of a turn", ", time") + ("" if whole else f" ({turns} turns)")))
            beside(axes, dots)
            axes.set_title(f"{mesh}; {order}", fontsize=10)
            clean(axes)
    for axes in panels[-1]:
        axes.set_xlabel("angular momentum over that at the start")
    for axes in panels[:, 0]:
        axes.set_ylabel("energy over that at the start")
    panels[0, 0].set_xlim(-0.08, 1.55)
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def beside(axes, dots):
    """Names beside the dots, moved apart upwards where they would cover each other."""
    placed = []
    for y, x, name in sorted(dots):
        place = y
        for column, taken in placed:
            if abs(x - column) < 0.45 and abs(place - taken) < 0.095:
                place = taken + 0.1
        placed.append((x, place))
        placed.sort(key=lambda p: p[1])
        axes.annotate(name, (x, y), (x + 0.05, place), fontsize=7, va="center", arrowprops={"arrowstyle": "-", "lw": 0.3})


def draw_orders(studies, path):
    """Errors over cells along a side: a panel for each motion, a line for each composition."""
    figure, panels = pyplot.subplots(1, len(studies), figsize=(4 * len(studies), 5.2))
    styles = {"linear": ":", "quadratic": "-", "cubic": "--", "triangles": "-."}
    marks = {"USL": "o", "MUSL": "s", "USF": "^"}
    for axes, (header, rows) in zip(panels, studies):
        cells = [int(n) for n in header[1:]]
        for composition, *errors in rows:
            shape, transfer, order = composition.split("; ")
            there = [(n, float(e.split()[0])) for n, e in zip(cells, errors) if e != "stopped"]
            axes.loglog(*zip(*there), styles[shape], marker=marks[order], markersize=4, linewidth=1.1, color=colour(transfer), label=composition)
        start = float(rows[0][1].split()[0]) / 3
        axes.loglog(cells, [start * (cells[0] / n) ** 2 for n in cells], color="#b0b0b0", linewidth=2.5, zorder=0, label="order 2")
        axes.set_title(header[0], fontsize=10)
        axes.set_xlabel("cells along a side")
        axes.set_xticks(cells, [str(n) for n in cells])
        axes.minorticks_off()
        clean(axes)
    panels[0].set_ylabel("error over the amplitude")
    figure.tight_layout(rect=(0, 0.2, 1, 1))
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncol=4, frameon=False, fontsize=8)
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def main():
    found = tables((HERE / "transfers.md").read_text())
    disc = next(rows for header, rows in found if "angular momentum" in header)
    draw_disc(disc, HERE / "images" / "transfers_disc.png")
    draw_orders([(header, rows) for header, rows in found if header[0].startswith("A = ")], HERE / "images" / "transfers_orders.png")


if __name__ == "__main__":
    main()
