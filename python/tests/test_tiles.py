"""Scenes cut into tiles: beside the whole scene, and on ranks of MPI."""

import os
import shutil
import subprocess
import sys
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


@pytest.fixture
def in_tiles(ar, sand, compiler):
    def make(**more):
        return ar.TiledScene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Flip(time=0.1)),
                             bodies=[ar.fill("sand", ar.Box((0, 0), (0.1, 0.1)), sand, per_cell=4)],
                             **{**dict(walls=[ar.bottom("fixed"), ar.left("roller")], gravity=(0, -9.81)), **more})

    return make


def by_id(ids, rows):
    return np.asarray(rows)[np.argsort(ids)]


def test_tiles_are_the_whole(ar, sand, in_tiles, tmp_path):
    """One tile has the bits of the whole scene, three are off by rounding errors; a series holds all points."""
    whole = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Flip(time=0.1)),
                     bodies=[ar.fill("sand", ar.Box((0, 0), (0.1, 0.1)), sand, per_cell=4)],
                     walls=[ar.bottom("fixed"), ar.left("roller")], gravity=(0, -9.81))
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
    for more, word in ((dict(tiles=-1), "TiledScene.tiles = -1"), (dict(ranks="all"), "must be a communicator of mpi4py"),
                       (dict(rebalance_every=0), "RebalanceOptions.every = 0"), (dict(tile_of_cell=[0, 1]), "tiles of a grid are boxes")):
        with pytest.raises(ar.Error, match=word):
            ar.run(in_tiles(**more), end=1e-4)
    with pytest.raises(TypeError, match="weigths"):
        in_tiles(weigths=[])


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


def test_an_error_on_one_rank_ends_all(on_ranks):
    code, lines, errors = on_ranks(3, "fail")
    assert code == 1 and "ValueError: the spade broke" in errors
    assert all(line.endswith("the spade broke']") for line in lines), lines
    code, _, errors = on_ranks(2, "fail_between")
    assert code == 1 and "IndexError" in errors


def test_points_come_and_go(on_ranks):
    one, two = on_ranks(1, "points"), on_ranks(2, "points")
    assert one[0] == two[0] == 0 and sorted(2 * one[1]) == two[1], two[2]
    assert sum("is not there for a scene that is cut into tiles" in line for line in one[1]) == 2
