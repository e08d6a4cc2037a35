"""Thirty ordinary scenes, of which most need no compiler: their composition is prebuilt, or a prebuilt one stands for it with the same bits."""

import re
from pathlib import Path

import numpy as np
import pytest

PREBUILT = Path(__file__).parents[1] / "arenite" / "prebuilt.txt"
LEAST = 25  #: of the scenes that must need no compiler


def triangles(ar, d):
    """A rectangle, 0.4 by 1 m, of triangles with a device in it, or a tetrahedron."""
    if d == 3:
        return ar.SimplexMesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2, 3)])
    x, y = np.linspace(0, 0.4, 5), np.linspace(0, 1, 11)
    nodes = [(a, b) for b in y for a in x]
    corners = [(5 * k + i, 5 * k + i + 1, 5 * k + i + 6, 5 * k + i + 5) for k in range(10) for i in range(4)]
    cells = [cell for a, b, c, e in corners for cell in ((a, b, c), (a, c, e))]
    device = [all(nodes[n][0] < 0.11 and 0.39 < nodes[n][1] < 0.61 for n in cell) for cell in cells]
    return ar.SimplexMesh(nodes, cells, region=[int(d) for d in device], region_names={"soil": 0, "device": 1})


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
    on_mesh = ar.MovingMesh(fixed_below=0.0, moving_from=0.4, moving_to=0.6, fixed_above=1.0)
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


def ordinary_names():
    """As pytest names the tests, before the package is there."""
    return re.findall(r'^        "(.*)": lambda', Path(__file__).read_text(), re.MULTILINE)


COMPILED = ("column, deviatoric strain", "layers of sand")


def kept(law):
    """Names of a law's history."""
    of = type(getattr(law, "friction_law", None)).__name__
    return {*(["shear_rate"] if re.search("Rate|Inertial|Logarithmic", of) else []), *(["plastic_strain"] if "Softening" in of else [])}


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


@pytest.fixture
def stands_in(ar):
    """Makes a scene where there is no compiler, and nothing that was compiled."""
    from arenite import _compile, _plugins

    _plugins._ensure_prebuilt()
    if set(prebuilt()) - set(_plugins._scenes):
        pytest.skip("the prebuilt compositions are not those of prebuilt.txt")

    def make(made):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(_plugins, "_scenes", {name: _plugins._scenes[name] for name in prebuilt()})
            patch.setattr(_compile, "built", lambda *_, **__: (_ for _ in ()).throw(ar.Error("compiler: not found")))
            return made()

    return make


@pytest.mark.parametrize("name", [*ordinary_names(), "wall askew"])
def test_scenes_run_without_a_compiler(ar, stands_in, name):
    """What they run in has no more to show than their own composition."""
    oblique = ar.where(lambda x: x[:, 0] + x[:, 1] < 0.01, ar.symmetry((1, 1)))
    make = ordinary(ar)["column, softening" if name == "wall askew" else name]
    if name in COMPILED:
        with pytest.raises(ar.Error, match="compiler"):
            stands_in(make)
        return
    if name == "wall askew":
        sand = make()._recipes["bodies"][0].law
        with pytest.raises(ar.Error, match="compiler"):  # damping that is off would move its round-off
            stands_in(lambda: scene(ar, sand, walls=[oblique]))
        return
    made = stands_in(make)
    ar.run(made, end=2e-4)
    for number, body in enumerate(made.bodies.values()):
        law = made._recipes["bodies"][number].law
        assert set(body.history) == kept(law), law
    own = made._composition()[3]
    for part, call in (("Reactions", lambda: made.reaction("bottom")), ("LocalDamping", lambda: made.out_of_balance),
                       ("LocalDamping", lambda: ar.settle(made, end=1.0))):
        if part not in own:
            with pytest.raises(ar.Error, match="name Reactions|name a part that damps"):
                call()
    assert ("Reactions" in own) == any(path.startswith("reactions/") for path in made.state)
    assert ("LocalDamping" in own) == any(path.endswith("/on") for path in made.state)


def test_what_stands_for_a_scene_has_its_bits_and_its_saved_states(ar, stands_in, compiler, tmp_path):
    make = ordinary(ar)["column, softening"]
    other = stands_in(make)
    own = ar.compile(other)
    assert own.compiled_as == own.composition == other.composition != other.compiled_as
    assert stands_in(make).compiled_as == other.compiled_as
    for made in (other, own):
        ar.run(made, end=0.02)
    assert other.step_count == own.step_count > 20
    assert list(other.state) == list(own.state)
    assert all(np.array_equal(value, own.state[path]) for path, value in other.state.items())
    other.save(tmp_path / "other")
    own.save(tmp_path / "own")
    again = make()  # in its own composition, which is in the cache now
    assert again.compiled_as == own.compiled_as
    again.restore(tmp_path / "other")
    assert again.compiled_as == other.compiled_as
    with pytest.raises(ar.Error, match=r"has no parts/2/dissipated.*\n.*ar.compile\(scene\)"):
        stands_in(make).restore(tmp_path / "own")
    ar.run(again, end=0.03)
    ar.run(own, end=0.03)
    assert all(np.array_equal(value, own.state[path]) for path, value in again.state.items())
    with pytest.raises(ar.Error, match="history = shear_rate: is no number of the law's history"):
        ar.insert_points(other, "body 0", [(0.3, 0.3)], 1e-4, history={"shear_rate": [1.0]})
    ar.fill_points(other, "body 0", ar.Box((0.3, 0.3), (0.32, 0.32)), history={"plastic_strain": 0.5})
    assert other.bodies["body 0"].history["plastic_strain"].max() >= 0.5
