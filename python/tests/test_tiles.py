"""Scenes cut into tiles: beside the whole scene, and on ranks of MPI."""

import inspect
import os
import pickle
import re
import shutil
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

SCRIPT = Path(__file__).parent / "tiles_on_ranks.py"


@pytest.fixture
def on_ranks(ar, compiler, tmp_path):
    """Runs a part of the script; returns its exit code, what the ranks printed, sorted, and what went wrong."""
    pytest.importorskip("mpi4py")
    if not shutil.which("mpirun") or not shutil.which("mpicxx"):
        pytest.skip("needs MPI")
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}

    def run(ranks, what):
        done = subprocess.run(["mpirun", "-n", str(ranks), sys.executable, "-m", "mpi4py", str(SCRIPT), what, str(tmp_path / "saved")],
                              env=environment, capture_output=True, text=True, timeout=300, cwd=tmp_path)
        return done.returncode, sorted(line for line in done.stdout.splitlines() if line), done.stderr

    return run


def recipe(ar, sand, **more):
    body = {name: more.pop(name) for name in ("velocity", "stress", "jitter", "seed", "exact_volume") if name in more}
    return ((ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Flip(time=0.1))),
            {**dict(bodies=[ar.fill("sand", more.pop("region", ar.Box((0, 0), (0.1, 0.1))), sand, per_cell=4, **body)],
                    walls=[ar.bottom("fixed"), ar.left("roller")], gravity=(0, -9.81)), **more})


@pytest.fixture
def in_tiles(ar, sand, compiler):
    def make(**more):
        positional, named = recipe(ar, sand, **more)
        return ar.TiledScene(*positional, **named)

    return make


@pytest.fixture
def in_one(ar, sand, compiler):
    def make(**more):
        positional, named = recipe(ar, sand, **more)
        return ar.Scene(*positional, **named)

    return make


def by_id(ids, rows):
    return np.asarray(rows)[np.argsort(ids)]


def test_tiles_are_the_whole(ar, in_one, in_tiles, tmp_path):
    """One tile has the bits of the whole scene, three are off by rounding errors; a series holds all points."""
    whole = in_one()
    due = []
    ar.run(whole, end=0.05, every={0.02: lambda s: due.append(s.time)})
    heights = np.sort(whole.bodies["sand"].position[:, 1])
    for tiles, error in ((1, 0), (3, 1e-11)):
        scene = in_tiles(tiles=tiles)
        times = []
        ar.run(scene, end=0.05, every={0.02: lambda s: times.append((s.time, s.energy.kinetic)), 0.05: ar.Vtu(tmp_path / f"of_{tiles}")})
        assert len(times) == 3 and [time for time, _ in times] == due and scene.step_count == whole.step_count
        assert [tile.number for tile in scene.tiles] == list(range(tiles))
        assert np.abs(np.sort(scene.bodies["sand"].position[:, 1]) - heights).max() <= error
        assert scene.energy.kinetic == pytest.approx(whole.energy.kinetic, rel=1e-9)
        assert sorted(scene.bodies["sand"].column("id")) == list(range(400))
    assert "of_3_sand_rank0_0001.vtu" in (tmp_path / "of_3.pvd").read_text()


def test_weights_and_what_is_refused(ar, in_tiles):
    weights = np.zeros(800) + 0.001
    weights[: 400] = 1
    few = [len(tile.bodies["sand"]) for tile in in_tiles(tiles=2, weights=weights).tiles]
    assert sum(few) == 400
    for more, word in ((dict(tiles=-1), "TiledScene.tiles = -1"), (dict(tiles=2.5), r"TiledScene.tiles = 2.5: must be a whole number"),
                       (dict(tiles=True), "TiledScene.tiles = True"), (dict(rebalance_every=1.5), "TiledScene.rebalance_every = 1.5"),
                       (dict(tiles=801), "split_cells.tiles = 801: must be between 1 and the number of cells, 800"),
                       (dict(tile_of_cell=[0.5, 1]), "tile_of_cell = an array .*of float64"), (dict(ranks="all"), "must be a communicator of mpi4py"),
                       (dict(rebalance_every=0), "RebalanceOptions.every = 0"), (dict(tile_of_cell=[0, 1]), "tiles of a grid are boxes")):
        with pytest.raises(ar.Error, match=word):
            ar.run(in_tiles(**more), end=1e-4)
    with pytest.raises(TypeError, match="weigths"):
        in_tiles(weigths=[])


def rows(scene, body="sand"):
    """Position, velocity and stress of all points, sorted by position."""
    of = scene.bodies[body]
    all_rows = np.column_stack([of.position, of.velocity, of.stress, *of.history.values()])
    return all_rows[np.lexsort(np.round(all_rows[:, :2], 12).T)]


def test_functions_see_all_positions(ar, in_one, in_tiles):
    """As those of an ordinary scene: once, in its order, for what is filled, for walls, and for points that join and leave."""
    calls = []

    def noted(f):
        def of(x):
            calls.append(len(x))
            return f(x)

        return of

    def make(kind, **more):
        calls.clear()
        scene = kind(region=noted(lambda x: x[:, 0] + x[:, 1] < x.mean()),
                     velocity=noted(lambda x: np.random.default_rng(1).normal(size=x.shape)),
                     stress=noted(lambda x: np.outer(x[:, 1].max() - x[:, 1], [-1e4, -2e4, -1e4, 0, 0, 0])), jitter=0.3,
                     walls=[ar.bottom("fixed"), ar.where(noted(lambda x: x[:, 0] <= x[:, 0].min()))], **more)
        made = list(calls)
        ar.remove_points(scene, "sand", noted(lambda x: x[:, 1] < np.median(x[:, 1])))
        ar.fill_points(scene, "sand", ar.Box((0.3, 0.1), (0.35, 0.15)), per_cell=4, velocity=noted(lambda x: x - x.mean(axis=0)))
        return scene, made, list(calls)

    whole, made, called = make(in_one)
    assert len(made) == 4
    for tiles in (1, 4):
        scene, made_here, called_here = make(in_tiles, tiles=tiles)
        assert made_here == made and called_here == called
        assert np.array_equal(rows(scene), rows(whole))
    ar.run(whole, end=0.002)
    ar.run(scene, end=0.002)
    assert rows(scene) == pytest.approx(rows(whole), rel=1e-9, abs=1e-9)


def test_a_new_scene_warns_as_a_whole(in_one, in_tiles, ar):
    def told(kind, **more):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            kind(walls=[ar.left("roller")], region=ar.Box((0.3, 0.1), (0.6, 0.106)), **more)
        return [str(w.message) for w in caught]

    wanted = told(in_one)
    assert len(wanted) == 3 and "everything falls" in wanted[-1], wanted
    assert told(in_tiles, tiles=4) == wanted
    with pytest.raises(ar.Error, match="the region holds no point of the mesh"):
        in_tiles(tiles=4, region=ar.Box((5, 5), (6, 6)))


def test_views_write_to_tiles(ar, in_one, in_tiles):
    for scene in (in_one(), in_tiles(tiles=4)):
        sand = scene.bodies["sand"]
        sand.velocity[:, 0] = 1.0
        sand.velocity[np.asarray(sand.position)[:, 1] > 0.05] = (2.0, 3.0)
        stress = sand.stress
        stress *= 0
        stress -= 5.0
        assert np.mean(sand.velocity, axis=0) == pytest.approx([1.5, 1.5]) and (np.asarray(sand.stress) == -5).all()
        for name in ("position", "mass", "volume"):
            with pytest.raises(ar.Error, match="cannot be written"):
                getattr(sand, name)[:] = 0
        assert np.array_equal(pickle.loads(pickle.dumps(sand.position)), sand.position)
        old = sand.velocity
        scene.step(1e-5)
        with pytest.raises(ar.Error, match="has stepped"):
            old[0]


def test_a_refusal_leaves_tiles_as_they_were(ar, in_one, in_tiles, tmp_path):
    """Also where it comes from one tile in the middle of a restore, and where a run was stopped."""
    questions = {"a reaction": lambda s: s.reaction("bottom"), "balance": lambda s: s.out_of_balance,
                 "no such state": lambda s: s.restore(tmp_path / "nothing"), "a point outside": lambda s: ar.insert_points(s, "sand", [(5, 0.9)], 1e-4),
                 "a thin section": lambda s: ar.section_force(s, "sand", (0.1, 0.05), (0, 1), 0), "a step back": lambda s: s.step(-1.0),
                 "an early end": lambda s: ar.run(s, end=-1), "an empty fill": lambda s: ar.fill_points(s, "sand", ar.Box((5, 5), (6, 6))),
                 "a watch": lambda s: ar.run(s, end=s.time + 0.01, watch=ar.Watch(speed=1e-6, every=1)),
                 "an observer": lambda s: ar.run(s, end=s.time + 0.01, every={0.001: lambda s: [][0]})}
    for name, ask in questions.items():
        whole, scene = in_one(), in_tiles(tiles=4)
        for of in (whole, scene):
            ar.run(of, end=0.001)
            with pytest.raises((ar.Error, IndexError)):
                ask(of)
            of.save(tmp_path / f"state{of is scene}")
            ar.run(of, end=0.02)
        assert scene.step_count == whole.step_count and rows(scene) == pytest.approx(rows(whole), rel=1e-9, abs=1e-9), name
        again = in_tiles(tiles=4)
        again.restore(tmp_path / "stateTrue")
        ar.run(again, end=0.02)
        assert np.array_equal(rows(again), rows(scene))
    with pytest.raises(ar.Error, match=r"nothing: must be a folder with a file tiles.txt, and there is none"):
        scene.restore(tmp_path / "nothing")
    with pytest.raises(ar.Error, match="is a file: a scene that is cut into tiles is saved to a folder"):
        scene.restore(tmp_path / "stateFalse")
    before = rows(scene)
    damaged = next((tmp_path / "stateTrue").glob("tile2_*.state"))
    damaged.write_bytes(damaged.read_bytes()[:-9])
    with pytest.raises(ar.Error, match="tile2_"):
        scene.restore(tmp_path / "stateTrue")
    assert np.array_equal(rows(scene), before)


def test_a_run_that_is_stopped_at_its_start_takes_no_step(ar, in_one, in_tiles):
    for scene in (in_one(), in_tiles(tiles=4)):
        calls = []
        stop, look = lambda s: calls.append("stop") or ar.STOP, lambda s: calls.append("look")
        for every in ({1: stop}, {1: [stop, look]}, {1: look, 2: stop}):
            ar.run(scene, end=0.01, every=every)
            assert scene.step_count == 0 and scene.time == 0
        assert calls == ["stop", "stop", "look", "look", "stop"]
        ar.run(scene, end=0.01, after_step=stop)
        assert scene.step_count == 1


def flat(value):
    """Numbers and words of a value, one after another."""
    if isinstance(value, dict):
        return flat([x for pair in value.items() for x in pair])
    if isinstance(value, (list, tuple)):
        return [x for part in value for x in flat(part)]
    return [value] if value is None or isinstance(value, (str, float, int)) else np.ravel(value).tolist()


def sorted_rows(columns):
    table = np.column_stack(columns)
    return table[np.lexsort(np.round(table.T, 9))]


def resumed(ar, scene, folder):
    how = ar.run_in_folder(scene, 0.002, folder / "run", checkpoint_every=0.001)
    return how, ar.run_in_folder(scene, 0.003, folder / "run", resume=True), scene.time


def saved(scene, folder):
    scene.save(folder / "state")
    scene.step(1e-5)
    scene.restore(folder / "state")
    return scene.step_count


def drawn(ar, scene):
    points = ar.plot(scene, "mass").collections[0]
    return sorted_rows([points.get_offsets(), points.get_array()])


#: What each public member of a Scene, and each function that takes one, gives; a word: what a TiledScene says instead.
MEMBERS = {
    "time": lambda ar, s, _: s.time, "time_step": lambda ar, s, _: s.time_step, "step_count": lambda ar, s, _: s.step_count,
    "stable_step": lambda ar, s, _: s.stable_step, "step": lambda ar, s, _: (s.step(1e-5), s.time),
    "steps": (lambda ar, s, _: list(s.steps(end=0.002)), "TiledScene.steps: is not there: give `run` an `after_step`"),
    "switch_off_damping": lambda ar, s, _: s.switch_off_damping(), "out_of_balance": lambda ar, s, _: s.out_of_balance,
    "energy": lambda ar, s, _: s.energy, "watched": lambda ar, s, _: (ar.run(s, 0.002, watch=ar.Watch(speed=10)), s.watched["speed"].worst),
    "nodes": lambda ar, s, _: sorted_rows(s.nodes("sand")), "number_of": lambda ar, s, _: s.number_of("sand"),
    "reaction": lambda ar, s, _: s.reaction("bottom"), "cells": lambda ar, s, _: s.cells,
    "state": lambda ar, s, _: sorted({re.sub("tiles/[0-9]+/", "", path) for path in s.state if "/id" not in path and "point_ids" not in path}),
    "law": lambda ar, s, _: repr(s.law("sand")), "composition": lambda ar, s, _: s.composition, "compiled_as": lambda ar, s, _: len(s.compiled_as) > 9,
    "rank": lambda ar, s, _: s.rank, "save": lambda ar, s, folder: saved(s, folder), "restore": lambda ar, s, folder: saved(s, folder),
    "copy": (lambda ar, s, _: s.copy().time, "TiledScene: cannot be copied; save it"),
    "bodies": lambda ar, s, _: rows(s), "rigids": lambda ar, s, _: s.rigids,
}
FUNCTIONS = {
    "run": lambda ar, s, _: (ar.run(s, 0.004), rows(s)), "settle": lambda ar, s, _: ar.settle(s, 0.01), "run_in_folder": lambda ar, s, f: resumed(ar, s, f),
    "check": lambda ar, s, _: str(ar.check(s)), "plot": lambda ar, s, _: drawn(ar, s),
    "animate": lambda ar, s, f: (ar.animate(s, f / "sand.gif", end=0.002, every=0.001).stat().st_size > 0, s.time),
    "fill_points": lambda ar, s, _: ar.fill_points(s, "sand", ar.Box((0.2, 0), (0.25, 0.05)), per_cell=4),
    "insert_points": lambda ar, s, _: ar.insert_points(s, "sand", [(0.21, 0.11), (0.3, 0.05)], 1e-5, velocity=[(1, 0), (0, 2)]),
    "remove_points": lambda ar, s, _: (ar.remove_points(s, "sand", ar.Box((0, 0.05), (0.1, 0.2))), ar.remove_points(s, "sand", lambda x: x[:, 0] < x[:, 0].mean()),
                                       ar.remove_points(s, "sand", np.asarray(s.bodies["sand"].position)[:, 0] > 0.09), rows(s)),
    "probe": lambda ar, s, _: ar.probe(s, "sand", [(0.05, 0.05), (0.3, 0.1)]), "section_force": lambda ar, s, _: ar.section_force(s, "sand", (0, 0.05), (0, 1), 0.02),
    "deviatoric_strain": lambda ar, s, _: ar.deviatoric_strain(s, "sand"), "compile": lambda ar, s, _: (type(ar.compile(s)) is type(s), ar.compile(s).time),
    "to_meshio": lambda ar, s, _: sorted_rows(list(ar.to_meshio(s).points.T)), "to_pyvista": lambda ar, s, _: sorted_rows(list(ar.to_pyvista(s).points.T)),
}


@pytest.mark.parametrize("name", [*MEMBERS, *FUNCTIONS])
def test_each_member_of_a_scene_in_tiles(ar, in_one, in_tiles, tmp_path, name):
    """The same as of a Scene, or a sentence."""
    ask = {**MEMBERS, **FUNCTIONS}[name]
    ask, refusal = ask if isinstance(ask, tuple) else (ask, None)
    if name in ("plot", "animate"):
        pytest.importorskip("matplotlib")
    if name.startswith("to_"):
        pytest.importorskip(name[3:])

    def told(scene, folder):
        folder.mkdir()
        ar.run(scene, end=0.001)
        try:
            return flat(ask(ar, scene, folder))
        except ar.Error as e:
            return str(e)

    wanted, found = told(in_one(), tmp_path / "one"), told(in_tiles(tiles=4), tmp_path / "tiles")
    if refusal:
        assert isinstance(found, str) and refusal in found and not isinstance(wanted, str)
    elif isinstance(wanted, str) or isinstance(found, str):
        assert found == wanted
    else:
        numbers = [k for k, x in enumerate(wanted) if isinstance(x, (int, float))]
        assert len(found) == len(wanted) and [x for x in found if isinstance(x, str)] == [x for x in wanted if isinstance(x, str)]
        assert [found[k] for k in numbers] == pytest.approx([wanted[k] for k in numbers], rel=1e-7, abs=1e-9, nan_ok=True)


def test_the_list_of_members_is_complete(ar):
    assert {name for name in dir(ar.Scene) if not name.startswith("_")} | {"bodies", "rigids"} == set(MEMBERS)
    taking = {name for name in ar.__all__ if inspect.isfunction(getattr(ar, name)) and "scene" in inspect.signature(getattr(ar, name)).parameters}
    assert taking | {"compile"} == set(FUNCTIONS)


def test_without_mpi_the_cure_is_named(ar, monkeypatch):
    from arenite import _compile

    monkeypatch.setenv("MPICXX", "no-such-mpicxx")
    with pytest.raises(ar.Error, match="compiler = no-such-mpicxx: not found; .*libopenmpi-dev"):
        _compile.ranks()


def test_ctrl_c_ends_tiles(ar, in_tiles, ctrl_c):
    scene = in_tiles(tiles=3)
    ctrl_c(0.3)
    with pytest.raises(KeyboardInterrupt):
        ar.run(scene, end=1e4)
    assert 0 < scene.time < 1e4


def test_same_bits_on_any_ranks(on_ranks):
    first = None
    for ranks in (1, 2, 3):
        code, lines, errors = on_ranks(ranks, "bits")
        assert code == 0 and len(lines) == ranks and len(set(lines)) == 1, errors
        first = first or lines[0]
        assert lines[0] == first
        code, lines, errors = on_ranks(3 - ranks % 2, "restart")  # on others than saved it
        assert code == 0 and first.startswith(lines[0]), errors


def test_a_run_stops_and_settles_on_all_ranks(on_ranks):
    for what in ("stop", "settled"):
        one, two = on_ranks(1, what), on_ranks(2, what)
        assert one[0] == two[0] == 0 and sorted(2 * one[1]) == two[1], two[2]
    assert "False 0" in one[1] and "True True" in one[1] and any("out of balance by" in line for line in one[1])


def test_a_warning_is_given_once_of_the_whole(on_ranks):
    one, two = on_ranks(1, "warned"), on_ranks(2, "warned")
    assert one[1] and two[1] == sorted([*one[1], "1 []"]), two[2]
    assert "not at rest" in one[1][0]


def test_an_error_on_one_rank_ends_all(on_ranks):
    code, lines, errors = on_ranks(3, "fail")
    assert code == 1 and "ValueError: the spade broke" in errors
    assert all(line.endswith("the spade broke']") for line in lines), lines
    code, _, errors = on_ranks(2, "fail_between")
    assert code == 1 and "IndexError" in errors


def test_points_come_and_go(on_ranks):
    one, two = on_ranks(1, "points"), on_ranks(2, "points")
    assert one[0] == two[0] == 0 and sorted(2 * one[1]) == two[1], two[2]
    assert sum(line.startswith(("TiledScene: cannot be copied", "TiledScene.steps: is not there", "TiledScene.cells: each tile")) for line in one[1]) == 3


def test_ranks_see_all_positions_and_go_on_after_a_refusal(on_ranks):
    for what in ("functions", "refused"):
        one, two = on_ranks(1, what), on_ranks(2, what)
        assert one[0] == two[0] == 0 and sorted(2 * one[1]) == two[1], two[2]


def test_ranks_that_are_told_different_things_say_so(on_ranks):
    """What is asked is compared before it is done: the sentence names the rank and what differs, on all ranks."""
    code, lines, errors = on_ranks(2, "differ")
    assert code == 0, errors
    expected = ["a TiledScene: rank 1 was given bodies[0].law.young = 10000000, rank 0 bodies[0].law.young = 1000000",
                "a TiledScene: rank 1 was given gravity = [0.0, 9.81], rank 0 gravity = [0.0, -9.81]",
                "a TiledScene: rank 1 was given tiles = 2, rank 0 tiles = 4", "run: rank 1 was given end = 0.01, rank 0 end = 0.02",
                "run: rank 1 was given courant = 0.1, rank 0 courant = 0.5", "run: rank 1 was given watch.volume = 0.1, rank 0 watch.volume = 0.2",
                "run: rank 1 was given every = [0.001], rank 0 every = [0.002]",
                "rank 1 asks for energy while rank 0 asks for the next steps of its run",
                "rank 1 asks for files of Vtu while rank 0 asks for the next steps of its run",
                "rank 1 asks for energy while rank 0 asks for stable_step", "probe: rank 1 was given places = [[0.2, 0.05]], rank 0 places = [[0.1, 0.05]]",
                "rank 1 asks for sum while rank 0 asks for least"]
    saved = [line for line in lines if line.startswith("save: rank 1 was given path = ")]
    assert sorted(set(lines) - set(saved)) == sorted(expected) and len(set(saved)) == 1
    assert all(lines.count(line) == 2 for line in lines), lines
    code, lines, errors = on_ranks(2, "differing_functions")
    assert code == 0 and len(set(lines)) == 1, errors
    assert "rank 1 was given gravity, which reads pull = 10.81, rank 0 gravity, which reads pull = 9.81" in lines[0]


def test_a_question_that_one_rank_asks_alone_ends(on_ranks):
    code, _, errors = on_ranks(2, "left_alone")
    assert code == 1 and "rank 0 asks for energy while the program of rank 1 has ended" in errors


@pytest.mark.parametrize("ranks", [2, 1])
def test_a_series_that_goes_on_on_other_ranks_lists_the_files_of_each_frame(on_ranks, tmp_path, ranks):
    for on, what in ((ranks, "series"), (3 - ranks, "series_on")):
        code, _, errors = on_ranks(on, what)
        assert code == 0, errors
    points = {}
    for time, file in re.findall(r'timestep="([^"]*)"[^>]*file="([^"]*)"', (tmp_path / "series/a.pvd").read_text()):
        count = re.search(rb'NumberOfPoints="(\d+)"', (tmp_path / "series" / file).read_bytes())
        points.setdefault(time, []).append(int(count[1]))
    frames = list(points.values())
    assert [len(files) for files in frames] == 3 * [ranks] + 2 * [3 - ranks]
    assert {sum(files) for files in frames} == {600}
    code, _, errors = on_ranks(2, "series")
    assert code == 0 and errors.count("which are replaced") == 1, errors
