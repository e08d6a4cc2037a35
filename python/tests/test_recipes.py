"""What a recipe tells of itself, and that it is checked where it is made: the table of parameters in its docstring is that of its
fields, with the bounds that the library has, and what C++ refuses, Python refuses before there is a scene."""

import ast
import dataclasses
import inspect
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

INCLUDE = Path(__file__).resolve().parents[2] / "include" / "arenite"


def recipes():
    ar = pytest.importorskip("arenite")
    from arenite._recipe import Recipe

    abstract = {"Law", "Shape", "Signal"}
    return [x for x in (getattr(ar, name) for name in ar.__all__ if name not in abstract) if isinstance(x, type) and issubclass(x, Recipe)]


def parameters(recipe):
    """Defaults by name; `inspect.Parameter.empty` where there is none."""
    if recipe.__init__ is object.__init__:
        return {}
    return {name: p.default for name, p in list(inspect.signature(recipe.__init__).parameters.items())[1:]}


def table(recipe):
    """Rows of the table in a docstring, by parameter."""
    lines = inspect.getdoc(recipe).split("\n")
    at = [k for k, line in enumerate(lines) if line.startswith("parameter  ")]
    if not at:
        return {}
    head, *rows = [re.split(r"  +", line) for line in lines[at[0]:]]
    assert head[:4] == ["parameter", "unit", "range", "default"], (recipe, head)
    assert all(len(head) >= len(row) >= 4 for row in rows), (recipe, rows)
    return {row[0]: dict(zip(head, row)) for row in rows}


def test_each_recipe_tells_its_parameters_with_unit_range_and_default(ar):
    assert len(recipes()) > 60
    for recipe in recipes():
        assert not inspect.getdoc(recipe).startswith(recipe.__name__ + "("), f"{recipe.__name__}: says nothing"
        told, has = table(recipe), parameters(recipe)
        assert list(told) == list(has), recipe.__name__
        for name, default in has.items():
            row = told[name]["default"]
            if default is inspect.Parameter.empty or isinstance(default, float) and math.isnan(default):
                assert row == "needed" or recipe is ar.Absorbing and row == "the law's", (recipe.__name__, name, row)
            elif isinstance(default, (bool, int, float, str)) and not isinstance(default, ar.Cone):
                assert ast.literal_eval(row.replace("inf", "1e999")) == default, (recipe.__name__, name, row)
            else:
                assert row, (recipe.__name__, name)


def test_recipes_are_what_the_headers_say():
    """A changed comment, default or member of an aggregate is written into _recipes.py."""
    tool = INCLUDE.parents[1] / "python" / "tools" / "recipes.py"
    if not shutil.which("doxygen") or not tool.exists():
        pytest.skip("needs Doxygen and the sources")
    run = subprocess.run([sys.executable, str(tool), "--check"], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr


def test_help_shows_the_table(ar):
    import pydoc

    said = pydoc.plain(pydoc.render_doc(ar.MohrCoulomb))
    assert re.search(r"friction +rad +\[0, 1.55\] +needed", said) and re.search(r"young +Pa +> 0 +needed", said)


def test_numbers_are_shown_as_numbers(ar):
    law = ar.MohrCoulomb(**ELASTIC, friction=np.radians(35), cohesion=np.float64(2.0))
    assert "np." not in repr(law) and "friction=0.6108652381980153" in repr(law)
    assert 35 * ar.deg == pytest.approx(np.radians(35), rel=1e-15)


def test_every_public_class_of_a_module_is_named(ar):
    from arenite import boundary, fill, functions, laws, meshes, numerics, rigid, shapes
    from arenite._recipe import Recipe

    inner = {"Part", "Policy", "Contact", "Mesh", "Periodic", "Combined", "Recipe"}
    for module in (boundary, fill, functions, laws, meshes, numerics, rigid, shapes):
        for name, x in vars(module).items():
            if isinstance(x, type) and issubclass(x, Recipe) and name[0] != "_" and name not in inner:
                assert name in ar.__all__, name


# Values that a recipe is made of, beside its defaults.
ELASTIC = {"density": 1540, "young": 1e6, "poisson": 0.3}
FRICTIONAL = {**ELASTIC, "friction": 0.6, "cohesion": 1e3}


def sound(ar):
    ball, bottom = ar.Ball((0, 0), 1), ar.bottom()
    softening = {"residual_friction": 0.5, "decay": 10}
    return {
        "LinearElastic": ELASTIC, "MohrCoulomb": FRICTIONAL, "DruckerPrager": FRICTIONAL, "SofteningFriction": softening,
        "RateSofteningFriction": {"softening": ar.SofteningFriction(**softening)}, "Ramp": {"over": 1.0}, "Coulomb": {"friction": 0.5},
        "FrictionalWall": {"where": bottom, "friction": 0.5}, "ViscousDamping": {"rate": 1.0}, "Geostatic": {"surface": 0.0, "k0": 0.5},
        "CartesianGrid": {"lower": (0, 0), "upper": (1, 1), "cell": 0.5}, "Guided": {"mass": 1.0},
        "Free": {"mass": 1.0, "inertia": 1.0, "centre": (0, 0)}, "Ball": {"centre": (0, 0), "radius": 1.0},
        "Capsule": {"a": (0, 0), "b": (1, 0), "radius": 1.0}, "Cylinder": {"a": (0, 0, 0), "b": (1, 0, 0), "radius": 1.0},
        "RoundedBox": {"lower": (0, 0), "upper": (1, 1), "radius": 0.1}, "ConeCylinder": {"radius": 0.02, "apex": 1.0, "length": 1e5},
        "MovingMesh": {"fixed_below": 0.0, "moving_from": 1.0, "moving_to": 2.0, "fixed_above": 3.0},
        "MeshSurface": {"region": "cone"}, "Rigid": {"surface": ball, "motion": ar.Guided(mass=1), "friction": 0.5},
        "Fill": {"name": "sand", "region": ball, "law": ar.LinearElastic(**ELASTIC)}, "Absorbing": {"where": bottom},
        "Surface": {"body": "sand", "region": ball, "normal": (0, 1), "thickness": 0.1}, "RigidContact": {"friction": 0.5}, "RigidPair": {"first": 0, "second": 1},
    }


PAIRED = {("SofteningFriction", "cell_size"), ("SofteningFriction", "reference_size"), ("CartesianGrid", "cell"), ("MovingMesh", "leader"),
          ("ConeCylinder", "length")}  # bounds that hang on others; they have no value just within


def bounds(row, given):
    """(bound, whether it is within) at the lower and the upper end of a range; None where there is none."""

    def number(word):
        return float(eval(word, {"pi": math.pi}, given))

    if found := re.fullmatch(r"(>=?) (\S+)", row):
        return (number(found[2]), found[1] == ">="), None
    if found := re.fullmatch(r"([\[(])([^,]+), ([^,]+)([\])])", row):
        try:
            return (number(found[2]), found[1] == "["), (number(found[3]), found[4] == "]")
        except NameError:  # a shape of an array
            return None, None
    return None, None


def refusal(ar, recipe, values):
    """What is said against a recipe of these values; nothing if it is made."""
    try:
        recipe(**values)
    except ar.Error as e:
        return str(e)
    return ""


def test_ranges_are_those_of_the_library(ar):
    """Each value just outside of a range is refused where the recipe is made, by its name; each just within is not."""
    tried, faults = 0, []
    for recipe in recipes():
        name = recipe.__name__
        base = sound(ar).get(name, {})
        given = {**parameters(recipe), **base}
        for parameter, row in table(recipe).items():
            now = given[parameter]

            def values(number):
                return {**base, parameter: (number,) * len(now) if isinstance(now, tuple) else number}

            for end, outwards in zip(bounds(row["range"], given), (-1, 1)):
                if end is None or (name, parameter) in PAIRED:
                    continue
                at, within = end
                whole = row.get("meaning") == "a whole number"
                a_little = outwards * (1 if whole else max(abs(at), 1e-3) * 1e-3)
                said = refusal(ar, recipe, values(at + (a_little if within else 0)))
                if not re.search(rf"{parameter}|angle", said):
                    faults.append(f"{name}.{parameter}: {row['range']}: just outside: {said or 'taken'}")
                if said := refusal(ar, recipe, values(at if within else at - a_little)):
                    faults.append(f"{name}.{parameter}: {row['range']}: just within: {said}")
                tried += 1
    assert not faults, "\n".join(faults)
    assert tried > 100, tried


def test_what_scenes_refuse_is_refused_where_it_is_made(ar):
    law = ar.MohrCoulomb(**FRICTIONAL)
    refused = [
        (lambda: ar.MohrCoulomb(poisson=0.6), r"MohrCoulomb.density: not given \(kg/m3, > 0\)"),
        (lambda: ar.MohrCoulomb(**{**FRICTIONAL, "poisson": 0.6}), r"MohrCoulomb.poisson = 0.6: must lie in \(-1, 0.5\)"),
        (lambda: ar.MohrCoulomb(**FRICTIONAL, memory=ar.RemembersOpening(), tension=0.0), "needs the cut-off at the apex"),
        (lambda: ar.MohrCoulomb(**FRICTIONAL, friction_law=ar.SofteningFriction(residual_friction=0.7, decay=1)), "must not exceed the law's friction"),
        (lambda: ar.MohrCoulomb(**FRICTIONAL, friction_law=ar.ForgetsOpening()), "must name a friction policy of the library"),
        (lambda: ar.Numerics(ar.LinearSimplex, ar.Flip(2)), r"Flip.fraction = 2: must lie in \[0, 1\]"),
        (lambda: ar.CartesianGrid((0, 0), (1, 1), cell=0.3), "CartesianGrid.cell = 0.3: must divide the extent 1 along axis 0"),
        (lambda: ar.CartesianGrid((0, 0), (1, -1), cell=0.5), "CartesianGrid.upper"),
        (lambda: ar.RectilinearGrid(x=(0, 1, 0.5), y=(0, 1)), "RectilinearGrid.x"),
        (lambda: ar.SimplexMesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 3)]), "SimplexMesh.cells.* = 3: must be a node of the mesh"),
        (lambda: ar.on("base", "roller"), "Wall.condition = roller: needs a face"),
        (lambda: ar.left("sticky"), "Wall.condition = sticky: must be fixed or roller"),
        (lambda: ar.bottom(ar.symmetry((0, 0, 0))), "symmetry.normal"),
        (lambda: ar.Table([]), "Table.rows = 0: must be at least one"),
        (lambda: ar.Ball((0, 0), 1) | ar.Ball((0, 0), -1), "Ball.radius = -1: must be positive"),
        (lambda: ar.Guided(mass=1, axis=(0, 0, 0)), "Guided.axis"),
        (lambda: ar.Guided(mass=1, load=math.nan), "Guided.load = nan: must be finite"),
        (lambda: ar.Guided(mass=1, load=lambda x, t: t), r"Guided.load = f\(x, t\): must be a number or a function of time"),
        (lambda: ar.fill("sand", ar.Ball((0, 0), 1), law, per_cell=0), "FillOptions.per_cell = 0: must be at least 1"),
        (lambda: ar.fill("sand", ar.Ball((0, 0), 1), law, velocity=(0, math.nan)), "FillOptions.velocity = nan: must be finite"),
        (lambda: ar.fill("sand", ar.Ball((0, 0), 1), law, velocity="fast"), "fill.velocity = .fast.: must be a list of numbers in SI units or a function"),
        (lambda: ar.fill("sand", ar.Ball((0, 0), 1), law, stress=-1e3), "fill.stress = -1000.0: must be a Geostatic or a function"),
        (lambda: ar.fill("sand", ar.Ball((0, 0), 1), law, history={"opening": math.inf}), "FillOptions.history, opening = inf: must be finite"),
        (lambda: ar.fill("sand", ar.Ball((0, 0), 1), law, seed=-1), "FillOptions.seed = -1: must be a whole number that fits"),
        (lambda: ar.Absorbing(ar.left(), shear_wave=-1), "Absorbing.shear_wave = -1: must not be negative"),
        (lambda: ar.Stage(strains=(0, 1)), "Stage.components = .*: must be a list of 6"),
        (lambda: ar.Stage(strains=(0, math.nan, 0, 0, 0, 0)), r"DriveStage.components\[1\] = nan: must be finite"),
        (lambda: ar.Stage(duration=-1), "DriveStage.duration = -1: must be finite, and not negative"),
        (lambda: ar.oedometer(axial=-0.1, steps=0), "DriveStage.steps = 0: must be at least 1"),
        (lambda: ar.RigidContact(friction=2.0), r"Friction.angle = 2: must lie in \[0, pi/2\)"),
        (lambda: ar.RigidPair(0, 1, friction=-0.1), "Friction.angle = -0.1"),
        (lambda: ar.RigidPair(1, 1), "RigidPair.second = 1: must be another body"),
        (lambda: ar.RigidPair(0, -1), "RigidPair.second = -1: must be the number of a rigid body"),
        (lambda: ar.UGimp(points=0), "UGimp.points = 0: must be at least 1"),
        (lambda: ar.UGimp(points=1.5), "UGimp.points = 1.5: must be a whole number"),
        (lambda: ar.MlsGradient(ar.LinearGrid), "MlsGradient.spline = .*LinearGrid.*: must be QuadraticBSpline or CubicBSpline"),
        (lambda: ar.MidpointStrain(ar.Flip), "MidpointStrain.order = .*Flip.*: must be Musl, Usl or Usf"),
    ]
    for make, sentence in refused:
        with pytest.raises(ar.Error, match=sentence):
            make()
    assert law  # what is sound is not


def sentences():
    """The text of the library's headers, with the parts of each sentence joined."""
    return "\n".join(re.sub(r'"\s*\\?\n\s*"', "", p.read_text()) for p in sorted(INCLUDE.rglob("*.hpp")))


def test_what_does_not_go_together_is_refused_with_the_compilers_sentence(ar, sand):
    """Without a compiler: as `Numerics` or `Rigid` is made, the rest as the scene is."""
    grid, ball = ar.CartesianGrid((0, 0), (1, 1), cell=0.1), ar.Ball((0.5, 0.9), 0.05)
    triangle = ar.SimplexMesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)])
    splines, guided = ar.Numerics(ar.QuadraticBSpline, ar.Apic), ar.Guided(mass=1)

    def scene(mesh=grid, numerics=splines, kinematics=None, **more):
        return ar.Scene(kinematics or ar.PlaneStrain(), mesh, numerics, bodies=[ar.fill("sand", ar.Box((0, 0), (1, 0.5)), sand)], **more)

    refused = [
        lambda: ar.Numerics(ar.LinearSimplex, ar.Apic),
        lambda: ar.Numerics(ar.LinearSimplex, ar.Aflip),
        lambda: ar.Numerics(ar.QuadraticBSpline, ar.Tpic),
        lambda: ar.Numerics(ar.MlsGradient(ar.CubicBSpline), ar.Tpic),
        lambda: scene(mesh=triangle, numerics=ar.Numerics(ar.MlsGradient, ar.Apic)),
        lambda: ar.Numerics(ar.QuadraticBSpline, anti_locking=ar.ElementAverage),
        lambda: ar.MohrCoulomb(**FRICTIONAL, stiffness_law=ar.RateStiffness()),
        lambda: ar.Rigid(ball, guided, 0.1, ar.CentreOfMass),
        lambda: ar.Rigid(ar.MeshSurface("body"), ar.Prescribed((0, 0)), 0.1, ar.CentreOfMass),
        lambda: ar.Rigid(ar.MeshSurface("body"), guided, 0.1, ar.PointContact),
        lambda: ar.Rigid(ar.MeshSurface("body"), ar.Free(mass=1, inertia=1, centre=(0, 0)), 0.1),
        lambda: scene(kinematics=ar.ThreeDimensional()),
        lambda: scene(mesh=triangle),
        lambda: scene(numerics=ar.Numerics(ar.LinearSimplex)),
        lambda: scene(rigids=[ar.Rigid(ar.MeshSurface("body"), guided, 0.1)]),
        lambda: scene(rigids=[ar.Rigid(ball, guided, 0.1, ar.PointContact)]),
        lambda: scene(rigids=[ar.Rigid(ball, guided, 0.1, ar.PointContact)], rigid_contact=ar.RigidContact(0.1),
                      numerics=ar.Numerics(ar.QuadraticBSpline, ar.Apic, ar.Usl)),
        lambda: scene(rigids=[ar.Rigid(ball, guided, 0.1, ar.PointContact)],
                      numerics=ar.Numerics(ar.QuadraticBSpline, ar.Apic, ar.MidpointStrain(ar.Musl))),
        lambda: scene(rigids=[ar.Rigid(ball, guided, 0.1)], moving_mesh=ar.MovingMesh(fixed_below=0.1, moving_from=0.5)),
    ]
    text = sentences() if INCLUDE.exists() else None
    for make in refused:
        with pytest.raises(ar.Error) as said:
            make()
        assert re.match(r"(Numerics|Stiffness|Rigid|Scene|MovingMesh|RigidContact): ", str(said.value))
        assert text is None or f'"{said.value}"' in text, f"no static_assert says: {said.value}"


def test_what_goes_together_is_made(ar):
    """Whatever the compiler takes."""
    for transfer in (ar.Flip, ar.Tpic, ar.Fmpm, ar.Xpic):
        ar.Numerics(ar.LinearSimplex, transfer, ar.Musl, ar.NodalAndElementAverage)
    for shape in (ar.LinearGrid, ar.QuadraticBSpline, ar.CubicBSpline, ar.UGimp, ar.MlsGradient, ar.MlsGradient(ar.CubicBSpline)):
        ar.Numerics(shape, ar.Flip, ar.Usf)
        ar.Numerics(shape, ar.Flip, ar.MidpointStrain)
    ar.Numerics(ar.QuadraticBSpline, ar.Aflip)
    ar.Rigid(ar.MeshSurface("body"), ar.Guided(mass=1), 0.1, ar.CentreOfMass)
    ar.Rigid(ar.Ball((0, 0), 1), ar.Prescribed(lambda t: (0, -t)), math.inf, ar.PointContact)
    ar.Rigid(ar.Ball((0, 0), 1), ar.Guided(mass=1), 0.1, ar.NodalGap)
    ar.Rigid(lambda x: np.ones(len(x)), ar.Prescribed(ar.Signal(0, 1)), 0.1)
    ar.MohrCoulomb(**FRICTIONAL, stiffness_law=ar.RateStiffness(),
                   friction_law=ar.RateSofteningFriction(softening=ar.SofteningFriction(residual_friction=0.5, decay=1)))
