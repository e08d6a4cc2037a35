"""Compositions compiled on first use, and laws of one's own."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

HERE = Path(__file__).parent


@pytest.fixture
def compiler(ar):
    from arenite import _compile

    try:
        _compile.compiler()
    except ar.Error as e:
        pytest.skip(str(e))


def bar(ar, law):
    return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.02),
                    ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                    bodies=[ar.fill("bar", ar.Box((0, 0), (0.2, 0.1)), law)], walls=[ar.bottom()], gravity=(0, -9.81))


def test_a_law_of_ones_own_is_the_built_in_one(ar, compiler):
    own = ar.compile(law=HERE / "own_elastic.hpp")
    given = dict(density=1000, young=1e6, poisson=0.3)
    built_in, mine = bar(ar, ar.LinearElastic(**given)), bar(ar, own(**given))
    for scene in (built_in, mine):
        ar.run(scene, end=0.01)
    assert np.array_equal(built_in.bodies["bar"].stress, mine.bodies["bar"].stress)
    with pytest.raises(ar.Error, match="OwnElastic.desnity = 1: is unknown; there are: density, young, poisson"):
        bar(ar, own(desnity=1))
    with pytest.raises(ar.Error, match="OwnElastic.poisson"):
        bar(ar, own(density=1000, young=1e6, poisson=0.6))


def test_the_compilers_sentence_is_pythons(ar, sand, compiler):
    law = ar.WithDeviatoricStrain(sand, dimension=2)
    with pytest.raises(ar.Error, match="WithDeviatoricStrain: made for plane scenes; in space leave its second argument out"):
        ar.Scene(ar.ThreeDimensional(), ar.CartesianGrid((0, 0, 0), (1, 1, 1), cell=0.5), ar.Numerics(ar.QuadraticBSpline),
                 bodies=[ar.fill("sand", ar.Box((0, 0, 0), (1, 1, 1)), law)])


def test_same_bits_as_cplusplus(ar, column, compiler, tmp_path):
    from arenite import _compile, _plugins

    program = tmp_path / "column"
    flags = _plugins.WIDTHS[_plugins.width()]["flags"]
    subprocess.run([*_compile.compiler(), "-std=c++20", "-O3", "-DNDEBUG", *flags,
                    *(f"-isystem{f}" for f in _compile.include_folders()), str(HERE / "column.cpp"), "-o", str(program),
                    "-pthread"], check=True)
    said = subprocess.run([program, "0.05"], check=True, capture_output=True, text=True).stdout.splitlines()
    scene = column()
    ar.run(scene, end=0.05)
    assert int(said[0]) == scene.step_count
    there = np.array([[float.fromhex(x) for x in line.split()] for line in said[1:]])
    body = scene.bodies["sand"]
    assert np.array_equal(there, np.column_stack([body.position, body.velocity, body.stress]))


def test_without_a_compiler_the_cure_is_named(ar, monkeypatch, tmp_path):
    monkeypatch.setenv("CXX", "no-such-compiler")
    monkeypatch.setenv("ARENITE_CACHE", str(tmp_path))
    with pytest.raises(ar.Error, match="no-such-compiler: not found.*install g\\+\\+ 12"):
        bar(ar, ar.compile(law=HERE / "own_elastic.hpp", name="Unknown")())


LAW = """
import sys
import arenite as ar
law = ar.compile(law=sys.argv[1])(density=1000, young=1e6, poisson=0.3)
print(ar.drive(law, ar.oedometer(axial=-0.01)).stress[-1, 1])
"""


def child(cache):
    environment = {**os.environ, "ARENITE_CACHE": str(cache)}
    return subprocess.Popen([sys.executable, "-c", LAW, str(HERE / "own_elastic.hpp")], env=environment, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)


def test_two_processes_compile_once_and_a_killed_one_leaves_a_sound_cache(ar, compiler, tmp_path):
    killed = child(tmp_path)
    while not list(tmp_path.glob("*.lock")):
        time.sleep(0.05)
    time.sleep(1)
    os.killpg(killed.pid, signal.SIGKILL)
    killed.communicate()
    assert not list(tmp_path.glob("*.so"))
    both = [child(tmp_path) for _ in range(2)]
    said = [p.communicate() for p in both]
    assert [p.returncode for p in both] == [0, 0], said
    assert sum("compiling" in err for _, err in said) == 1, said
    assert len(list(tmp_path.glob("*.so"))) == 1
    assert {out for out, _ in said} == {said[0][0]} and float(said[0][0]) == pytest.approx(-0.01 * 1e6 * 0.7 / (1.3 * 0.4))
    third = child(tmp_path)
    _, err = third.communicate()
    assert third.returncode == 0 and "compiling" not in err


def test_every_recipe_of_the_examples_is_prebuilt(ar, column, sand):
    """What the README and the tests of this folder use needs no compiler."""
    from arenite import _plugins

    _plugins._ensure_prebuilt()
    lines = (Path(_plugins.PACKAGE) / "prebuilt.txt").read_text().splitlines()
    known = {line.split(" ", 1)[1] for line in lines if line.startswith(("scene ", "law "))}
    assert column().composition in known and sand.cpp() in known
    if _plugins.prebuilt(_plugins.width()).exists():
        plugin = _plugins._plugins[str(_plugins.prebuilt(_plugins.width()))]
        assert set(plugin.scenes()) | set(plugin.laws()) == known


def test_import_is_quick(ar):
    times = []
    for _ in range(3):
        begin = time.monotonic()
        subprocess.run([sys.executable, "-c", "import arenite"], check=True)
        begin_numpy = time.monotonic()
        subprocess.run([sys.executable, "-c", "import numpy"], check=True)
        times.append((begin_numpy - begin) - (time.monotonic() - begin_numpy))
    assert min(times) < 0.3
