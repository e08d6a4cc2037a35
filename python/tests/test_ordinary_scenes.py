"""Thirty ordinary scenes, of which most need no compiler: their composition is prebuilt, or a prebuilt one stands for it with the same bits."""

import re
from pathlib import Path

import numpy as np
import pytest

PREBUILT = Path(__file__).parents[1] / "arenite" / "prebuilt.txt"
LEAST = 25  #: of the scenes that must need no compiler


def triangles(ar, d):
    """A unit square of two triangles, or a tetrahedron."""
    if d == 3:
        return ar.SimplexMesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2, 3)])
    return ar.SimplexMesh([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)])


def scene(ar, *laws, kinematics=None, simplices=False, d=2, numerics=None, **more):
    """A box of each law above the other."""
    mesh = triangles(ar, d) if simplices else ar.CartesianGrid((0,) * d, (0.4, 0.4, 0.4)[:d], cell=0.02)
    numerics = numerics or (ar.Numerics(ar.LinearSimplex, anti_locking=ar.NodalAndElementAverage) if simplices
                            else ar.Numerics(ar.QuadraticBSpline, ar.Apic))
    boxes = [ar.Box((0, 0.1 * k, 0)[:d], (0.2, 0.1 * (k + 1), 0.2)[:d]) for k in range(len(laws))]
    given = dict(bodies=[ar.fill(f"body {k}", box, law) for k, (box, law) in enumerate(zip(boxes, laws))],
                 walls=[ar.bottom(), ar.left("roller")], gravity=(0, -9.81, 0)[:d])
    given.update(more)
    return ar.Scene(kinematics or (ar.ThreeDimensional() if d == 3 else ar.PlaneStrain()), mesh, numerics, **given)


def ordinary(ar):
    """Scenes by name; each is a function that makes it."""
    elastic = dict(density=1540, young=1e6, poisson=0.3)
    strength = dict(elastic, friction=np.radians(35))
    sand, grains, block = ar.MohrCoulomb(**strength), ar.DruckerPrager(**strength), ar.LinearElastic(**elastic)
    softening = ar.SofteningFriction(residual_friction=0.5, decay=8)
    flip, axisymmetric = ar.Numerics(ar.QuadraticBSpline), ar.Axisymmetric()
    plain = ar.Numerics(ar.LinearSimplex)

    def with_friction(friction):
        return ar.MohrCoulomb(**strength, friction_law=friction)

    def rigid(motion, d=2, surface=None):
        return [ar.Rigid(surface or ar.Ball((0.1, 0.3, 0.1)[:d], 0.05), motion, 0.3, name="device")]

    held, free = ar.Prescribed((0, -1)), ar.Free(mass=1, inertia=1, centre=(0.1, 0.3))
    dropped, free_in_space = ar.Guided(mass=1, velocity=-1), ar.Free(mass=1, inertia=1, centre=(0.1, 0.3, 0.1))
    on_mesh = ar.MovingMesh(fixed_below=0.0, moving_from=0.4, moving_to=0.6, fixed_above=1.0, leader="device")
    return {
        "column": lambda: scene(ar, sand),
        "column, linear rate": lambda: scene(ar, with_friction(ar.LinearRateFriction())),
        "column, mu(I)": lambda: scene(ar, with_friction(ar.InertialFriction())),
        "column, logarithmic": lambda: scene(ar, with_friction(ar.LogarithmicFriction())),
        "column, softening": lambda: scene(ar, with_friction(softening)),
        "column, softening and rate": lambda: scene(ar, with_friction(ar.RateSofteningFriction(softening))),
        "column, FLIP": lambda: scene(ar, sand, numerics=flip),
        "column, Drucker-Prager": lambda: scene(ar, grains),
        "column, gravity in time": lambda: scene(ar, sand, gravity=lambda t: (0, -9.81 * min(t, 1))),
        "column, reactions of walls": lambda: scene(ar, sand, reactions=True),
        "column that settles": lambda: scene(ar, sand, parts=[ar.LocalDamping()]),
        "column, deviatoric strain": lambda: scene(ar, ar.WithDeviatoricStrain(sand, 2)),
        "block": lambda: scene(ar, block),
        "block that settles, reactions": lambda: scene(ar, block, parts=[ar.LocalDamping()], reactions=True),
        "blocks that collide": lambda: scene(ar, block, block, numerics=flip, contact=ar.Coulomb(0.3), walls=[], gravity=None),
        "footing on sand, contact": lambda: scene(ar, sand, block, contact=ar.Coulomb(0.3)),
        "footing on sand, no slip": lambda: scene(ar, sand, block),
        "layers of sand": lambda: scene(ar, sand, with_friction(softening)),
        "plate pushed into sand": lambda: scene(ar, sand, rigids=rigid(held)),
        "ball on sand": lambda: scene(ar, sand, rigids=rigid(free)),
        "ball on softening sand": lambda: scene(ar, with_friction(softening), rigids=rigid(free)),
        "axisymmetric column": lambda: scene(ar, sand, kinematics=axisymmetric),
        "axisymmetric column, mu(I)": lambda: scene(ar, with_friction(ar.InertialFriction()), kinematics=axisymmetric),
        "axisymmetric, guided cone": lambda: scene(ar, sand, kinematics=axisymmetric, rigids=rigid(dropped)),
        "column in space": lambda: scene(ar, sand, d=3),
        "column in space, logarithmic": lambda: scene(ar, with_friction(ar.LogarithmicFriction()), d=3),
        "ball on sand in space": lambda: scene(ar, sand, d=3, rigids=rigid(free_in_space, 3)),
        "block of triangles": lambda: scene(ar, block, simplices=True, numerics=plain),
        "slope of triangles": lambda: scene(ar, sand, simplices=True),
        "penetrometer, moving mesh": lambda: scene(ar, sand, kinematics=axisymmetric, simplices=True, moving_mesh=on_mesh,
                                                   rigids=rigid(dropped, surface=ar.MeshSurface("device"))),
    }


def prebuilt():
    return [line.split(" ", 1)[1] for line in PREBUILT.read_text().splitlines() if line.startswith("scene ")]


@pytest.fixture
def asked(ar, monkeypatch):
    """What a scene asks for: its type and the values of its parts."""
    monkeypatch.setattr(ar.Scene, "_take", lambda *_: None)
    monkeypatch.setattr(ar.Scene, "_make", lambda *_: None)

    def of(made):
        type_name, values, _, _ = made._composition()
        return type_name, values["parts"], made._recipes["mesh"].dimension

    return of


def test_most_ordinary_scenes_need_no_compiler(ar, asked):
    from arenite import _stand_ins

    known, scenes = prebuilt(), ordinary(ar)
    assert len(scenes) == 30
    need = []
    for name, make in scenes.items():
        type_name, parts, dimension = asked(make())
        found = _stand_ins.find(type_name, parts, dimension, known)
        print(f"{name}: {'prebuilt' if type_name in known else found.type if found else 'COMPILED'}")
        if type_name not in known and found is None:
            need.append(name)
    print(f"{len(scenes) - len(need)} of {len(scenes)} need no compiler; compiled are: {', '.join(need)}")
    assert len(scenes) - len(need) >= LEAST, need


def test_each_prebuilt_composition_serves_an_ordinary_scene(ar, asked):
    """Or a page of the documentation (test_compile.py)."""
    from arenite import _stand_ins

    known, used = prebuilt(), set()
    for make in ordinary(ar).values():
        type_name, parts, dimension = asked(make())
        found = _stand_ins.find(type_name, parts, dimension, known)
        used.add(type_name if type_name in known else found.type if found else "")
    assert not set(known) - used, set(known) - used
