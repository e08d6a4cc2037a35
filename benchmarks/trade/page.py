"""Writes docs/trade.md and its pictures from the rows: each number and each advice of the page is taken from them."""

import statistics
from pathlib import Path

from trade import problem, problems, read

TARGETS = [0.1, 0.03, 0.01, 0.003]  # errors that advice is given for
FAMILIES = ["FLIP", "APIC", "AFLIP", "TPIC", "XPIC", "FMPM", "PIC"]
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#6b6b6b"]  # Okabe and Ito
DASHES = {"linear": ":", "uGIMP": (0, (5, 1, 1, 1)), "quadratic": "-", "cubic": "--", "triangles": "-."}
MARKS = {"MUSL": "s", "USL": "o", "USF": "^"}
CLEARLY = 1.1  # times of the processor agree to some 10 %


class Row:
    """A row of the table with numbers in the place of texts."""

    def __init__(self, given):
        self.problem, self.composition = given["problem"], composition(given)
        self.shape, self.transfer, self.order = given["shape"], given["transfer"], given["order"]
        self.per_cell, self.cells, self.courant = int(given["per_cell"]), int(given["cells"]), float(given["courant"])
        self.failure = given["failure"]
        self.error, self.seconds = (float(given[k]) if given[k] else float("inf") for k in ("error", "seconds"))
        self.steps, self.points = (int(given[k] or 0) for k in ("steps", "points"))

    @property
    def usual(self):
        return self.courant == 0.5 and self.per_cell in (3, 4)

    @property
    def rate(self):
        """Point-steps a second."""
        return self.steps * self.points / self.seconds


def composition(given):
    return "; ".join([given["shape"], given["transfer"], given["order"]] + ([] if given["average"] == "none" else [given["average"] + " average"]))


def rows_of(out):
    return [Row(r) for r in read(Path(out) / "rows.csv")]


def cheapest(rows, target):
    """The row of the least time with an error of at most `target`; None."""
    return min((r for r in rows if r.error <= target), key=lambda r: r.seconds, default=None)


def front(rows):
    """Rows than which none is both more exact and cheaper."""
    kept, best = [], float("inf")
    for r in sorted((r for r in rows if not r.failure), key=lambda r: (r.seconds, r.error)):
        if r.error < best:
            kept.append(r)
            best = r.error
    return kept


def dominated(rows):
    """Compositions for each of whose rows, on every problem, another composition's is clearly cheaper and no less exact."""
    names = list(dict.fromkeys(r.composition for r in rows))

    def beaten(r):
        return r.failure or any(o.problem == r.problem and o.composition != r.composition and o.error <= r.error
                                and o.seconds * CLEARLY < r.seconds for o in rows)

    return [n for n in names if all(beaten(r) for r in rows if r.composition == n)]


def percent(x):
    return f"{100 * x:.2g} %" if x < 0.995 else f"{100 * x:.0f} %"


def time_of(x):
    return f"{x:.2g} s"


def told(r):
    return f"`{r.composition}` on {r.cells} cells, {r.per_cell} points a cell, Courant number {r.courant:g}"


def advice(rows, target):
    """A sentence on the cheapest row for an error."""
    r = cheapest(rows, target)
    if r is None:
        best = min(rows, key=lambda r: r.error)
        return f"- For {percent(target)}: none of these; the least error is {percent(best.error)}, {told(best)}, {time_of(best.seconds)}."
    return f"- For {percent(target)} the cheapest is {told(r)}: {percent(r.error)} in {time_of(r.seconds)}."


def advices(rows):
    """Until none reaches it."""
    lines = []
    for target in TARGETS:
        lines.append(advice(rows, target))
        if cheapest(rows, target) is None:
            break
    return lines


def pairs(rows, differs, a, b):
    """Medians over compositions and sizes of time and error of rows that differ in one thing, b over a; None."""
    def others(r):
        return (r.problem, r.composition, r.cells, *(getattr(r, k) for k in ("per_cell", "courant") if k != differs))

    first = {others(r): r for r in rows if getattr(r, differs) == a and not r.failure}
    second = {others(r): r for r in rows if getattr(r, differs) == b and not r.failure}
    both = [(first[k], second[k]) for k in first if k in second]
    if not both:
        return None
    return [statistics.median(q(y) / q(x) for x, y in both) for q in (lambda r: r.seconds, lambda r: r.error)]


CHANGES = [("per_cell", 4, 9, "9 points a cell for 4"), ("per_cell", 4, 1, "1 point a cell for 4"), ("per_cell", 3, 6, "6 points a triangle for 3"),
           ("per_cell", 3, 1, "1 point a triangle for 3"), ("courant", 0.5, 0.9, "a Courant number of 0.9 for 0.5"),
           ("courant", 0.5, 0.25, "a Courant number of 0.25 for 0.5")]


def changes(rows):
    lines = []
    for differs, a, b, words in CHANGES:
        found = pairs(rows, differs, a, b)
        if found:
            lines.append(f"- {words[0].upper() + words[1:]}: {found[0]:.2g} times the time, {found[1]:.2g} times the error (medians).")
    return lines


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
    lines = []
    for r in rows:
        if r.failure:
            lines.append(f"- {told(r)}: {r.failure}")
    return lines


def draw(rows, path, title):
    """Error over time of the processor: a line for each composition, the front ringed."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams.update({"svg.hashsalt": "trade", "svg.fonttype": "none"})
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(9.5, 5), constrained_layout=True)
    for name in dict.fromkeys(r.composition for r in rows):
        mine = sorted((r for r in rows if r.composition == name and r.usual and not r.failure), key=lambda r: r.cells)
        if not mine:
            continue
        r = mine[0]
        family = r.transfer.split("(")[0].split(",")[0]
        face = "none" if "time" in r.transfer or "average" in name else None
        axes.loglog([q.seconds for q in mine], [q.error for q in mine], linestyle=DASHES[r.shape], marker=MARKS[r.order], markersize=4,
                    linewidth=1.1, color=COLOURS[FAMILIES.index(family)], markerfacecolor=face, label=name)
    others = [r for r in rows if not r.usual and not r.failure]
    axes.loglog([r.seconds for r in others], [r.error for r in others], ".", color="#c8c8c8", markersize=3, zorder=0,
                label="other points a cell, Courant numbers")
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
    from compositions import every

    counts, all_of = {}, every()
    for c in all_of:
        try:
            c.numerics()
        except ar.Error as e:
            sentence = " ".join(str(e).split())
            counts[sentence] = counts.get(sentence, 0) + 1
    return sorted(counts.items(), key=lambda item: -item[1]), len(all_of)


def text(out):
    """The page."""
    rows = rows_of(out)
    there = [n for n in problems() if any(r.problem == n for r in rows)]
    of = {n: [r for r in rows if r.problem == n] for n in there}
    lines = [
        "# What a result costs", "",
        "How wrong compositions are on problems with a known answer, and what that costs. Each row is one run: a shape function, a transfer, an order",
        "of the stress update, an average, points a cell, cells, a Courant number. The page is written by [benchmarks/trade](../benchmarks/trade/trade.py)",
        "from its table `rows.csv`; nothing on it is typed. Seconds are those of one core, of steps alone; they agree to some 10 %, for the machine did other",
        "work. Python has double precision alone. `FLIP, time` has the time of the problem: its period, unless it says otherwise.", "",
        "```sh", "benchmarks/trade/trade.py                          # runs what the table lacks, and appends row by row",
        "benchmarks/trade/trade.py --page docs/trade.md     # writes this page from it", "```", "",
        "## The cheapest for an error", "",
        "| problem | kind | " + " | ".join(percent(t) for t in TARGETS) + " |", "|" + "---|" * (2 + len(TARGETS))]
    for n in there:
        cells = []
        for t in TARGETS:
            r = cheapest(of[n], t)
            cells.append("none" if r is None else f"{r.composition}; {r.cells} cells; {r.per_cell} points; {r.courant:g}: {time_of(r.seconds)}")
        lines.append(f"| [{problem(n).TITLE}](#{anchor(problem(n).TITLE)}) | {problem(n).KIND} | {' | '.join(cells)} |")
    beaten = dominated(rows)
    lines += ["", "\"None\": no row of the table is as exact. Cells are counted as each problem says.", "",
              "## Dominated everywhere", "",
              "On every problem, for each of their rows, another composition is as exact in clearly less time (a tenth): "
              + (", ".join(f"`{n}`" for n in beaten) or "none") + ".", "", "## More points, longer steps", ""]
    lines += changes(rows)
    for n in there:
        p = problem(n)
        lines += ["", f"## {p.TITLE}", "", *p.SOURCE.splitlines(), "", f"Error: {p.ERROR}. Cells: {p.CELLS_ARE}.", "",
                  f"![Error over time of one core](images/trade/{n}.svg)", "", *advices(of[n]), *changes(of[n]), "",
                  *orders(of[n], p.CELLS, p.ORDER)]
        failed = failures(of[n])
        if failed:
            lines += ["", "Failed:", "", *failed]
    found, all_of = refused()
    lines += ["", "## What does not go together", "",
              f"Of {all_of} products of the names of `compositions.py` the library refuses {sum(k for _, k in found)}, with these sentences:", "",
              "| sentence | products |", "|---|---|", *(f"| {sentence} | {count} |" for sentence, count in found), ""]
    return "\n".join(lines)


def anchor(title):
    return "".join(c for c in title.lower() if c.isalnum() or c in " -").replace(" ", "-")


def write(path, out):
    path.write_text(text(out))
    rows = rows_of(out)
    for n in problems():
        mine = [r for r in rows if r.problem == n]
        if mine:
            draw(mine, path.parent / "images" / "trade" / f"{n}.svg", problem(n).TITLE)
