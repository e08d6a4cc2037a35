"""benchmarks/trade and docs/trade.md: the page is what the table says, and its advice the cheapest row."""

import contextlib
import csv
import re
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]
FOLDER = SOURCE / "benchmarks" / "trade"
PAGE = SOURCE / "docs" / "trade.md"


@pytest.fixture
def trade(ar, monkeypatch):
    monkeypatch.syspath_prepend(str(FOLDER))
    import trade

    return trade


@pytest.fixture
def table():
    with open(FOLDER / "rows.csv", newline="") as file:
        return list(csv.DictReader(file))


def test_page_is_what_the_table_says(trade):
    import page

    assert page.text(FOLDER) == PAGE.read_text(), "write it anew: benchmarks/trade/trade.py --page docs/trade.md"
    assert page.recommended(FOLDER) == page.RECOMMENDED.read_text()


def test_constants_of_problems_are_those_of_their_modules(trade):
    """A page reads them, without an import."""
    import page

    for name in trade.problems():
        told, module = page.problem(name), trade.problem(name)
        for word in ("TITLE", "KIND", "SOURCE", "ERROR", "CELLS", "CELLS_ARE", "ORDER", "__doc__"):
            assert getattr(told, word) == getattr(module, word), (name, word)
        assert told.DIMENSION == getattr(module, "DIMENSION", 2)


def test_tables_need_the_standard_library_alone(trade):
    """The site of the documentation writes them where nothing is built."""
    import page

    script = f"import sys; sys.path.insert(0, {str(FOLDER)!r}); import page; sys.stdout.write(page.tables(page.HERE))"
    found = subprocess.run([sys.executable, "-I", "-S", "-c", script], check=True, capture_output=True, text=True).stdout
    assert found == page.tables(FOLDER)


def test_tables_have_all_compositions_on_each_problem(trade, table):
    """Each error at the usual points and steps stands in its row, below the heading that the page of advice has, too."""
    import page

    parts = sections(page.tables(FOLDER))
    assert not set(sections(PAGE.read_text())) - set(parts) - {"The cheapest for an error", "What does not go together"}
    for name, rows in page.by_problem(page.on_one(page.rows_of(FOLDER))).items():
        lines = {line.split(" | ")[0]: line.split(" | ") for line in parts[page.problem(name).TITLE].splitlines() if line.startswith("| ")}
        for r in rows:
            cells = lines[f"| {r.composition}"]
            if r.usual:
                assert cells[1 + page.problem(name).CELLS.index(r.cells)] == ("failed" if r.failure else f"{r.error:.3g}")


def test_pictures_are_there():
    named = re.findall(r"\]\((images/trade/.*?)\)", PAGE.read_text())
    assert named and {p.name for p in (PAGE.parent / "images" / "trade").glob("*")} == {Path(n).name for n in named}
    assert all((PAGE.parent / n).stat().st_size > 0 for n in named)


def sections(text):
    """Those of a page, by heading."""
    return dict(part.split("\n", 1) for part in re.split(r"^## ", text, flags=re.MULTILINE)[1:])


def exact_enough(table, name, target):
    """Rows of a problem within an error, on finer cells of their composition too."""
    def composition(r):
        return [r[k] for k in ("shape", "transfer", "order", "average", "number")]

    def off(r):
        return bool(r["failure"]) or float(r["error"]) > target

    rows = [r for r in table if r["problem"] == name and r["threads"] == "1"]
    usual = ("4", "8") if name == "manufactured_cube" else ("3", "4")  # in space, in the plane

    def counts(o, r):
        same = o["courant"] == r["courant"] and o["per_cell"] == r["per_cell"]
        return composition(o) == composition(r) and int(o["cells"]) > int(r["cells"]) and (
            same or (o["courant"] == "0.5" and o["per_cell"] in usual))

    return [r for r in rows if not off(r) and not any(off(o) for o in rows if counts(o, r))]


ADVICE = r"`(.*?)`, (\d+) cells, (\d+) points?(?:, Courant number (\S+))?: "


def is_cheapest(table, name, target, told, cells, points, courant):
    """No row of the problem that is as exact as is asked takes less time, and the row is there."""
    best = min(exact_enough(table, name, float(target) / 100), key=lambda r: float(r["seconds"]), default=None)
    if best is None:
        return False
    average = [] if best["average"] == "none" else [best["average"] + " average"]
    number = [] if best["number"] == "double" else [best["number"]]
    return (told == "; ".join([best["shape"], best["transfer"], best["order"], *average, *number])
            and (cells, points, float(courant or 0.5)) == (best["cells"], best["per_cell"], float(best["courant"])))


def test_advice_is_the_cheapest_row(trade, table):
    """Each line of both pages."""
    import page

    names = list(dict.fromkeys(r["problem"] for r in table))
    for text, least in ((PAGE.read_text(), 1), (page.tables(FOLDER), 2)):
        parts = sections(text)
        for name in names:
            part = parts[trade.problem(name).TITLE]
            reached, missed = re.findall(rf"^- (\S+) %: {ADVICE}", part, re.MULTILINE), re.findall(r"^- (\S+) %: none", part, re.MULTILINE)
            assert all(is_cheapest(table, name, *line) for line in reached) and not any(exact_enough(table, name, float(t) / 100) for t in missed)
            assert len(reached) + len(missed) >= least


def test_table_of_advice_has_the_cheapest_rows(trade, table):
    lines = sections(PAGE.read_text())["The cheapest for an error"].strip().splitlines()
    targets = [cell.removesuffix(" %") for cell in lines[0].strip("| ").split(" | ")[2:]]
    rows = {re.match(r"\| \[(.*?)\]", line)[1]: line.strip("| ").split(" | ")[2:] for line in lines if line.startswith("| [")}
    names = list(dict.fromkeys(r["problem"] for r in table))
    assert set(rows) == {trade.problem(name).TITLE for name in names} and len(targets) == 4
    for name in names:
        for target, cell in zip(targets, rows[trade.problem(name).TITLE]):
            if cell == "none":
                assert not exact_enough(table, name, float(target) / 100)
            else:
                assert is_cheapest(table, name, target, *re.match(ADVICE, cell).groups())


def test_table_holds_each_composition_once(trade, table):
    keys = [trade.key(r) for r in table]
    assert len(set(keys)) == len(keys)
    for name in dict.fromkeys(r["problem"] for r in table):
        for compositions, extent in trade.groups(name):
            assert not [row for _, row in trade.plan(name, compositions, extent) if trade.key(row) not in set(keys)]
    assert all(bool(r["failure"]) != (float(r["error"] or 0) > 0 and float(r["seconds"] or 0) > 0) for r in table)


def test_rows_that_are_there_are_not_run_again(trade, tmp_path, monkeypatch):
    ran = []

    def measure(c, row, longest):
        ran.append(row)
        if row["cells"] == trade.problem("bar").CELLS[1]:
            return {**row, "failure": "it failed, with a comma"}
        return {**row, "error": "0.1", "seconds": "1", "steps": 1, "points": 1, "figures": ""}

    monkeypatch.setattr(trade, "measure", measure)
    from compositions import BASE

    for more in (2 * len(BASE), 0, 0):
        before = len(ran)
        trade.run(["bar"], tmp_path, quick=True, every=False, longest=1)
        assert len(ran) - before == more
    assert {r["failure"] for r in trade.read(tmp_path / "rows.csv")} == {"", "it failed, with a comma"}


def test_what_the_library_refuses_is_not_run(trade, ar):
    from arenite._recipe import check_together
    from compositions import SHAPES, Composition, every

    for shape, recipe in SHAPES.items():
        with contextlib.nullcontext() if Composition(shape, "FLIP", "MUSL").on_grid() else pytest.raises(ar.Error):
            check_together(recipe, "CartesianGrid")
    admitted = set(trade.admitted())
    assert Composition("quadratic", "APIC", "USL") in admitted and Composition("triangles", "APIC", "USL") not in admitted
    assert 0 < len(admitted) < len(every())
    with pytest.raises(ar.Error, match="APIC needs B-splines"):
        Composition("triangles", "APIC", "USL").numerics()


def test_elastica(trade):
    """Tips of Bisshopp and Drucker (1945), as Mattiasson (1981) tabulates them; a small weight has the deflection of linear theory."""
    from common import elastica

    for load, across, down in ((1, 0.94357, 0.30172), (2, 0.83936, 0.49346), (5, 0.61237, 0.71379), (10, 0.44500, 0.81061)):
        assert elastica(0.0, load)[-1][1:3] == pytest.approx((across, -down), abs=2e-5)
    assert elastica(1e-3, 0.0, 0.02)[-1][2] == pytest.approx(-1e-3 * (1 / 8 + 0.02 / 2), rel=1e-5)


def test_recommendation(trade, ar):
    """Is what the page advises, and runs."""
    import page

    rows = [r for r in page.on_one(page.rows_of(FOLDER)) if r.problem == "bar" and "time" not in r.transfer]
    for error in (0.1, 0.01):
        best, found = page.cheapest(rows, error), ar.recommend("vibration", error)
        assert (found.cells, found.per_cell, found.courant) == (best.cells, best.per_cell, best.courant)
        assert found.error <= error and found.seconds == best.seconds
        assert (found.numerics.kinds()[0], found.dtype) == (type(best.of.numerics().shape).__name__, best.of.dtype)
    footing = ar.recommend("bearing", 0.03)  # of one problem, which it names
    assert footing.cells == 2 and footing.measured == trade.problem("footing").__doc__ and "weightless" in str(footing)
    assert "on that problem alone, 2 cells below the half footing" in str(footing) and "refine cells until" in str(footing)
    loose, tight = ar.recommend("waves", 0.1), ar.recommend("waves", 0.01)
    assert tight.seconds > loose.seconds
    with pytest.raises(ar.Error, match="problem = tea: must be one of vibration, waves"):
        ar.recommend("tea", 0.1)
    with pytest.raises(ar.Error, match="error = 1e-09: none of the table is as exact on waves"):
        ar.recommend("waves", 1e-9)
    with pytest.raises(ar.Error, match="error = 0: must be positive"):
        ar.recommend("waves", 0)


def test_a_run_gives_the_row_of_the_table(trade, table, compiler):
    """But for its time, and for what other products of a compiler change."""
    from compositions import Composition

    row = {"problem": "bar", "shape": "quadratic", "transfer": "APIC", "order": "USL", "average": "none", "per_cell": 4, "cells": 16, "courant": 0.5,
           "number": "double", "threads": 1}
    there = next(r for r in table if trade.key(r) == trade.key(row))
    found = trade.measure(Composition("quadratic", "APIC", "USL"), row, 60)
    assert (found["steps"], found["points"]) == (int(there["steps"]), int(there["points"]))
    assert float(found["error"]) == pytest.approx(float(there["error"]), rel=1e-3) and float(found["seconds"]) > 0
    failed = trade.measure(Composition("triangles", "APIC", "USL"), row, 60)
    assert "APIC needs B-splines" in failed["failure"] and "error" not in failed


def test_two_threads_have_the_error_of_one(table):
    """The same bits: the table's text."""
    def alone(r):
        return tuple(r[k] for k in r if k not in ("threads", "seconds"))

    one = {alone(r) for r in table if r["threads"] == "1"}
    both = [r for r in table if r["threads"] == "2"]
    assert both and all(alone(r) in one for r in both)


def test_guide_advises_what_the_table_bears_out(trade, table):
    """docs/choose.md, by scene: the first composition of each row that is compared is, on the finest cells, within twice the least error, or 5 %."""
    import page

    words = {"QuadraticBSpline": "quadratic", "CubicBSpline": "cubic", "LinearSimplex": "triangles", "MlsGradient<QuadraticBSpline>": "MLS",
             "Flip": "FLIP", "Flip{.time = 0.1}": "FLIP, time", "Apic": "APIC", "Musl": "MUSL", "Usl": "USL",
             "NodalAndElementAverage": "nodal and element"}
    title = {page.anchor(trade.problem(name).TITLE): name for name in trade.problems()}
    seen = 0
    for cells in re.findall(r"^\| (.*) \|$", (PAGE.parent / "choose.md").read_text(), flags=re.MULTILINE):
        columns = cells.split(" | ")
        linked = re.search(r"trade\.md#(\S+)\)", columns[-1])
        if len(columns) != 8 or not linked:
            continue
        shape, *average = (words[w] for w in re.findall(r"`(.*?)`", columns[3].split(" or ")[0].split(";")[0]))
        transfer, order = (words[w] for w in re.findall(r"`(.*?)`", columns[4].split(";")[0])[:2])
        usual = [r for r in table if r["problem"] == title[linked[1]] and not r["failure"] and (r["number"], r["threads"]) == ("double", "1")
                 and r["courant"] == "0.5" and r["per_cell"] in "34"]
        finest = [r for r in usual if int(r["cells"]) == max(int(q["cells"]) for q in usual)]
        error = [float(r["error"]) for r in finest
                 if (r["shape"], r["transfer"], r["order"], r["average"]) == (shape, transfer, order, average[0] if average else "none")]
        assert error and error[0] <= max(0.05, 2 * min(float(r["error"]) for r in finest)), columns[0]
        seen += 1
    assert seen >= 7
