#!/usr/bin/env python3
"""What compositions cost and how wrong they are, on problems whose answers are known.

    trade.py [--quick] [--all] [--only bar,spin] [--out FOLDER]     runs what is not in FOLDER/rows.csv yet, and appends row by row
    trade.py --page PAGE [--out FOLDER]                             writes docs/trade.md and its pictures from the rows
    trade.py --tables PAGE [--out FOLDER]                           writes the tables by problem, with the standard library alone
    trade.py --compare [--only bar,spin] --out FOLDER               ends with 1 where errors of FOLDER are not those of the table here

With a Python that has the package arenite, numpy and, for the page, matplotlib. A composition that the package does not have is compiled when it
first runs, 20 s each, and cached. --quick: compositions.BASE on two sizes of cells, no other numbers of points and
steps; --all: every composition that the library admits, in full."""

import argparse
import csv
import importlib
import math
import os
import signal
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

KEY = ["problem", "shape", "transfer", "order", "average", "per_cell", "cells", "courant", "number", "threads"]
COLUMNS = [*KEY, "error", "seconds", "steps", "points", "bytes", "figures", "failure"]


def problems():
    """Names, in the order of the page."""
    there = sorted(p.stem for p in (HERE / "problems").glob("*.py"))
    first = ["bar", "drifting_bar", "impact", "spin", "cantilever", "settling", "discs", "slope", "manufactured_1", "manufactured_5",
             "manufactured_20", "manufactured_cube", "vortex", "footing", "collapse", "tall_collapse", "ball", "drop"]
    return [n for n in first if n in there] + [n for n in there if n not in first]


def problem(name):
    return importlib.import_module(f"problems.{name}")


def read(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def key(row):
    return tuple(str(row[k]) for k in KEY)


class Rows:
    """A table that grows by a row at a time; a row that is there is not asked for again."""

    def __init__(self, path):
        self.path = path
        self.keys = {key(row) for row in read(path)}

    def __contains__(self, row):
        return key(row) in self.keys

    def append(self, row):
        new = not self.path.exists()
        with open(self.path, "a", newline="") as file:
            writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            if new:
                writer.writeheader()
            writer.writerow(row)
        self.keys.add(key(row))


#: Which cells of a problem run at the usual points and steps, and whether other points and steps run where cells are coarse.
FULL, ALL_CELLS, COARSE, FINEST = (slice(None), True), (slice(None), False), (slice(2), False), (slice(-1, None), False)


#: Problems whose scenes are of types that others share: MORE and FLOAT, too, run on these.
SHARED = ["bar", "drifting_bar", "impact", "spin", "cantilever", "settling", "discs", "slope", "footing", "collapse"]


def groups(name):
    """Compositions that run on a problem, and how much of it."""
    from compositions import BASE, FLOAT, MORE, THREADS

    more = [(MORE, COARSE), (FLOAT, ALL_CELLS), (THREADS, FINEST)] if name in SHARED else []
    return [(BASE, FULL), *more]


def plan(name, compositions, extent):
    """Rows to run of a problem."""
    p, (which, more) = problem(name), extent
    for c in compositions:
        usual, others = c.points(getattr(p, "DIMENSION", 2))
        chosen = [(n, usual, 0.5) for n in p.CELLS[which]]
        if more:
            chosen += [(n, k, 0.5) for n in p.CELLS[:2] for k in others] + [(p.CELLS[1], usual, courant) for courant in (0.25, 0.9)]
        for n, k, courant in chosen:
            yield c, {"problem": name, **c.columns(), "per_cell": k, "cells": n, "courant": courant}


def compare(names, out):
    """Sentences on the rows of a folder whose error is another one than that of the table here. What only rounds otherwise, as on a processor
    with another instruction set, stays below 2 %, but where sand flows."""
    expected, told = {key(row): row for row in read(HERE / "rows.csv")}, []
    found = [row for row in read(out / "rows.csv") if row["problem"] in names and key(row) in expected]
    for row in found:
        old, new = (r["failure"] or float(r["error"]) for r in (expected[key(row)], row))
        near = 0.2 if row["problem"] == "collapse" else 0.02
        same = bool(row["failure"]) == bool(expected[key(row)]["failure"]) if str in (type(old), type(new)) else abs(new - old) <= near * old + 1e-5
        if not same:
            told.append(f"{', '.join(k for k in key(row))}: error {new}, in the table {old}")
    return found, told


class TooLong(Exception):
    pass


def _too_long(*_):
    raise TooLong


def measure(c, row, longest):
    """A row with its error and cost; one that fails has the sentence. Short runs are repeated, and their mean time counts."""
    import arenite as ar
    from common import Clock, Failed

    p, times = problem(row["problem"]), []
    ar.set_threads(c.threads)
    signal.signal(signal.SIGPROF, _too_long)
    try:
        while not times or (len(times) < 50 and sum(times) < 0.2):  # the processor's clock may go in 4 ms
            clock = Clock(c.threads)
            signal.setitimer(signal.ITIMER_PROF, longest)
            found = p.solve(c, row["cells"], row["per_cell"], row["courant"], clock)
            signal.setitimer(signal.ITIMER_PROF, 0)
            times.append(clock.seconds)
        error = float(found.pop("error"))
        if not math.isfinite(error):
            raise Failed("the result is not a number")
        figures = "; ".join(f"{name} {value:.6g}" for name, value in found.items())
        return {**row, "error": f"{error:.4g}", "seconds": f"{sum(times) / len(times):.4g}", "steps": clock.steps,
                "points": round(clock.point_steps / max(clock.steps, 1)), "bytes": clock.bytes, "figures": figures}
    except TooLong:
        return {**row, "failure": f"stopped after {longest:g} s"}
    except (ar.Error, ar.RunError, Failed) as e:
        return {**row, "failure": " ".join(str(e).split())}
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def admitted():
    """All compositions that the library does not refuse."""
    import arenite as ar
    from compositions import every

    for c in every():
        try:
            c.numerics()
        except ar.Error:
            continue
        yield c


def run(names, out, quick, every, longest):
    from compositions import BASE

    out.mkdir(parents=True, exist_ok=True)
    rows = Rows(out / "rows.csv")
    for name in names:
        chosen = [(list(admitted()), FULL)] if every else [(BASE, COARSE)] if quick else groups(name)
        for c, row in (planned for compositions, extent in chosen for planned in plan(name, compositions, extent)):
            if row in rows:
                continue
            done = measure(c, row, longest)
            rows.append(done)
            told = done.get("failure") or f"error {done['error']} in {done['seconds']} s"
            print(f"{name}: {c.name}; {row['cells']} cells, {row['per_cell']} points, {row['courant']}: {told}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--only", default="", help="names of problems, with commas")
    parser.add_argument("--out", type=Path, default=HERE, help="folder of rows.csv [benchmarks/trade]")
    parser.add_argument("--page", type=Path, help="writes the page instead")
    parser.add_argument("--tables", type=Path, help="writes the tables by problem instead")
    parser.add_argument("--compare", action="store_true", help="compares --out with the table here instead")
    parser.add_argument("--longest", type=float, default=60, help="seconds of the processor that one run may take [60]")
    given = parser.parse_args()
    names = given.only.split(",") if given.only else problems()
    if unknown := set(names) - set(problems()):
        parser.error(f"--only {', '.join(sorted(unknown))}: must be of {', '.join(problems())}")
    if given.page:
        import page

        page.write(given.page, given.out)
    elif given.tables:
        import page

        given.tables.write_text(page.tables(given.out))
    elif given.compare:
        found, told = compare(names, given.out)
        print(*told, f"{len(found)} rows compared, {len(told)} differ", sep="\n")
        sys.exit(bool(told) or not found)
    else:
        run(names, given.out, given.quick, given.all, given.longest)


if __name__ == "__main__":
    os.environ.setdefault("ARENITE_THREADS", "1")
    main()
