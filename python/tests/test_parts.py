"""Parts of scenes that their own closed forms test in C++: that Python's words reach them."""

import warnings

import numpy as np
import pytest


@pytest.fixture
def block(ar):
    """An elastic block, 0.1 by 0.1 m, in the middle of a grid, with an acceleration, a force and damping."""

    def make(young=1e5, velocity=(0, 0), acceleration=0.0, force=0.0, damping=0.0):
        law = ar.WithDeviatoricStrain(ar.LinearElastic(density=1000, young=young, poisson=0.3), dimension=2)
        return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.4), cell=0.05), ar.Numerics(ar.UGimp(points=2)),
                        bodies=[ar.fill("block", ar.Box((0.15, 0.15), (0.25, 0.25)), law, velocity=velocity)],
                        parts=[ar.BodyForce((acceleration, 0.0)), ar.PointLoad((0.2, 0.2), (0.0, force)),
                               ar.ViscousDamping(damping)])

    return make


def test_body_force_point_load_and_viscous_damping(ar, block):
    """Newton: m dv/dt = m a + F - m c v from rest, v(t) = (a + F / m) (1 - exp(-c t)) / c."""
    scene = block(acceleration=1.0, force=20.0, damping=3.0)
    ar.run(scene, end=0.3)
    body = scene.bodies["block"]
    v = (np.asarray(body.velocity) * np.asarray(body.mass)[:, None]).sum(axis=0) / body.mass.sum()
    growth = (1 - np.exp(-3 * 0.3)) / 3
    assert v[0] == pytest.approx(growth, rel=2e-3) and v[1] == pytest.approx(2 * growth, rel=2e-3)


def test_ugimp_moves_a_body_as_it_is(ar, block):
    scene = block(velocity=(1.0, -0.5))
    x = scene.bodies["block"].position.mean(axis=0)
    ar.run(scene, end=0.05)
    assert np.allclose(scene.bodies["block"].position.mean(axis=0) - x, (0.05, -0.025), rtol=1e-9)
    assert scene.energy.strain < 1e-12


def test_deviatoric_strain(ar, block, column):
    """Of Hooke's law e = s / (2 G) in each point, for as long as it turns little."""
    scene = block(young=1.0, velocity=lambda x: np.column_stack([0.1 * (x[:, 1] - 0.2), 0 * x[:, 0]]))
    ar.run(scene, end=0.05, max_step=1e-3)
    stress = np.asarray(scene.bodies["block"].stress)
    s = stress - np.array([1, 1, 1, 0]) * stress[:, :3].mean(axis=1, keepdims=True)
    size = np.sqrt((s[:, :3]**2).sum(axis=1) + 2 * s[:, 3]**2)
    assert size.max() > 1e-3  # Pa, of G = 0.38 Pa
    assert np.allclose(ar.deviatoric_strain(scene, "block"), np.sqrt(2 / 3) * size / (2 * 1.0 / 2.6), rtol=1e-3)
    from arenite.vtu import point_fields

    fields, columns = point_fields(scene, "block"), scene.bodies["block"].history
    assert {name for name in fields if "deviatoric" in name} == {"deviatoric_strain", *(f"deviatoric_strain_{c}" for c in ("xx", "yy", "xy"))}
    assert not [name for name in fields if name.isdigit()]
    assert np.array_equal(fields["deviatoric_strain"], ar.deviatoric_strain(scene))
    assert np.allclose(fields["deviatoric_strain_xy"], s[:, 3] / (2 * 1.0 / 2.6), rtol=1e-3, atol=1e-9) and len(columns) == 3
    with pytest.raises(ar.Error, match="must be a WithDeviatoricStrain"):
        ar.deviatoric_strain(column())


def test_traction_and_pressure(ar, block_between_rollers):
    """A block under a pressure on its free face, at rest: the stress is that pressure."""
    scenes = [block_between_rollers(load) for load in (ar.Pressure(ar.top(), 1e3), ar.Traction(ar.top(), (0, -1e3)))]
    for scene in scenes:
        ar.settle(scene, end=2)
        below = scene.bodies["block"].position[:, 1] < 0.25  # two cells from the face
        assert np.allclose(scene.bodies["block"].stress[below][:, 1], -1e3, rtol=0.01)
    assert np.array_equal(scenes[0].bodies["block"].stress, scenes[1].bodies["block"].stress)


def test_a_load_that_finds_no_matter(ar, block_between_rollers):
    """It is told of once, by a Python warning with its share and the cure."""
    scene = block_between_rollers(ar.Pressure(ar.top(), 1e3), mesh_height=0.325)
    with pytest.warns(ar.Warning, match=r"pressure on top: 0 % of it acts on matter; .* pressure\(surface") as caught:
        for _ in range(3):
            scene.step(1e-5)
    assert len(caught) == 1


def test_pressure_on_the_surface_of_a_body(ar, block_between_rollers):
    """An oedometer in a mesh that is higher than the body: below the layer that is loaded the stress is the pressure."""
    layer = ar.Box((0, 0.3 - 0.025 / 2), (0.1, 0.3))  # a row of points
    for name in ("block", 0):
        top = ar.surface(name, layer, normal=(0, 1), thickness=0.025 / 2)
        scene = block_between_rollers(ar.Pressure(top, ar.Ramp(1e3, over=0.05)), mesh_height=0.4)
        ar.settle(scene, end=2)
        below = scene.bodies["block"].position[:, 1] < 0.2  # four cells
        assert np.allclose(np.asarray(scene.bodies["block"].stress)[below, 1], -1e3, rtol=0.01)
        if name == "block":
            first = scene
    assert np.array_equal(scene.bodies["block"].stress, first.bodies["block"].stress)
    with pytest.raises(ar.Error, match="Surface.body = sand: the scene has no such body; it has block"):
        block_between_rollers(ar.Pressure(ar.surface("sand", layer, normal=(0, 1), thickness=0.01), 1e3))
    with pytest.raises(ar.Error, match="SurfaceOptions.thickness = 0: must be given, and positive"):
        ar.surface("block", layer, normal=(0, 1), thickness=0)


def test_driven_wall_and_absorbing_faces(ar):
    """A wall pushes a bar with v; at its other end dashpots of its impedance (Lysmer and Kuhlemeyer 1969) let the wave
    out, so that the stress stays rho c v, as in an endless bar."""
    density, young, v = 1000.0, 1e6, 0.01
    scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1, 0.1), cell=0.05), ar.Numerics(ar.QuadraticBSpline),
                     bodies=[ar.fill("bar", ar.Box((0, 0), (1, 0.1)), ar.LinearElastic(density=density, young=young, poisson=0.0))],
                     walls=[ar.bottom("roller"), ar.top("roller")],
                     parts=[ar.Driven(ar.left("roller"), (v, 0)), ar.Absorbing(ar.right())])
    ar.run(scene, end=0.2)  # a wave takes 0.032 s from end to end
    middle = (scene.bodies["bar"].position[:, 0] > 0.3) & (scene.bodies["bar"].position[:, 0] < 0.7)
    assert np.asarray(scene.bodies["bar"].stress)[middle, 0].mean() == pytest.approx(-v * np.sqrt(density * young), rel=0.03)
    assert scene.bodies["bar"].velocity[:, 0].mean() == pytest.approx(v, rel=0.03)


def test_friction_poses_and_bodies_that_touch(ar):
    """A block that slides on a frictional wall slows down by mu g; a rigid ball falls onto a floor, a box held by a
    prescribed pose, and stays there. Past the floor it falls through the wall, which a run tells, or lands on it."""
    law = ar.LinearElastic(density=1000, young=1e6, poisson=0.3)
    floor = ar.Rigid(ar.Box((0.7, 0.0), (1.0, 0.1)), ar.PrescribedPose(centre=(0.85, 0.05)), friction=0.3, name="floor")
    ball = ar.Rigid(ar.Ball((0.85, 0.18), 0.05), ar.Free(mass=5, inertia=5e-3, centre=(0.85, 0.18)), friction=0.3, name="ball")

    def scene_of(contact):
        return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1, 0.3), cell=0.05), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                        bodies=[ar.fill("block", ar.Box((0.1, 0), (0.3, 0.1)), law, velocity=(1, 0))], gravity=(0, -9.81),
                        rigids=[floor, ball], rigid_contact=contact, parts=[ar.FrictionalWall(ar.bottom(), np.radians(15))])

    scene = scene_of(ar.RigidContact(friction=0.3))
    ar.run(scene, end=0.2)
    assert scene.bodies["block"].velocity[:, 0].mean() == pytest.approx(1 - np.tan(np.radians(15)) * 9.81 * 0.2, abs=0.02)
    # From 3 cm above it: 0.078 s of fall, then at rest.
    assert scene.rigids["ball"].displacement[1] == pytest.approx(-0.03, abs=2e-3)
    assert abs(scene.rigids["ball"].velocity[1]) < 0.05
    apart = scene_of(ar.RigidContact(friction=0.3, pairs=[ar.RigidPair(0, 1)]))
    ar.run(apart, end=0.1)
    assert apart.rigids["ball"].displacement[1] == pytest.approx(-9.81 * 0.1**2 / 2, rel=0.01)
    with pytest.warns(UserWarning, match=r"rigid body ball has passed the wall at the bottom by 0.0125 m.*RigidContact.walls"):
        ar.run(apart, end=0.2)
    held = scene_of(ar.RigidContact(friction=0.3, pairs=[ar.RigidPair(0, 1)], walls=0.3))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ar.run(held, end=0.2)
    assert held.rigids["ball"].displacement[1] == pytest.approx(-0.13, abs=1e-9)
    with pytest.raises(ar.Error, match=r"Friction.angle = 2: must lie in \[0, pi/2\)"):
        ar.RigidContact(friction=0.3, walls=2.0)


def test_a_block_that_sticks_to_a_slope_is_not_lifted(ar):
    """With the gap of each node kept; without it the block rises by 4 mm and creeps by 22 mm."""
    slope, off = np.radians(30), 1e-6
    law = ar.LinearElastic(density=1800, young=1e6, poisson=0.3)
    base = ar.Rigid(ar.Box((-1, -1), (2, 0.21)), ar.Prescribed((0, 0)), np.radians(40), ar.NodalGap)
    scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1, 0.4), cell=0.02), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                     bodies=[ar.fill("block", ar.Box((0.2, 0.21 - off), (0.4, 0.31 - off)), law)],
                     gravity=(9.81 * np.sin(slope), -9.81 * np.cos(slope)), rigids=[base])
    before = scene.bodies["block"].position.mean(axis=0)
    ar.run(scene, end=0.5, courant=0.4)
    along, across = scene.bodies["block"].position.mean(axis=0) - before
    assert abs(along) < 3e-3 and across < 0.2e-3


def strip(ar, cells):
    """Mean pressure below a smooth rigid strip of some cells, 1 m wide, that is pushed 4 mm into weightless clay, over c."""
    half, strength, speed, end = 0.5, 20e3, 0.01, 0.45
    clay = ar.MohrCoulomb(density=2000, young=1e4 * strength, poisson=0.3, friction=0, cohesion=strength)
    motion = ar.Prescribed(ar.Scaled((0, -speed, 0), ar.Ramp(over=0.2 * end)))
    scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (3, 2.5), cell=2 * half / cells), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                     bodies=[ar.fill("clay", ar.Box((0, 0), (3, 2)), clay)], walls=[ar.left("roller"), ar.right("roller"), ar.bottom("fixed")],
                     gravity=(0, 0), rigids=[ar.Rigid(ar.Box((-half, 2), (half, 2.25)), motion, friction=0.0)])
    ar.run(scene, end=0.9 * end, courant=0.9)
    begin = scene.time, scene.rigids[0].impulse[1]
    ar.run(scene, end=end, courant=0.9)
    return (scene.rigids[0].impulse[1] - begin[1]) / (scene.time - begin[0]) / half / strength


def test_a_rigid_strip_bears_more_on_coarse_cells(ar):
    """Contact acts ahead of its surface: at failure above (2 + pi) c (Prandtl 1920), the less the more cells to its width."""
    coarse, fine = (strip(ar, cells) / (2 + np.pi) - 1 for cells in (8, 16))
    assert 0 < fine < coarse < 0.06 and fine < 0.04


def test_what_a_new_scene_says_of_rigid_bodies(ar):
    """Matter inside, which `region - shape` cures for shapes and functions, and walls thinner than a cell."""
    clay, sand = ar.MohrCoulomb(density=2000, young=1e6, poisson=0.3, friction=0.6), ar.Box((0, 0), (1, 0.6))

    def scene(region, shape):
        return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1, 1), cell=0.05), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                        bodies=[ar.fill("clay", region, clay)], walls=[ar.bottom("fixed")], gravity=(0, -9.81),
                        rigids=[ar.Rigid(shape, ar.Prescribed((0, 0)), friction=0.3, name="f")])

    def disc(x):
        return np.hypot(x[0, 0] - 0.5, x[0, 1] - 0.5) - 0.2

    for shape in (ar.Box((0.3, 0.3), (0.7, 0.9)), ar.placed(ar.Box((-0.2, -0.2), (0.2, 0.2)), at=(0.5, 0.5, 0), turned=(0, 0, 0.5)),
                  ar.Ball((0.5, 0.5), 0.2) | ar.Box((0.3, 0.5), (0.7, 0.9)), disc):
        with pytest.warns(ar.Warning, match=r"rigid body f: \d+ of the 960 points of body clay lie inside of it: .*region - shape"):
            scene(sand, shape)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            scene(sand - shape, shape)
    with pytest.warns(ar.Warning, match="rigid body f: a wall is 0.4 cells thick"):
        scene(sand, ar.Box((0.2, 0.8), (0.8, 0.82)))


def test_pyvista(ar, column):
    pytest.importorskip("pyvista")
    scene = column()
    cloud = ar.to_pyvista(scene)
    assert np.array_equal(cloud.points[:, :2], np.asarray(scene.bodies["sand"].position, dtype=cloud.points.dtype))
    assert cloud.point_data["stress"].shape == (600, 6)


def test_rate_and_softening(ar):
    """Drained triaxial: the peak angle grows by log10(rate / reference) decades, then falls to the residual one."""
    pressure, phi = 100e3, np.radians(35)

    def path(rate, **softening):
        law = ar.MohrCoulomb(density=1540, young=50e6, poisson=0.3, friction=phi,
                             friction_law=ar.RateSofteningFriction(
                                 softening=ar.SofteningFriction(residual_friction=np.radians(30), **softening),
                                 reference_rate=1e-3, dilatancy_per_decade=0.0),
                             stiffness_law=ar.RateStiffness(per_decade=0.0))
        return ar.drive(law, ar.triaxial(pressure=pressure, axial=-0.05, steps=400, duration=0.05 / rate))

    assert np.max(path(1e-5, decay=1e-9).q) == pytest.approx(pressure * (np.tan(np.pi / 4 + phi / 2)**2 - 1), rel=1e-3)
    residual = path(1e-5, decay=1e4).q[-1]
    assert residual == pytest.approx(pressure * (np.tan(np.pi / 4 + np.radians(15))**2 - 1), rel=2e-2)
    assert np.max(path(10.0, decay=1e-9).q) > 1.1 * np.max(path(1e-5, decay=1e-9).q)


def test_cone_of_drucker_prager(ar):
    """In triaxial compression the cone through the compression edges is Mohr-Coulomb; the other cones are weaker."""
    strengths = [ar.drive(ar.DruckerPrager(density=1540, young=50e6, poisson=0.3, friction=0.6, cone=cone),
                          ar.triaxial(pressure=1e5, axial=-0.05, steps=200)).q[-1] for cone in ar.Cone]
    assert strengths[0] == pytest.approx(1e5 * (np.tan(np.pi / 4 + 0.3)**2 - 1), rel=1e-6)
    assert strengths[1] < strengths[0] and strengths[2] < strengths[0]
    with pytest.raises(ar.Error, match="DruckerPrager.cone = 'edges': must be one of Cone.compression"):
        ar.DruckerPrager(cone="edges")
