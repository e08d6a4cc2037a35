"""Scenes: laws of nature, closed forms, views, functions, states."""

import copy
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest


def test_free_fall(ar, column):
    with pytest.warns(ar.Warning, match="everything falls"):
        scene = column(ar.Box((0.1, 0.04), (0.2, 0.19)), walls=[ar.right("roller")])
    body = scene.bodies["sand"]
    height = body.position.mean(axis=0)[1]
    ar.run(scene, end=0.05)
    v = body.velocity
    assert np.allclose(v[:, 1].mean(), -9.81 * 0.05, rtol=1e-12)
    assert abs(body.position.mean(axis=0)[1] - (height - 9.81 * 0.05**2 / 2)) < 9.81 * 0.05 * scene.time_step
    assert abs(scene.energy.residual) < 1e-2 * scene.energy.kinetic


def test_energy_and_mass(ar, column):
    scene = column()
    seen = []
    ar.run(scene, end=0.1, every={0.02: lambda s: seen.append(s.time)})
    assert len(seen) == 6 and seen[0] == 0
    e = scene.energy
    assert e.external > 0 and e.plastic > 0 and abs(e.residual) < 0.5 * e.external
    assert np.isclose(scene.bodies["sand"].mass.sum(), 1540 * 0.1 * 0.15, rtol=1e-12)


def test_views_see_the_memory_and_refuse_after_a_step(ar, column):
    scene = column()
    v = scene.bodies["sand"].velocity
    v[:, 0][:] = 3.0
    assert np.all(np.asarray(scene.bodies["sand"].velocity)[:, 0] == 3.0)
    v *= 2
    assert scene.bodies["sand"].velocity[:, 0].max() == 6.0
    mask = scene.bodies["sand"].position[:, 1] > 0.1
    v[mask] = (0.0, 1.0)
    assert np.all(scene.bodies["sand"].velocity[mask] == (0.0, 1.0))
    kept = np.asarray(v)
    scene.step(1e-5)
    for use in (lambda: v + 1, lambda: v[0], lambda: len(v), lambda: np.asarray(v), lambda: v.mean(), lambda: v[:, 0]):
        with pytest.raises(ar.Error, match="take the view anew"):
            use()
    with pytest.raises(ar.Error):
        v[0] = 0
    assert kept.shape == (600, 2)
    with pytest.raises(ar.Error, match="cannot be written"):
        scene.bodies["sand"].position[0] = (0, 0)


def test_functions_of_place_are_called_once_with_all_positions(ar, column, sand):
    calls = []

    def inside(x):
        calls.append(("where", x.shape))
        return (x[:, 0] < 0.1) & (x[:, 1] < 0.15)

    def velocity(x):
        calls.append(("velocity", x.shape))
        return np.column_stack([x[:, 1], 0 * x[:, 0]])

    def stress(x):
        p = -1540 * 9.81 * (0.15 - x[:, 1])
        return np.column_stack([p, p, p, 0 * p, 0 * p, 0 * p])

    scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01),
                     ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                     bodies=[ar.fill("sand", inside, sand, velocity=velocity, stress=stress)],
                     walls=[ar.where(lambda x: x[:, 1] < 1e-9, "fixed"), ar.left("roller")], gravity=(0, -9.81))
    # APIC asks for the gradient of the velocity too: five places a point.
    assert calls == [("where", (40 * 20 * 4, 2)), ("velocity", (600 * 5, 2))]
    same = column()
    assert np.array_equal(scene.bodies["sand"].position, same.bodies["sand"].position)
    x = np.asarray(scene.bodies["sand"].position)
    assert np.array_equal(scene.bodies["sand"].velocity[:, 0], x[:, 1])
    gradient = scene.bodies["sand"].column("velocity_gradient")
    assert np.allclose(gradient[:, 2], 1, atol=1e-6)  # dv_x/dy
    with pytest.warns(DeprecationWarning, match="velocity_gradient"):
        assert np.array_equal(scene.bodies["sand"].column("motion"), gradient)
    assert np.allclose(scene.bodies["sand"].stress[:, 1], -1540 * 9.81 * (0.15 - x[:, 1]))


def test_same_bits_alone_and_in_threads(ar, column):
    alone = column()
    ar.run(alone, end=0.02)
    scenes = [column() for _ in range(3)]
    threads = [threading.Thread(target=ar.run, args=(s,), kwargs=dict(end=0.02)) for s in scenes]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    for s in scenes:
        assert s.step_count == alone.step_count
        assert all(np.array_equal(value, s.state[path]) for path, value in alone.state.items())


def test_steps_and_run_are_the_same(ar, column):
    one, two = column(), column()
    ar.run(one, end=0.01)
    assert sum(two.steps(end=0.01)) == pytest.approx(0.01, rel=1e-12)
    assert np.array_equal(one.bodies["sand"].position, two.bodies["sand"].position)


def test_a_mesh_of_float32(ar, compiler, tmp_path):
    """A column falls freely: columns are of 4 bytes, and the fall is that of float64 but for round-off."""
    def scene(dtype):
        grid = ar.CartesianGrid((0, 0), (1, 2), cell=0.125, dtype=dtype)
        s = ar.Scene(ar.PlaneStrain(), grid, ar.Numerics(ar.QuadraticBSpline, ar.Apic), gravity=(0, -9.81), walls=[ar.bottom()],
                     bodies=[ar.fill("block", ar.Box((0.25, 1), (0.75, 1.5)), ar.LinearElastic(density=1000, young=1e5, poisson=0.3))])
        ar.run(s, end=0.2, max_step=1e-3)
        return s

    double, single = scene("float64"), scene(np.float32)
    assert single.bodies["block"].position.dtype == np.float32 and double.bodies["block"].position.dtype == np.float64
    assert "CartesianGrid<2, float>" in single.compiled_as
    fall = [np.asarray(s.bodies["block"].position)[:, 1].mean() - 1.25 for s in (double, single)]
    assert fall[0] == pytest.approx(-9.81 * 0.2**2 / 2, rel=0.01) and fall[1] == pytest.approx(fall[0], rel=1e-4)
    single.save(tmp_path / "state")
    with pytest.raises(ar.Error):
        double.restore(tmp_path / "state")
    with pytest.raises(ar.Error, match="CartesianGrid.dtype = int: must be float64 or float32"):
        ar.CartesianGrid((0, 0), (1, 1), cell=0.1, dtype="int")


def test_saved_copied_pickled(ar, column, tmp_path):
    scene = column()
    ar.run(scene, end=0.01)
    scene.save(tmp_path / "state")
    others = [scene.copy(), pickle.loads(pickle.dumps(scene)), column()]
    others[2].restore(tmp_path / "state")
    ar.run(scene, end=0.02)
    for other in others:
        assert other.time == pytest.approx(0.01)
        ar.run(other, end=0.02)
        assert np.array_equal(other.bodies["sand"].position, scene.bodies["sand"].position)


def test_a_function_that_pickle_cannot_take_is_named(ar, column):
    scene = column(region=lambda x: x[:, 1] < 0.1)
    with pytest.raises(ar.Error, match=r"Scene.bodies\[0\].region = <function .*<lambda>.*: cannot be pickled: a function must be one of a module"):
        pickle.dumps(scene)
    for other in (copy.copy(scene), copy.deepcopy(scene)):  # need no pickle
        assert np.array_equal(other.bodies["sand"].position, scene.bodies["sand"].position)


@pytest.mark.parametrize("returned, said", [("text", "'text'"), ({"x": 1}, "{'x': 1}"), (None, "None"), (1j, "1j"), ([1, None], r"\[1, None\]"),
                                            (np.array(["a"]), "array"), (object(), "<object")])
def test_a_function_that_returns_no_numbers_is_named(ar, sand, returned, said):
    def of_place(x):
        return returned

    def of_time(t):
        return returned

    def scene(region=ar.Box((0, 0), (0.1, 0.1)), walls=(ar.bottom(),), **options):
        ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                 bodies=[ar.fill("sand", region, sand, **options)], walls=walls, gravity=(0, -9.81))

    rule = rf"function = .*of_\w+ \(test_scene.py:\d+\): returned {said}.*: must return numbers"
    for given in (dict(region=of_place), dict(velocity=of_place), dict(stress=of_place), dict(walls=[ar.where(of_place, "fixed")])):
        with pytest.raises(ar.Error, match=rule):
            scene(**given)
    with pytest.raises(ar.Error, match=rule):
        cone(ar, sand, ar.Prescribed(velocity=of_time)).step(1e-5)


def cone(ar, sand, motion):
    return ar.Scene(ar.Axisymmetric(), ar.CartesianGrid((0, 0), (0.15, 0.3), cell=0.01),
                    ar.Numerics(ar.QuadraticBSpline),
                    bodies=[ar.fill("sand", ar.Box((0, 0), (0.15, 0.2)), sand)], walls=[ar.bottom(), ar.right("roller")],
                    gravity=(0, -9.81),
                    rigids=[ar.Rigid(ar.ConeCylinder(radius=0.02, apex=np.radians(60), length=0.3, tip=0.2), motion,
                                     friction=np.radians(20), name="cone")])


def test_a_signal_is_the_motion_of_a_function(ar, sand):
    signal_velocity = ar.Signal(0, -1, 0)
    by_signal = cone(ar, sand, ar.Prescribed(signal_velocity))
    by_function = cone(ar, sand, ar.Prescribed(lambda t: (0, -1, 0)))
    by_vector = cone(ar, sand, ar.Prescribed((0, -1)))
    for scene in (by_signal, by_function, by_vector):
        ar.run(scene, end=0.01)
    body = by_signal.rigids["cone"]
    assert body.displacement[1] == pytest.approx(-0.01, rel=1e-12) and body.force[1] > 0
    assert np.array_equal(body.force, by_function.rigids["cone"].force)
    assert np.array_equal(body.force, by_vector.rigids["cone"].force)
    signal_velocity.set(0, 0, 0)
    ar.run(by_signal, end=0.011)
    assert body.displacement[1] == pytest.approx(-0.01, rel=1e-12)


def test_a_guided_body_takes_a_load_in_time(ar, sand):
    """Above the sand: m dv/dt = -m g + F sin(w t), so that half a period gives 2 F / (m w) - g pi / w."""
    mass, force, w = 2.0, 60.0, np.pi / 0.02

    def scene(load):
        return ar.Scene(ar.Axisymmetric(), ar.CartesianGrid((0, 0), (0.15, 0.3), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                        bodies=[ar.fill("sand", ar.Box((0, 0), (0.15, 0.05)), sand)], walls=[ar.bottom(), ar.right("roller")], gravity=(0, -9.81),
                        rigids=[ar.Rigid(ar.Ball((0, 0.2), 0.02), ar.Guided(mass=mass, load=load), friction=0.3, name="ball")])

    pushed = scene(lambda t: force * np.sin(w * t))
    ar.run(pushed, end=0.02, max_step=1e-4)
    assert pushed.rigids["ball"].velocity[1] == pytest.approx(2 * force / (mass * w) - 9.81 * 0.02, abs=1e-4 * force / (mass * w))
    tabled = scene(ar.Table([(0, 0), (0.01, 20.0)]))
    ar.run(tabled, end=0.02, max_step=1e-4)
    assert tabled.rigids["ball"].velocity[1] == pytest.approx(20.0 * 0.015 / mass - 9.81 * 0.02, abs=20.0 * 1e-4 / mass)
    with pytest.raises(ar.RunError, match="t = 0 s: Guided.load = nan: must be finite"):
        scene(lambda t: np.nan).step(1e-5)


def test_what_a_function_raises_comes_out(ar, sand):
    def motion(t):
        if t > 0.001:
            raise KeyError("the motion")
        return (0, -1, 0)

    scene = cone(ar, sand, ar.Prescribed(motion))
    with pytest.raises(KeyError, match="the motion"):
        ar.run(scene, end=0.01)
    with pytest.raises(ZeroDivisionError):
        ar.run(cone(ar, sand, ar.Prescribed((0, -1))), end=0.01, after_step=lambda s: 1 / 0)


def test_a_run_ends_where_a_function_says(ar, column):
    scene = column()
    ar.run(scene, end=1.0, after_step=lambda s: ar.STOP if s.step_count == 7 else None)
    assert scene.step_count == 7


def test_interrupt_stops_after_the_step(ar, column, ctrl_c):
    scene = column()
    ctrl_c(0.3)
    with pytest.raises(KeyboardInterrupt):
        ar.run(scene, end=1e3)
    steps = scene.step_count
    assert steps > 0
    ar.run(scene, end=scene.time + 1e-3)
    assert scene.step_count > steps


def test_a_scene_within_a_step_is_refused_to_others(ar, sand):
    scene = None
    errors = []

    def motion(t):
        try:
            scene.time
        except ar.Error as e:
            errors.append(str(e))
        return (0, -1, 0)

    scene = cone(ar, sand, ar.Prescribed(motion))
    scene.step(1e-5)
    assert errors and "within a step" in errors[0]


@pytest.mark.parametrize("change, sentence", [
    (dict(mesh=lambda ar: ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.03)), "CartesianGrid.cell = 0.03: must divide the extent"),
    (dict(mesh=lambda ar: ar.CartesianGrid((0, 0), (0.4,), cell=0.01)), "must be 2 numbers"),
    (dict(region=lambda ar: ar.Ball((0, 0), -1)), "Ball.radius = -1: must be positive"),
    (dict(region=lambda ar: ar.Box((0, 0, 0), (1, 1, 1))), "must be 2 numbers in this scene"),
    (dict(region=lambda ar: (lambda x: x[:, 0] > 10)), "the region holds no point"),
    (dict(walls=lambda ar: [ar.on("base")]), "no node sets"),
    (dict(walls=lambda ar: [ar.bottom("glued")]), "must be fixed or roller"),
    (dict(gravity=lambda ar: (0, float("nan"))), "must be finite"),
    (dict(friction=lambda ar: 2.0), r"MohrCoulomb.friction = 2: must lie in \[0, 1.55\]"),
    (dict(friction=lambda ar: float("nan")), "MohrCoulomb.friction"),
])
def test_what_cplusplus_refuses_python_refuses(ar, change, sentence):
    with pytest.raises(ar.Error, match=sentence):
        given = {name: value(ar) for name, value in change.items()}
        sand = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=given.get("friction", 0.6))
        ar.Scene(ar.PlaneStrain(), given.get("mesh", ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01)),
                 ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                 bodies=[ar.fill("sand", given.get("region", ar.Box((0, 0), (0.1, 0.15))), sand)],
                 walls=given.get("walls", [ar.bottom(), ar.left("roller")]), gravity=given.get("gravity", (0, -9.81)))


def test_run_refuses_steps_that_are_unstable(ar, column):
    scene = column()
    with pytest.raises(ar.Error, match="courant = 2: must be at most 1"):
        ar.run(scene, end=0.1, courant=2)
    with pytest.raises(ar.Error, match="must be positive"):
        scene.step(-1)


def test_points_for_meshio(ar, column):
    pytest.importorskip("meshio")
    scene = column()
    mesh = ar.to_meshio(scene)
    assert mesh.points.shape == (600, 3) and mesh.point_data["stress"].shape == (600, 6)


# --- sweeps of any function, in processes of their own

def toe(friction, cell):
    """Of a small column, m; and where its points end, [n, 2]."""
    import arenite

    law = arenite.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=friction)
    scene = arenite.Scene(arenite.PlaneStrain(), arenite.CartesianGrid((0, 0), (0.4, 0.2), cell=cell),
                          arenite.Numerics(arenite.QuadraticBSpline, arenite.Apic),
                          bodies=[arenite.fill("sand", arenite.Box((0, 0), (0.1, 0.1)), law)],
                          walls=[arenite.bottom("fixed"), arenite.left("roller")], gravity=(0, -9.81))
    arenite.run(scene, end=0.05)
    x = np.asarray(scene.bodies["sand"].position)
    return {"toe": x[:, 0].max(), "points": x, "seen": (len(x), "sand", None)}


def counted(value):
    """Leaves a file for each call; some values end otherwise."""
    folder, x = value
    (Path(folder) / f"{x}-{os.getpid()}-{time.time_ns()}").touch()
    if x == "raises":
        raise ValueError("too steep")
    if x == "dies":
        os.kill(os.getpid(), signal.SIGKILL)
    if x == "exits":
        os._exit(3)
    return object() if x == "odd" else 2 * x


def calls(folder):
    return sorted(p.name.split("-")[0] for p in folder.iterdir())


def test_a_sweep_of_scenes(ar, tmp_path):
    swept = {"friction": [0.4, np.float64(0.6)], "cell": [0.02]}
    sweep = ar.sweep(toe, swept, jobs=2, out=tmp_path / "out")
    assert list(sweep["status"]) == ["done"] * 2 and list(sweep["friction"]) == [0.4, 0.6] and sweep["toe"][0] > sweep["toe"][1] > 0.09
    for row, result in zip(sweep, sweep.results):
        alone = toe(row["friction"], row["cell"])
        assert row["toe"] == result["toe"] == alone["toe"] and np.array_equal(result["points"], alone["points"])
        assert result["seen"] == [100, "sand", None]
    again = ar.sweep(toe, swept, out=tmp_path / "out")
    assert all(np.array_equal(a["points"], b["points"]) for a, b in zip(again.results, sweep.results))
    assert "friction  cell  status" in repr(sweep) and repr(sweep).startswith("Table of 2 values")
    assert len(sweep.plot("friction", "toe").containers) == 1 if "matplotlib" in sys.modules else True


def test_a_sweep_outlives_its_failures_and_goes_on(ar, tmp_path):
    """What is done is read; what failed is tried again; a process that dies takes its value with it alone."""
    marks, out = tmp_path / "marks", tmp_path / "out"
    marks.mkdir()
    values = [(str(marks), x) for x in (1, "raises", "dies", 2, "exits", "odd", 3)]
    sweep = ar.sweep(counted, values, jobs=2, out=out)
    assert list(sweep["status"]) == ["done", "failed", "failed", "done", "failed", "failed", "done"] and sweep["result"][[0, 3, 6]].tolist() == [2, 4, 6]
    failure = sweep["failure"]
    assert failure[1] == "ValueError: too steep" and failure[2] == "its process ended by signal 9 (SIGKILL)"
    assert failure[4] == "its process ended with exit code 3" and failure[5].startswith("result = <object object")
    assert "must be a number, a text, an array" in failure[5] and sweep.results[1] is None and np.isnan(sweep["result"][1])
    traces = [p.read_text() for p in out.glob("*.failed.txt")]
    assert len(traces) == 4 and sum("in counted" in trace for trace in traces) == 1
    before = set(out.glob("*.npz"))
    ar.sweep(counted, [(str(marks), 5)], out=out)
    (cut,) = set(out.glob("*.npz")) - before  # of 5, whose file is cut as by a full disk
    cut.write_bytes(cut.read_bytes()[:100])
    for mark in marks.iterdir():
        mark.unlink()
    again = ar.sweep(counted, [*values, (str(marks), 4), (str(marks), 5)], out=out)
    assert calls(marks) == sorted(["4", "5", "dies", "exits", "odd", "raises"])
    assert again["result"][[0, 3, 6, 7, 8]].tolist() == [2, 4, 6, 8, 10]
    with pytest.raises(ar.Error, match="sweep: each of 1 values failed; value = .*: ValueError: too steep"):
        ar.sweep(counted, values[1:2])


def test_jobs_of_a_cluster_share_a_sweep(ar, tmp_path, monkeypatch):
    """Each runs its cases; what others have done is read; numbers that are none are refused."""
    marks, out = tmp_path / "marks", tmp_path / "out"
    marks.mkdir()
    values = [(str(marks), x) for x in (1, 2, 3, "raises", 5)]
    plan = ar.sweep(counted, values, out=out, cases="none")
    assert list(plan["status"]) == ["waiting"] * 5 and calls(marks) == []
    monkeypatch.setenv("ARENITE_CASES", "1-2")
    part = ar.sweep(counted, values, out=out)
    assert list(part["status"]) == ["waiting", "done", "done", "waiting", "waiting"] and calls(marks) == ["2", "3"]
    monkeypatch.delenv("ARENITE_CASES")
    part = ar.sweep(counted, values, out=out, cases=[3, 4])
    assert list(part["status"]) == ["waiting", "done", "done", "failed", "done"] and part["failure"][3] == "ValueError: too steep"
    with ar._cases.alone(out / f"{ar._sweep._case({'value': values[0]}, (values[0],), {}).name}.lock") as here:
        assert here and list(ar.sweep(counted, values[:3], out=out)["status"]) == ["running", "done", "done"]
    whole = ar.sweep(counted, values, out=out, jobs=2)
    assert whole["result"][[0, 1, 2, 4]].tolist() == [2, 4, 6, 10] and calls(marks) == ["1", "2", "3", "5", "raises", "raises"]
    assert not list(out.glob("*.lock"))
    for cases, rule in ((5, "cases = 5: the sweep has the cases 0 to 4"), ("2-", "cases = 2-: must be none, all, or numbers"), (1.5, "must be none, all"),
                        ("0-9", "the sweep has the cases 0 to 4")):
        with pytest.raises(ar.Error, match=rule):
            ar.sweep(counted, values, out=out, cases=cases)
    with pytest.raises(ar.Error, match="needs a folder"):
        ar.sweep(counted, values, cases=1)


def test_values_that_go_together(ar):
    assert ar._cases.combinations({"a, b": [(1, 2), (3, 4)], "c": [5, 6]}) == [
        {"a": 1, "b": 2, "c": 5}, {"a": 1, "b": 2, "c": 6}, {"a": 3, "b": 4, "c": 5}, {"a": 3, "b": 4, "c": 6}]
    with pytest.raises(ar.Error, match="must be 2 values"):
        ar._cases.combinations({"a, b": [(1, 2, 3)]})


SWEEP = """
import pathlib, signal, sys, time
import arenite as ar

signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in what a shell runs in its background

def slow(x):
    pathlib.Path(f"calls-{x}-{time.time_ns()}").touch()
    time.sleep(0.05 if x < 3 else float(sys.argv[1]))
    return x * x

if __name__ == "__main__":
    print(ar.sweep(slow, range(6), jobs=2, out="out")["result"].tolist())
"""


@pytest.mark.parametrize("with_signal", [signal.SIGKILL, signal.SIGINT])
def test_a_sweep_that_is_killed_goes_on(ar, tmp_path, with_signal):
    (tmp_path / "script.py").write_text(SWEEP)
    first = subprocess.Popen([sys.executable, "script.py", "30" if with_signal == signal.SIGINT else "2"], cwd=tmp_path,
                             stderr=subprocess.PIPE, text=True, start_new_session=True)
    until = time.monotonic() + 60
    while len(list((tmp_path / "out").glob("*.npz"))) < 3 or len(list(tmp_path.glob("calls-*"))) < 5:
        assert time.monotonic() < until and first.poll() is None
        time.sleep(0.02)
    first.send_signal(with_signal)
    _, said = first.communicate(timeout=20)  # its processes have ended, too: they hold the stream
    assert first.returncode != 0 and ("KeyboardInterrupt" in said) == (with_signal == signal.SIGINT)
    known = len(list((tmp_path / "out").glob("*.npz")))
    assert known == (3 if with_signal == signal.SIGINT else 5)  # what was under way when the first was killed came to its end
    for mark in tmp_path.glob("calls-*"):
        mark.unlink()
    done = subprocess.run([sys.executable, "script.py", "0"], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == "[0, 1, 4, 9, 16, 25]\n" and len(list(tmp_path.glob("calls-*"))) == 6 - known


def test_what_a_sweep_refuses(ar, tmp_path):
    with pytest.raises(ar.Error, match="sweep.function = <function .*<lambda>.*: cannot be pickled: a function must be one of a module"):
        ar.sweep(lambda x: x, [1])
    with pytest.raises(ar.Error, match="sweep.values.value = <function .*: cannot be pickled"):
        ar.sweep(counted, [lambda x: x])
    for values, sentence in (([], "needs at least one value"), (3, "sweep.values = 3: must be several values"), ({"x": 1}, "sweep.values.x = 1")):
        with pytest.raises(ar.Error, match=sentence):
            ar.sweep(counted, values)
    with pytest.raises(ar.Error, match="jobs = 0: must be a whole number of at least 1"):
        ar.sweep(counted, [1], jobs=0)
    script = tmp_path / "script.py"
    script.write_text("import arenite as ar\ndef f(x):\n    return x\nif __name__ == '__main__':\n    ar.sweep(f, [1], out='out')\n")

    def said():
        done = subprocess.run([sys.executable, "script.py"], cwd=tmp_path, capture_output=True, text=True)
        return done.stderr.strip().splitlines()[-1] if done.returncode else ""

    assert said() == ""
    script.write_text(script.read_text().replace("return x", "return x + 1"))
    assert "sweep.out = out: holds results of this function as its code was then; name another folder, or remove it" in said()
    script.write_text(script.read_text().replace("f(x)", "g(x)").replace("(f,", "(g,"))
    assert "holds results of another function" in said()
    script.write_text("import arenite as ar\ndef h(x):\n    return x\nar.sweep(h, [1])\n")
    assert 'before its first value; a script must call sweep under `if __name__ == "__main__":`' in said()
    os.mkfifo(tmp_path / "fifo.json")
    (tmp_path / "piped").mkdir()
    os.rename(tmp_path / "fifo.json", tmp_path / "piped" / "sweep.json")
    with pytest.raises(ar.Error, match="must be a regular file, not a pipe"):
        ar.sweep(counted, [1], out=tmp_path / "piped")


def test_a_result_on_disk_runs_nothing(ar, tmp_path):
    """A pickle that lies in a result's place is not loaded."""
    values = [(str(tmp_path), 5)]
    ar.sweep(counted, values, out=tmp_path / "out")
    path, = (tmp_path / "out").glob("*.npz")

    class Planted:
        def __reduce__(self):
            return os.system, (f"touch {tmp_path}/ran",)

    planted = np.array([Planted()], dtype=object)
    np.savez(path, told=planted)
    assert ar.sweep(counted, values, out=tmp_path / "out")["result"].tolist() == [10] and not (tmp_path / "ran").exists()
