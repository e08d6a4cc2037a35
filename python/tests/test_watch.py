"""A run is watched unless one says that it is not, and tells how far it is if asked."""

import io
import math

import pytest


def test_limits_are_those_of_cplusplus(ar):
    """Each by its name, and refused where the watch is made."""
    with pytest.raises(ar.Error, match="WatchLimits.volume = 0: must be positive"):
        ar.Watch(volume=0)
    with pytest.raises(ar.Error, match="WatchLimits.every"):
        ar.Watch(every=0)
    with pytest.raises(TypeError, match="volumes"):
        ar.Watch(volumes=1)


def test_a_run_past_a_limit_is_stopped(ar, column):
    scene = column()
    with pytest.raises(ar.RunError, match="volume = .*: the limit is 0.001"):
        ar.run(scene, end=0.4, watch=ar.Watch(volume=1e-3, every=1))
    assert scene.time < 0.4
    seen = scene.watched["volume"]
    assert seen.worst > seen.limit == 1e-3 and seen.body == 0 and seen.time == scene.time


def test_messages_name_bodies(ar, sand, column):
    """Errors and warnings, of a run, of steps and of a new scene: by their names, a rigid body without one by its number."""
    limits = ar.Watch(volume=1e-3, every=1)
    with pytest.raises(ar.RunError, match="volume = .*; body sand: mean V/V0"):
        ar.run(column(), end=0.4, watch=limits)
    with pytest.raises(ar.RunError, match="volume = .*; body sand: mean V/V0"):
        for _ in column().steps(end=0.4, watch=limits):
            pass
    with pytest.warns(ar.Warning, match="volume = .*; body sand: mean V/V0"):
        ar.run(column(), end=0.05, watch=ar.Watch(volume=0.005, every=1))
    foot = ar.Box((0.03, 0.05), (0.07, 0.1))
    for name, called in (("foot", "foot"), ("", "0")):
        with pytest.warns(ar.Warning, match=rf"^rigid body {called}: \d+ of the \d+ points of body sand lie inside"):
            column(rigids=[ar.Rigid(foot, ar.Prescribed((0, 0)), friction=0.3, name=name)])
    with pytest.raises(ar.Error, match="^body 0 is not named outside of a scene$"):
        raise ar.Error("body 0 is not named outside of a scene")


def test_run_watches_unless_told_not_to(ar, column):
    """Points that a function throws about: energy that nothing put in."""

    def kick(scene):
        if 0.02 < scene.time:
            scene.bodies["sand"].velocity[:] = 3.0

    scene = column()
    with pytest.raises(ar.RunError, match="energy_gain"):
        ar.run(scene, end=0.1, after_step=kick)
    unseen = column()
    ar.run(unseen, end=0.05, after_step=kick, watch=False)
    assert unseen.watched == {} and unseen.time == 0.05


def test_steps_end_as_a_run_does(ar, column):
    """With the same sentence; what the caller writes in between is no energy from nothing."""
    def told(go, scene, **options):
        with pytest.raises(ar.Error) as raised:
            for _ in [go(scene, **options)] if go is ar.run else go(scene, **options):
                pass
        return type(raised.value), str(raised.value), scene.time

    by_run, by_steps = (told(go, column(), end=0.4, watch=ar.Watch(volume=1e-3, every=1)) for go in (ar.run, ar.Scene.steps))
    assert by_run == by_steps and by_run[0] is ar.RunError and "volume" in by_run[1]
    for wrong in ({"courant": 1.5, "end": 1}, {"end": -1}, {"max_step": 0, "end": 1}):
        assert told(ar.run, column(), **wrong) == told(ar.Scene.steps, column(), **wrong)
    scene = column()
    with pytest.raises(ar.RunError, match="energy_gain"):
        for dt in scene.steps(end=0.1):
            if scene.time > 0.02:
                scene._core.columns()["bodies/0/points/velocity/x"][:] = 3.0
    for watch in (True, ar.Watch(every=3, energy_gain=0.5)):
        driven = column()
        for dt in driven.steps(end=0.05, watch=watch):
            if driven.time > 0.02:
                driven.bodies["sand"].velocity[:] = 0.3 if driven.step_count % 2 else -0.3
        assert driven.time == 0.05


def test_settle_watches_as_run_does(ar, block_between_rollers):
    """By default with the watch of `run`, with limits by these, or not."""
    def made():
        return block_between_rollers(load=ar.Pressure(ar.top(), 1e3))

    scene = made()
    ar.settle(scene, end=2, watch=ar.Watch())
    assert scene.watched["volume"].worst > 0 and scene.watched["volume"].limit == 0.5
    with pytest.raises(ar.RunError, match="volume = .*: the limit is 1e-05"):
        ar.settle(made(), end=2, watch=ar.Watch(volume=1e-5, every=1))

    def kick(scene):
        if scene.step_count == 150:
            scene.bodies["block"].velocity[:] = 3.0

    with pytest.raises(ar.RunError, match="energy_gain"):
        ar.settle(made(), end=2, after_step=kick)
    unseen = made()
    ar.settle(unseen, end=2, after_step=kick, watch=False)
    assert unseen.watched == {} and unseen.out_of_balance <= 1e-3


def test_what_is_sound_is_not_warned_of_and_keeps_its_bits(ar, column, recwarn):
    seen, unseen = column(), column()
    ar.run(seen, end=0.1, watch=ar.Watch())
    ar.run(unseen, end=0.1, watch=False)
    assert not [w for w in recwarn if issubclass(w.category, ar.Warning)]
    assert set(seen.watched) >= {"energy_gain", "volume", "strength", "lost"}
    assert seen.watched["strength"].worst < 1e-9 and math.isfinite(seen.watched["energy_gain"].worst)
    assert all((seen.state[path] == unseen.state[path]).all() for path in seen.state)


def test_progress(ar, column):
    """Where it is no terminal: a line each tenth; on one, a line that is rewritten."""
    told = io.StringIO()
    ar.run(column(), end=0.2, progress=ar.Progress(told))
    lines = told.getvalue().splitlines()
    assert lines[-1].startswith("100.0 %  t = 0.20000 s") and 1 <= len(lines) <= 10

    class Terminal(io.StringIO):
        def isatty(self):
            return True

    screen = Terminal()
    ar.run(column(), end=0.02, progress=ar.Progress(screen))
    assert screen.getvalue().startswith("\r100.0 %") and screen.getvalue().endswith("\n")
