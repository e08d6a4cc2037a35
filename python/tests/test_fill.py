"""Filling: geostatic stress takes what it needs from the scene, and mass is that of the region, or told."""

import numpy as np
import pytest


@pytest.fixture
def layers(ar):
    def make(gravity=(0, -1.62), top=0.2, **options):
        """Two layers, the upper one of half the density, up to 0.2 m."""
        def law(density):
            return ar.LinearElastic(density=density, young=1e7, poisson=0.3)

        return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.1, 0.25), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                        bodies=[ar.fill("low", ar.Box((0, 0), (0.1, 0.1)), law(2000), stress=ar.Geostatic(surface=0.2, k0=0.5)),
                                ar.fill("high", ar.Box((0, 0.1), (0.1, top)), law(1000), stress=ar.Geostatic(surface=0.2, k0=0.5), **options)],
                        walls=[ar.left("roller"), ar.right("roller"), ar.bottom("roller")], gravity=gravity)
    return make


def test_geostatic_takes_gravity_and_layers_from_the_scene(ar, layers, recwarn):
    scene = layers()
    for body, density, above in ((scene.bodies["low"], 2000, 1000 * 0.1), (scene.bodies["high"], 1000, 0)):
        x, stress = np.asarray(body.position), np.asarray(body.stress)
        top = 0.1 if above else 0.2
        assert np.allclose(stress[:, 1], -1.62 * (above + density * (top - x[:, 1])), rtol=1e-12)
        assert np.allclose(stress[:, 0], stress[:, 1] / 2)
    ar.run(scene, end=1e-4)
    assert not recwarn.list
    with pytest.raises(TypeError, match="gravity"):
        ar.Geostatic(surface=0.2, k0=0.5, gravity=9.81)
    with pytest.raises(ar.Error, match="Geostatic.surcharge = -1"):
        ar.Geostatic(surface=0.2, k0=0.5, surcharge=-1)
    with pytest.raises(ar.Error, match="Geostatic: gravity at t = 0 s = .*must act when the ground is filled"):
        layers(gravity=(0, 0))
    with pytest.raises(ar.Error, match="must act along an axis"):
        layers(gravity=(5, -8))


def test_mass_is_that_of_the_region_or_told(ar, layers):
    with pytest.warns(UserWarning, match=r"body high: its points have 10\.5 kg, its region 10\.26.*exact_volume"):
        layers(top=0.2026)
    scene = layers(top=0.2026, exact_volume=True)
    mass = np.asarray(scene.bodies["high"].mass)
    assert mass.sum() == pytest.approx(10.26, rel=1e-9)
    with pytest.warns(UserWarning, match="the ground is not at rest: in the first step .* % of its weight"):
        ar.run(scene, end=1e-4)
    with pytest.warns(UserWarning, match="body high: its points have"):
        ar.fill_points(scene, "high", ar.Box((0, 0.22), (0.1, 0.2226)))
    added = ar.fill_points(scene, "high", ar.Box((0, 0.23), (0.1, 0.2326)), exact_volume=True)
    assert added.mass == pytest.approx(0.26, rel=1e-9)


def test_bodies_of_one_law_are_one_composition_in_any_number(ar, layers):
    """Two layers of one density are one body of twice the height, to round-off; three bodies need no other composition than two, keep
    their names, and messages, loads and probes find each."""
    def scene(*tops, densities=(2000.0,) * 9):
        fills = [ar.fill(f"layer {k}", ar.Box((0, low), (0.1, high)), ar.LinearElastic(density=density, young=1e7, poisson=0.3))
                 for k, (low, high, density) in enumerate(zip((0, *tops), tops, densities))]
        return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.1, 0.25), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                        bodies=fills, walls=[ar.left("roller"), ar.right("roller"), ar.bottom("roller")], gravity=(0, -1.62))

    two, three = scene(0.1, 0.2), scene(0.05, 0.1, 0.2)
    assert two.composition == three.composition == layers().composition
    for made in (two, three):
        for _ in range(20):
            made.step(1e-5)
    assert list(three.bodies) == ["layer 0", "layer 1", "layer 2"]
    of_two, of_three = ({tuple(np.round(x, 6)): s for b in made.bodies.values() for x, s in zip(np.asarray(b.position), np.asarray(b.stress))}
                        for made in (two, three))
    assert of_two.keys() == of_three.keys() and len(of_two) == 800
    assert all(np.allclose(of_two[x], of_three[x], rtol=1e-6, atol=1e-6) for x in of_two)
    mixed = scene(0.05, 0.1, 0.2, densities=(2000, 1500, 1000))
    assert [b.mass.sum() for b in mixed.bodies.values()] == pytest.approx([10, 7.5, 10])
    assert not np.isnan(ar.probe(mixed, "layer 2", [(0.05, 0.15)]).stress).any() and np.isnan(ar.probe(mixed, "layer 2", [(0.05, 0.02)]).stress).all()
    assert ar.remove_points(mixed, "layer 1", ar.Box((0, 0.05), (0.05, 0.1))).mass == pytest.approx(3.75)
    assert len(mixed.bodies["layer 1"]) == 100 and len(mixed.bodies["layer 0"]) == len(mixed.bodies["layer 2"]) / 2 == 200
    with pytest.raises(ar.Error, match="layer 7"):
        ar.remove_points(mixed, "layer 7", ar.Box((0, 0), (1, 1)))


def test_constants_by_place(ar, layers):
    """A body with Young's modulus by place is two bodies of these moduli, and its factors are those of the law's parameters."""
    def rubber(young):
        return ar.LinearElastic(density=1000, young=young, poisson=0.3)

    def scene(*fills):
        return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.1, 0.25), cell=0.01), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                        bodies=list(fills), walls=[ar.left("roller"), ar.right("roller"), ar.bottom("roller")], gravity=(0, -9.81))

    one = scene(ar.fill("ground", ar.Box((0, 0), (0.1, 0.2)), ar.ByPoint(rubber(1e6)),
                        history={"stiffness": lambda x: np.where(x[:, 1] < 0.1, 4.0, 1.0)}))
    two = scene(ar.fill("low", ar.Box((0, 0), (0.1, 0.1)), rubber(4e6)), ar.fill("high", ar.Box((0, 0.1), (0.1, 0.2)), rubber(1e6)))
    assert one.stable_step == pytest.approx(two.stable_step, rel=1e-12)
    for made in (one, two):
        for _ in range(200):
            made.step(5e-5)
    by_place = [{tuple(p): s for b in made.bodies.values() for p, s in zip(np.round(np.asarray(b.position), 8), np.asarray(b.stress))}
                for made in (one, two)]
    assert by_place[0].keys() == by_place[1].keys()
    assert np.abs(list(by_place[1].values())).max() > 500
    assert all(np.allclose(by_place[0][x], by_place[1][x], rtol=1e-8, atol=1e-6) for x in by_place[0])
    with pytest.raises(ar.Error, match="history, stiffness = -1: must not be negative"):
        ar.fill_points(one, "ground", ar.Box((0, 0.2), (0.1, 0.25)), history={"stiffness": -1})

    clay = dict(density=1800, young=1e6, poisson=0.3, friction=np.arctan(0.5), cohesion=1000.0)
    law = ar.ByPoint(ar.MohrCoulomb(**clay))
    assert law.history_names == ("friction", "stiffness", "strength")
    stronger = ar.MohrCoulomb(**{**clay, "young": 2e6, "cohesion": 3000.0, "friction": np.arctan(0.6)})
    stress, strain = np.full((1, 6), [-5e3, -9e3, -6e3, 0, 0, 0]), np.array([[0, -4e-3, 0, 9e-3, 0, 0]])
    assert np.allclose(law.update(stress, strain, history=[[1.2, 2.0, 3.0]]).stress, stronger.update(stress, strain).stress, rtol=1e-10)
    assert not np.allclose(law.update(stress, strain).stress, stronger.update(stress, strain).stress, rtol=1e-2)
    with pytest.raises(ar.Error, match="ByPoint.law = .*constant friction"):
        ar.ByPoint(ar.MohrCoulomb(**clay, friction_law=ar.LinearRateFriction()))
