import os
import signal
import threading

import numpy as np
import pytest

try:  # here alone: a notebook's kernel chooses its own
    import matplotlib

    matplotlib.use("Agg")
except ImportError:
    pass


@pytest.fixture
def ar():
    return pytest.importorskip("arenite")


@pytest.fixture
def compiler(ar):
    """Skips where there is none."""
    from arenite import _compile

    try:
        _compile.compiler()
    except ar.Error as e:
        pytest.skip(str(e))


@pytest.fixture
def sand(ar):
    return ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=np.radians(35))


@pytest.fixture
def column(ar, sand):
    """A column of sand, 10 by 15 cm, that collapses."""

    def make(region=None, **more):
        given = dict(walls=[ar.bottom("fixed"), ar.left("roller")], gravity=(0, -9.81))
        given.update(more)
        box = ar.Box((0, 0), (0.1, 0.15)) if region is None else region
        return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01),
                        ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                        bodies=[ar.fill("sand", box, sand, per_cell=4)], **given)

    return make


@pytest.fixture
def block_between_rollers(ar):
    """An elastic block, 0.1 m wide and 0.3 m high, with a load on top of it, that comes to rest."""

    def make(load=None, gravity=(0, 0), mesh_height=0.3):
        law = ar.LinearElastic(density=2000, young=1e6, poisson=0.3)
        height = 0.3
        return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.1, mesh_height), cell=0.025),
                        ar.Numerics(ar.QuadraticBSpline, ar.Apic), bodies=[ar.fill("block", ar.Box((0, 0), (0.1, height)), law)],
                        walls=[ar.bottom("roller"), ar.left("roller"), ar.right("roller")], gravity=gravity,
                        parts=[load or ar.Pressure(ar.top(), 0.0), ar.LocalDamping()])

    return make


@pytest.fixture
def ctrl_c():
    """`ctrl_c(0.3)`: SIGINT in so many seconds, as a terminal has it; what a shell runs in its background ignores it."""
    old = signal.signal(signal.SIGINT, signal.default_int_handler)
    timers = []

    def start(seconds):
        timers.append(threading.Timer(seconds, lambda: os.kill(os.getpid(), signal.SIGINT)))
        timers[-1].start()

    yield start
    for timer in timers:
        timer.cancel()
    signal.signal(signal.SIGINT, old)
