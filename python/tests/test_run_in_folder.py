"""Runs in a folder: interrupted ones go on with the same bits, failures are told, a folder is one run's."""

import json
import os
import pickle
import signal
import subprocess
import sys

import numpy as np
import pytest

import arenite as ar


def column():
    sand = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=0.6)
    return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.02), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                    bodies=[ar.fill("sand", ar.Box((0, 0), (0.1, 0.15)), sand)], walls=[ar.bottom("fixed"), ar.left("roller")], gravity=(0, -9.81))


def status(folder):
    return json.loads((folder / "status.json").read_text())


def raises_signal(at, number=signal.SIGTERM):
    return lambda scene: os.kill(os.getpid(), number) if scene.step_count == at else None


@pytest.fixture
def interruptible():
    """SIGINT as a terminal has it: in a background job it is ignored, and `run_in_folder` leaves that so."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_an_interrupted_run_goes_on_with_the_same_bits(tmp_path, interruptible):
    whole, part, rest = column(), column(), column()
    before = signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)
    assert ar.run_in_folder(whole, 0.05, tmp_path / "whole", checkpoint_every=0.01) == "finished"
    for number, at in (signal.SIGTERM, 7), (signal.SIGINT, 12):
        part = column()
        assert ar.run_in_folder(part, 0.05, tmp_path / "parts", resume=at > 7, after_step=raises_signal(at, number)) == "interrupted"
        assert part.step_count == at and status(tmp_path / "parts")["status"] == "interrupted"
    assert (signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)) == before
    assert ar.run_in_folder(rest, 0.05, tmp_path / "parts", checkpoint_every=0.01, resume=True) == "finished"
    told = status(tmp_path / "parts")
    assert told["status"] == "finished" and told["failure"] is None and told["time_s"] == told["end_s"] == 0.05
    assert len(told["resumed_at_s"]) == 1 and told["points"] == len(rest.bodies["sand"]) and told["process"] == os.getpid()
    assert rest.step_count == whole.step_count
    for a, b in zip(whole.state.values(), rest.state.values()):
        assert np.array_equal(a, b)
    assert ar.run_in_folder(rest, 0.06, tmp_path / "parts", resume=True) == "finished"  # a later end


def test_a_killed_run_goes_on_from_its_checkpoint(tmp_path):
    program = ("import os, signal, sys; sys.path.insert(0, sys.argv[1]); from test_run_in_folder import *\n"
               "ar.run_in_folder(column(), 0.05, sys.argv[2], checkpoint_every=0.01,\n"
               "                 after_step=lambda s: os.kill(os.getpid(), signal.SIGKILL) if s.time > 0.025 else None)")
    child = subprocess.run([sys.executable, "-c", program, os.path.dirname(__file__), tmp_path / "killed"])
    assert child.returncode == -signal.SIGKILL and status(tmp_path / "killed")["status"] == "running"
    rest, whole = column(), column()
    calls = []
    assert ar.run_in_folder(rest, 0.05, tmp_path / "killed", checkpoint_every=0.01, resume=True, every={0.01: lambda s: calls.append(s.time)}) == "finished"
    assert calls[0] > 0.025 and status(tmp_path / "killed")["resumed_at_s"][0] == pytest.approx(0.02, abs=1e-3)
    ar.run(whole, 0.05)
    assert whole.step_count == rest.step_count and np.array_equal(whole.bodies["sand"].position, rest.bodies["sand"].position)


def same(a, b):
    return a.step_count == b.step_count and all(np.array_equal(x, y) for x, y in zip(a.state.values(), b.state.values()))


def test_what_has_the_bits_of_one_run(tmp_path):
    """Saved by a function of `every`, or ended by STOP, a run goes on with the same bits; past an `end` that it has hit it does not."""
    whole, seen, stopped, ended, rest = (column() for _ in range(5))
    ar.run(whole, 0.05)
    ar.run(seen, 0.05, every={0.003: lambda s: None, 0.02: lambda s: s.save(tmp_path / "state") if s.time < 0.03 else None})
    assert same(seen, whole)  # no step is shortened
    rest.restore(tmp_path / "state")
    assert 0.02 <= rest.time < 0.021
    ar.run(stopped, 0.05, every={0.02: lambda s: ar.STOP if s.time else None})
    assert same(stopped, rest)
    ar.run(rest, 0.05)
    ar.run(stopped, 0.05)
    assert same(rest, whole) and same(stopped, whole)
    ar.run(ended, 0.02)
    ar.run(ended, 0.05)
    assert ended.time == whole.time and not same(ended, whole)


def test_observers_of_one_period(tmp_path):
    """All are called, in their order, and the state is saved behind them."""
    for every in ([(0.01, "a"), (0.01, "b"), (0.02, "c")], {0.01: "ab", 0.02: "c"}):
        calls = []
        each = [(p, [lambda s, n=n: calls.append(n) for n in names]) for p, names in (every.items() if isinstance(every, dict) else every)]
        ar.run(column(), 0.02, every=dict(each) if isinstance(every, dict) else [(p, f) for p, (f,) in each])
        assert "".join(calls) == "abcababc"
        calls.clear()
        ar.run_in_folder(column(), 0.02, tmp_path, checkpoint_every=0.01, every=each)
        assert "".join(calls) == "abcababc"


def test_only_stop_ends_a_run():
    scene = column()
    ar.run(scene, 0.002, every={0.001: lambda s: 1, 0.002: lambda s: False}, after_step=lambda s: "text")
    assert scene.time == 0.002 and pickle.loads(pickle.dumps(ar.STOP)) is ar.STOP and str(ar.STOP) == "ar.STOP"
    for told in True, np.bool_(True):
        with pytest.raises(ar.Error, match=r"run.after_step: a function returned True: return ar.STOP to end the run, or nothing"):
            ar.run(scene, 0.01, after_step=lambda s: told)


def f(scene):
    pass


@pytest.mark.parametrize("given, rule", [
    (dict(end="0.03"), "end = '0.03': must be a number, s"), (dict(end=None), "end = None: must be a number, s"), (dict(end=True), "end = True: must be a number"),
    (dict(end=-1), "end = -1: must not lie before the scene's time 0"), (dict(courant=0), "courant = 0: must be positive"),
    (dict(courant="x"), "courant = 'x': must be a number$"), (dict(max_step=None), "max_step = None: must be a number, s"),
    (dict(every={-1: f}), "every: period = -1: must be positive, s"), (dict(every={0: f}), "every: period = 0: must be positive"),
    (dict(every={"0.1": f}), "every: period = '0.1': must be a number, s"), (dict(every={0.1: 3}), r"every\[0.1\] = 3: must be a function of the scene"),
    (dict(every={0.1: [f, None]}), r"every\[0.1\] = None: must be a function"), (dict(every=f), "every = .*: must be functions of the scene by their period"),
    (dict(every=[0.1, f]), "every = .*: must be functions of the scene by their period"), (dict(after_step=[f]), "after_step = .*: must be a function of the scene"),
    (dict(watch=0), "watch = 0: must be True, False or a Watch"), (dict(progress=1), "progress = 1: must be True, False or a Progress")])
def test_what_a_run_refuses(tmp_path, given, rule):
    scene = column()
    for go in ar.run, lambda scene, **given: ar.run_in_folder(scene, folder=tmp_path, **given):
        with pytest.raises(ar.Error, match=rule):
            go(scene, **{"end": 0.01, **given})
    assert scene.step_count == 0


def test_failures_and_stops_are_told(tmp_path):
    def fails(scene):
        raise ValueError("an \"observer\" of mine")

    with pytest.raises(ValueError):
        ar.run_in_folder(column(), 0.05, tmp_path, every={0.01: fails})
    assert status(tmp_path)["status"] == "failed" and status(tmp_path)["failure"] == "an \"observer\" of mine"
    assert ar.run_in_folder(column(), 0.05, tmp_path, after_step=lambda s: ar.STOP) == "stopped"
    assert status(tmp_path)["status"] == "stopped" and status(tmp_path)["steps"] == 1


def test_what_cannot_be_is_refused(tmp_path):
    with pytest.raises(ar.Error, match="checkpoint_every = 0: must be positive"):
        ar.run_in_folder(column(), 0.05, tmp_path / "none", checkpoint_every=0)
    with pytest.raises(ar.Error, match="end = nan: must not lie before"):
        ar.run_in_folder(column(), float("nan"), tmp_path / "none")
    assert not (tmp_path / "none").exists()
    ar.run_in_folder(column(), 0.002, tmp_path, recipe="35 deg")
    before = (tmp_path / "status.json").read_bytes()
    with pytest.raises(ar.Error, match="recipe: 35 deg"):
        ar.run_in_folder(column(), 0.05, tmp_path, resume=True, recipe="30 deg")
    assert (tmp_path / "status.json").read_bytes() == before

    def again(scene):
        with pytest.raises(ar.Error, match=f"is in use by the run with process id {os.getpid()}"):
            ar.run_in_folder(column(), 0.05, tmp_path)
        return ar.STOP

    assert ar.run_in_folder(column(), 0.05, tmp_path, after_step=again) == "stopped"
