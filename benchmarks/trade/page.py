"""Writes docs/trade.md, its pictures and the tables by problem, docs/trade_tables.md, from the rows: each number and each advice is taken from
them. The tables need the standard library alone, since the site of the documentation writes them where the package is not built."""

import ast
import contextlib
import functools
import statistics
import types
from pathlib import Path

from compositions import BASE, FLOAT, MORE, THREADS, Composition, every
from trade import HERE, SHARED, problems, read

TARGETS = [0.1, 0.03, 0.01, 0.003]  # errors that advice is given for
FAMILIES = ["FLIP", "APIC", "AFLIP", "TPIC", "XPIC", "FMPM", "PIC"]
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#6b6b6b"]  # Okabe and Ito
DASHES = {"linear": ":", "uGIMP": (0, (5, 1, 1, 1)), "quadratic": "-", "cubic": "--", "MLS": (0, (3, 1, 1, 1, 1, 1)), "triangles": "-."}
MARKS = {"MUSL": "s", "USL": "o", "USF": "^"}
MACHINE = "one core of a virtual Intel Xeon with AVX-512, of two, the other one busy, g++ 12 -O3"  # of rows.csv
STATE = "the code of 1 December 2026, before version 0.1.0"  # of rows.csv
CLEARLY = 1.2  # times of the processor agree to some 20 %


@functools.lru_cache(maxsize=None)
def constants(module):
    """Literals that a module of this folder gives names to, or takes from another one, and its docstring: read, since to import a problem takes
    numpy, the package and a compiler."""
    def path(name):
        return HERE / f"{name.replace('.', '/')}.py"

    tree = ast.parse(path(module).read_text())
    found = {"__doc__": ast.get_docstring(tree), "DIMENSION": 2}
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and path(node.module).exists():
            there = constants(node.module)
            found.update({a.name: there[a.name] for a in node.names if a.name in there})
        elif isinstance(node, ast.Assign):
            pair = node.targets[0], node.value
            for target, value in zip(*(side.elts for side in pair)) if all(isinstance(side, ast.Tuple) for side in pair) else [pair]:
                with contextlib.suppress(ValueError):  # computed
                    found[target.id] = ast.literal_eval(value)
    return found


def problem(name):
    """What a problem is called, its cells, and what a page says of it."""
    return types.SimpleNamespace(**constants(f"problems.{name}"))


def dimension(name):
    return problem(name).DIMENSION


class Row:
    """A row of the table with numbers in the place of texts."""

    def __init__(self, given):
        self.problem, self.of = given["problem"], Composition.of(given)
        self.composition = self.of.name
        for choice, value in self.of.columns().items():
            setattr(self, choice, value)
        self.per_cell, self.cells, self.courant = int(given["per_cell"]), int(given["cells"]), float(given["courant"])
        self.failure = given["failure"]
        self.error, self.seconds = (float(given[k]) if given[k] else float("inf") for k in ("error", "seconds"))
        self.steps, self.points, self.bytes = (int(given[k] or 0) for k in ("steps", "points", "bytes"))

    @property
    def usual(self):
        return self.courant == 0.5 and self.per_cell == self.of.points(dimension(self.problem))[0]

    @property
    def rate(self):
        """Point-steps a second."""
        return self.steps * self.points / self.seconds


def rows_of(out):
    return [Row(r) for r in read(Path(out) / "rows.csv")]


def on_one(rows):
    """Rows of one thread, whose seconds can be compared."""
    return [r for r in rows if r.threads == 1]


def kept_error(r, rows):
    """The error that the composition of a row of a problem keeps on finer cells, too (at the usual points and steps, and at its own), so that what
    is exact by chance does not count."""
    return max([r.error, *(o.error for o in rows if o.composition == r.composition and o.cells > r.cells
                           and (o.usual or (o.per_cell, o.courant) == (r.per_cell, r.courant)))])


def cheapest(rows, target):
    """The row of a problem of the least time whose error is kept below `target`; None."""
    return min((r for r in rows if kept_error(r, rows) <= target), key=lambda r: r.seconds, default=None)


def front(rows):
    """Rows of a problem with an error that may be of use, than which none is both more exact and cheaper."""
    kept, best = [], TARGETS[0] * (1 + 1e-9)
    for r in sorted(rows, key=lambda r: (r.seconds, kept_error(r, rows))):
        if kept_error(r, rows) < best:
            kept.append(r)
            best = kept_error(r, rows)
    return kept


def dominated(of):
    """Compositions for each of whose rows of use, on every problem, another composition is clearly cheaper and no less exact. of: rows by problem."""
    def beaten(r, rows):
        return kept_error(r, rows) > TARGETS[0] or any(o.composition != r.composition and kept_error(o, rows) <= kept_error(r, rows)
                                                       and o.seconds * CLEARLY < r.seconds for o in rows)

    names = list(dict.fromkeys(r.composition for rows in of.values() for r in rows))
    everywhere = [n for n in names if all(any(r.composition == n for r in rows) for rows in of.values())]
    return [n for n in everywhere if all(beaten(r, rows) for rows in of.values() for r in rows if r.composition == n)]


def percent(x):
    return f"{100 * x:.2g} %" if x < 0.995 else f"{100 * x:.0f} %"


def time_of(x):
    return f"{x:.2g} s"


def shown(name):
    return name.replace("_", " ")


def ratio(x):
    return f"{x:.2g}" if x < 99.5 else f"{x:.0f}"


def count(n, word):
    return f"{n} {word}" + ("" if n == 1 else "s")


def numbers(r):
    """The cells of a row, its points a cell and, where it is not the usual one, its Courant number."""
    return f"{r.cells} cells, {count(r.per_cell, 'point')}" + ("" if r.courant == 0.5 else f", Courant number {r.courant:g}")


def advice(rows, target):
    """A line on the cheapest row for an error."""
    r = cheapest(rows, target)
    if r is None:
        return f"- {percent(target)}: none."
    return f"- {percent(target)}: `{r.composition}`, {numbers(r)}: {percent(r.error)} in {time_of(r.seconds)}."


def advices(rows):
    """Until none reaches it."""
    lines = []
    for target in TARGETS:
        lines.append(advice(rows, target))
        if cheapest(rows, target) is None:
            break
    return lines


CHOICES = ("shape", "transfer", "order", "average", "number", "threads", "per_cell", "courant")
CHANGES = [("per_cell", 4, 9, "9 points a cell for 4"), ("per_cell", 4, 1, "1 point a cell for 4"), ("per_cell", 3, 6, "6 points a triangle for 3"),
           ("per_cell", 3, 1, "1 point a triangle for 3"), ("per_cell", 8, 27, "27 points a cell for 8"), ("per_cell", 8, 1, "1 point a cell for 8"),
           ("per_cell", 4, 10, "10 points a tetrahedron for 4"), ("courant", 0.5, 0.9, "a Courant number of 0.9 for 0.5"),
           ("courant", 0.5, 0.25, "a Courant number of 0.25 for 0.5"), ("order", "MUSL", "USL", "USL for MUSL"), ("order", "MUSL", "USF", "USF for MUSL"),
           ("shape", "quadratic", "linear", "linear functions for quadratic"), ("shape", "quadratic", "uGIMP", "uGIMP for quadratic B-splines"),
           ("shape", "quadratic", "cubic", "cubic B-splines for quadratic"),
           ("shape", "quadratic", "MLS", "MLS gradients for those of quadratic B-splines"), ("transfer", "FLIP", "FLIP, time", "FLIP with a time for FLIP"),
           ("transfer", "FLIP", "PIC", "PIC for FLIP"), ("transfer", "FLIP", "APIC", "APIC for FLIP"), ("transfer", "FLIP", "XPIC(2)", "XPIC(2) for FLIP"),
           ("transfer", "FLIP", "FMPM(4)", "FMPM(4) for FLIP"), ("transfer", "APIC", "AFLIP", "AFLIP for APIC"),
           ("average", "none", "nodal", "the nodal average for none"),
           ("average", "nodal", "nodal and element", "the nodal and element average for the nodal one"), ("number", "double", "float", "float for double"),
           ("threads", 1, 2, "two threads for one, on the finest cells")]


def pairs(rows, differs, a, b):
    """Medians of time and error of rows that differ in one choice, b over a; None."""
    def others(r):
        return (r.problem, r.cells, *(getattr(r, k) for k in CHOICES if k != differs))

    first = {others(r): r for r in rows if getattr(r, differs) == a and not r.failure}
    second = {others(r): r for r in rows if getattr(r, differs) == b and not r.failure}
    both = [(first[k], second[k]) for k in first if k in second]
    if not both:
        return None
    return [statistics.median(q(y) / q(x) for x, y in both) for q in (lambda r: r.seconds, lambda r: r.error)]


def changes(rows):
    """Lines on points and steps."""
    lines = []
    for differs, a, b, words in CHANGES:
        found = pairs(rows, differs, a, b)
        if found and differs in ("per_cell", "courant"):
            lines.append(f"- {words[0].upper() + words[1:]}: {found[0]:.2f} times the time, {found[1]:.2f} times the error (medians).")
    return lines


def what_changes(rows, of):
    """A table: what each choice changes in time, and in error by problem."""
    lines = ["| choice | time | " + " | ".join(map(shown, of)) + " |", "|" + "---|" * (2 + len(of))]
    for differs, a, b, words in CHANGES:
        found = pairs(rows, differs, a, b)
        if found:
            each = [pairs(of[n], differs, a, b) for n in of]
            lines.append(f"| {words} | {found[0]:.2f} | " + " | ".join("" if e is None else ratio(e[1]) for e in each) + " |")
    return lines


def in_words(rows, of):
    """What each choice costs, and on which problems it halves or doubles the error at least."""
    lines, others = [], []
    for differs, a, b, words in CHANGES:
        found = pairs(rows, differs, a, b)
        if not found:
            continue
        each = {shown(n): pairs(of[n], differs, a, b) for n in of}
        halved, doubled = ([f"{n} ({ratio(e[1])})" for n, e in each.items() if e and test(e[1])] for test in (lambda q: q <= 0.5, lambda q: q >= 2))
        said = [f"{word}: {', '.join(names)}" for word, names in (("less error", halved), ("more error", doubled)) if names]
        if said:
            lines.append(f"- **{words}**: time {found[0]:.2f}; {'; '.join(said)}.")
        else:
            others.append(f"{words} ({found[0]:.2f})")
    return [*lines, "", f"No error is halved or doubled by these (time): {', '.join(others)}."]


def orders(rows, sizes, theory):
    """Error, observed order and time of each composition by size of the cells, at the usual points and steps."""
    import math

    lines = [f"| composition | {' | '.join(f'{n} cells' for n in sizes)} | order | s | ns a point and step |",
             "|" + "---|" * (len(sizes) + 4)]
    for name in dict.fromkeys(r.composition for r in rows):
        mine = {r.cells: r for r in rows if r.composition == name and r.usual}
        cells, last = [], None
        for n in sizes:
            r = mine.get(n)
            cells.append("" if r is None else "failed" if r.failure else f"{r.error:.3g}")
        there = [mine[n] for n in sizes if n in mine and not mine[n].failure]
        if len(there) > 1:
            a, b = there[-2:]
            last = f"{math.log(a.error / b.error) / math.log(b.cells / a.cells):.2f}"
        costs = f"{there[-1].seconds:.2g} | {1e9 / there[-1].rate:.0f}" if there else " | "
        lines.append(f"| {name} | {' | '.join(cells)} | {last or ''} | {costs} |")
    return [*lines, "", f"Order: of the last two sizes; theory: {theory}. s, ns: on the finest cells that ran."]


def failures(rows):
    """Rows that failed, by the cause and what they share."""
    found = {}
    for r in rows:
        if r.failure:
            where = f"{r.cells} cells, {count(r.per_cell, 'point')} a cell, Courant number {r.courant:g}: {r.failure}"
            found.setdefault(where, []).append(f"`{r.composition}`")
    return [f"- {where}: {', '.join(names)}" for where, names in found.items()]


def best_table(rows, of, names):
    """What compositions cost, and the problems on whose fronts they are."""
    lines = ["| composition | ns | ns, space | bytes | on the front of |", "|---|---|---|---|---|"]
    fronts = {n: {r.composition for r in front(of[n])} for n in of}
    for name in names:
        mine = [r for r in rows if r.composition == name]
        rates = [[1e9 / r.rate for r in mine if dimension(r.problem) == d and r.usual and not r.failure] for d in (2, 3)]
        costs = " | ".join(f"{statistics.median(q):.0f}" if q else "" for q in rates)
        bytes_of = max(r.bytes for r in mine if r.problem == "bar")
        lines.append(f"| {name} | {costs} | {bytes_of} | {', '.join(shown(n) for n in of if name in fronts[n])} |")
    return lines


def draw(rows, path, title):
    """Error over time of the processor: a line for each composition, the front ringed."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams.update({"svg.hashsalt": "trade", "svg.fonttype": "none"})
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(9.5, 5), constrained_layout=True)
    base = [c.name for c in BASE]
    for name in base:
        mine = sorted((r for r in rows if r.composition == name and r.usual and not r.failure), key=lambda r: r.cells)
        if not mine:
            continue
        r = mine[0]
        family = r.transfer.split("(")[0].split(",")[0]
        face = "none" if "time" in r.transfer or "average" in name else None
        axes.loglog([q.seconds for q in mine], [q.error for q in mine], linestyle=DASHES[r.shape], marker=MARKS[r.order], markersize=4,
                    linewidth=1.1, color=COLOURS[FAMILIES.index(family)], markerfacecolor=face, label=name)
    others = [r for r in rows if not r.failure and not (r.usual and r.composition in base)]
    axes.loglog([r.seconds for r in others], [r.error for r in others], ".", color="#c8c8c8", markersize=3, zorder=0,
                label="other points a cell, Courant numbers,\nand compositions")
    best = front(rows)
    axes.loglog([r.seconds for r in best], [r.error for r in best], "o", color="k", markerfacecolor="none", markersize=9, markeredgewidth=0.8,
                label="none is cheaper and more exact")
    axes.set(xlabel="time of one core [s]", ylabel="error", title=title)
    axes.spines[["top", "right"]].set_visible(False)
    figure.legend(loc="outside right upper", frameon=False, fontsize=8)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)


def refused():
    """What the library refuses of all products of names, by its sentence: [(sentence, how many, of how many)]."""
    import arenite as ar

    counts, all_of = {}, every()
    for c in all_of:
        try:
            c.numerics()
        except ar.Error as e:
            sentence = " ".join(str(e).split())
            counts[sentence] = counts.get(sentence, 0) + 1
    return sorted(counts.items(), key=lambda item: -item[1]), len(all_of)


def by_problem(rows):
    """Rows of each problem that has some, in the order of the pages."""
    found = {n: [r for r in rows if r.problem == n] for n in problems()}
    return {n: mine for n, mine in found.items() if mine}


def text(out):
    """The page of advice."""
    all_rows = rows_of(out)
    rows = on_one(all_rows)
    of = by_problem(rows)
    names = list(dict.fromkeys(r.composition for r in rows))
    on_front = [n for n in names if any(r.composition == n for mine in of.values() for r in front(mine))]
    lines = [
        "# What a result costs", "",
        "How wrong compositions are on problems with a known answer, and what that costs. All numbers are from `benchmarks/trade/rows.csv`",
        f"({len(all_rows)} runs, {len({r.composition for r in all_rows})} compositions). A run has a shape function, a transfer, an order of the stress",
        "update, an average, double or float, threads, points a cell, cells and a Courant number, 0.5 where none is given. Seconds are processor time",
        f"of the steps alone, on {MACHINE},",
        f"with {STATE}; they repeat to some 20 %. {len(BASE)} compositions ran in full; on {len(SHARED)} problems",
        f"{len(MORE)} more with two sizes of cells, {len(FLOAT)} in float (`dtype=\"float32\"` of the mesh) and {len(THREADS)} on two threads, in time of the",
        "clock. `FLIP, time` takes the period of the problem, or its whole time, as its time.", "",
        "All compositions by problem are on the page \"Tables of the trade\" of the documentation site. `benchmarks/trade/trade.py` writes this page",
        "with `--page docs/trade.md`, those tables with `--tables docs/trade_tables.md`.", "",
        "## The cheapest for an error", "",
        "| problem | kind | " + " | ".join(percent(t) for t in TARGETS) + " |", "|" + "---|" * (2 + len(TARGETS))]
    for n, mine in of.items():
        p, best = problem(n), [cheapest(mine, t) for t in TARGETS]
        cells = ["none" if r is None else f"`{r.composition}`, {numbers(r)}: {time_of(r.seconds)}" for r in best]
        lines.append(f"| [{p.TITLE}](#{anchor(p.TITLE)}) | {p.KIND} | {' | '.join(cells)} |")
    lines += ["", "A row counts if its composition keeps to the error on finer cells, too; \"none\": no row does. Points are those of a cell; each problem",
              "below says how its cells are counted, and repeats the two smallest errors that are reached. `arenite.recommend` reads the same",
              "table.", "",
              "## Where each composition is best", "",
              "On the front of a problem are rows with an error of at most 10 % than which none is both cheaper and more exact. ns: time of a point and",
              "step, median of all rows with the usual points and steps, in the plane and in space. Bytes: of a point of the vibrating bar, its number",
              "included.", "",
              *best_table(rows, of, on_front), "",
              f"The other {len(names) - len(on_front)} compositions are on no front. Dominated, of those that ran on all problems (for each of their rows of",
              f"at most 10 % another one is as exact, in less time by a sixth or more): {', '.join(f'`{n}`' for n in dominated(of)) or 'none'}.", "",
              "## What each choice changes", "",
              "Of rows that differ in one choice alone, medians of the ratios: of the time over all problems, and of the error where it is at least",
              "halved or doubled.", "", *in_words(all_rows, by_problem(all_rows)), "",
              "The points of a cell are computed side by side, in packs of up to eight numbers ([performance](performance.md)): up to there, more of them",
              "cost little."]
    for n, mine in of.items():
        p = problem(n)
        lines += ["", f"## {p.TITLE}", "", f"{p.__doc__} Error: {' '.join(p.ERROR.split('. ')[0].split())}. Cells: {p.CELLS_ARE}.", "",
                  f"![Error over time](images/trade/{n}.svg)", "", *[advice(mine, t) for t in TARGETS if cheapest(mine, t)][-2:]]
    found, all_of = refused()
    lines += ["", "## What does not go together", "",
              f"Of {all_of} products of the names in `compositions.py` the library refuses {sum(k for _, k in found)}:", "",
              *(f"- {k}: {sentence}" for sentence, k in found), ""]
    return "\n".join(lines)


def tables(out):
    """The page of all compositions by problem."""
    all_rows = rows_of(out)
    rows = on_one(all_rows)
    of = by_problem(rows)
    lines = ["# Tables of the trade", "",
             "All compositions of `benchmarks/trade/rows.csv` on each problem; advice, and what the words mean, are in [what a result costs](trade.md).",
             f"Seconds: {MACHINE}, with {STATE}; two threads: seconds of the clock.", "",
             "## Where each composition is best", "", *best_table(rows, of, dict.fromkeys(r.composition for r in rows)), "",
             "## What each choice changes", "",
             "Times over all problems, errors by problem, of rows that differ in this choice alone: medians of the ratios.", "",
             *what_changes(all_rows, by_problem(all_rows))]
    for n, mine in of.items():
        p = problem(n)
        lines += ["", f"## {p.TITLE}", "", *p.SOURCE.splitlines(), "", f"Error: {p.ERROR}. Cells: {p.CELLS_ARE}.", "",
                  f"![Error over time](images/trade/{n}.svg)", "", *advices(mine), *changes(mine), "", *orders(mine, p.CELLS, p.ORDER)]
        failed = failures(mine)
        if failed:
            lines += ["", "Failed:", "", *failed]
    return "\n".join(lines) + "\n"


def anchor(title):
    return "".join(c for c in title.lower() if c.isalnum() or c in " -").replace(" ", "-")


RECOMMENDED = HERE.parent.parent / "python" / "arenite" / "_trade.csv"


def recommended(out):
    """The table of `arenite.recommend`: rows of the fronts, without those that need a time of the problem."""
    import csv
    import dataclasses
    import io

    text, rows = io.StringIO(), on_one(rows_of(out))
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow("problem title measured shape transfer values order average dtype cells cells_are per_cell courant error seconds".split())
    for n in problems():
        p, mine = problem(n), [r for r in rows if r.problem == n and "time" not in r.transfer]
        for r in front(mine):
            numerics = r.of.numerics()
            shape, transfer, order, average = numerics.kinds()
            values = " ".join(f"{f.name}={getattr(numerics.transfer, f.name):g}" for f in dataclasses.fields(numerics.transfer)
                              if getattr(numerics.transfer, f.name) != f.default)
            writer.writerow([p.KIND, p.TITLE, p.__doc__.split("\n\n")[0].replace("\n", " "), shape, transfer, values, order, average, r.of.dtype, r.cells,
                             p.CELLS_ARE, r.per_cell, f"{r.courant:g}", f"{kept_error(r, mine):.4g}", f"{r.seconds:.4g}"])
    return text.getvalue()


def write(path, out):
    path.write_text(text(out))
    if path.resolve() == RECOMMENDED.parent.parent.parent / "docs" / "trade.md":
        RECOMMENDED.write_text(recommended(out))
    rows = on_one(rows_of(out))
    for n in problems():
        mine = [r for r in rows if r.problem == n]
        if mine:
            draw(mine, path.parent / "images" / "trade" / f"{n}.svg", problem(n).TITLE)
