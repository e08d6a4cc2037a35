"""Sweeps: a folder keeps the results of what decides them alone; names, values and numbers of cases are refused or kept, never lost."""

import functools
import importlib
import os
import subprocess
import sys
import textwrap
import warnings

import numpy as np
import pytest

import arenite as ar

MODEL = """
import dataclasses, functools, threading
import numpy as np
import swept_helper

STIFFNESS = 1.0
ROWS = np.arange(3.0)
LOCK = threading.Lock()
TIMES = 2

def times(by):
    def around(f):
        @functools.wraps(f)
        def inner(*a):
            return by * f(*a)
        return inner
    return around

def plain(x, *, more=0):
    return STIFFNESS * x + ROWS.sum() + swept_helper.helps(x) + more

def late(x):
    from swept_helper import helps
    return helps(x)

@times(TIMES)
def decorated(x):
    return x

@functools.lru_cache
def cached(x):
    return STIFFNESS * x

@dataclasses.dataclass
class Options:
    all: list = dataclasses.field(default_factory=lambda: [1])

def optional(x):
    return sum(Options().all) * x

class Model:
    SHARE = 1

    def __init__(self, k):
        self.k, self.names = k, {"a", "b", "c"}

    def run(self, x):
        return self.k * x + self.other()

    __call__ = run

    def other(self):
        return 0 * self.SHARE

def product(k, x):
    return (k.density if hasattr(k, "density") else np.sum(k)) * x

def locked(x):
    with LOCK:
        return x

def guarded(x):
    try:
        import a_module_that_is_not_there
    except ImportError:
        return x

class Held:
    LOCK = threading.Lock()

def of_held(x):
    return 3
"""
HELPER = """
def helps(x):
    return inner(x)

def inner(x):
    return 0 * x
"""


@pytest.fixture
def model(tmp_path, monkeypatch):
    """A module of the user's, which tests may change."""
    (tmp_path / "swept_model.py").write_text(MODEL)
    (tmp_path / "swept_helper.py").write_text(HELPER)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    yield importlib.import_module("swept_model")
    for name in "swept_model", "swept_helper":
        sys.modules.pop(name, None)


def refused(function, out, because):
    with pytest.raises(ar.Error, match=because):
        ar.sweep(function, [1, 2], out=out, cases="none")


def test_a_folder_is_that_of_an_objects_state(model, tmp_path):
    law = ar.LinearElastic(density=2, young=1e6, poisson=0.3)
    for k, (one, other, result) in enumerate([
            (model.Model(2).run, model.Model(3).run, 2), (model.Model(2), model.Model(3), 2), (functools.partial(model.product, 2), functools.partial(model.product, 3), 2),
            (functools.partial(model.product, np.ones(2)), functools.partial(model.product, np.array([1.0, 2.0])), 2),
            (functools.partial(model.product, law), functools.partial(model.product, ar.LinearElastic(density=2, young=1e6, poisson=0.2)), 2)]):
        out = tmp_path / f"out{k}"
        assert ar.sweep(one, [1], out=out)["result"].tolist() == [result]
        assert ar.sweep(one, [1], out=out, cases="none")["status"].tolist() == ["done"]
        refused(other, out, "holds results of this function, but then with another object or arguments; name another folder, or remove it")
    refused(model.product, tmp_path / "out2", "another object or arguments")
    refused(model.locked, tmp_path / "locked", r"swept_model.LOCK: <unlocked .* cannot be told from others .*give what it holds as a parameter .*or sweep without `out`")
    refused(model.Held, tmp_path / "locked", "swept_model.Held.LOCK: .* cannot be told from others")
    assert ar.sweep(model.locked, [1])["result"].tolist() == [1] and ar.sweep(model.of_held, [model.Held()])["result"].tolist() == [3]
    with pytest.raises(ar.Error, match="swept_model.Held.LOCK: .* cannot be told from others"):
        ar.sweep(model.of_held, [model.Held()], out=tmp_path / "held")
    assert ar.sweep(model.guarded, [1], out=tmp_path / "guarded")["result"].tolist() == [1]
    header = tmp_path / "own.hpp"
    header.write_text("struct Own {};")
    own = functools.partial(model.product, ar.OwnLaw("Own", str(header)))
    before = ar._decides.what_decides(own)
    assert ar._decides.what_decides(own) == before
    header.write_text("struct Own { double young; };")
    assert ar._decides.first_difference(before, ar._decides.what_decides(own)) == "object or arguments"


def test_a_folder_is_that_of_the_globals(model, tmp_path):
    out = tmp_path / "out"
    assert ar.sweep(model.plain, [1], out=out)["result"].tolist() == [4]
    model.STIFFNESS = 5.0
    refused(model.plain, out, "this function, but then with another swept_model.STIFFNESS; name another folder")
    with pytest.raises(ar.Error, match="swept_model.STIFFNESS is another one in the processes that a sweep starts.*give it as a parameter"):
        ar.sweep(model.plain, [1], out=tmp_path / "anew")
    with pytest.warns(ar.Warning, match="swept_model.STIFFNESS is another one"):
        ar.sweep(model.plain, [1])
    model.STIFFNESS = 1.0
    assert ar.sweep(model.plain, [1], out=tmp_path / "anew")["result"].tolist() == [4]  # nothing was kept there
    model.ROWS[1] = 7
    refused(model.plain, out, "another swept_model.ROWS")
    model.ROWS[1] = 1
    ar.sweep(model.Model(2).run, [1], out=tmp_path / "method")
    model.Model.SHARE = 2
    refused(model.Model(2).run, tmp_path / "method", "another swept_model.Model")
    version = ar._decides._core.version
    assert ar._decides.what_decides(model.plain)["arenite"] == version and "numpy" in ar._decides.what_decides(np.sqrt)
    assert ar.sweep(model.plain, [1], out=out, cases="none")["status"].tolist() == ["done"]


def test_a_folder_is_that_of_the_code_that_is_called(model, tmp_path):
    names = "plain", "late", "decorated", "cached", "optional"
    for name in names:
        ar.sweep(getattr(model, name), [1], out=tmp_path / name)
    program = textwrap.dedent("""
        import sys, arenite as ar, swept_model
        if __name__ == "__main__":
            for name in sys.argv[1:]:
                try:
                    print(name, ar.sweep(getattr(swept_model, name), [1], out=name, cases="none")["status"][0])
                except ar.Error as e:
                    print(name, str(e).split("; ")[0].split(" holds results of ")[1])
        """)
    (tmp_path / "program.py").write_text(program)

    def said():
        done = subprocess.run([sys.executable, "program.py", *names], cwd=tmp_path, capture_output=True, text=True, check=True)
        return dict(line.split(" ", 1) for line in done.stdout.splitlines())

    assert said() == {name: "done" for name in names}
    (tmp_path / "swept_helper.py").write_text(HELPER.replace("0 * x", "1 * x"))
    (tmp_path / "swept_model.py").write_text(MODEL.replace("TIMES = 2", "TIMES = 3").replace("lambda: [1]", "lambda: [2]").replace("return STIFFNESS * x\n", "return 2 * STIFFNESS * x\n"))
    this = "this function, but then with another "
    assert said() == {"plain": this + "swept_helper.inner", "late": this + "swept_helper.inner", "decorated": this + "'by' of swept_model.decorated",
                      "cached": "this function as its code was then", "optional": this + "swept_model.Options.<lambda>"}


def square(x):
    return {"square": x * x}


def echo(**given):
    return {"sum": sum(v for v in given.values() if isinstance(v, (int, float))), "given": sorted(given)}


def named(x):
    return {1: {"status": "diverged"}, 2: {"value": 3.0}, 3: {"failure": 1}, 4: {"value": [1, 2], "y": 4}}[x]


def frames(x):
    import pandas

    frame = pandas.DataFrame({"t": [0.0, 1.0], "u": ["a", "b"]})
    return {1: frame, 2: pandas.Series([1.5, 2.5], index=["toe", "top"]), 3: pandas.Series([1.0, 2.0], name="w"), 4: frame.set_index("t"),
            5: np.ma.array([1, 2], mask=[True, False])}[x]


def test_names_are_kept_or_refused():
    table = ar.sweep(named, [1, 2, 3, 4])
    assert table["status"].tolist() == ["failed"] * 3 + ["done"] and table["value"].tolist() == [1, 2, 3, 4] and table["y"][3] == 4
    assert table["failure"][0] == "result.status = 'diverged': a column of this sweep has that name; name the result otherwise"
    assert table.results[3] == {"value": [1, 2], "y": 4} and "and failure" in repr(table)
    assert "failure" not in repr(ar.sweep(square, [1]))
    for values, rule in (({"status": [1]}, "sweep.values.status: every sweep has a column of that name"), ({"x": [1], "x, y": [(1, 2)]}, "each name must stand there once"),
                         ({3: [1]}, "sweep.values: 3: must be the name of a parameter"), ({}, "needs at least one value"), ({1, 2}, "has no order")):
        with pytest.raises(ar.Error, match=rule):
            ar.sweep(echo, values)


def test_names_of_pandas_are_kept():
    pandas = pytest.importorskip("pandas")
    assert ar.sweep(square, pandas.Series([2, 3], name="side"))["side"].tolist() == [2, 3]
    table = ar.sweep(echo, pandas.DataFrame({"friction": [0.5, 0.6], "cells": [1, 2]}))
    assert table["friction"].tolist() == [0.5, 0.6] and table["sum"].tolist() == [1.5, 2.6] and table.results[0]["given"] == ["cells", "friction"]
    with pytest.raises(ar.Error, match="sweep.values.x: is a table, whose names would be lost"):
        ar.sweep(echo, {"x": pandas.DataFrame({"a": [1]})})
    table = ar.sweep(frames, [1, 2, 3, 4, 5])
    assert table.results[0]["t"].tolist() == [0, 1] and table.results[0]["u"] == ["a", "b"] and table["toe"][1] == 1.5 and table["top"][1] == 2.5
    assert table.results[2]["w"].tolist() == [1, 2]
    assert "has an index that would be lost" in table["failure"][3] and "masked values" in table["failure"][4]


def test_values_that_are_equal(tmp_path):
    """The same value is run once for all its rows; 1, 1.0 and True are others; so is what is no number."""
    nan = float("nan")
    table = ar.sweep(square, [2, 2, 3, nan, nan, 2.0, True], jobs=2, out=tmp_path / "out")
    assert table["status"].tolist() == ["done"] * 7 and table["square"][[0, 1, 2, 5, 6]].tolist() == [4, 4, 9, 4, 1] and np.isnan(table["square"][[3, 4]]).all()
    assert len(list((tmp_path / "out").glob("*.npz"))) == 5


def test_numbers_of_cases(tmp_path, monkeypatch):
    for cases, rule in (("2-0", "cases = 2-0: must rise"), ("", "must be none, all, or numbers"), ("0-99999999999999", "the sweep has the cases 0 to 2"), (b"1", "must be none"),
                        (-1, "has the cases 0 to 2"), (True, "must be none, all")):
        with pytest.raises(ar.Error, match=rule):
            ar.sweep(square, [1, 2, 3], out=tmp_path, cases=cases)
    monkeypatch.setenv("ARENITE_CASES", "2-1")
    with pytest.raises(ar.Error, match="ARENITE_CASES = 2-1: must rise"):
        ar.sweep(square, [1, 2, 3], out=tmp_path)
    monkeypatch.delenv("ARENITE_CASES")
    assert ar.sweep(square, [1, 2, 3], out=tmp_path, cases="1,1")["status"].tolist() == ["waiting", "done", "waiting"]
    for jobs in 0, -1, 1.5, "2", True:
        with pytest.raises(ar.Error, match=f"jobs = {jobs!r}: must be a whole number of at least 1"):
            ar.sweep(square, [1], jobs=jobs)


def test_a_disk_without_locks(tmp_path, monkeypatch):
    """Cases run, with one warning; where another process holds a lock they do not."""
    fcntl = pytest.importorskip("fcntl")

    def flock(file, how):
        raise OSError(38, "Function not implemented")

    monkeypatch.setattr(fcntl, "flock", flock)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        table = ar.sweep(square, [1, 2, 3], out=tmp_path / "out")
    assert table["square"].tolist() == [1, 4, 9]
    assert [str(w.message) for w in said] == [f"{tmp_path / 'out'}: cannot be locked (Function not implemented); nothing else must write there meanwhile"]


def test_a_lock_that_its_holder_removes(tmp_path):
    """Who has waited for a lock whose file was removed takes the one that is there now."""
    import threading

    inside, together, path = [], [], tmp_path / "lock"

    def hold():
        for _ in range(50):
            with ar._cases.alone(path, wait=True):
                inside.append(1)
                together.append(len(inside))
                inside.pop()

    threads = [threading.Thread(target=hold) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert together == [1] * 200 and not path.exists()


def fills(x):
    import resource
    import signal

    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    if x == 2:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
    return np.zeros(100)


def test_a_folder_that_cannot_be_written(tmp_path):
    """A result that the disk does not take is a failure of its case."""
    table = ar.sweep(fills, [1, 2], jobs=1, out=tmp_path / "out")
    assert table["status"].tolist() == ["done", "failed"] and "File too large" in table["failure"][1] and not list((tmp_path / "out").glob("*.part"))
    for out in "", 3:
        with pytest.raises(ar.Error, match=f"out = {out!r}: must be the name of a folder"):
            ar.sweep(square, [1], out=out)
    os.mkdir(tmp_path / "gone")
    (tmp_path / "file").touch()
    with pytest.raises(ar.Error, match="sweep.out = .*file: cannot be used"):
        ar.sweep(square, [1], out=tmp_path / "file")
    if os.getuid() != 0:
        os.chmod(tmp_path / "gone", 0o500)
        with pytest.raises(ar.Error, match="sweep.out = .*gone: cannot be used"):
            ar.sweep(square, [1], out=tmp_path / "gone")
