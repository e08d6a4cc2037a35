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
