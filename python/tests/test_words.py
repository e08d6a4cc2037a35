"""What users read: each wrong argument is refused by its name with value and rule, names that are not there with the nearest one, every
recipe can be pasted back from what it shows, every public name tells of its parameters, and notebooks get tables."""

import inspect
import math
import re
import threading

import numpy as np
import pytest

from test_recipes import recipes, sound


class Quantity:
    """A number with a unit, as packages of units have it."""

    def __init__(self, number, unit):
        self.number, self.unit = number, unit

    def __float__(self):
        raise TypeError("only a quantity without a unit is a number")

    def __repr__(self):
        return f"<Quantity({self.number}, '{self.unit}')>"


WRONG = ["50 ms", Quantity(50, "ms"), object(), 3 + 4j, {"a": object()}, [object()], -1.5, [[1], [2, 3]], None, True, print]
MADE_BY_OTHERS = {"Sweep", "View", "BodyHere", "Tile", "Error", "RunError", "Warning", "Cone"}  # not by users


def functions_and_methods(ar, scene):
    """Public callables by name, methods as those of objects that there are."""
    found = {name: getattr(ar, name) for name in ar.__all__ if callable(getattr(ar, name)) and name not in MADE_BY_OTHERS}
    law, signal = scene.law(), ar.Signal(0, 1)
    for told, owner in {"Scene": scene, "Law": law, "Signal": signal, "Body": scene.bodies["sand"], "Watch": ar.Watch()}.items():
        found.update((f"{told}.{name}", getattr(owner, name)) for name, x in vars(type(owner)).items() if name[0] != "_" and inspect.isfunction(x))
    return found


def parameters_of(x):
    kinds = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
    return {name: p for name, p in inspect.signature(x).parameters.items() if p.kind in kinds}


def sound_arguments(ar, scene, name, x):
    """For the parameters that must be given."""
    law = scene.law()
    known = {"scene": scene, "end": scene.time, "law": law, "body": "sand", "region": ar.Box((0, 0), (1, 1)), "name": "sand", "path": "nowhere", "folder": "nowhere",
             "kinematics": ar.PlaneStrain(), "mesh": ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01), "numerics": ar.Numerics(ar.QuadraticBSpline, ar.Apic),
             "bodies": [ar.fill("sand", ar.Box((0, 0), (0.1, 0.15)), law)]}
    return {**known, **sound(ar).get(name, {})}


def test_each_wrong_type_is_refused_in_words(ar, column, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    scene, tried, faults = column(reactions=True), 0, []

    def not_compiled(type_name, headers, check, *rest):
        check()
        raise ar.Error("nothing is compiled here")

    monkeypatch.setattr("arenite._plugins.scene_plugin", not_compiled)
    monkeypatch.setattr("arenite._plugins.tiles_plugin", not_compiled)
    slow = {"compile", "animate", "plot", "sweep", "run", "settle", "run_in_folder", "Scene.steps", "Scene.step"}  # would run with what is no mistake
    for name, x in functions_and_methods(ar, scene).items():
        if isinstance(x, type) and issubclass(x, tuple) or name == "Body.column":  # results; what has no such column says so as an attribute does
            continue
        base = sound_arguments(ar, scene, name, x)
        parameters = parameters_of(x)
        needed = {n: base[n] for n, p in parameters.items() if p.default is p.empty and n in base}
        for parameter in parameters:
            for wrong in WRONG:
                if name in slow and (wrong is None or wrong is True or wrong is print or isinstance(wrong, dict)):
                    continue
                tried += 1
                try:
                    x(**{**needed, parameter: wrong})
                except ar.Error as e:
                    if "incompatible" in str(e) or "Invoked with" in str(e) or "object has no attribute" in str(e):
                        faults.append(f"{name}({parameter}={wrong!r}): {e}")
                except ImportError:
                    continue
                except Exception as e:
                    faults.append(f"{name}({parameter}={wrong!r}): {type(e).__name__}: {e}")
    assert tried > 1000
    assert not faults, f"{len(faults)}\n" + "\n".join(faults)


def test_a_unit_is_named_with_argument_value_and_rule(ar, column):
    scene = column(reactions=True)
    refused = [
        (lambda: ar.run(scene, end=Quantity(50, "ms")), r"run\.end = <Quantity\(50, 'ms'\)>: must be a number, s"),
        (lambda: ar.run(scene, end="50 ms"), r"run\.end = '50 ms': must be a number, s"),
        (lambda: ar.Signal("0.03"), r"Signal\.components = '0.03': must be a number"),
        (lambda: ar.Signal(0).set(1, "2"), r"Signal\.set\.components = '2': must be a number"),
        (lambda: scene.step("0.1"), r"Scene\.step\.dt = '0.1': must be a number"),
        (lambda: ar.Box((0, 0), "wide"), r"Box\.upper = 'wide': must be a list of numbers"),
        (lambda: ar.fill("sand", ar.Box((0, 0), (1, 1)), ar.LinearElastic), r"fill\.law = .*: must be a Law \(make one: LinearElastic\(\.\.\)\)"),
        (lambda: ar.probe(scene, "sand", "here"), r"probe\.places = 'here': must be numbers in SI units"),
        (lambda: ar.run("scene", 1.0), r"run\.scene = 'scene': must be a Scene"),
    ]
    for call, sentence in refused:
        with pytest.raises(ar.Error, match="^" + sentence):
            call()
        with pytest.raises(TypeError):
            call()
    # What is a number stays one.
    assert ar.Box(np.zeros(2), np.float32([1, 1])) and ar.Flip(np.float64(0.5)) and ar.UGimp(points=np.int64(2)) and ar.Signal(np.float32(1))


def test_what_is_not_given_is_told_with_meaning_and_unit(ar):
    for make, sentence in [(lambda: ar.Free(mass=3), r"Free\.centre: not given \(of mass, at the start, m\)"),
                           (lambda: ar.Guided(), r"Guided\.mass: not given \(.*, kg, > 0\)"), (lambda: ar.Ramp(), r"Ramp\.over: not given \(.*, s, >= 0\)"),
                           (lambda: ar.ConeCylinder(radius=1), r"ConeCylinder\.apex: not given \(full angle of the cone, rad, \(0, pi\)\)"),
                           (lambda: ar.Box((0, 0)), r"Box\.upper: not given \(m, as many\)"), (lambda: ar.run(), r"run\.scene: not given")]:
        with pytest.raises(ar.Error, match="^" + sentence + "$"):
            make()
    for recipe in recipes():  # and of none, that NaN is a value
        try:
            recipe()
        except ar.Error as e:
            assert "nan" not in str(e), e


def test_the_nearest_name_is_told(ar, column, tmp_path):
    scene = column(reactions=True)
    ball = ar.Ball((0, 0), 1)
    sweep = ar.sweep(math.sqrt, [1.0], out=tmp_path / "sweep")
    misspelt = [
        (lambda: scene.bodies["sandy"], "sand"), (lambda: scene.nodes("snad"), "sand"), (lambda: scene.law("Sand"), "sand"),
        (lambda: scene.reaction("botom"), "bottom"), (lambda: scene.state["bodies/0/points/velocity/z"], "bodies/0/points/velocity/"),
        (lambda: ar.MohrCoulomb(frictoin=1), "friction"), (lambda: ar.fill("sand", ball, scene.law(), per_cel=4), "per_cell"),
        (lambda: ar.run(scene, ends=1.0), "end"), (lambda: ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1, 1), 0.5), ar.Numerics(ar.LinearGrid), bodys=[]), "bodies"),
        (lambda: ar.animate(scene, tmp_path / "a.gif", end=1.0, every=0.1, courent=0.5), "courant"), (lambda: ar.bottom("rolller"), "roller"),
        (lambda: ar.plot(scene, "presure"), "pressure"), (lambda: sweep["resul"], "result"), (lambda: ar.recommend("rotatoin", 0.1), "rotation"),
        (lambda: scene.bodies["sand"].column("velocty"), "velocity"), (lambda: ar.probe(scene, "sandd", [(0.0, 0.0)]), "sand"),
        (lambda: ar.to_meshio(scene, "sandd"), "sand"),
        (lambda: ar.Scene(ar.PlaneStrain(), scene._recipes["mesh"], scene._recipes["numerics"], bodies=scene._recipes["bodies"],
                          parts=[ar.PointLoad((0.05, 0.1), (0, -1), "sandy")]), "sand"),
    ]
    for call, name in misspelt:
        with pytest.raises((ar.Error, AttributeError)) as told:
            call()
        assert re.search(rf"; did you mean {re.escape(name)}", str(told.value)), told.value
    for lookup in (lambda: scene.bodies["clay"], lambda: scene.rigids["clay"], lambda: sweep["clay"]):  # as of any mapping; no name is near
        with pytest.raises(KeyError) as told:
            lookup()
        assert isinstance(told.value, ar.Error) and "did you mean" not in str(told.value)
    assert dict(scene.bodies) and scene.bodies.get("clay") is None and "clay" not in scene.bodies


def test_every_recipe_can_be_pasted_back(ar, sand):
    given = sound(ar)
    made = []
    for recipe in recipes():
        try:
            made.append(recipe(**given.get(recipe.__name__, {})))
        except ar.Error:
            continue
    numbers = np.array([0.0, 1.0, 2.0])
    triangle = ar.SimplexMesh(np.array([(0, 0), (1, 0), (0, 1)], float), [(0, 1, 2)], region_names={"soil": 1}, region=[1], node_sets={"base": np.array([0, 1])})
    made += [sand, triangle, ar.RectilinearGrid(numbers, numbers), ar.periodic(ar.CartesianGrid((0, 0), (1, 1), 0.5), 0), ar.Signal(0, -1), ar.bottom("roller"),
             ar.left(ar.symmetry((1, 1))).named("wall"), ar.on("base"), ar.surface("sand", ar.Box((0, 0), (1, 1)), (0, 1), 0.1), ar.Cells("soil"),
             (ar.Box((0, 0, 0), (1, 1, 1)) | ar.Ball((0, 0, 0), 1)) - ar.placed(ar.Ball((0, 0, 0), 1), (1, 0, 0)), ar.Polygon([(0, 0), (1, 0), (0, 1)]),
             ar.Rigid(ar.Ball((0, 0), 1), ar.Free(mass=1, inertia=1, centre=(0, 0)), math.inf, ar.PointContact(), name="ball"), ar.Table([(0, 0), (1, np.float64(2))]),
             ar.Numerics(ar.MlsGradient(ar.CubicBSpline), ar.Flip(0.9), ar.MidpointStrain(ar.Musl)), ar.DruckerPrager(1540, 1e6, 0.3, 0.5, cone=ar.Cone.extension),
             ar.Scaled((0, 1), ar.Ramp(to=3.0, over=1.0)), ar.Traction(ar.top(), (0, -1e3)), ar.OwnPart("Pull", "pull.hpp", {"by": 2.0}), ar.OwnLaw("Own", "own.hpp", {"young": 1.0}),
             ar.Stage(stresses=(None, -1e3, None, None, None, None)), ar.Condition(3, (1, 0, 0)), ar.WithDeviatoricStrain(sand), ar.Driven(ar.bottom(), ar.Signal(1))]
    for x in made:
        back = eval(repr(x), dict(vars(ar)))
        assert back == x and repr(back) == repr(x) and hash(type(back)) == hash(type(x)), repr(x)
        assert len(repr(x)) < 400, repr(x)
    assert len(made) > 80
    assert repr(ar.MohrCoulomb(density=1540, young=1e6, poisson=0.3, friction=0.6)) == "MohrCoulomb(density=1540, young=1000000.0, poisson=0.3, friction=0.6)"
    # Unequal ones are not equal; long arrays and functions are shown short.
    assert ar.Numerics(ar.LinearGrid) == ar.Numerics(ar.LinearGrid()) != ar.Numerics(ar.LinearGrid, ar.Apic)
    assert triangle != ar.SimplexMesh([(0, 0), (1, 0), (0, 2)], [(0, 1, 2)]) and ar.Signal(1) != ar.Signal(2) and ar.Box((0, 0), (1, 1)) != ar.Box((0, 0), (1, 2))
    many = ar.RectilinearGrid(np.arange(1000.0), (0, 1))
    assert repr(many) == "RectilinearGrid(x=<array [1000]>, y=(0, 1))"
    assert repr(ar.where(math.sqrt)) == "Wall(test=<function sqrt>)"


def test_every_public_name_tells_of_its_parameters(ar, column):
    silent = []
    for name, x in functions_and_methods(ar, column(reactions=True)).items():
        words = "\n".join(inspect.getdoc(c) or "" for c in (x.__mro__[:-1] if isinstance(x, type) else [x]))
        lacking = [p for p in parameters_of(x) if not re.search(rf"\b{p}\b", words)] + ([] if inspect.getdoc(x) else ["a docstring"])
        silent += [f"{name}: {', '.join(lacking)}"] if lacking else []
    assert not silent, "\n".join(silent)
    import pydoc

    for recipe in recipes():  # `help` shows no docstring of a base
        told = pydoc.plain(pydoc.render_doc(recipe))
        assert all(re.search(rf"^ \|  {name}  .*", told, re.M) for name in inspect.signature(recipe).parameters if recipe is not ar.Signal), told[:2000]
    shown = pydoc.plain(pydoc.render_doc(ar.fill))
    assert re.search(r"per_cell +- +>= 1 +None +points a cell", shown) and re.search(r"jitter +- +\[0, 1\]", shown)


def test_notebooks_get_escaped_tables(ar, column, tmp_path):
    scene = column(reactions=True)
    ar.run(scene, end=1e-3)
    path = ar.drive(scene.law(), ar.oedometer(-0.01))
    sweep = ar.sweep(math.sqrt, [1.0, 4.0], out=tmp_path / "sweep")
    for shown, words in [(scene, ["sand", "MohrCoulomb", str(len(scene.bodies["sand"])), "Scene&lt;PlaneStrain"]), (scene.energy, ["kinetic", "residual", "[J]", f"{scene.energy.kinetic:.6g}"]),
                         (sweep, ["result", "<td>2</td>"]), (path, ["q [Pa]", f"{path.q[-1]:.6g}"]), (ar.check(scene), ["tried"]),
                         (ar.recommend("bearing", 0.03), ["weightless", "footing"])]:
        table = shown._repr_html_()
        assert table.count("<table>") == table.count("</table>") == 1 and len(table) < 4000
        assert all(word in table for word in words), (table, words)
        assert not re.search(r"<(?!/?(table|caption|thead|tbody|tr|th|td|p)>)", table), table
    from arenite._rows import Rows

    assert "<td>&lt;script&gt;</td>" in Rows([{"name": "<script>"}], ["name"], [])._repr_html_()
    assert repr(path).startswith("<Path: 101 states, t = 0 to 1 s; at its end p = ") and len(repr(path)) < 120


def test_two_scenes_in_two_threads_have_the_bits_of_each_alone(ar, column):
    def state_of(scene):
        return {path: column.tobytes() for path, column in scene.state.items()}

    def run(scene):
        ar.run(scene, end=0.02, every={0.005: lambda s: seen.append(s is scene)})

    def make():
        return [column(reactions=True), column(ar.Box((0, 0), (0.2, 0.1)), reactions=True)]

    seen = []
    alone, beside = make(), make()
    for scene in alone:
        run(scene)
    threads = [threading.Thread(target=run, args=(scene,)) for scene in beside]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [state_of(s) for s in beside] == [state_of(s) for s in alone] and all(seen) and len(seen) == 4 * 5
