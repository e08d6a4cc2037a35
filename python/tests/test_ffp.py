"""The penetrometer from Python: laws of motion and closed forms first, then the program's options, files and words.

Coarse cells, so that all takes seconds. Without the program arenite-ffp all is skipped: ARENITE_FFP names it.
"""

import csv
import gc
import inspect
import json
import os
import re
import signal
import subprocess
import sys
import time
import warnings
from pathlib import Path

import numpy
import pytest

from arenite import ffp
from arenite._errors import Error, RunError
from arenite._folder import Folder
from arenite.ffp import Columns, _driver, _words
from arenite.ffp._mean import moving_mean

try:
    DRIVER = os.fspath(_driver.program())
except Error as problem:
    pytest.skip(f"no driver: {problem}", allow_module_level=True)

GRAVITY = 9.81
COARSE = {"cell": 0.04, "points_per_element": 10, "fields_every": 0}
SHORT = {**COARSE, "end": 0.01}
SOURCE = Path(__file__).resolve().parents[2]

pytestmark = [pytest.mark.filterwarnings("ignore:t = .*energy_gain"),  # such coarse cells let some energy in,
              pytest.mark.filterwarnings("ignore:--cell = .* is coarser than an eighth")]  # and are told to be coarse
PROFILE = [(0, 0), (0.03, 0.05), {"to": (0.035, 0.06), "arc": 0.02}, (0.035, 0.4)]


@pytest.fixture(scope="module")
def coarse():
    return ffp.drop(**COARSE)


def program(*words):
    """What the program itself says: exit code and both of its streams."""
    done = subprocess.run([DRIVER, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8")
    if "was built without CLI11" in done.stdout:
        pytest.skip("the program reads no typed options")
    return done.returncode, done.stdout


# The numbers

def test_history_obeys_newton(coarse):
    h, mass = coarse.history, 7.71
    assert h["velocity_m_s"][0] == 5.6
    step = numpy.diff(h["time_s"])
    numpy.testing.assert_allclose(h["reaction_N"][1:], mass * (h["acceleration_m_s2"][1:] + GRAVITY), atol=1e-6 * mass * GRAVITY)
    numpy.testing.assert_allclose(h["velocity_m_s"], 5.6 - numpy.append(0, numpy.cumsum(h["acceleration_m_s2"][1:] * step)), atol=1e-9)
    numpy.testing.assert_allclose(h["penetration_m"], numpy.append(0, numpy.cumsum(h["velocity_m_s"][1:] * step)), atol=1e-9)
    put_in = h["kinetic_energy_J"][0] + abs(h["external_work_J"][-1])
    assert abs(h["energy_residual_J"][-1]) < 0.05 * put_in
    assert h["kinetic_energy_J"][0] == pytest.approx(0.5 * mass * 5.6**2)


def test_history_is_the_file(coarse):
    with open(coarse.folder / "history.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert list(coarse.history) == list(rows[0])
    for name, values in coarse.history.items():
        assert values.dtype == float and values.shape == (len(rows),) == (coarse.summary["steps"] + 1,)
        numpy.testing.assert_array_equal(values, [float(row[name] or "nan") for row in rows])
    assert numpy.isnan(coarse.history["fill_ratio"][0])  # an empty field
    assert numpy.shares_memory(coarse.history["time_s"], coarse.history["time_s"]), "the file is read once"
    with pytest.raises(KeyError, match="depth: no such column; there are time_s, "):
        coarse.history["depth"]


def test_mean_of_closed_forms():
    time = numpy.cumsum(numpy.append(0, numpy.random.default_rng(1).uniform(1e-5, 3e-4, 500)))
    numpy.testing.assert_allclose(moving_mean(time, numpy.full(len(time), 3.0)), 3, rtol=1e-12)
    # 1 from the row behind t0 on: within the window the share of it behind t0.
    t0 = time[250]
    expected = numpy.clip((time + 1e-3 - t0) / 2e-3, 0, 1)
    inner = (time > 1e-3) & (time < time[-1] - 1e-3)
    numpy.testing.assert_allclose(moving_mean(time, (time > t0).astype(float))[inner], expected[inner], atol=1e-9)


def test_peak_of_the_picture_is_that_of_the_summary():
    drop = ffp.drop(cell=0.04, tip="blunt", end=0.02, fields_every=0)
    peak = moving_mean(drop.history["time_s"], drop.history["acceleration_m_s2"]).max() / GRAVITY
    assert peak == pytest.approx(drop.summary["peak_deceleration_g"], rel=1e-9)


def test_paper_within_the_error_bar():
    drop = ffp.drop(delta=20, accuracy="coarse", fields_every=0, error_bar=True)
    assert (drop.summary["inputs"]["cell_m"], drop.summary["inputs"]["courant"]) == (0.02, 0.9)
    for name, paper in (("final_penetration_m", 0.20), ("peak_deceleration_g", 17)):
        bar = drop.uncertainty[name]
        assert bar["value"] == drop.summary[name]
        assert 0 < bar["u"] < paper and abs(bar["value"] - paper) <= bar["u"]
    depth = drop.uncertainty["final_penetration_m"]
    assert f"{depth['value']:.3f} +- {depth['u']:.3f} m" in repr(drop)


def free_fall_record(path, height=1.6, slowing=15 * GRAVITY, rate=20000):
    """A fall from rest over `height`, m, then constant net deceleration to rest; returns what it comes to."""
    velocity = (2 * GRAVITY * height) ** 0.5
    fall, stop = velocity / GRAVITY, velocity / slowing
    time = numpy.arange(0, 0.1 + fall + stop + 0.05, 1 / rate)
    net = numpy.where(time < 0.1, 0, numpy.where(time < 0.1 + fall, -GRAVITY, numpy.where(time < 0.1 + fall + stop, slowing, 0)))
    with open(path, "w") as file:
        file.write("t [ms],deceleration [g]\n")
        for row in zip(time * 1e3, net / GRAVITY):
            file.write("{:.6f},{:.9f}\n".format(*row))
    return {"velocity": velocity, "depth": velocity**2 / (2 * slowing), "stop": stop, "impact": 0.1 + fall}


FLAT = "ignore:the record stays at its largest"  # a constant deceleration, whose closed form is simple


@pytest.mark.filterwarnings(FLAT)
def test_reduce_of_a_fall_with_a_closed_form(tmp_path):
    exact = free_fall_record(tmp_path / "measured.csv")
    found = ffp.reduce(tmp_path / "measured.csv", mass=7.71, unit_weight=15100)
    assert found["impact_velocity_m_s"] == pytest.approx(exact["velocity"], rel=2e-3)  # sqrt(2 g h)
    assert found["impact_time_s"] == pytest.approx(exact["impact"], abs=2e-4)
    assert found["depth_cm"] == pytest.approx(exact["depth"] * 100, rel=5e-3)
    assert found["peak_deceleration_g"] == pytest.approx(15, rel=1e-6)
    # m (a + g) over the area of the base, 8.75 cm wide: the cone is all in.
    deep = found.table["depth_m"] > 0.09
    steady = deep & (found.table["velocity_m_s"] > 0.5)
    resistance = 7.71 * 16 * GRAVITY / (numpy.pi * 0.04375**2) / 1e3
    assert steady.any()
    numpy.testing.assert_allclose(found.table["q_dyn_projected_kPa"][steady], resistance, rtol=1e-6)
    firmness = found.estimates["firmness factor"]  # a_max / (g t_p v_i)
    assert firmness["value"] == pytest.approx(15 / (exact["stop"] * exact["velocity"]), rel=1e-2)
    assert "Mulukutla" in firmness["source"] and firmness["unit"] == "1/m" and firmness["range"]
    assert "firmness factor" in repr(found) and "Mulukutla" in repr(found)
    assert not list(tmp_path.glob("reduced*")), "nothing is written beside a measured record"


@pytest.mark.filterwarnings(FLAT)
def test_reduce_of_columns_that_are_told(tmp_path):
    exact = free_fall_record(tmp_path / "measured.csv")
    net = numpy.loadtxt(tmp_path / "measured.csv", delimiter=",", skiprows=1)[:, 1]
    axes = numpy.outer(net + 1, (2 / 7, 3 / 7, 6 / 7))  # a direction of length 1
    numpy.savetxt(tmp_path / "axes.csv", axes, fmt="%.9f", delimiter=",", header='"a, x",ay,az', comments="")
    for column in (("a, x", "ay", "az"), (1, 2, 3)):
        found = ffp.reduce(tmp_path / "axes.csv", column=column, reads="proper", rate=20000, deceleration_unit="g")
        assert found["impact_velocity_m_s"] == pytest.approx(exact["velocity"], rel=2e-3)
        assert found["depth_cm"] == pytest.approx(exact["depth"] * 100, rel=5e-3)
        assert "the magnitude of a, x, ay, az" in found["notes"][0]
    with pytest.raises(Error, match="^--column = ax: .*axes.csv has no such column; its columns: a, x, ay, az$"):
        ffp.reduce(tmp_path / "axes.csv", column="ax", rate=20000)
    numpy.savetxt(tmp_path / "two.csv", numpy.concatenate([net, net]), header="deceleration_g", comments="")
    with pytest.raises(Error, match=r"holds 2 drops; give --drop N, or --impact-time:\n  drop 1 at 0.67.*\n  drop 2 at 1.4"):
        ffp.reduce(tmp_path / "two.csv", rate=20000)


@pytest.mark.parametrize("text, sentence", [
    ("a,b\n0,1\n0,1,5\n", r"line 3, number of fields = 3: must be 2, as in the header"), ("a,b\n0\n", "line 2, number of fields = 1"),
    ("a;b\n0,5;1\n", "line 2, number of fields = 2: must be 1"), ("a,b\n0,x\n", "must be a table of numbers"),
    ("a,b\n".encode("utf-16"), "must be text in UTF-8")], ids=range(5))
def test_columns_of_a_table_that_is_none(text, sentence, tmp_path):
    (tmp_path / "history.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(Error, match=sentence):
        Columns(Folder(tmp_path), "history.csv")["a"]


def test_reduce_takes_a_drop_and_its_options(coarse, tmp_path):
    own = coarse.reduction
    again = ffp.reduce(coarse, out=tmp_path / "r")
    assert dict(again) == dict(own) and again.folder == tmp_path / "r" and (tmp_path / "r" / "reduced.csv").exists()
    assert own["depth_cm"] == pytest.approx(coarse.summary["max_penetration_m"] * 100, rel=5e-3)
    heavy = ffp.reduce(coarse, mass=2 * 7.71)
    numpy.testing.assert_allclose(heavy.table["q_dyn_mantle_kPa"], 2 * own.table["q_dyn_mantle_kPa"])
    with pytest.raises(Error, match=r"FILE = nowhere.csv: there is no such file or folder$"):
        ffp.reduce("nowhere.csv")
    with pytest.raises(Error, match="^--window = 5: must lie in"):
        ffp.reduce(coarse, window=5)


def test_reduce_warns_of_an_offset(tmp_path):
    time = numpy.arange(0, 1.5, 5e-4)
    net = numpy.where(time < 0.4, 0, -1) + numpy.where(time < 0.9, 0, 1 + 8 * numpy.sin(numpy.pi * numpy.clip(time - 0.9, 0, 0.1) / 0.1))
    record = tmp_path / "off.csv"
    record.write_text("Zeit [s];Acceleration [g]\n" + "".join(f"{t:.4f};{a:.4f}\n" for t, a in zip(time, net + 0.05)).replace(".", ","))
    with pytest.warns(UserWarning, match=r"is off by 0.05 g at rest before the release: with that taken off \(--zero-at-rest\)"):
        found = ffp.reduce(record)
    assert found["warnings"][0] in repr(found)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        taken = ffp.record(record, zero_at_rest=True)
    assert taken.reduction["depth_cm"] == found["depth_without_offset_cm"] > found["depth_cm"]


@pytest.mark.filterwarnings(FLAT)
def test_record_of_the_probe(tmp_path):
    exact = free_fall_record(tmp_path / "m.csv", rate=2000)
    with open(tmp_path / "m.csv") as file:
        g = numpy.array([float(row["deceleration [g]"]) for row in csv.DictReader(file)])
    rows = numpy.zeros((120000, 10), dtype=">i4")  # 60 s at 2 kHz
    rows[20000:20000 + len(g), 3] = rows[20000:20000 + len(g), 2] = numpy.round(g * 1e5)
    rows[:, 2] = numpy.clip(rows[:, 2], None, 2 * 10**5)  # 15 g clips the one of 2 g
    (tmp_path / "bLog07.bin").write_bytes(rows.view("u1").reshape(-1, 4)[:, 1:].tobytes())
    measured = ffp.record(tmp_path / "bLog07.bin", scale={"2g": 1e5, "18g": 1e5})
    assert measured.name == "bLog07.bin"
    # At 2 kHz the sharp edges leave some velocity at rest, which goes on moving it.
    assert numpy.interp(exact["stop"], measured["time_s"], measured["depth_m"]) == pytest.approx(exact["depth"], rel=2e-2)
    assert measured["velocity_m_s"][0] == pytest.approx(exact["velocity"], rel=1e-2)
    assert measured["time_s"][0] == 0
    assert list(measured) == ["time_s", "depth_m", "velocity_m_s", "deceleration_g", "filtered_deceleration_g"]
    assert any("18g" in note for note in measured.reduction["notes"])


# Options

def listed_options(command):
    """[(option, what it takes, its help)], of the program's help: "--delta", "DEG", ".. in [0, 60] deg (default 20)"."""
    text = re.sub(r"\n {30,}", "  ", program(command, "--help")[1])
    return re.findall(r"^  (--[\w-]+)(?: ([^\s]+))?  +(.*)$", text, re.M)


def values_of(takes, text):
    """Values that an option takes."""
    if not takes:
        return [True]
    if "|" in takes:
        return [*takes.split("|"), *([True, False] if takes == "on|off" else [])]
    limits = re.search(r"in [\[(](\S+), (\S+)[\])]", text)
    default = re.search(r"\(default ([-\d.e+]+)\)", text)
    number = default or limits
    return [float(number[1 if default else 2].rstrip(",")) if number else 28 if takes == "N" else "name"]


@pytest.mark.parametrize("command, count", [("drop", 63), ("reduce", 33)])
def test_every_option_is_a_keyword(command, count, coarse, tmp_path):
    options = [one for one in listed_options(command) if one[0] != "--version"]
    assert len(options) >= count
    files = {"input": tmp_path / "inputs.json", "device_file": tmp_path / "device.json"}
    files["input"].write_text("{}")
    files["device_file"].write_text(json.dumps({"name": "cone", "profile": [[0, 0], [0.03, 0.05], [0.03, 0.4]]}))
    run = {"drop": lambda **told: ffp.drop(**told), "reduce": lambda **told: ffp.reduce(coarse, **told)}[command]
    # The words are read before any limit is looked at: what is told is only the limit of another option.
    last, wrong, limit = ("threads", -1, "[0, 1024]") if command == "drop" else ("k0", -1, "[0, 3]")
    for option, takes, text in options:
        keyword = option[2:].replace("-", "_")
        for value in [files[keyword]] if keyword in files else values_of(takes, text):
            with pytest.raises(Error) as caught:
                run(**{"out": tmp_path / "o", keyword: value, last: wrong})
            expected = f"--{last} = {wrong}: must lie in {limit}"
            assert str(caught.value) == expected, f"{option} {value}"
    assert not (tmp_path / "o" / "history.csv").exists()


def test_options_reach_the_drop():
    told = {"velocity": numpy.float64(6.123456789012345), "tip": "cone-truncated", "mass": 8, "shoulder": "fillet", "fillet": 0.02,
            "delta": numpy.int64(30), "friction": 38.5, "dilatancy": 5, "cohesion": 100.0, "young": 4e6, "poisson": 0.3,
            "unit_weight": 16000, "k0": 0.4, "contact_offset": -0.001, "cell": 0.04, "moving_depth": 0.08, "points_per_element": 9,
            "anti_locking": False, "flip": 0.99, "courant": 0.4, "end": 1e-3, "fields_every": 0, "no_slip": True, "mesh": None}
    inputs = ffp.drop(**told).summary["inputs"]
    units = {"velocity": "m_s", "mass": "kg", "fillet": "m", "delta": "deg", "friction": "deg", "dilatancy": "deg", "cohesion": "Pa",
             "young": "Pa", "unit_weight": "N_m3", "contact_offset": "m", "cell": "m", "moving_depth": "m", "end": "s", "fields_every": "s"}
    for name, value in told.items():
        key = f"{name}_{units[name]}" if name in units else name
        assert inputs[key] == {"anti_locking": "off", "mesh": "generated"}.get(name, value), name


def test_device_reaches_drop_reduction_and_sweep(tmp_path):
    small = ffp.Device(diameter=0.05, length=0.4, cone_angle=90, mass=3)
    drop = ffp.drop(penetrometer=small, accuracy="coarse", end=2e-3, fields_every=0, out=tmp_path / "small")
    assert {name: drop.summary["penetrometer"][name] for name in ("name", "diameter_m", "length_m", "cone_angle_deg", "mass_kg")} == {
        "name": "bluedrop, cone, changed", "diameter_m": 0.05, "length_m": 0.4, "cone_angle_deg": 90, "mass_kg": 3}
    assert drop.summary["inputs"]["cell_m"] == pytest.approx(0.02 * 0.05 / 0.0875, rel=1e-12)
    with pytest.raises(Error, match="^mass = 4: is given beside the penetrometer, which has its own"):
        ffp.drop(penetrometer=small, mass=4)

    drawn = ffp.Device(name="drawn", source="drawing 12", profile=PROFILE, mass=3.2, gyration=0.11)
    same = {"name": "drawn", "source": "drawing 12", "profile": [[0, 0], [0.03, 0.05], {"to": [0.035, 0.06], "arc": 0.02}, [0.035, 0.4]],
            "mass_kg": 3.2, "gyration_m": 0.11}
    table = ffp.sweep(penetrometer=[small, drawn], accuracy="coarse", end=2e-3, out=tmp_path / "swept")
    assert table.drops[1].summary["inputs"]["device_profile"] == same
    assert [drop.status for drop in table.drops] == ["done", "done"]
    numpy.testing.assert_array_equal(table.drops[0].history["velocity_m_s"], drop.history["velocity_m_s"])

    time, net = numpy.arange(0, 1.6, 1e-3), -GRAVITY  # 0.5 s of fall, then 49.05 m/s2 until it rests
    (tmp_path / "record.csv").write_text("time_s,deceleration_m_s2\n" + "".join(
        f"{t:.3f},{0 if t < 0.5 or t > 1.1 else net if t < 1 else 49.05}\n" for t in time))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        q = {name: ffp.reduce(tmp_path / "record.csv", penetrometer=device, from_depth=0) for name, device in (("small", small), ("drawn", drawn))}
    assert q["drawn"]["penetrometer"]["diameter_m"] == 0.07
    found = {name: numpy.median(one.table["q_dyn_projected_kPa"][40:80]) for name, one in q.items()}  # the whole section is in
    assert found["drawn"] / found["small"] == pytest.approx(3.2 / 3 * (0.05 / 0.07) ** 2, rel=1e-9)


@pytest.mark.parametrize("told, sentence", [
    ({"gyration": 0.1}, "Device.gyration = 0.1: goes with a profile"),
    ({"profile": PROFILE, "tip": "blunt"}, "Device.tip = 'blunt': goes without a profile"),
    ({"profile": [(0, 0), 3]}, "Device.profile: must be points (radius, height) in m"),
    ({"profile": [(0, 0), (0.03, 0.05), (0.03, 0.4)]}, "--mass: must be given for a profile"),
    ({"penetrometer": "tube"}, "--penetrometer = tube: must be bluedrop or cone-10cm2"),
    ({"diameter": 0.05, "length": 0.4, "mass": 0.01}, "--mass = 0.01: must give a mean density in"),
])
def test_devices_that_are_none(told, sentence):
    with pytest.raises(Error, match=re.escape(sentence)):
        ffp.drop(penetrometer=ffp.Device(**told))


def test_values():
    assert _words.values_of("drop", {"error_bar": True, "force": False, "no_watch": numpy.True_}) == {
        "error_bar": True, "force": False, "no_watch": True}
    assert _words.values_of("drop", {"cell_at_cone": 1e-3, "contact_offset": -0.005, "young": 5e6, "delta": None}) == {
        "cell_at_cone": "0.001", "contact_offset": "-0.005", "young": "5000000"}
    assert _words.values_of("reduce", {"scale": {"2g": 1.62e6, "18g": 1.6e5}}) == {"scale": "2g=1620000,18g=160000"}
    assert _words.values_of("drop", {"mesh": Path("a") / "b.msh"}) == {"mesh": "a/b.msh"}
    assert _words.values_of("reduce", {"column": ("a, x", "ay", 3)}) == {"column": '"a, x",ay,3'}


def test_on_and_off(tmp_path):
    for given in (False, "off"):
        assert ffp.drop(out=tmp_path, anti_locking=given, **SHORT).summary["inputs"]["anti_locking"] == "off"
    assert ffp.drop(anti_locking=True, **SHORT).summary["inputs"]["anti_locking"] == "on"


def values(given):
    """What the program says to values on its standard input."""
    text = given if isinstance(given, str) else json.dumps(given)
    done = subprocess.run([DRIVER, "values"], input=text, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8")
    return done.returncode, done.stdout


@pytest.mark.parametrize("given, sentence", [
    ("", "values: is no JSON"), ("[" * 200000, "values: is nested deeper than 64 levels"), ([], "values = []: must be an object"),
    ({}, "command: must be drop, push, reduce or paper, not nothing"), ({"command": 1}, "values = command: must be a text"),
    ({"command": "drop", "options": []}, "values = options: must be an object"),
    ({"command": "drop", "options": {"delta": "x"}}, "--delta = x: must be a number"),
    ({"command": "drop", "options": {"delta": [1]}}, "--delta = [1]: must be a number, a text, true or false"),
    ({"command": "drop", "options": {"delta": 61}}, "--delta = 61: must lie in [0, 60] deg"),
    ({"command": "drop", "options": {"threads": 1.5}}, "--threads = 1.5: must be a whole number"),
    ({"command": "drop", "options": {"quiet": "yes"}}, "--quiet = yes: takes no value"),
    ({"command": "drop", "options": {"input": "absent.json"}}, "--input = absent.json: no such file"),
    ({"command": "paper", "options": {"delta": 20}}, "--delta=20: no such option of paper"),
    ({"command": "reduce"}, "FILE = (none): must be given")], ids=range(14))
def test_values_are_checked(given, sentence):
    code, text = values(given)
    assert code == 2 and text.startswith(f"arenite-ffp: {sentence}")


def test_values_win_over_those_of_a_file(tmp_path):
    (tmp_path / "case.json").write_text(json.dumps({"delta_deg": 30, "cohesion_Pa": 100}))
    inputs = ffp.drop(input=tmp_path / "case.json", delta=25, **SHORT).summary["inputs"]
    assert (inputs["delta_deg"], inputs["cohesion_Pa"]) == (25, 100)


@pytest.mark.parametrize("told, words", [
    ({"delta": 61}, ["--delta=61"]), ({"delta": "rough"}, ["--delta=rough"]), ({"delta": True}, ["--delta=true"]),
    ({"delta": [20, 30]}, ["--delta=20,30"]), ({"tip": "round"}, ["--tip=round"]), ({"error_bar": 1}, ["--error-bar=1"]),
    ({"cell": float("nan")}, ["--cell=nan"]), ({"dilatancy": 50}, ["--dilatancy=50"]), ({"mesh": ""}, ["--mesh="])])
def test_wrong_options_are_told_in_the_programs_words(told, words, tmp_path):
    code, text = program("drop", *words, "--out", str(tmp_path / "a"))
    assert code == 2
    with pytest.raises(Error) as caught:
        ffp.drop(**told)
    assert f"arenite-ffp: {caught.value}\n" == text and not isinstance(caught.value, RunError)


def test_help_is_the_programs():
    for command in ("drop", "push", "reduce"):
        text = ffp.help(command)
        typed = re.findall(r"^  --([a-z0-9-]+)", program(command, "--help")[1], re.MULTILINE)
        listed = re.findall(r"^  ([a-z0-9_]+)=", text, re.MULTILINE)
        assert set(typed) - {"version", "help", "input"} == {name.replace("_", "-") for name in listed} and repr(text) == text
        assert text in ffp.help()
    assert "  delta=DEG\n      Angle of friction between sand and penetrometer, in [0, 60] deg (default 20)\n" in ffp.help("drop")
    with pytest.raises(Error, match="^command: must be drop, push, reduce or paper, not dorp"):
        ffp.help("dorp")
    with pytest.raises(Error, match="^--help: is no option of a run"):
        ffp.drop(help=True)


# A drop and its folder

def test_temporary_folder_goes_with_the_last_that_reads_it():
    drop = ffp.drop(**SHORT)
    folder, history = drop.folder, drop.history
    del drop
    gc.collect()
    assert history["time_s"][-1] == pytest.approx(0.01)  # read only now
    del history
    gc.collect()
    assert not folder.exists()


def test_finished_drop_is_read_again(tmp_path):
    out = tmp_path / "one"
    first = ffp.drop(out=out, **SHORT)
    written = (out / "history.csv").stat().st_mtime_ns
    again = ffp.drop(out=out, **SHORT, threads=1)
    assert (out / "history.csv").stat().st_mtime_ns == written and again.summary == first.summary
    ffp.drop(out=out, **SHORT, resume=False)
    assert (out / "history.csv").stat().st_mtime_ns != written
    with pytest.raises(Error, match="^--resume: .*: is of a run with other inputs: delta_deg is 20.* there, 30.* here"):
        ffp.drop(out=out, **SHORT, delta=30, resume=True)
    assert ffp.drop(out=out, **SHORT, delta=30).summary["inputs"]["delta_deg"] == 30
    read = ffp.Drop(out)
    assert read.summary["inputs"]["delta_deg"] == 30 and repr(read).startswith(f"Drop('{out}'): done") and read.options == {}
    with pytest.raises(Error, match="must be the folder of a drop, with its summary.json"):
        ffp.Drop(tmp_path)


def test_files_that_are_none(tmp_path):
    os.mkfifo(tmp_path / "summary.json")  # nobody writes to it: to open it would wait without end
    with pytest.raises(Error, match="summary.json: must be a regular file, not a pipe or a device"):
        ffp.Drop(tmp_path)
    (tmp_path / "summary.json").unlink()
    (tmp_path / "summary.json").write_text("[" * 200000)
    with pytest.raises(Error, match="summary.json: is nested too deeply"):
        ffp.Drop(tmp_path)
    with open(tmp_path / "summary.json", "w") as file:
        file.truncate(40 << 30)  # without blocks on the disk
    with pytest.raises(Error, match="has 42949672960 bytes; must have at most"):
        ffp.Drop(tmp_path)
    with pytest.raises(Error, match="must be the folder of a drop"):
        ffp.Drop(tmp_path / "absent")


def test_reduction_of_a_drop_without_its_end(tmp_path):
    done = ffp.drop(out=tmp_path / "a", **SHORT)
    summary = json.loads((done.folder / "summary.json").read_text())
    (done.folder / "summary.json").write_text(json.dumps({**summary, "status": "running"}))
    with pytest.raises(Error, match="status = running: must be done"):
        ffp.reduce(done)


def test_same_bits_as_the_program(tmp_path):
    drop = ffp.drop(out=tmp_path / "a", **SHORT)
    assert program("drop", "--cell", "0.04", "--points-per-element", "10", "--fields-every", "0", "--end", "0.01", "--quiet", "--out",
                   str(tmp_path / "b"))[0] == 0
    assert (tmp_path / "a" / "history.csv").read_bytes() == (tmp_path / "b" / "history.csv").read_bytes()
    assert drop.summary["inputs_hash"] == json.loads((tmp_path / "b" / "summary.json").read_text())["inputs_hash"]


def test_drop_that_fails(tmp_path):
    with pytest.raises(RunError, match="^the run failed: t = .*volume"):
        ffp.drop(out=tmp_path, watch_volume=1e-5, **COARSE)
    failed = ffp.Drop(tmp_path)
    assert failed.status == "failed" and "volume" in failed.failure and failed.history["time_s"][-1] < 0.1
    assert "failed, t = " in repr(failed)


def test_warnings_are_issued():
    with pytest.warns(UserWarning, match="volume") as caught:
        drop = ffp.drop(watch_volume=1e-3, **SHORT)
    assert [str(one.message) for one in caught] == drop.summary["warnings"]
    assert caught[0].filename == __file__


def test_short_drop_has_no_reduction():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        drop = ffp.drop(accuracy="coarse", fields_every=0, end=1e-5)
    assert (drop.reduction is None) == (not (drop.folder / "reduced.json").exists())
    assert drop.uncertainty is None


def test_repr(coarse):
    text = repr(coarse)
    assert text.startswith("Drop(cell=0.04, points_per_element=10, fields_every=0): done\n")
    assert f"{coarse.summary['final_penetration_m']:.4g} m at 100 ms" in text
    assert f"{coarse.summary['peak_deceleration_g']:.4g} g at" in text


def test_progress_only_if_asked_for(capfd):
    ffp.drop(**SHORT)
    assert capfd.readouterr() == ("", "")
    ffp.drop(**SHORT, quiet=False)
    out, err = capfd.readouterr()
    assert out == "" and "100.0 %" in err and "steps of" in err


def test_ctrl_c_stops_the_program(tmp_path):
    code = ("import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
            f"from arenite import ffp; ffp.drop(out={str(tmp_path / 'a')!r}, cell=0.01, end=5, fields_every=0)")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    child = subprocess.Popen([sys.executable, "-c", code], env=environment, stderr=subprocess.PIPE, encoding="utf-8",
                             start_new_session=True)
    history = tmp_path / "a" / "history.csv"
    until = time.monotonic() + 30
    while not (history.exists() and history.stat().st_size > 0) and time.monotonic() < until and child.poll() is None:
        time.sleep(0.02)
    os.kill(child.pid, signal.SIGINT)
    assert "KeyboardInterrupt" in child.communicate(timeout=30)[1]
    stopped = ffp.Drop(tmp_path / "a")
    assert stopped.status == "interrupted"
    with pytest.raises(ProcessLookupError):
        os.kill(stopped.summary["process_id"], 0)


def test_where_the_program_is_looked_for(tmp_path, monkeypatch):
    monkeypatch.setenv("ARENITE_FFP", str(tmp_path / "none"))
    with pytest.raises(Error, match=r"^ARENITE_FFP = .*none: must be the path of the program arenite-ffp$"):
        ffp.drop()
    monkeypatch.delenv("ARENITE_FFP")
    monkeypatch.setattr(_driver, "__file__", str(tmp_path / "arenite" / "ffp" / "_driver.py"))
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(Error, match="set ARENITE_FFP to its path$"):
        ffp.drop()
    for folder in (tmp_path, tmp_path / "arenite" / "bin"):  # on PATH, then the package's own, which wins
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "arenite-ffp").write_text("#!/bin/sh\n")
        (folder / "arenite-ffp").chmod(0o755)
        assert _driver.program() == folder / "arenite-ffp"


# Sweeps

def test_sweep_is_its_drops(coarse):
    table = ffp.sweep(jobs=2, delta=range(20, 41, 20), tip=("cone", "blunt"), **COARSE)
    assert len(table) == 4 and [(row["delta"], row["tip"]) for row in table] == [(20, "cone"), (20, "blunt"), (40, "cone"), (40, "blunt")]
    assert list(table["status"]) == ["done"] * 4
    assert table["final_penetration_m"].dtype == float and table["delta"].dtype.kind == "i"
    assert table["final_penetration_m"][0] == coarse.summary["final_penetration_m"]  # to the bit, on any number of threads
    assert table["final_penetration_m"][2] < table["final_penetration_m"][0]  # rougher: less deep
    for row, drop in zip(table, table.drops):
        assert drop.options["tip"] == row["tip"] and drop.summary["inputs"]["delta_deg"] == row["delta"]
        assert row["peak_deceleration_g"] == drop.summary["peak_deceleration_g"]
        assert row["folder"] == str(drop.folder) and drop.folder.exists()
    assert "delta" in repr(table) and "blunt" in repr(table) and f"{table['final_penetration_m'][3]:.4g}" in repr(table)
    with pytest.raises(KeyError, match="depth: no such column; there are delta, tip, status"):
        table["depth"]


def test_sweep_goes_on(tmp_path, capfd):
    short = {**SHORT, "out": tmp_path}
    first = ffp.sweep(delta=[20, 30], **short)
    folders = {path.name: (path / "history.csv").stat().st_mtime_ns for path in tmp_path.iterdir()}
    assert set(folders) == {f"cell=0.04,delta={delta},end=0.01,fields_every=0,points_per_element=10" for delta in (20, 30)}
    for delta, folder in zip(first["delta"], first["folder"]):
        assert f",delta={delta}," in folder and ffp.Drop(folder).summary["inputs"]["delta_deg"] == delta
    more = ffp.sweep(delta=numpy.array([20, 25, 30]), quiet=False, **short)
    for name, written in folders.items():
        assert (tmp_path / name / "history.csv").stat().st_mtime_ns == written
    numpy.testing.assert_array_equal(more["final_penetration_m"][[0, 2]], first["final_penetration_m"])
    err = capfd.readouterr().err
    assert "3 of 3: delta=30: done, " in err and err.count("\n") == 3
    (tmp_path / "precious").write_text("precious")
    (tmp_path / "table.csv").symlink_to("precious")  # replaced, not followed
    more.to_csv(tmp_path / "table.csv")
    assert (tmp_path / "precious").read_text() == "precious" and not (tmp_path / "table.csv").is_symlink()
    with open(tmp_path / "table.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["final_penetration_m"]) for row in rows] == list(more["final_penetration_m"])
    assert list(rows[0]) == list(more.columns)


def test_sweep_outlives_its_failures():
    table = ffp.sweep(jobs=2, delta=[20, 70], watch_volume=[0.5, 1e-5], **COARSE)
    assert list(table["status"]) == ["done", "failed", "refused", "refused"]
    assert "volume" in table["failure"][1] and table["failure"][2] == "--delta = 70: must lie in [0, 60] deg" and table["failure"][0] == ""
    assert numpy.isnan(table["final_penetration_m"]).tolist() == [False, True, True, True]
    assert table.drops[1].history["time_s"][-1] < 0.1 and table.drops[2].status == "refused"
    with pytest.raises(Error, match=r"^--detla=20: no such option of drop; arenite.ffp.help\('drop'\) lists them$"):
        ffp.sweep(detla=[20, 30])
    with pytest.raises(Error, match="needs at least one value"):
        ffp.sweep(delta=[])
    with pytest.raises(Error, match="^jobs = 0: must be a whole number of at least 1"):
        ffp.sweep(jobs=0)


def test_folders_of_a_sweep_differ():
    from arenite.ffp._sweep import folder_names
    names = folder_names([{"mesh": "a/b", "threads": 1}, {"mesh": "a b"}, {"threads": 2}, {"mesh": "x" * 300}, {"mesh": "x" * 300 + "y"}])
    assert names[:3] == ["mesh=a-b", "mesh=a-b-2", "default"] and len(set(names)) == 5 and max(map(len, names)) < 200


def test_sweep_takes_the_error_bar():
    table = ffp.sweep(error_bar=[False, True], cell=0.02, points_per_element=4, end=0.004)
    assert numpy.isnan(table["u_final_penetration_m"][0])
    assert table["u_final_penetration_m"][1] == table.drops[1].uncertainty["final_penetration_m"]["u"]


# pandas, pictures, the notebook

def test_pandas(coarse):
    pandas = pytest.importorskip("pandas")
    frame = coarse.history.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame) == list(coarse.history)
    numpy.testing.assert_array_equal(frame["penetration_m"], coarse.history["penetration_m"])
    table = ffp.sweep(delta=[20, 30], **SHORT)
    frame = table.to_pandas()
    assert list(frame) == list(table.columns) and list(frame["delta"]) == [20, 30]


@pytest.mark.filterwarnings(FLAT)
def test_plot(coarse, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot
    exact = free_fall_record(tmp_path / "measured.csv")
    measured = ffp.record(tmp_path / "measured.csv")
    figure = coarse.plot(beside=measured)
    depth, deceleration = figure.axes
    numpy.testing.assert_allclose(depth.lines[0].get_xydata(),
                                  numpy.column_stack([coarse.history["time_s"] * 1e3, coarse.history["penetration_m"] * 100]))
    assert depth.lines[1].get_ydata().max() == pytest.approx(exact["depth"] * 100, rel=5e-3)
    assert [text.get_text() for text in depth.get_legend().get_texts()] == ["cell=0.04, points_per_element=10, fields_every=0",
                                                                          "measured.csv"]
    assert depth.get_ylabel() == "depth [cm]" and depth.yaxis_inverted() and "[g]" in deceleration.get_ylabel()
    assert numpy.nanmax(deceleration.lines[1].get_ydata()) == pytest.approx(coarse.summary["peak_deceleration_g"])
    own, axes = pyplot.subplots()
    assert coarse.plot(axes, beside=[coarse]) is own and len(axes.lines) == 2
    with pytest.raises(Error, match=r"^plot\.ax: must be"):
        coarse.plot("axes")
    pyplot.close("all")


def test_table_and_reduction_are_drawn(coarse):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    table = ffp.sweep(delta=[30, 20], tip=["cone", "blunt"], **{**COARSE, "end": 0.02})
    depth, peak = table.plot()
    assert (depth.get_xlabel(), depth.get_ylabel(), peak.get_ylabel()) == ("delta", "final_penetration_m", "peak_deceleration_g")
    names = [text.get_text() for text in depth.get_legend().get_texts()]
    assert names == ["tip = cone", "tip = blunt"]
    cone = depth.containers[0][0]
    assert cone.get_xdata().tolist() == [20, 30]  # ascending
    assert cone.get_ydata().tolist() == [table["final_penetration_m"][k] for k in (2, 0)]
    assert table.plot("delta", "steps", ax=depth) is depth
    with pytest.raises(Error, match="^plot: tip: must be a column of numbers; there are delta"):
        table.plot(y="tip")
    axes = ffp.reduce(coarse).plot()
    reduced = ffp.reduce(coarse)
    numpy.testing.assert_array_equal(axes.lines[0].get_xdata(), reduced.table["q_dyn_mantle_kPa"][:numpy.argmax(reduced.table["depth_m"]) + 1])
    assert axes.yaxis_inverted()
    assert ffp.reduce(coarse, medium="water").plot(axes) is axes and axes.get_ylabel() == "depth [cm]"
    with pytest.raises(Error, match=r"^plot\.ax: must be one pair"):
        reduced.plot("axes")
    pyplot.close("all")


def test_everything_says_what_it_is():
    for name in ffp.__all__:
        assert inspect.getdoc(getattr(ffp, name)), name


def test_notebook():
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    pytest.importorskip("matplotlib")
    path = SOURCE / "docs" / "notebooks" / "penetrometer.ipynb"
    if not path.exists():
        pytest.skip("the notebook is not beside the package")
    book = nbformat.read(path, 4)
    assert not any(cell.get("outputs") for cell in book.cells), "is stored without outputs"
    before = os.environ.get("PYTHONPATH")
    os.environ["PYTHONPATH"] = os.pathsep.join(sys.path)
    try:
        nbclient.NotebookClient(book, timeout=120).execute()
    finally:
        os.environ.pop("PYTHONPATH") if before is None else os.environ.update(PYTHONPATH=before)
    outputs = [output for cell in book.cells for output in cell.get("outputs", [])]
    assert sum("image/png" in output.get("data", {}) for output in outputs) == 3
    assert any("Table of 6 drops" in output.get("data", {}).get("text/plain", "") for output in outputs)


def test_pushes(tmp_path):
    told = {"cell": 0.0107, "chamber_radius": 0.25, "start_depth": 0.09, "distance": 0.04}
    pushed = ffp.push(**told, out=tmp_path / "a")
    assert pushed.status == "done" and pushed.failure == "" and pushed.uncertainty is None
    assert pushed.history["q_c_kPa"][-1] > 100 and (pushed.history["depth_m"][1:] > pushed.history["depth_m"][:-1]).all()
    assert pushed.summary["closed_forms"][0]["source"] == "Teh and Houlsby 1991"
    assert f"{pushed.summary['net_resistance_kPa']:.4g} kPa" in repr(pushed) and "Push(cell=0.0107" in repr(pushed)
    assert ffp.Push(tmp_path / "a").summary == pushed.summary and f"{tmp_path / 'a'}" == os.fspath(pushed)
    assert pushed.plot().axes[0].get_ylim()[0] > pushed.plot().axes[0].get_ylim()[1]  # depth downward
    again = ffp.push(**{**pushed.summary["inputs"], "threads": 1})
    assert (again.history["q_c_kPa"] == pushed.history["q_c_kPa"]).all()
    with pytest.raises(Error, match="^--cell = 1: must lie in"):
        ffp.push(cell=1)
    with pytest.raises(Error, match="must be the folder of a push"):
        ffp.Push(tmp_path)
