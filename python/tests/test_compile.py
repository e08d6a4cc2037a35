"""Compositions compiled on first use, and laws of one's own."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

HERE = Path(__file__).parent


def bar(ar, law):
    return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.02),
                    ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                    bodies=[ar.fill("bar", ar.Box((0, 0), (0.2, 0.1)), law)], walls=[ar.bottom()], gravity=(0, -9.81))


def test_a_law_of_ones_own_is_the_built_in_one(ar, compiler):
    own = ar.compile(law=HERE / "own_elastic.hpp")
    given = dict(density=1000, young=1e6, poisson=0.3)
    built_in, mine = bar(ar, ar.LinearElastic(**given)), bar(ar, own(**given))
    for scene in (built_in, mine):
        ar.run(scene, end=0.01)
    assert np.array_equal(built_in.bodies["bar"].stress, mine.bodies["bar"].stress)
    with pytest.raises(ar.Error, match="Held.desnity = 1: is unknown; there are: density, young, poisson"):
        bar(ar, own(desnity=1))
    with pytest.raises(ar.Error, match="Held.poisson"):
        bar(ar, own(density=1000, young=1e6, poisson=0.6))


@pytest.mark.parametrize("name, cure", [("Law", "give it `struct Parameters .*explicit Law.const Parameters"),
                                        ("my::Shape", 'my::Shape is a template: name what it is made for, as in name="my::Shape<2>"')])
def test_a_law_that_cannot_be_made_by_name_is_refused_at_once(ar, tmp_path, name, cure):
    (tmp_path / "law.hpp").write_text("""
        class Base { };  // class Law { Law(double); };
        class Law : public Base {
         public:
          explicit Law(double density) : density_{density} {}
          template <class T, int D> T update(T& stress) const { return T(0); }
        };
        namespace my { template <int D> class Shape { struct Parameters {}; }; }""")
    with pytest.raises(ar.Error, match=cure):
        ar.compile(law=tmp_path / "law.hpp", name=name)


@pytest.mark.parametrize("header, name", [("own_law", ""), ("extend/laws/neo_hookean", ""), ("extend/laws/newtonian_fluid", ""),
                                          ("extend/laws/kelvin_voigt", "KelvinVoigt<2>")])
def test_the_examples_laws_can_be_made_by_name(ar, header, name):
    assert ar.compile(law=HERE.parents[1] / "examples" / f"{header}.hpp", name=name)(density=1).parameters == {"density": 1}


ELASTIC = dict(density=2000, young=1e6, poisson=0.3)
TOO_LONG = "must be zero along an axis that the scene does not have"


@pytest.mark.parametrize("wrong, told", [
    (lambda ar: dict(gravity=9.81), "gravity = 9.81: must be up to 3 numbers, or a function of time"),
    (lambda ar: dict(gravity="down"), "gravity = down: must be up to 3 numbers"),
    (lambda ar: dict(gravity=(0, 0, -9.81)), "gravity: components = 3: must be 2, as many as the scene has dimensions"),
    (lambda ar: dict(walls=[ar.front()]), "Wall.axis = 2: must be an axis of the scene"),
    (lambda ar: dict(walls=[ar.on("base")]), "Wall.set = base: a Cartesian grid has no node sets"),
    (lambda ar: dict(region=ar.Box((0, 0, 0), (1, 1, 1))), "Box.lower = .*: must be 2 numbers in this scene"),
    (lambda ar: dict(region=ar.Box((5, 5), (6, 6))), "fill: points = 0: the region holds no point of the mesh"),
    (lambda ar: dict(region=ar.Cells("soil")), "Cells = soil: a grid has no regions"),
    (lambda ar: dict(velocity=(0, 0, 1)), f"FillOptions.velocity = 1: {TOO_LONG}"),
    (lambda ar: dict(parts=[ar.Driven(ar.top(), (0, 0, 1))]), f"Driven.velocity = .*: {TOO_LONG}"),
    (lambda ar: dict(parts=[ar.Driven(ar.front(), (0, 1))]), "Wall.axis = 2"),
    (lambda ar: dict(parts=[ar.Traction(ar.top(), (0, 0, 1))]), f"Traction.traction = .*: {TOO_LONG}"),
    (lambda ar: dict(parts=[ar.FrictionalWall(ar.front(), 0.3)]), "Wall.axis = 2"),
    (lambda ar: dict(parts=[ar.BodyForce((0, 0, 1))]), f"BodyForce.force = .*: {TOO_LONG}"),
    (lambda ar: dict(parts=[ar.PointLoad((0.5, 0.5, 1), (0, 1))]), f"PointLoad.place = .*: {TOO_LONG}"),
    (lambda ar: dict(parts=[ar.PointLoad((0.5, 0.5), (0, 1), body=1)]), "PointLoad.body = 1: the scene has 1 bodies, numbered from 0"),
    (lambda ar: dict(motion=ar.Prescribed((0, 0, 1))), f"Prescribed.velocity = .*: {TOO_LONG}"),
    (lambda ar: dict(motion=ar.Guided(mass=1, axis=(0, 0, 1))), "Guided.axis = .*: must have a length in the scene's dimensions"),
    (lambda ar: dict(motion=ar.Free(mass=1, inertia=1, centre=(0.5, 0.8, 1))), f"Free.centre = 1: {TOO_LONG}"),
    (lambda ar: dict(motion=ar.PrescribedPose(spin=(1, 0, 0))), "PrescribedPose.spin = 1: must be about z in a plane scene"),
    (lambda ar: dict(motion=ar.Prescribed((0, 0)), surface=ar.Ball((0.5, 0.8, 0), 0.1)), "Ball.centre = .*: must be 2 numbers"),
    (lambda ar: dict(motion=ar.Prescribed((0, 0)), rigid_contact=ar.RigidContact(0.3, [ar.RigidPair(0, 4)])), "RigidPair.second = 4: the scene has 1"),
])
def test_what_needs_no_composition_is_told_before_it_is_compiled(ar, compiler, monkeypatch, tmp_path, wrong, told):
    from arenite import _compile

    monkeypatch.setenv("ARENITE_CACHE", str(tmp_path))
    monkeypatch.setattr(_compile, "_made", lambda *_: pytest.fail("it is compiled"))
    given = dict(region=ar.Box((0, 0), (1, 0.5)), surface=ar.Ball((0.5, 0.8), 0.1), walls=[ar.bottom()], parts=[], gravity=(0, -9.81), motion=None)
    given.update(wrong(ar))
    options = {key: given[key] for key in ("velocity", "stress") if key in given}
    rigids = [ar.Rigid(given["surface"], given["motion"], 0.3)] if given["motion"] else []
    with pytest.raises(ar.Error, match=told):
        ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1, 1), cell=0.1), ar.Numerics(ar.LinearGrid),
                 bodies=[ar.fill("b", given["region"], ar.LinearElastic(**ELASTIC), **options)], walls=given["walls"], gravity=given["gravity"],
                 rigids=rigids, rigid_contact=given.get("rigid_contact"), parts=[*given["parts"], ar.ViscousDamping(1.0)])


def test_names_of_a_mesh_are_looked_up_before_compiling_and_functions_are_left_alone(ar, compiler, monkeypatch, tmp_path):
    from arenite import _compile

    class Compiles(Exception):
        pass

    def made(*_):
        raise Compiles

    monkeypatch.setenv("ARENITE_CACHE", str(tmp_path))
    monkeypatch.setattr(_compile, "_made", made)
    mesh = ar.SimplexMesh([(0, 0), (1, 0), (1, 1), (0, 1)], [[0, 1, 2], [0, 2, 3]], [1, 1], {"soil": 1}, {"base": [0, 1]})

    def scene(region="soil", base="base", **more):
        ar.Scene(ar.PlaneStrain(), mesh, ar.Numerics(ar.LinearSimplex),
                 bodies=[ar.fill("b", region if callable(region) else ar.Cells(region), ar.LinearElastic(**ELASTIC), **more.pop("fill", {}))],
                 walls=[base if isinstance(base, ar.Wall) else ar.on(base)], parts=[ar.ViscousDamping(1.0), *more.pop("parts", [])], **more)

    with pytest.raises(ar.Error, match="SimplexMesh: region = soill: must be one of: soil"):
        scene(region="soill")
    with pytest.raises(ar.Error, match="SimplexMesh: node set = basis: must be one of: base"):
        scene(base="basis")

    def never(*_):
        pytest.fail("called before the scene is there")

    with pytest.raises(Compiles):
        scene(region=never, base=ar.where(never), gravity=never, fill={"velocity": never, "history": {"x": never}},
              parts=[ar.Driven(ar.where(never), never), ar.Traction(ar.where(never), never), ar.BodyForce(never), ar.Driven(ar.on("base"), ar.Signal(0, 1))],
              rigids=[ar.Rigid(never, ar.Prescribed(never), 0.3), ar.Rigid(ar.Ball((0, 2), 0.1), ar.Prescribed(ar.Scaled((0, 1), ar.Ramp(over=1))), 0.3)])


def test_the_compilers_sentence_is_pythons(ar, sand, compiler):
    law = ar.WithDeviatoricStrain(sand, dimension=2)
    with pytest.raises(ar.Error, match="WithDeviatoricStrain: made for plane scenes; in space leave its second argument out"):
        ar.Scene(ar.ThreeDimensional(), ar.CartesianGrid((0, 0, 0), (1, 1, 1), cell=0.5), ar.Numerics(ar.QuadraticBSpline),
                 bodies=[ar.fill("sand", ar.Box((0, 0, 0), (1, 1, 1)), law)])


def test_same_bits_as_cplusplus(ar, column, compiler, tmp_path):
    from arenite import _compile, _plugins

    program = tmp_path / "column"
    flags = _plugins.WIDTHS[_plugins.width()]["flags"]
    subprocess.run([*_compile.compiler(), "-std=c++20", "-O3", "-DNDEBUG", *flags,
                    *(f"-isystem{f}" for f in _compile.include_folders()), str(HERE / "column.cpp"), "-o", str(program),
                    "-pthread"], check=True)
    said = subprocess.run([program, "0.05"], check=True, capture_output=True, text=True).stdout.splitlines()
    scene = column()
    ar.run(scene, end=0.05)
    assert int(said[0]) == scene.step_count
    there = np.array([[float.fromhex(x) for x in line.split()] for line in said[1:]])
    body = scene.bodies["sand"]
    assert np.array_equal(there, np.column_stack([body.position, body.velocity, body.stress]))


def test_without_a_compiler_the_cure_is_named(ar, monkeypatch, tmp_path):
    monkeypatch.setenv("CXX", "no-such-compiler")
    monkeypatch.setenv("ARENITE_CACHE", str(tmp_path))
    with pytest.raises(ar.Error, match="no-such-compiler: not found.*install g\\+\\+ 12"):
        bar(ar, ar.compile(law=HERE / "own_elastic.hpp", name="Unknown")())


LAW = """
import sys
import arenite as ar
law = ar.compile(law=sys.argv[1], name="Registration")(density=1000, young=1e6, poisson=0.3)
print(ar.drive(law, ar.oedometer(axial=-0.01)).stress[-1, 1])
"""


def child(cache):
    environment = {**os.environ, "ARENITE_CACHE": str(cache)}
    return subprocess.Popen([sys.executable, "-c", LAW, str(HERE / "own_elastic.hpp")], env=environment, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)


def test_two_processes_compile_once_and_a_killed_one_leaves_a_sound_cache(ar, compiler, tmp_path):
    killed = child(tmp_path)
    while not list(tmp_path.glob("*.lock")):
        time.sleep(0.05)
    time.sleep(1)
    os.killpg(killed.pid, signal.SIGKILL)
    killed.communicate()
    assert not list(tmp_path.glob("*.so"))
    both = [child(tmp_path) for _ in range(2)]
    said = [p.communicate() for p in both]
    assert [p.returncode for p in both] == [0, 0], said
    assert sum("compiling" in err for _, err in said) == 1, said
    assert len(list(tmp_path.glob("*.so"))) == 1
    assert {out for out, _ in said} == {said[0][0]} and float(said[0][0]) == pytest.approx(-0.01 * 1e6 * 0.7 / (1.3 * 0.4))
    third = child(tmp_path)
    _, err = third.communicate()
    assert third.returncode == 0 and "compiling" not in err


@pytest.fixture
def unit(ar, compiler, monkeypatch, tmp_path):
    """Compiles and opens units that are a header alone, in a cache of its own; `answer(header)` is that of its function."""
    from arenite import _compile

    monkeypatch.setenv("ARENITE_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(_compile, "source", lambda what, name, headers: f'#include "{headers[0]}"\n')

    def build(header):
        return _compile.built("law", "Unit", [str(header)], [])

    def answer(header):
        code = "import ctypes, sys; print(ctypes.CDLL(sys.argv[1]).answer())"
        return int(subprocess.run([sys.executable, "-c", code, str(build(header))], capture_output=True, text=True, check=True).stdout)

    header, included = tmp_path / "own header.hpp", tmp_path / "included.hpp"
    header.write_text('#include "included.hpp"\nextern "C" int answer() { return included; }\n')
    included.write_text("inline constexpr int included = 1;\n")
    unit.build, unit.answer, unit.header, unit.included, unit.cache = build, answer, header, included, tmp_path / "cache"
    return unit


def test_what_a_header_includes_decides_too(unit, capfd):
    assert unit.answer(unit.header) == 1 and "compiling" in capfd.readouterr().err
    assert unit.answer(unit.header) == 1 and "compiling" not in capfd.readouterr().err
    unit.included.write_text("inline constexpr int included = 2;\n")
    assert unit.answer(unit.header) == 2
    unit.included.write_text("inline constexpr int included = 1;\n")  # of the same length, and known
    capfd.readouterr()
    assert unit.answer(unit.header) == 1 and "compiling" not in capfd.readouterr().err
    unit.included.write_text('#include "another.hpp"\n')
    (unit.included.parent / "another.hpp").write_text("inline constexpr int included = 3;\n")
    assert unit.answer(unit.header) == 3
    (unit.included.parent / "another.hpp").write_text("inline constexpr int included = 4;\n")
    assert unit.answer(unit.header) == 4


def test_a_header_that_changes_while_it_is_compiled_is_compiled_again(unit, monkeypatch):
    from arenite import _compile

    compiled, times = _compile._compiled, []

    def changing(*arguments):
        files = compiled(*arguments)
        times.append(0)
        if len(times) == 1:
            unit.included.write_text("inline constexpr int included = 7;\n")
        return files

    monkeypatch.setattr(_compile, "_compiled", changing)
    assert unit.answer(unit.header) == 7 and len(times) == 2


@pytest.mark.parametrize("header, units", [
    ("int step();\n#if defined ARENITE_STEP_HERE || !defined ARENITE_EXTERN_STEP\nint step() { return 5; }\n#endif\n"
     "#ifndef ARENITE_STEP_HERE\nextern \"C\" int answer() { return step(); }\n#endif\n", 2),
    ("extern \"C\" int answer() { return 5; }\n", 1),  # a function that is not inline
    ("namespace { int step() { return 5; } }\n#ifndef ARENITE_STEP_HERE\nextern \"C\" int answer() { return step(); }\n#endif\n", 2),
])
def test_the_step_of_a_scene_is_a_unit_of_its_own_where_it_can_be(unit, monkeypatch, header, units):
    from arenite import _compile

    monkeypatch.setattr(_compile, "source", lambda what, name, headers: f'#include "{headers[0]}"\n// {_compile.STEP}\n')
    unit.header.write_text(header)
    called, commands = _compile._called, []
    monkeypatch.setattr(_compile, "_called", lambda command: commands.append(command) or called(command))
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0, 1})
    assert unit.answer(unit.header) == 5
    levels = sorted({"-O1", "-O3"}.intersection(command).pop() for command in commands if str(unit.cache) in command[-1])
    assert levels == ["-O1", "-O3", "-O3"] + ["-O3"] * (units == 1)  # hosted, step, linked, and all of it in one

    commands.clear()
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0})
    unit.header.write_text(header + "\n")
    assert unit.answer(unit.header) == 5
    assert sum(str(unit.cache) in command[-1] for command in commands) == 1


def test_flags_of_the_compiler_decide_too(unit, monkeypatch):
    unit.included.write_text("inline constexpr int included = NUMBER;\n")
    for number in (5, 6):
        monkeypatch.setenv("CXX", f"g++ -DNUMBER={number}")
        assert unit.answer(unit.header) == number


def test_a_broken_object_is_made_again(unit, capfd):
    made = unit.build(unit.header)
    whole = made.read_bytes()
    for bytes_left in [0, 1, 31, 40, len(whole) // 4, len(whole) // 2, len(whole) - 4096, len(whole) - 1]:
        made.write_bytes(whole[:bytes_left])
        assert unit.answer(unit.header) == 1
    for name in [made, *unit.cache.glob("*.files")]:  # one byte in the middle
        content = bytearray(name.read_bytes())
        content[len(content) // 2] ^= 1
        name.write_bytes(content)
        capfd.readouterr()
        assert unit.answer(unit.header) == 1 and "compiling" in capfd.readouterr().err
    assert not list(unit.cache.glob("*.tmp"))


def test_the_packages_object_serves_the_compiler_that_made_it(ar, tmp_path):
    from arenite import _compile

    host, made_by = tmp_path / "libhost_16.a", tmp_path / "compiler.txt"
    version = "/usr/bin/g++-12\ng++ (Debian 12.2.0-14) 12.2.0\nCopyright\n"
    assert not _compile._is_of(host, version)
    host.touch()
    assert not _compile._is_of(host, version)
    made_by.write_text("c++ (Debian 12.2.0-14) 12.2.0\nCopyright\n")  # another name of the same
    assert _compile._is_of(host, version)
    made_by.write_text("c++ (Debian 13.1.0-6) 13.1.0\nCopyright\n")
    assert not _compile._is_of(host, version)
    native = HERE.parent / "native" / "host.cpp"
    cold = "#include <arenite/cold.hpp>\n"  # has a unit of its own in the package
    assert cold in _compile.HOST and native.read_text().endswith(_compile.HOST.replace(cold, ""))


def test_an_object_of_someone_else_does_not_run(ar, unit):
    made = unit.build(unit.header)
    assert unit.cache.stat().st_mode & 0o777 == 0o700 and made.stat().st_mode & 0o077 == 0
    made.chmod(0o666)
    with pytest.raises(ar.Error, match="others may write there"):
        unit.build(unit.header)
    made.chmod(0o600)
    for mode in (0o777, 0o770, 0o1777):
        unit.cache.chmod(mode)
        with pytest.raises(ar.Error, match=f"cache = .*mode {mode:o}"):
            unit.build(unit.header)
    unit.cache.chmod(0o700)
    elsewhere = made.with_suffix(".else")
    made.rename(elsewhere)
    made.symlink_to(elsewhere)
    with pytest.raises(ar.Error, match="cache = "):
        unit.build(unit.header)
    made.unlink()
    made.mkdir()
    with pytest.raises(ar.Error, match="must be a file"):
        unit.build(unit.header)
    made.rmdir()
    elsewhere.rename(made)
    if os.geteuid() == 0:  # none other may give a file away
        for path in (made, unit.cache):
            os.chown(path, 12345, -1)
            with pytest.raises(ar.Error, match="belongs to user 12345"):
                unit.build(unit.header)
            os.chown(path, 0, -1)


def test_where_the_cache_is(ar, monkeypatch, tmp_path):
    from arenite import _cache

    monkeypatch.delenv("ARENITE_CACHE", raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    for not_given in ("", "relative", "./a"):
        monkeypatch.setenv("XDG_CACHE_HOME", not_given)
        assert _cache.folder() == tmp_path / ".cache" / "arenite"
    monkeypatch.setenv("XDG_CACHE_HOME", "/somewhere")
    assert str(_cache.folder()) == "/somewhere/arenite"
    monkeypatch.setenv("ARENITE_CACHE", "relative")
    with pytest.raises(ar.Error, match="ARENITE_CACHE = relative: must be an absolute path"):
        _cache.folder()
    monkeypatch.setenv("ARENITE_CACHE", "")
    monkeypatch.setenv("XDG_CACHE_HOME", "")
    monkeypatch.setenv("HOME", "relative")
    with pytest.raises(ar.Error, match="HOME = relative"):
        _cache.folder()


@pytest.mark.parametrize("given, rule", [("g++ 'x", "CXX = g\\+\\+ 'x: must be words"), ("true", "true: ended without an error, but made no object"),
                                         ("/no/such", "/no/such: not found"), ("{folder}/broken", "cannot be run"), ("{folder}", "not found")])
def test_a_compiler_that_is_none(ar, unit, monkeypatch, tmp_path, given, rule):
    (tmp_path / "broken").write_bytes(b"\x7fELF nothing")
    (tmp_path / "broken").chmod(0o755)
    monkeypatch.setenv("CXX", given.format(folder=tmp_path))
    with pytest.raises(ar.Error, match=rule):
        unit.build(unit.header)


def test_a_cache_that_cannot_be_written(ar, unit, monkeypatch, tmp_path):
    def refused(place, rule):
        monkeypatch.setenv("ARENITE_CACHE", str(place))
        with pytest.raises(ar.Error, match=f"cache = {place}.*{rule}.*ARENITE_CACHE"):
            unit.build(unit.header)

    (tmp_path / "file").write_text("")
    refused(tmp_path / "file", "must be a folder")
    refused(tmp_path / "file" / "below", "/file;")
    refused("/proc/arenite", "")
    refused("/sys/arenite", "")
    (tmp_path / "cache").mkdir(mode=0o700)
    monkeypatch.setattr(os, "open", lambda *a, **k: (_ for _ in ()).throw(OSError(30, "Read-only file system", str(a[0]))))
    refused(tmp_path / "cache", "Read-only file system")


@pytest.mark.parametrize("text, name", [("struct A { void update(); };", "A"), ("namespace a { namespace b::c { class L final { void update( ", "a::b::c::L"),
                                        ("namespace a { struct B {}; } struct L : a::B { void update(", "L"),
                                        ("/* struct X {\n update( */ struct L { struct Parameters { int x; }; void update(", "L")])
def test_the_class_of_a_law(ar, tmp_path, text, name):
    from arenite import _compile

    (tmp_path / "law.hpp").write_text(text)
    assert _compile.law_name(tmp_path / "law.hpp") == name


def test_every_recipe_of_the_examples_is_prebuilt(ar, column, sand):
    """What the README and the tests of this folder use needs no compiler."""
    from arenite import _plugins

    _plugins._ensure_prebuilt()
    lines = (Path(_plugins.PACKAGE) / "prebuilt.txt").read_text().splitlines()
    known = {line.split(" ", 1)[1] for line in lines if line.startswith(("scene ", "law "))}
    assert column().compiled_as in known and sand.cpp() in known
    if _plugins.prebuilt(_plugins.width()).exists():
        plugin = _plugins._plugins[str(_plugins.prebuilt(_plugins.width()))]
        assert set(plugin.scenes()) | set(plugin.laws()) == known


@pytest.mark.parametrize("page", ["README.md", "docs/first_python.md", "docs/python.md"])
def test_the_first_scene_of_a_page_is_prebuilt(ar, page, monkeypatch):
    """As the recipes spell it today, or by what stands for it."""
    from arenite import _stand_ins

    class Made(Exception):
        pass

    def made(scene):
        type_name, values, _, _ = scene._composition()
        raise Made(type_name, values["parts"], scene._recipes["mesh"].dimension)

    monkeypatch.setattr(ar.Scene, "_make", made)
    text = (HERE.parents[1] / page).read_text()
    code = "\n".join(re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE))
    with pytest.raises(Made) as asked:
        exec(compile(code, page, "exec"), {})
    lines = (HERE.parents[1] / "python" / "arenite" / "prebuilt.txt").read_text().splitlines()
    known = [line.split(" ", 1)[1] for line in lines if line.startswith("scene ")]
    assert asked.value.args[0] in known or _stand_ins.find(*asked.value.args, known)


def test_import_brings_the_package_numpy_and_the_standard_library_alone(ar):
    """What else is needed, pictures, tables, meshes, is imported by what needs it: the import is quick."""
    code = "import sys, numpy; before = set(sys.modules); import arenite; print(*set(sys.modules) - before)"
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    loaded = {name.partition(".")[0] for name in done.stdout.split()}
    assert "arenite" in loaded
    assert loaded - {"arenite", "numpy", "__mp_main__"} <= set(sys.stdlib_module_names)
