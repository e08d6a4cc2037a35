#!/usr/bin/env python3
"""Runs the drops behind the tables of docs/ffp.md, one after the other, and prints the tables as Markdown: what each choice
does to the answer, and what it costs. All of it takes a quarter of an hour on two processors; drops that are there are not run again.

    study.py                              all tables; results in out/study
    study.py --only delta cell            some of them; --list says which there are
    study.py --only trade --picture trade.png --options "--friction 36"
    study.py --page docs/ffp_tables.md    all tables, as that page

Build the driver first (examples/ffp/run.sh does). The picture needs matplotlib, the rest the standard library alone.
"""

import argparse
import bisect
import itertools
import os
import re
import subprocess
import sys

from regular_file import read_json, read_table, replaced

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3))
GRAVITY = 9.81
SLICE = "--kinematics slice"
COARSE_SLICE = SLICE + " --cell 0.02"


def each(option, values, *others):
    """Rows that set one option to each of some values."""
    return [(f"{value}", " ".join([*others, f"--{option} {value}"])) for value in values]


# Laws of the sand's friction, by `--law`; no constant was fitted (docs/sand.md).
LAWS = {
    "linear-rate, 1e-3 s": "--law linear-rate",
    "mu-i, beads of 0.53 mm": "--law mu-i",
    "log-rate, 2.7 % a decade": "--law log-rate",
    "softening, 40 to 36 deg": "--law softening --residual-friction 36",
    "softening-rate, 39 to 36 deg, psi 10 to 0": "--law softening-rate --friction 39 --residual-friction 36 --dilatancy 10 --dilatancy-per-decade 0.27",
}

# Each table: what it asks, and its rows: a label, and options of `arenite-ffp drop`.
TABLES = {
    "delta": ("Friction between sand and penetrometer, deg",
              [*each("delta", [20, 24, 28, 32, 36, 40]), ("no slip", "--no-slip")]),
    "open": ("What the paper leaves open", [
        ("default", ""),
        ("fillet of 1 cm", "--shoulder fillet"),
        ("fillet of 1 cm, 40 deg", "--shoulder fillet --delta 40"),
        *((f"FLIP {share}", f"--flip {share}") for share in (0.99, 0.9, 0)),
        ("FLIP 0.99, Courant 0.2", "--flip 0.99 --courant 0.2"),
        ("centre of mass", "--contact centre-of-mass"),
        ("centre of mass, 40 deg", "--contact centre-of-mass --delta 40"),
        ("centre of mass, no slip", "--contact centre-of-mass --no-slip"),
        *((f"K0 {k0}", f"--k0 {k0}") for k0 in (0.357, 1)),
        *((f"zone of {depth} m", f"--moving-depth {depth}") for depth in (0.03, 0.04, 0.08, 0.1)),
        ("to 0.3 s", "--end 0.3"),
    ]),
    "tips": ("Tips", [
        *((f"{tip}, {cells}", f"--tip {tip} {options}".strip())
          for cells, options in (("1 cm", ""), ("0.5 cm at the cone", "--cell-at-cone 0.005"))
          for tip in ("cone", "cone-truncated", "parabolic", "blunt")),
    ]),
    "offset": ("Contact offset, m", [(f"{offset}", f"--contact-offset={offset}") for offset in (-0.005, -0.0025, 0.0025, 0.005)]),
    "points": ("Points a triangle", each("points-per-element", [4, 9, 10, 15, 16, 21, 25, 28, 36, 49])),
    "cell": ("Cell size, m", each("cell", [0.02, 0.014, 0.01, 0.007, 0.005])),
    "cell-rough": ("Cell size, m, 40 deg", each("cell", [0.02, 0.014, 0.01, 0.007, 0.005], "--delta 40")),
    "dilatancy": ("Angle of dilatancy, deg",
                  [*each("dilatancy", [5, 10, 15, 20, 30, 40]),
                   *((f"{psi}, no averages", f"--dilatancy {psi} --anti-locking off") for psi in (20, 30, 40)),
                   *((f"{psi}, slice, 3 cm", f"{SLICE} --cell 0.03 --dilatancy {psi}") for psi in (8, 20)),
                   *((f"{psi}, elastic, 2 cm", f"--device elastic --cell 0.02 --dilatancy {psi}") for psi in (20, 40))]),
    "courant": ("Courant number", each("courant", [0.1, 0.2, 0.5, 0.7, 0.9])),
    "locking": ("No anti-locking", [
        (label, f"--anti-locking off {options}".strip()) for label, options in [
            ("1 cm, 28 points", ""),
            *((f"{n} points", f"--points-per-element {n}") for n in (9, 10, 16, 49)),
            *((f"cell {h}", f"--cell {h}") for h in (0.02, 0.014, 0.007, 0.005)),
            ("40 deg", "--delta 40"),
            *((f"slice, 2 cm, {n} points", f"{COARSE_SLICE} --points-per-element {n}") for n in (10, 20)),
        ]
    ]),
    "law": ("Friction of the sand, constants of the sources", [
        (f"{label}, {delta} deg", f"{options} --delta {delta}") for label, options in LAWS.items() for delta in (20, 32, 40)
    ]),
    "elastic": ("Elastic penetrometer", [
        (label, f"--device elastic {options}".strip()) for label, options in [
            ("20 deg", ""), ("40 deg", "--delta 40"), ("no slip", "--no-slip"), ("2 cm", "--cell 0.02"),
        ]
    ]),
    "coarse-slice": ("Slice, 2 cm", [
        *((f"{n} points", f"{COARSE_SLICE} --points-per-element {n}") for n in (10, 20, 35)),
        *((f"40 deg, {n} points", f"{COARSE_SLICE} --delta 40 --points-per-element {n}") for n in (10, 20)),
        ("centre of mass, 20 points", f"{COARSE_SLICE} --contact centre-of-mass --points-per-element 20"),
        *((f"elastic, {n} points", f"{COARSE_SLICE} --device elastic --points-per-element {n}") for n in (10, 20)),
        ("axisymmetric, 28 points", "--cell 0.02"),
        ("axisymmetric, 10 points", "--cell 0.02 --points-per-element 10"),
        ("axisymmetric, 40 deg", "--cell 0.02 --delta 40"),
        ("axisymmetric, centre of mass", "--cell 0.02 --contact centre-of-mass"),
    ]),
    "slice": ("Slice, 1 cm", [
        ("10 points", SLICE),
        ("10 points, Courant 0.9", SLICE + " --courant 0.9"),
        ("20 points", SLICE + " --points-per-element 20"),
        ("40 deg, 10 points", SLICE + " --delta 40"),
        ("elastic, 10 points", SLICE + " --device elastic"),
    ]),
    "grid": ("The grid, linear rate term of 1e-3 s", [
        (f"{contact}, {delta} deg, {sizes}", f"--mesh-kind grid --law linear-rate --contact {contact} --delta {delta} --cell {sizes}")
        for contact, refined in (("rigid", ()), ("points", ("0.01 --cell-at-cone 0.005", "0.01 --cell-at-cone 0.0025",
                                                            "0.01 --cell-at-cone 0.0025 --split 9")))
        for delta in (20, 40) for sizes in ("0.02", "0.01", "0.005", *refined)
    ] + [(f"Mohr-Coulomb, {delta} deg", f"--mesh-kind grid --delta {delta}") for delta in (20, 40)]),
}
# The lines of the picture: what a run costs, and what it answers.
TRADE = {
    "cells of 2 to 0.5 cm": TABLES["cell"][1],
    "9 to 49 points a triangle": TABLES["points"][1][1:],
    "Courant number 0.9 to 0.1": TABLES["courant"][1][::-1],
    "slice, 2 cm, 10 to 35 points": TABLES["coarse-slice"][1][:3],
    "slice, 1 cm, 10 (Courant 0.9, 0.5) and 20 points": [TABLES["slice"][1][k] for k in (1, 0, 2)],
}
TABLES["trade"] = ("Speed against accuracy: the drops of the picture",
                   [(f"{line}: {label}", options) for line, rows in TRADE.items() for label, options in rows])

PAGE = """# The penetrometer's drop: what each option does

Appendix of [ffp.md](ffp.md): every drop behind its numbers. `examples/ffp/scripts/study.py --page docs/ffp_tables.md` runs them all and writes this page; do
not edit it. Where nothing else is said: axisymmetric, rigid, delta = 20 deg, cells of 1 cm. Peaks are of the 2 ms mean; the last column is the
time of the steps."""


class Runs:
    """Drops by their options, each run once, in a folder of its own."""

    def __init__(self, driver, folder, common, threads):
        self.driver, self.folder, self.common, self.threads = driver, folder, common, threads

    def place(self, options):
        signed = re.sub(r"[ =]-(?=[0-9.])", " minus ", f"{options} {self.common}".lower())
        words = re.sub(r"[^a-z0-9.]+", "-", signed).strip("-")
        return os.path.join(self.folder, words or "default")

    def drop(self, options):
        """The summary of a drop; one that failed on its way says so in its status. Ends the study if there is none."""
        place = self.place(options)
        found = self.ended(place)
        if found is None:
            command = [self.driver, "drop", *options.split(), *self.common.split(), "--threads", str(self.threads),
                       "--fields-every", "0", "--quiet", "--out", place]
            print(" ".join(command), file=sys.stderr, flush=True)
            done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=sys.stderr)
            found = self.ended(place)
            if found is None:
                sys.exit(f"study.py: the drop stopped with exit code {done.returncode} and has no result in {place}")
        return found

    @staticmethod
    def ended(place):
        """The summary in a folder, if it is that of a run that came to an end of its own; else none."""
        try:
            found = read_json(os.path.join(place, "summary.json"))
        except FileNotFoundError:
            return None
        except (OSError, ValueError) as problem:
            sys.exit(f"study.py: {place}: must hold the summary.json of a drop, or none ({problem})")
        return found if found["status"] in ("done", "failed") else None

    def peaks(self, options, windows):
        """Greatest mean of the deceleration, g, over each of some windows, s, of a drop that has been run."""
        table = read_table(os.path.join(self.place(options), "history.csv"), "time_s", "acceleration_m_s2")
        time = table["time_s"]
        # The acceleration of a row holds since the row before.
        parts = [mean * (b - a) for mean, a, b in zip(table["acceleration_m_s2"][1:], time, time[1:])]
        integral = [0.0, *itertools.accumulate(parts)]

        def until(t):
            k = min(max(bisect.bisect_right(time, t) - 1, 0), len(time) - 2)
            return integral[k] + (integral[k + 1] - integral[k]) * (t - time[k]) / (time[k + 1] - time[k])

        def mean(t, window):
            a, b = max(t - window / 2, time[0]), min(t + window / 2, time[-1])
            return (until(b) - until(a)) / (b - a)

        return [max(mean(t, window) for t in time) / GRAVITY for window in windows]


def add_run_arguments(parser, out):
    """Where the driver is, where results go (`out`, a folder in the checkout), and how each drop is run."""
    parser.add_argument("--driver", metavar="FILE", help="arenite-ffp [that which examples/ffp/run.sh builds]",
                        default=os.path.join(ROOT, "build", "ffp", "examples", "ffp", "arenite-ffp"))
    parser.add_argument("--out", metavar="DIR", default=os.path.join(ROOT, out), help=f"folder of the results [{out}]")
    parser.add_argument("--options", default="", help="options that every drop gets, in quotes")
    parser.add_argument("--threads", type=int, default=0, help="threads, 0 for all [0]")


def runs_of(arguments):
    """The drops that those arguments ask for; ends the program if there is no driver."""
    if not os.access(arguments.driver, os.X_OK):
        sys.exit(f"{os.path.basename(sys.argv[0])}: {arguments.driver}: is no program; examples/ffp/run.sh builds it")
    return Runs(arguments.driver, arguments.out, arguments.options, arguments.threads)


def row(label, found):
    """One line of a table."""
    if found["status"] != "done":
        return f"| {label} | stopped: {found['failure']} | | | | | | | |"
    second = "-"
    if found["second_peak_deceleration_g"] is not None:
        second = f"{found['second_peak_deceleration_g']:.1f}, {found['second_peak_time_s'] * 1e3:.0f}"
    length = f"{found['dt_min_s'] * 1e6:.3g} to {found['dt_max_s'] * 1e6:.3g}"
    return (f"| {label} | {found['final_penetration_m']:.4f} | {found['max_penetration_m']:.4f}, "
            f"{found['max_penetration_time_s'] * 1e3:.0f} | {found['peak_deceleration_g']:.1f}, "
            f"{found['peak_time_s'] * 1e3:.1f}, {found['peak_penetration_m']:.3f} | {second} | "
            f"{round(found['energy_residual'] * 100, 1) + 0:.1f} | {found['points']:,} | {found['steps']:,} of {length} | {found['wall_s']:.1f} |")


def table(runs, name):
    """Lines of a table, one by one, as its drops come to their ends."""
    title, rows = TABLES[name]
    yield from ("", f"**{title}**", "", "|  | final depth, m | greatest, m, at ms | peak, g, at ms, at m | second peak, g, at ms | "
                "residual, % | points | steps, us | s |", "|---" * 9 + "|")
    for label, options in rows:
        yield row(label, runs.drop(options))
    if name == "open":
        windows = [0.5e-3, 1e-3, 2e-3, 4e-3]
        found = zip(windows, runs.peaks("", windows))
        yield from ("", "Peak of the default drop by the window of its mean: " +
                    ", ".join(f"{window * 1e3:g} ms {peak:.1f} g" for window, peak in found))


def drawing():
    """What pictures need (pictures.py), or the end: asked for before the drops are run, and only then."""
    import pictures

    return pictures


def draw(runs, path, pictures):
    """The trade: seconds of each run against its depth and its peak."""
    figure, panels = pictures.pyplot.subplots(1, 2, figsize=(11, 4.6), constrained_layout=True)
    for (line, rows), colour, marker in zip(TRADE.items(), [*pictures.COLOURS[:4], pictures.COLOURS[6]], "osD^v"):
        drops = [found for found in (runs.drop(options) for _, options in rows) if found["status"] == "done"]
        seconds = [found["wall_s"] for found in drops]
        for axes, key, factor in zip(panels, ("final_penetration_m", "peak_deceleration_g"), (100, 1)):
            axes.plot(seconds, [found[key] * factor for found in drops], color=colour, marker=marker, label=line, linewidth=1.4)
    default = runs.drop("")
    for axes, value, paper, text in ((panels[0], default["final_penetration_m"] * 100, 20, "final depth [cm]"),
                                     (panels[1], default["peak_deceleration_g"], 17, "peak, 2 ms mean [g]")):
        axes.plot([default["wall_s"]], [value], "*", color="#E69F00", markeredgecolor="#333333", markersize=15, zorder=5,
                  label="the default drop")
        axes.axhline(paper, color="#6b6b6b", linewidth=1, linestyle=(0, (5, 3)), zorder=0)
        axes.text(0.99, paper, "the paper", color="#6b6b6b", fontsize=8, ha="right", va="bottom",
                  transform=axes.get_yaxis_transform())
        axes.set(xscale="log", xlabel=f"time of the steps [s], {default['threads']} threads", ylabel=text)
        axes.xaxis.set_major_formatter("{x:g}")
        axes.spines[["top", "right"]].set_visible(False)
    pictures.legend_below(figure, panels[0], 3, 0.12)
    pictures.save(figure, path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_run_arguments(parser, os.path.join("out", "study"))
    parser.add_argument("--only", metavar="TABLE", nargs="+", choices=list(TABLES), help="these tables [all]")
    parser.add_argument("--picture", metavar="FILE", help="draw the trade of speed for accuracy")
    parser.add_argument("--page", metavar="FILE.md", help="write the tables as a page, too")
    parser.add_argument("--list", action="store_true", help="say which tables there are, and stop")
    arguments = parser.parse_args()
    if arguments.list:
        for name, (title, rows) in TABLES.items():
            print(f"{name:13} {len(rows):3} drops  {title}")
        return
    pictures = drawing() if arguments.picture else None
    runs = runs_of(arguments)
    lines = [PAGE] if arguments.page else []
    for name in arguments.only or [name for name in TABLES if name != "trade" or not arguments.page]:  # rows of other tables
        for line in table(runs, name):
            print(line, flush=True)
            lines.append(line)
    if arguments.page:
        with replaced(arguments.page, "x") as file:
            file.write("\n".join(lines) + "\n")
    if arguments.picture:
        draw(runs, arguments.picture, pictures)


if __name__ == "__main__":
    main()
