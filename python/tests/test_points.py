"""Points inserted, removed and looked at between steps; stages that settle; VTU files."""

import pickle
import sys

import numpy as np
import pytest


def test_removed_by_region_function_and_mask(ar, column):
    """The three ways take the same points, and mass, momentum and energy balance count them."""
    taken = []
    for where in (ar.Box((0, 0.1), (0.1, 0.15)), lambda x: x[:, 1] > 0.1, None):
        scene = column()
        ar.run(scene, end=0.02)
        sand = scene.bodies["sand"]
        x, v, m = (np.asarray(c) for c in (sand.position, sand.velocity, sand.mass))
        above, view = x[:, 1] > 0.1, sand.mass
        before = scene.energy
        totals = ar.remove_points(scene, "sand", above if where is None else where)
        assert totals.points == above.sum() and len(scene.bodies["sand"]) == 600 - totals.points
        assert totals.mass == pytest.approx(m[above].sum(), rel=1e-12)
        assert np.allclose(totals.momentum, (m[:, None] * v)[above].sum(axis=0), rtol=1e-9, atol=1e-12)
        assert np.all(np.asarray(scene.bodies["sand"].position)[:, 1] <= 0.1)
        after = scene.energy
        assert after.residual == pytest.approx(before.residual, abs=1e-9 * before.external)
        assert before.kinetic - after.kinetic == pytest.approx(totals.kinetic_energy, rel=1e-9)
        with pytest.raises(ar.Error, match="take the view anew"):
            view + 1
        ar.run(scene, end=0.03)
        taken.append(np.asarray(scene.bodies["sand"].position))
    assert np.array_equal(taken[0], taken[1]) and np.array_equal(taken[0], taken[2])


def test_filled_and_inserted(ar, column):
    scene = column()
    totals = ar.fill_points(scene, "sand", ar.Box((0.2, 0), (0.25, 0.05)), velocity=lambda x: np.column_stack([x[:, 1], 0 * x[:, 1]]))
    assert totals.points == 100 and totals.mass == pytest.approx(1540 * 0.05**2, rel=1e-12)
    sand = scene.bodies["sand"]
    new = sand.position[:, 0] > 0.15
    assert np.array_equal(sand.velocity[new][:, 0], sand.position[new][:, 1])
    more = ar.insert_points(scene, "sand", [(0.3, 0.1), (0.31, 0.1)], 1e-6, velocity=[(1, 0), (0, 1)],
                            stress=[(-1, -2, -3, 0)] * 2)
    assert more == ar.Totals(2, pytest.approx(2 * 1540e-6), pytest.approx([1540e-6, 1540e-6]), pytest.approx(1540e-6),
                             pytest.approx(more.strain_energy))
    # U = (s:s - nu ((tr s)^2 - s:s) ...) of Hooke's law: ((1 + nu) s:s - nu (tr s)^2) / (2 E)
    assert more.strain_energy == pytest.approx(2e-6 * (1.3 * 14 - 0.3 * 36) / 2e6, rel=1e-9)
    there = scene.bodies["sand"].position[:, 0] > 0.29
    assert there.sum() == 2 and scene.bodies["sand"].stress[there][0].tolist() == [-1, -2, -3, 0]
    scene.step(1e-5)
    assert scene.energy.inserted == pytest.approx(totals.kinetic_energy + more.kinetic_energy + more.strain_energy, rel=1e-6)


def test_states_know_who_joined_and_left(ar, column):
    scene = column()
    ar.run(scene, end=0.01)
    ar.remove_points(scene, "sand", ar.Box((0, 0.12), (0.1, 0.2)))
    ar.fill_points(scene, "sand", ar.Box((0.2, 0), (0.3, 0.05)))
    others = [pickle.loads(pickle.dumps(scene)), scene.copy()]
    for each in (scene, *others):
        ar.run(each, end=0.03)
    for other in others:
        assert np.array_equal(other.bodies["sand"].position, scene.bodies["sand"].position)
        assert other.energy == scene.energy


def test_refusals_leave_the_scene(ar, column):
    scene = column()
    for bad, text in [(lambda: ar.insert_points(scene, "sand", [(9, 9)], 1e-6), "must lie in the mesh"),
                      (lambda: ar.insert_points(scene, "sand", [(0.1, 0.1)], -1), "volume = -1: must be given, positive"),
                      (lambda: ar.insert_points(scene, "sand", [(0.1, 0.1)], 1e-6, velocity=[(1, 2, 3)]), "must be 1 rows of 2"),
                      (lambda: ar.insert_points(scene, "sand", [(0.1, 0.1)], 1e-6, history={"age": [1]}), "history = age"),
                      (lambda: ar.fill_points(scene, "sand", ar.Box((5, 5), (6, 6))), "holds no point"),
                      (lambda: ar.remove_points(scene, "sand", np.ones(3, bool)), "one for each of 600 points"),
                      (lambda: ar.remove_points(scene, "sand", np.ones(600)), "must be of booleans"),
                      (lambda: ar.remove_points(scene, "clay", ar.Box((0, 0), (1, 1))), "body = clay: must be one of sand"),
                      (lambda: ar.probe(scene, "sand", [(0, 0, 0)]), r"must be \[n, 2\]"),
                      (lambda: ar.section_force(scene, "sand", (0, 0), (0, 1), thickness=-1), "Section.thickness = -1")]:
        with pytest.raises(ar.Error, match=text):
            bad()
    assert len(scene.bodies["sand"]) == 600


def test_probe_and_section(ar, column):
    """A linear field of velocities, and a geostatic one of stresses, as the places have them."""
    def stress(x):
        p = -1540 * 9.81 * (0.15 - x[:, 1])
        return np.column_stack([p, p, p, 0 * p, 0 * p, 0 * p])

    sand = column().law("sand")
    scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01),
                     ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                     bodies=[ar.fill("sand", ar.Box((0, 0), (0.1, 0.15)), sand, stress=stress, velocity=(0.5, -1))],
                     walls=[ar.bottom("fixed"), ar.left("roller")], gravity=(0, -9.81))
    found = ar.probe(scene, "sand", [(0.05, 0.075), (0.35, 0.15)])
    assert np.allclose(found.velocity[0], (0.5, -1), rtol=1e-12)
    assert found.stress[0, 1] == pytest.approx(-1540 * 9.81 * 0.075, rel=1e-6)
    assert np.all(np.isnan(found.velocity[1])) and np.all(np.isnan(found.stress[1]))
    weight = 1540 * 9.81 * 0.1 * 0.05  # of what lies above the cut
    force = ar.section_force(scene, "sand", (0, 0.1), (0, 1), thickness=0.04)
    assert force[1] == pytest.approx(-weight, rel=1e-3) and abs(force[0]) < 1e-9 * weight
    nodes = ar.section_force(scene, "sand", (0, 0.1), (0, 1), thickness=0.04, of_nodes=True)
    assert nodes[1] == pytest.approx(-weight, rel=2e-2)


def test_settles_under_its_weight(ar, block_between_rollers):
    """A block between rollers: sigma_y = rho g (h - y), closed form, after dynamic relaxation."""
    scene = block_between_rollers(gravity=(0, -9.81))
    for stop, steps in (dict(every={0.1: lambda s: ar.STOP}), 0), (dict(after_step=lambda s: ar.STOP if s.step_count == 3 else None), 3):
        assert ar.settle(scene, end=2, **stop) is False and scene.step_count == steps
    assert ar.settle(scene, end=2) is True
    assert scene.out_of_balance <= 1e-3 and scene.time < 2
    block = scene.bodies["block"]
    within = (block.position[:, 1] > 0.05) & (block.position[:, 1] < 0.25)
    exact = -2000 * 9.81 * (0.3 - block.position[:, 1])
    assert np.abs(block.stress[:, 1] - exact)[within].max() < 0.01 * 2000 * 9.81 * 0.3
    scene.switch_off_damping()
    scene.step(1e-5)
    with pytest.raises(ar.RunError, match="out of balance by"):
        scene.bodies["block"].velocity[:, 1][:] = 1
        ar.settle(scene, end=scene.time + 1e-3)
    with pytest.raises(ar.Error, match="SettleOptions.ratio = 0: must be positive"):
        ar.settle(scene, end=5, ratio=0)


def test_settle_needs_damping(ar, column):
    with pytest.raises(ar.Error, match="settle: name a part that damps"):
        ar.settle(column(), end=1)


def test_vtu(ar, column, tmp_path):
    meshio = pytest.importorskip("meshio")
    scene = column()
    ar.run(scene, end=0.02, every={0.01: ar.Vtu(tmp_path / "out" / "column")})
    series = (tmp_path / "out" / "column.pvd").read_text()
    assert series.count("<DataSet") == 3 and "column_sand_0002.vtu" in series
    mesh = meshio.read(tmp_path / "out" / "column_sand_0002.vtu")
    sand = scene.bodies["sand"]
    assert np.array_equal(mesh.points[:, :2], np.asarray(sand.position))
    assert np.array_equal(mesh.point_data["stress"][:, :4], np.asarray(sand.stress))
    assert set(mesh.point_data) == {"velocity", "stress", "pressure", "mass", "volume"}
    with pytest.raises(ar.Error, match="goes with a mesh of simplices"):
        ar.Vtu(tmp_path / "x", mesh=True)(scene)


def test_a_series_of_files_goes_on_after_a_restart(ar, column, tmp_path):
    """That of an earlier run is replaced with a warning, and never by a run that begins behind its first frame."""
    prefix = tmp_path / "x"

    def times():
        return [float(line.split('"')[1]) for line in (tmp_path / "x.pvd").read_text().splitlines() if "timestep" in line]

    def run(scene, end, **options):
        ar.run(scene, end=end, every={0.01: ar.Vtu(prefix, **options)})

    run(column(), 0.03)
    with pytest.warns(ar.Warning, match="x.pvd: holds 4 frames of an earlier run, t = 0 to 0.03 s, which are replaced"):
        run(column(), 0.02)
    assert len(times()) == 3
    first = column()
    same = ar.Vtu(prefix, resumed=True)
    with pytest.warns(ar.Warning, match="replaced"):  # nothing is there from before the start
        ar.run(first, end=0.01, every={0.01: same})
    ar.run(first, end=0.02, every={0.01: same})  # the frame at 0.01 s is one
    first.save(tmp_path / "state")
    kept = [(tmp_path / f"x_sand_000{k}.vtu").read_bytes() for k in range(3)]
    again = column()
    again.restore(tmp_path / "state")
    with pytest.raises(ar.Error, match="holds 3 frames of an earlier run, t = 0 to 0.02 s, which this one, from t = 0.02 s on, would replace"):
        ar.Vtu(prefix, resumed=False)(again)
    assert len(times()) == 3 and again.time == 0.02
    called = []
    ar.run(again, end=0.03, every={0.01: ar.Vtu(prefix), 0.005: lambda s: called.append(s.time)})
    assert times() == [0, 0.01, 0.02, 0.03]
    assert np.allclose(called, [0.025, 0.03], atol=5e-4)  # what was due at 0.02 s was called before the state was saved
    assert [(tmp_path / f"x_sand_000{k}.vtu").read_bytes() for k in range(3)] == kept
    # of a longer interval: the frame at 0.03 s is behind the state, though before the first one that is written
    back, same = column(), ar.Vtu(prefix)
    back.restore(tmp_path / "state")
    ar.run(back, end=0.04, every={0.02: same})
    assert times() == [0, 0.01, 0.02, 0.04]
    run(back, 0.05)
    run(back, 0.06)  # frames that were written since are no others'
    assert times() == [0, 0.01, 0.02, 0.04, 0.05, 0.06]
    back.restore(tmp_path / "state")  # with a series under way
    ar.run(back, end=0.04, every={0.02: same})
    assert times() == [0, 0.01, 0.02, 0.04]
    assert [(tmp_path / f"x_sand_000{k}.vtu").read_bytes() for k in range(3)] == kept


# --- pictures

def drawn(axes):
    """Values and widths, m, of the points in axes."""
    points, = axes.collections
    return np.asarray(points.get_array()), np.asarray(points.get_widths() if hasattr(points, "get_widths") else 2 * points._widths)


def test_plot_shows_each_point_as_wide_as_its_matter(ar, column):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    scene = column()
    ar.run(scene, end=0.02)
    axes = ar.plot(scene)
    values, widths = drawn(axes)
    assert np.array_equal(values, -np.asarray(scene.bodies["sand"].stress)[:, :3].mean(axis=1))
    assert np.allclose(widths**2, scene.bodies["sand"].volume, rtol=1e-12)
    assert (axes.get_xlabel(), axes.get_ylabel(), axes.get_title()) == ("x [m]", "y [m]", "t = 0.02 s")
    assert axes.get_xlim() == (0, 0.4) and axes.figure.axes[1].get_ylabel() == "pressure [Pa]"
    _, own = pyplot.subplots()
    assert ar.plot(scene, "speed", ax=own, limits=(0, 1)) is own and own.collections[0].get_clim() == (0, 1)
    assert np.allclose(drawn(own)[0], np.linalg.norm(scene.bodies["sand"].velocity, axis=1), rtol=1e-12)
    assert np.array_equal(drawn(ar.plot(scene, lambda body: np.arange(len(body))))[0], np.arange(600))
    stress = np.asarray(scene.bodies["sand"].stress)  # sqrt(3 J2) of the plane's four
    mises = np.sqrt(((stress[:, 0] - stress[:, 1])**2 + (stress[:, 1] - stress[:, 2])**2 + (stress[:, 2] - stress[:, 0])**2) / 2 + 3 * stress[:, 3]**2)
    assert np.allclose(drawn(ar.plot(scene, "shear_stress"))[0], mises, rtol=1e-9, atol=1e-9)
    for wrong, sentence in ((dict(quantity="temperature"), "plot.quantity = temperature: body 'sand' has none; it has mass, pressure"),
                            (dict(plane="xz"), "plot.plane = 'xz': must be two of x, y"), (dict(body="clay"), "body = clay: must be one of sand"),
                            (dict(quantity=lambda body: 1.0), r"plot.quantity: of body 'sand': returned an array \[\]")):
        with pytest.raises(ar.Error, match=sentence):
            ar.plot(scene, **wrong)
    pyplot.close("all")


def test_plot_in_axisymmetry_and_in_space(ar, sand):
    """The section is as large as the matter's; in space the nearest points are drawn last."""
    pyplot = pytest.importorskip("matplotlib.pyplot")
    numerics = ar.Numerics(ar.QuadraticBSpline, ar.Apic)
    disc = ar.Scene(ar.Axisymmetric(), ar.CartesianGrid((0, 0), (0.2, 0.2), cell=0.02), numerics,
                    bodies=[ar.fill("sand", ar.Box((0.04, 0), (0.1, 0.1)), sand)], walls=[ar.bottom()], gravity=(0, -9.81))
    axes = ar.plot(disc, "volume")
    assert (drawn(axes)[1]**2).sum() == pytest.approx(0.06 * 0.1, rel=1e-9) and axes.get_xlabel() == "r [m]"
    block = ar.Scene(ar.ThreeDimensional(), ar.CartesianGrid((0, 0, 0), (0.2, 0.2, 0.2), cell=0.05), numerics,
                     bodies=[ar.fill("sand", ar.Box((0, 0, 0), (0.1, 0.1, 0.1)), sand, per_cell=8)], walls=[ar.bottom()], gravity=(0, -9.81, 0))
    for plane, across, sign in (("xy", 2, 1), ("xz", 1, -1), ("zy", 0, -1), ("yz", 0, 1)):
        values, widths = drawn(ar.plot(block, lambda body: np.asarray(body.position)[:, across], plane=plane))
        assert np.all(np.diff(sign * values) >= 0) and np.allclose(widths, 0.025, rtol=1e-9), plane
    pyplot.close("all")


def test_animate(ar, column, tmp_path):
    image = pytest.importorskip("PIL.Image")
    animation = pytest.importorskip("matplotlib.animation")
    scene = column()
    path = ar.animate(scene, tmp_path / "film.gif", "speed", end=0.1, every=0.025, courant=0.8)
    assert path == tmp_path / "film.gif" and scene.time == 0.1 and image.open(path).n_frames == 5
    (tmp_path / "precious").write_text("precious")
    (tmp_path / "link.gif").symlink_to("precious")
    with pytest.raises(ZeroDivisionError):  # as far as it came, in the link's place
        ar.animate(column(), tmp_path / "link.gif", end=0.1, every=0.025, after_step=lambda s: None if s.time < 0.06 else 1 / 0)
    assert image.open(tmp_path / "link.gif").n_frames == 3 and (tmp_path / "precious").read_text() == "precious"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["film.gif", "link.gif", "precious"]
    with pytest.raises(ar.Error, match="must end with .gif or .mp4"):
        ar.animate(column(), tmp_path / "film.avi", end=0.1, every=0.1)
    if animation.writers.is_available("ffmpeg"):
        assert ar.animate(column(), tmp_path / "film.mp4", end=0.02, every=0.01).stat().st_size > 1000
    else:
        with pytest.raises(ar.Error, match="needs the program ffmpeg: apt install ffmpeg; or name a .gif"):
            ar.animate(column(), tmp_path / "film.mp4", end=0.02, every=0.01)


def test_without_matplotlib_the_cure_is_named(ar, column, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ar.Error, match=r"^plot\(\) needs matplotlib: pip install matplotlib$"):
        ar.plot(column())
    with pytest.raises(ar.Error, match=r"^animate\(\) needs matplotlib"):
        ar.animate(column(), "film.gif", end=0.1, every=0.1)
