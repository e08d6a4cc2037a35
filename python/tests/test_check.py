"""What lies outside of the envelope that random scenes have tried."""

import json
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def report():
    sys.path.insert(0, str(ROOT / "tests" / "extremes"))
    try:
        import report
    finally:
        sys.path.pop(0)
    return report


def test_an_ordinary_scene_lies_within(ar, column):
    found = ar.check(column())
    assert found.outside == []
    assert found.scenes > 500 and found.endings["fault"] == 0 and sum(found.endings.values()) == pytest.approx(100, abs=0.1)
    assert "all parts and values lie within" in str(found) and "sound" in str(found)


@pytest.mark.parametrize("gravity", [(0, -1e5), lambda t: (0, -1e5 - t)], ids=["constant", "in time"])
def test_each_value_outside_is_told(ar, sand, column, gravity):
    import dataclasses

    hard = dataclasses.replace(sand, young=1e13, density=1e5)
    scene = ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1e5, 1e5), 1e4), column()._recipes["numerics"],
                     bodies=[ar.fill("rock", ar.Box((2e4, 0), (8e4, 4e4)), hard, velocity=(1e6, 0, 0))], gravity=gravity)
    said = {o.what: o for o in ar.check(scene, courant=0.001).outside}
    for what, value in {"rock: young": 1e13, "rock: density": 1e5, "rock: speed, m/s": 1e6, "mesh, edge of a cell, m": 1e4, "gravity, m/s2": 1e5,
                        "Courant number": 0.001}.items():
        assert said[what].value == pytest.approx(value)
        assert re.search(r"tried \S+ to \S+", str(said[what]))
    assert "rock: poisson" not in said


def test_the_words_tell_what_the_numbers_mean(ar, sand):
    from arenite.check import Checked, Outside, _apart

    said = str(Checked([Outside("sand: poisson", 0.4999, f"{_apart(-0.9, 0.4999)} to {_apart(0.4998993431, 0.4999)}")], 7507,
                       {"sound": 46.1, "damped": 39.0, "left": 5.0, "stopped": 9.9, "refused": 0.0, "fault": 0.0}))
    assert "sand: poisson = 0.4999: tried -0.9 to 0.499899" in said and "not wrong" in said  # a bound is told from the value
    assert re.search(r"46.1 % ran to their end, with momentum and energy kept \(sound\)", said)
    assert re.search(r" 0.0 % went wrong without an error", said) and "not of your scene" in said and "refused" not in said
    assert _apart(2.0, 1.0) == "2" and _apart(0.5, 0.5) == "0.5"


def test_the_page_and_the_data_are_of_the_same_scenes(ar, report):
    from arenite import check

    data = json.loads((Path(sys.modules["arenite.check"].__file__).parent / "_envelope.json").read_text())
    page = report.PAGE.read_text()
    for name, part in data["parts"].items():
        assert f"| `{name}` | {part['scenes']} |" in page
    assert all(limit in page for limit in report.limits_in_tests())
    assert check is ar.check


def test_each_class_that_a_user_may_name_has_a_place_on_the_page(ar, report):
    """A new transfer or contact is to be tried, or shown as not tried."""
    from arenite import _bases, _recipes

    placed = {name for names in report.GROUPS.values() for name in names.split()}
    default = {"ConstantFriction", "ConstantStiffness", "ForgetsOpening", "NoAntiLocking"}
    kinds = tuple(getattr(_bases, name) for name in ("Law", "Policy", "Contact") if hasattr(_bases, name))
    of_kinds = {n for n, c in vars(_recipes).items() if isinstance(c, type) and c not in kinds and issubclass(c, kinds)}
    assert of_kinds - default - {"Law", "Policy", "Contact", "Part", "Frictional"} <= placed, of_kinds - placed
