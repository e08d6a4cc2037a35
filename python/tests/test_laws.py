"""Laws without a scene: closed forms."""

import math

import numpy as np
import pytest


def test_triaxial_strength(ar):
    phi, pressure = np.radians(35), 100e3
    sand = ar.MohrCoulomb(density=1540, young=20e6, poisson=0.3, friction=phi)
    path = ar.drive(sand, ar.triaxial(pressure=pressure, axial=-0.05, steps=200))
    strength = pressure * np.tan(np.pi / 4 + phi / 2)**2
    assert -path.stress[-1, 1] == pytest.approx(strength, rel=1e-9)
    assert np.allclose(-path.stress[:, 0], pressure, rtol=1e-9)
    assert path.q[-1] == pytest.approx(strength - pressure, rel=1e-9)
    assert path.strain.shape == (201, 6) and np.all(np.diff(path.work) > -1e-12)


def test_oedometer(ar):
    path = ar.drive(ar.LinearElastic(density=1000, young=1e6, poisson=0.25), ar.oedometer(axial=-0.01))
    modulus = 1e6 * 0.75 / (1.25 * 0.5)
    assert path.stress[-1, 1] == pytest.approx(-0.01 * modulus, rel=1e-12)


@pytest.mark.parametrize("columns", [4, 6])
def test_update_of_arrays(ar, columns):
    law = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=0.6)
    random = np.random.default_rng(3)
    n = 1001
    stress = np.zeros((n, columns))
    stress[:, :3] = -1e4
    strain = 1e-2 * random.standard_normal((n, columns))
    all_at_once = law.update(stress, strain)
    each = [law.update(stress[k:k + 1], strain[k:k + 1]).stress[0] for k in range(n)]
    assert np.allclose(all_at_once.stress, each, rtol=1e-9, atol=1e-6)
    s = all_at_once.stress
    full = np.zeros((n, 3, 3))
    for k, (i, j) in enumerate([(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)][:columns]):
        full[:, i, j] = full[:, j, i] = s[:, k]
    principal = np.linalg.eigvalsh(full)
    outside = (principal[:, 2] - principal[:, 0]) + (principal[:, 2] + principal[:, 0]) * math.sin(0.6)
    assert outside.max() < 1e-6 * np.abs(principal).max()
    assert np.all(stress[:, 0] == -1e4)  # what was given stays
    assert law.elastic_energy(s).shape == (n,)


def test_history(ar):
    law = ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=0.6, memory=ar.RemembersOpening())
    assert law.history_names == ("opening",)
    after = law.update(np.zeros((1, 6)), np.array([[1e-3, 1e-3, 1e-3, 0, 0, 0]]))
    assert after.history[0, 0] == pytest.approx(3e-3, rel=1e-9) and after.opening[0] == pytest.approx(3e-3, rel=1e-9)
    with pytest.raises(ar.Error, match=r"strain: shape: must be \[1, 6\]"):
        law.update(np.zeros((1, 6)), np.zeros((1, 4)))


def test_unknown_parameters_and_bad_values(ar):
    with pytest.raises(TypeError):
        ar.MohrCoulomb(desnity=1)
    with pytest.raises(ar.Error, match="LinearElastic.poisson = 0.5"):
        ar.drive(ar.LinearElastic(density=1, young=1, poisson=0.5), ar.oedometer(-0.01))
    with pytest.raises(ar.RunError, match="no strain gives the prescribed stress"):
        ar.drive(ar.MohrCoulomb(density=1, young=1e6, poisson=0.3, friction=0.6),
                 ar.Stage(stresses=(-1e6, -1e3, -1e3, 0.0, 0.0, 0.0)), stress=(-1e3, -1e3, -1e3, 0, 0, 0))
    for test in [], [1], 3, ar.Test([]):
        with pytest.raises(ar.Error, match="drive.test = .*: must be a Test, or one or more Stages"):
            ar.drive(ar.LinearElastic(density=1, young=1, poisson=0.2), test)
