"""The driver arenite-ffp from outside: its files, its numbers, its words when something is wrong. Standard library only.

    driver.py ARENITE_FFP [unittest options]      writes into the working folder
"""

import csv
import json
import math
import os
import pty
import random
import resource
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest
import unittest.mock
import xml.etree.ElementTree as ElementTree

DRIVER = ""
GRAVITY = 9.81
COARSE = ["--cell", "0.04", "--points-per-element", "10"]
SLICE = ["--kinematics", "slice", "--cell", "0.04", "--points-per-element", "4", "--end", "0.004"]
GRID = ["--mesh-kind", "grid", "--cell", "0.04"]
SHORT = [*COARSE, "--end", "0.01", "--fields-every", "0"]
FIRST_COLUMNS = "time_s,penetration_m,velocity_m_s,acceleration_m_s2,reaction_N,"
KEYS = """final_penetration_m max_penetration_m peak_deceleration_g peak_time_s peak_penetration_m raw_peak_deceleration_g
    peak_reaction_N end_s version started process_id inputs_hash expected_steps warnings watch
    points steps dt_min_s dt_max_s wall_s point_steps_per_s threads register_bytes lost_points
    energy_transfer energy_walls energy_residual inputs status""".split()
INPUTS = """kinematics device velocity_m_s tip mass_kg shoulder fillet_m device_young_Pa device_poisson delta_deg no_slip
    friction_deg dilatancy_deg cohesion_Pa young_Pa poisson unit_weight_N_m3 law k0 contact contact_offset_m cell_m points_per_element
    moving_depth_m mesh mesh_kind anti_locking flip flip_time_s courant end_s fields_every_s""".split()


def drop(*options):
    """Runs `arenite-ffp drop OPTIONS`; returns exit code, standard output and standard error."""
    done = subprocess.run([DRIVER, "drop", *options], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    return done.returncode, done.stdout, done.stderr


def history(folder):
    """Columns of history.csv by name."""
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.reader(file))
    return {name: [float(row[i] or "nan") for row in rows[1:]] for i, name in enumerate(rows[0])}


def summary(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def content(folder, name="history.csv"):
    with open(os.path.join(folder, name), "rb") as file:
        return file.read()


def field_files(folder):
    """[(time, path)] of the series."""
    entries = ElementTree.parse(os.path.join(folder, "fields.pvd")).getroot().iter("DataSet")
    return [(float(e.get("timestep")), os.path.join(folder, e.get("file"))) for e in entries]


def vtu(path):
    """All arrays of one VTU file by name, each a flat tuple."""
    with open(path, "rb") as file:
        data = file.read()
    start = data.index(b"<AppendedData")
    first = data.index(b"_", start) + 1
    arrays = {}
    for array in ElementTree.fromstring(data[:start] + b"</VTKFile>").iter("DataArray"):
        code, width = {"Float64": ("d", 8), "Float32": ("f", 4), "Int32": ("i", 4), "UInt8": ("B", 1)}[array.get("type")]
        at = first + int(array.get("offset"))
        (size,) = struct.unpack_from("<Q", data, at)
        arrays[array.get("Name")] = struct.unpack_from(f"<{size // width}{code}", data, at + 8)
    return arrays


class Mesh:
    """The mesh of a run's first field file, with the node sets that its geometry gives."""

    def __init__(self, folder):
        arrays = vtu(os.path.join(folder, "fields_mesh_0000.vtu"))
        x = arrays.get("position") or arrays["Points"]
        self.nodes = [x[i : i + 3] for i in range(0, len(x), 3)]
        corners = arrays["offsets"][0]
        self.cells = [arrays["connectivity"][i : i + corners] for i in range(0, len(arrays["connectivity"]), corners)]
        self.region = arrays["region"]
        self.region_names = {"soil": 0, "air": 1, "device": 2}
        radius = [(a * a + c * c) ** 0.5 if corners == 4 else a for a, _, c in self.nodes]
        place = range(len(self.nodes))
        self.sets = {
            "bottom": [i for i in place if self.nodes[i][1] == -0.4],
            "wall": [i for i in place if abs(radius[i] - 0.4) < 1e-12],
        }
        if corners == 4:
            slope = 0.17632698070846498  # tangent of 10 degrees
            for name, side in (("side_minus", -slope), ("side_plus", slope)):
                self.sets[name] = [i for i in place if abs(self.nodes[i][2] - side * self.nodes[i][0]) < 1e-12]

    def write(self, path, version):
        """As Gmsh text, format 2.2 (cells in their order) or 4.1 (cells region by region)."""
        dimension, kind = (2, 2) if len(self.cells[0]) == 3 else (3, 4)
        names = [f'{dimension} {number + 1} "{name}"' for name, number in self.region_names.items()]
        names += [f'0 {k + 1} "{name}"' for k, name in enumerate(self.sets)]
        lines = ["$MeshFormat", f"{version} 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames"]
        points = [(k + 1, node + 1) for k, nodes in enumerate(self.sets.values()) for node in nodes]
        count = len(points) + len(self.cells)
        xyz = [" ".join(repr(c) for c in node) for node in self.nodes]
        cells = [" ".join(str(i + 1) for i in cell) for cell in self.cells]
        if version == "2.2":
            lines += ["$Nodes", str(len(xyz)), *(f"{i + 1} {x}" for i, x in enumerate(xyz)), "$EndNodes", "$Elements", str(count)]
            lines += [f"{n + 1} 15 2 {group} {group} {node}" for n, (group, node) in enumerate(points)]
            lines += [
                f"{len(points) + n + 1} {kind} 2 {self.region[n] + 1} {self.region[n] + 1} {cell}" for n, cell in enumerate(cells)
            ]
        else:
            regions = sorted(self.region_names.values())
            box = "-1 -1 -1 1 1 1"
            lines += ["$Entities", f"{len(self.sets)} 0 " + ("0 3" if dimension == 3 else "3 0")]
            lines += [f"{k + 1} 0 0 0 1 {k + 1}" for k in range(len(self.sets))]
            lines += [f"{r + 1} {box} 1 {r + 1} 0" for r in regions] + ["$EndEntities"]
            lines += ["$Nodes", f"1 {len(xyz)} 1 {len(xyz)}", f"{dimension} 1 0 {len(xyz)}"]
            lines += [*(str(i + 1) for i in range(len(xyz))), *xyz, "$EndNodes"]
            lines += ["$Elements", f"{len(self.sets) + len(regions)} {count} 1 {count}"]
            tag = 0
            blocks = [(0, k + 1, 15, [str(i + 1) for i in nodes]) for k, nodes in enumerate(self.sets.values())]
            blocks += [(dimension, r + 1, kind, [c for c, own in zip(cells, self.region) if own == r]) for r in regions]
            for dim, entity, element, members in blocks:
                lines.append(f"{dim} {entity} {element} {len(members)}")
                for member in members:
                    tag += 1
                    lines.append(f"{tag} {member}")
        with open(path, "w") as file:
            file.write("\n".join([*lines, "$EndElements", ""]))
        return path


class DriverTest(unittest.TestCase):
    def setUp(self):
        shutil.rmtree("refused", ignore_errors=True)  # of an earlier run that was not refused

    def run_drop(self, folder, *options):
        """A run that must succeed without a word but warnings, which the summary holds too."""
        code, out, err = drop("--quiet", "--out", folder, *options)
        self.assertEqual((code, out), (0, ""), err)
        found = summary(folder)
        self.assertEqual(err.splitlines(), ["arenite-ffp: warning: " + text for text in found["warnings"]])
        return history(folder), found

    def assert_refused(self, sentence, *options):
        """Exit code 2 and one line on standard error that begins with the sentence; nothing is written."""
        code, out, err = drop("--out", "refused", *options)
        self.assertEqual((code, out), (2, ""), err)
        self.assertEqual(err.count("\n"), 1, err)
        self.assertTrue(err.startswith("arenite-ffp: " + sentence), err)
        self.assertFalse(os.path.exists("refused"))

    def assert_consistent(self, columns, mass=7.71, velocity=5.6, balance=1e-9, residual=0.05):
        """What holds for any drop, whatever its numerics."""
        time, depth, speed = columns["time_s"], columns["penetration_m"], columns["velocity_m_s"]
        acceleration, reaction = columns["acceleration_m_s2"], columns["reaction_N"]
        self.assertEqual((time[0], depth[0], reaction[0]), (0, 0, 0))
        self.assertAlmostEqual(columns["mean_volume_ratio"][0], 1, delta=1e-12)
        self.assertAlmostEqual(speed[0], velocity, delta=1e-12)
        largest = max(abs(r) for r in reaction)
        self.assertGreater(largest, 100)
        for a, r in zip(acceleration, reaction):
            self.assertAlmostEqual(mass * (a + GRAVITY), r, delta=balance * largest)
        for i in range(1, len(time)):
            step = time[i] - time[i - 1]
            self.assertGreater(step, 0)
            self.assertAlmostEqual(columns["time_step_s"][i], step, delta=1e-12)
            self.assertAlmostEqual(depth[i] - depth[i - 1], speed[i] * step, delta=1e-12)
            self.assertAlmostEqual(speed[i - 1] - speed[i], acceleration[i] * step, delta=1e-9)
        put_in = columns["kinetic_energy_J"][0] + columns["external_work_J"][-1]
        self.assertAlmostEqual(columns["kinetic_energy_J"][0], mass / 2 * velocity**2, delta=1e-9)
        for name in ("plastic_work_J", "contact_dissipation_J"):
            self.assertGreater(columns[name][-1], 0)
        for i, left in enumerate(columns["energy_residual_J"]):
            kept = sum(columns[n][i] for n in ("kinetic_energy_J", "strain_energy_J", "plastic_work_J", "contact_dissipation_J",
                                                   "transfer_loss_J", "wall_loss_J"))
            # Without the strain energy at rest, which is not a column.
            start = columns["kinetic_energy_J"][0] + columns["strain_energy_J"][0]
            self.assertAlmostEqual(left, kept - start - columns["external_work_J"][i], delta=1e-8)
            self.assertLess(abs(left), residual * put_in)
        self.assertEqual(set(columns["lost_points"]), {0})

    def assert_readable(self, folder):
        """Whatever the moment at which a run was ended: each file is whole, but that the history may be young."""
        for name in os.listdir(folder):
            path = os.path.join(folder, name)
            if name.endswith(".vtu"):
                self.assertTrue(vtu(path))
            elif name == "fields.pvd":
                for _, file in field_files(folder):
                    self.assertTrue(os.path.exists(file), file)
            elif name == "history.csv":
                lines = content(folder).decode("ascii").split("\n")
                cut = lines.pop()  # empty, but when Linux cut the write of a row at the end of a memory page
                self.assertTrue(not cut or os.path.getsize(path) % resource.getpagesize() == 0, cut)
                self.assertEqual({line.count(",") for line in lines}, {17} if lines else set())
                self.assertNotIn("nan", "".join(lines))
            elif name in ("reduced.csv", "reduced.json"):
                self.assertTrue(content(folder, name).endswith(b"\n"))
            elif name == "summary.json":
                self.assertIn(summary(folder)["status"], ("running", "done", "failed", "interrupted", "disk-full"))
            else:
                self.assertTrue(name in (".arenite-ffp.lock", "checkpoint.state", "reduced.csv", "reduced.json", "reduced.svg") or name.endswith(".part"), name)

    def assert_summary(self, found, columns):
        for key in KEYS:
            self.assertIn(key, found)
        for key in INPUTS:
            self.assertIn(key, found["inputs"])
        self.assertEqual(found["status"], "done")
        self.assertEqual(found["final_penetration_m"], columns["penetration_m"][-1])
        self.assertEqual(found["max_penetration_m"], max(columns["penetration_m"]))
        self.assertEqual(found["steps"], len(columns["time_s"]) - 1)
        self.assertAlmostEqual(found["raw_peak_deceleration_g"], max(columns["acceleration_m_s2"]) / GRAVITY, delta=1e-9)
        self.assertAlmostEqual(found["dt_min_s"], min(columns["time_step_s"][1:]), delta=1e-12)
        self.assertAlmostEqual(found["dt_max_s"], max(columns["time_step_s"][1:]), delta=1e-12)
        rate = found["points"] * found["steps"] / found["wall_s"]
        self.assertAlmostEqual(found["point_steps_per_s"], rate, delta=1e-9 * rate)

    def assert_same_drop(self, a, b, share):
        """Two histories agree but for `share` of the largest value of each of the first columns."""
        for name in FIRST_COLUMNS.rstrip(",").split(","):
            largest = max(abs(x) for x in a[name])
            self.assertEqual(len(a[name]), len(b[name]))
            for x, y in zip(a[name], b[name]):
                self.assertAlmostEqual(x, y, delta=share * largest, msg=name)


class Drops(DriverTest):
    """Whole drops, coarse."""

    def test_rigid(self):
        columns, found = self.run_drop("rigid", *COARSE)
        self.assertTrue(content("rigid").startswith(FIRST_COLUMNS.encode()))
        self.assert_consistent(columns)
        self.assert_summary(found, columns)
        self.assertEqual(columns["time_s"][-1], 0.1)
        self.assertTrue(0.12 < found["final_penetration_m"] < 0.25)
        self.assertTrue(10 < found["peak_deceleration_g"] < 25)
        self.assertLess(abs(columns["velocity_m_s"][-1]), 0.2)
        self.assertTrue(all(0 < f < 1.2 for f in columns["fill_ratio"][1:] if f == f))
        files = field_files("rigid")
        self.assertEqual({round(time, 3) for time, _ in files}, {0, 0.02, 0.04, 0.06, 0.08, 0.1})
        self.assertEqual(len(files), 6 * 3)  # soil, mesh, device
        first, last = vtu("rigid/fields_soil_0000.vtu"), vtu("rigid/fields_soil_0005.vtu")
        self.assertEqual(len(first["deviatoric_strain"]), found["points"])
        self.assertEqual(max(first["deviatoric_strain"]), 0)
        self.assertGreater(max(last["deviatoric_strain"]), 0.3)
        self.assertEqual((len(last["stress"]), len(last["velocity"])), (6 * found["points"], 3 * found["points"]))
        device = vtu("rigid/fields_device_0005.vtu")
        tip = min(device["Points"][3 * i + 1] for i in device["connectivity"])
        self.assertAlmostEqual(tip, -found["final_penetration_m"], delta=1e-12)

    def test_more_friction_brakes_earlier(self):
        smooth = self.run_drop("delta20", *COARSE, "--fields-every", "0")[1]
        rough = self.run_drop("delta40", *COARSE, "--fields-every", "0", "--delta", "40")[1]
        self.assertLess(rough["final_penetration_m"], 0.95 * smooth["final_penetration_m"])
        self.assertFalse(os.path.exists("delta20/fields.pvd"))

    def test_tips(self):
        depths = {}
        for tip, mass in (("cone", 7.71), ("cone-truncated", 7.71), ("parabolic", 9.15), ("blunt", 10.3)):
            columns, found = self.run_drop("tip_" + tip, *COARSE, "--fields-every", "0", "--tip", tip)
            self.assert_consistent(columns, mass=mass)
            self.assertEqual((found["inputs"]["tip"], found["inputs"]["mass_kg"]), (tip, mass))
            depths[tip] = found["final_penetration_m"]
        self.assertLess(depths["blunt"], 0.9 * depths["cone"])

    def test_contact_offset(self):
        """The depth is that of the penetrometer's tip, whatever surface the sand meets."""
        columns, found = self.run_drop("offset", *SHORT, "--contact-offset", "-0.002")
        self.assertAlmostEqual(columns["penetration_m"][0], 0.004, delta=1e-12)
        self.assertEqual(found["inputs"]["contact_offset_m"], -0.002)
        self.assertEqual(found["device_outline_m"][1][0], 0.04375)

    def test_centre_of_mass(self):
        columns, found = self.run_drop("centre", *COARSE, "--contact", "centre-of-mass", "--fields-every", "0")
        self.assert_consistent(columns)
        self.assert_summary(found, columns)
        self.assertEqual(found["inputs"]["contact"], "centre-of-mass")

    def test_elastic(self):
        columns, found = self.run_drop("elastic", *COARSE, "--device", "elastic", "--fields-every", "0.05")
        self.assert_consistent(columns)
        self.assert_summary(found, columns)
        device = vtu("elastic/fields_device_points_0002.vtu")
        self.assertGreater(max(abs(s) for s in device["stress"]), 1)

    def test_laws(self):
        plain, _ = self.run_drop("law_plain", *COARSE, "--fields-every", "0")
        self.run_drop("law_off", *COARSE, "--fields-every", "0", "--law", "linear-rate", "--rate-time", "0")
        self.assertEqual(content("law_off"), content("law_plain"))  # a law without its term is Mohr-Coulomb, to the bit
        for law, options, stronger in (("linear-rate", [], True), ("mu-i", [], None), ("log-rate", [], True),
                                       ("softening", ["--residual-friction", "36"], False),
                                       ("softening-rate", ["--residual-friction", "36", "--dilatancy", "5"], None)):
            columns, found = self.run_drop("law_" + law, *COARSE, "--fields-every", "0.05", "--law", law, *options)
            self.assert_consistent(columns)
            self.assertEqual(found["inputs"]["law"], law)
            depth = found["final_penetration_m"] - plain["penetration_m"][-1]
            if stronger is None:  # so little, or stronger and weaker at once, that cells of 4 cm do not tell
                self.assertTrue(0 < abs(depth) < 0.01, law)
            else:
                self.assertGreater(-depth if stronger else depth, 1e-3, law)

    def test_refined(self):
        """Finer cells at the cone, into which points come that split."""
        columns, found = self.run_drop("refined", "--cell", "0.04", "--cell-at-cone", "0.015", "--points-per-element", "10",
                                       "--end", "0.03", "--fields-every", "0")
        self.assert_consistent(columns)
        self.assertEqual(found["inputs"]["split"], 9)
        self.assertGreater(found["point_steps_per_s"] * found["wall_s"], 1.01 * found["points"] * found["steps"])

    def test_points(self):
        """Depth and peak hardly depend on the number of points: cells that shear leaves short of points stay filled."""
        depth, peak = zip(*((columns["penetration_m"][-1], found["peak_deceleration_g"]) for columns, found in (
            self.run_drop(f"points_{n}", "--cell", "0.02", "--points-per-element", str(n), "--end", "0.04", "--fields-every", "0")
            for n in (9, 49))))
        self.assertLess(abs(depth[0] / depth[1] - 1), 0.015)  # 0.6 %; 5 % if only cells filled by 0.9 count
        self.assertLess(abs(peak[0] / peak[1] - 1), 0.03)  # 1 %; 10 %

    def test_grid(self):
        columns, found = self.run_drop("grid", *GRID, "--fields-every", "0.05")
        self.assert_consistent(columns, residual=0.01)
        self.assert_summary(found, columns)
        self.assertEqual([found["inputs"][key] for key in ("contact", "anti_locking", "flip_time_s")], ["points", "off", 0.1])
        self.assertTrue(0.1 < found["final_penetration_m"] < 0.25)
        self.assertTrue(0 <= found["deepest_point_m"] < 0.03 * 0.04)
        self.assertTrue(all(f != f for f in columns["fill_ratio"]))
        files = field_files("grid")
        self.assertEqual(len(files), 3)  # soil
        self.assertEqual(len(vtu(files[0][1])["deviatoric_strain"]), found["points"])

    def test_grid_rigid_and_law(self):
        plain, _ = self.run_drop("grid_nodes", *GRID, "--contact", "rigid", "--end", "0.03", "--fields-every", "0")
        self.assert_consistent(plain)
        columns, found = self.run_drop("grid_law", *GRID, "--contact", "rigid", "--end", "0.03", "--fields-every", "0",
                                       "--law", "linear-rate", "--rate-time", "5e-3")
        self.assert_consistent(columns)
        self.assertNotIn("deepest_point_m", found)
        self.assertLess(columns["penetration_m"][-1], plain["penetration_m"][-1] - 1e-3)

    def test_grid_refined(self):
        columns, found = self.run_drop("grid_refined", *GRID, "--cell-at-cone", "0.02", "--end", "0.03", "--fields-every", "0")
        self.assert_consistent(columns)
        self.assertGreater(found["point_steps_per_s"] * found["wall_s"], 1.01 * found["points"] * found["steps"])

    def test_slice_law(self):
        columns, found = self.run_drop("slice_law", *SLICE, "--law", "mu-i")
        self.assert_consistent(columns)
        self.assert_summary(found, columns)

    def test_slice(self):
        columns, found = self.run_drop("slice", *SLICE)
        self.assert_consistent(columns)
        self.assert_summary(found, columns)

    def test_elastic_slice(self):
        columns, found = self.run_drop("elastic_slice", *SLICE, "--device", "elastic")
        self.assert_consistent(columns)
        self.assert_summary(found, columns)


class SameBits(DriverTest):
    """The same input gives the same history, to the byte, whatever the number of threads."""

    def check(self, name, *options):
        for threads in (1, 2, 3):
            found = self.run_drop(f"{name}{threads}", *options, "--fields-every", "0", "--threads", str(threads))[1]
            self.assertEqual(found["threads"], threads)
            self.assertEqual(content(f"{name}{threads}"), content(f"{name}1"))

    def test_rigid(self):
        self.check("bits_rigid", *COARSE, "--end", "0.02")

    def test_refined(self):
        self.check("bits_refined", *COARSE, "--cell-at-cone", "0.02", "--end", "0.01")

    def test_grid(self):
        self.check("bits_grid", *GRID, "--cell-at-cone", "0.02", "--end", "0.01")

    def test_centre_of_mass(self):
        self.check("bits_centre", *COARSE, "--end", "0.01", "--contact", "centre-of-mass")

    def test_elastic(self):
        self.check("bits_elastic", *COARSE, "--end", "0.01", "--device", "elastic")

    def test_slice(self):
        self.check("bits_slice", *SLICE, "--end", "0.002")


class Mistakes(DriverTest):
    """Exit code 2 and one sentence."""

    def test_options(self):
        self.assert_refused("--poisson = 0.6: must lie in (-1, 0.5)\n", "--poisson", "0.6")
        self.assert_refused("--cell = abc: must be a number\n", "--cell", "abc")
        self.assert_refused("--device = soft: must be rigid or elastic\n", "--device", "soft")
        self.assert_refused("--points-per-element = 9: must be 1, 4, 10", "--kinematics", "slice", "--points-per-element", "9")
        self.assert_refused("--wings: no such option", "--wings", "2")
        self.assert_refused("--end = : needs a value\n", "--end")
        self.assert_refused("--cell-at-cone = 0.02: must not exceed --cell = 0.01 m\n", "--cell-at-cone", "0.02")
        self.assert_refused("--cell-at-cone = 0.005: needs --kinematics axisymmetric", "--cell-at-cone", "0.005", "--kinematics", "slice")
        self.assert_refused("--split = 9: needs --device rigid", "--cell-at-cone", "0.005", "--device", "elastic")
        self.assert_refused("--mesh-kind = grid: needs --kinematics axisymmetric, --device rigid", "--mesh-kind", "grid", "--device", "elastic")
        self.assert_refused("--contact = points: needs --mesh-kind grid", "--contact", "points")
        self.assert_refused("--split = 0.5: must be 0 or at least 1", "--split", "0.5")
        self.assert_refused("--law = mu-i: needs --device rigid", "--law", "mu-i", "--device", "elastic")
        self.assert_refused("--fields-every = 1e-300: must be 0, for none, or at least 0.0001 s", "--fields-every", "1e-300")

    def test_steps(self):
        """A run without end is told before it begins."""
        self.assert_refused("--courant = 1e-09: makes the run take about ", *COARSE, "--courant", "1e-9")
        self.assert_refused("--poisson = 0.499999999999: makes the run take about ", *COARSE, "--poisson", "0.499999999999")
        self.run_drop("sliver_of", *COARSE, "--end", "1e-5")
        sliver = Mesh("sliver_of")
        lowest = min(range(len(sliver.nodes)), key=lambda i: (sliver.nodes[i][1], sliver.nodes[i][0]))
        apart = next(cell for cell, own in zip(sliver.cells, sliver.region) if own == 0 and lowest in cell)
        a, b = (i for i in apart if i != lowest)
        # The corner of one cell nearly on the side across.
        sliver.nodes[lowest] = tuple((x + y) / 2 + 1e-9 * (z - (x + y) / 2) for x, y, z in zip(*(sliver.nodes[i] for i in (a, b, lowest))))
        path = sliver.write("sliver.msh", "2.2")
        code, out, err = drop("--out", "refused", "--mesh", path, *COARSE, "--end", "1")
        self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
        self.assertIn(f"--mesh = {path}", err)
        self.assertFalse(os.path.exists("refused"))

    def test_command(self):
        done = subprocess.run([DRIVER], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertTrue(done.stderr.startswith("arenite-ffp: command: must be drop"), done.stderr)

    def test_folder(self):
        with open("a_file", "w") as file:
            file.write("not a folder\n")
        for folder in ("a_file", "a_file/below"):
            code, out, err = drop(*SHORT, "--out", folder)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
            self.assertIn(f"--out = {folder}: ", err)


class Doors(DriverTest):
    """Files that are links, pipes, devices, endless or nested without end: nothing is emptied, waited for or read to its end."""

    def setUp(self):
        super().setUp()
        shutil.rmtree("doors", ignore_errors=True)
        os.mkdir("doors")
        with open("doors/precious", "w") as file:
            file.write("precious")

    def refused(self, sentence, *words):
        done = subprocess.run([DRIVER, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=60)
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)
        self.assertIn(sentence, done.stderr)
        self.assertEqual(content("doors", "precious"), b"precious")

    def test_the_lock_is_ours(self):
        lock = "doors/out/.arenite-ffp.lock"
        for make, sentence in ((lambda: os.symlink("../precious", lock), "is a link, a folder or a pipe"),
                               (lambda: os.symlink("../absent", lock), "is a link, a folder or a pipe"),
                               (lambda: os.link("doors/precious", lock), "holds what no drop has written"),
                               (lambda: os.mkfifo(lock), "is no regular file"), (lambda: os.mkdir(lock), "is a link, a folder or a pipe")):
            os.mkdir("doors/out")
            make()
            self.refused(f"--out = doors/out: .arenite-ffp.lock {sentence}", "drop", *SHORT, "--out", "doors/out")
            self.assertEqual(os.listdir("doors/out"), [".arenite-ffp.lock"])
            shutil.rmtree("doors/out")
        self.assertFalse(os.path.lexists("doors/absent"))
        os.mkdir("doors/out")
        with open(lock, "wb") as file:
            file.write(bytes(1 << 16))  # as a drop leaves it that was killed
        self.run_drop("doors/out", *SHORT)
        self.assertEqual(os.path.getsize(lock), 0)

    def test_links_are_replaced(self):
        os.mkdir("doors/out")
        names = ["summary.json", "history.csv", "fields.pvd", "reduced.csv", "reduced.json", "checkpoint.state", "fields_soil_0000.vtu"]
        for name in [*names, *(name + ".part" for name in names)]:
            os.symlink("../precious", f"doors/out/{name}")
        os.symlink("out", "doors/to_out")  # a folder may be reached by a link
        self.run_drop("doors/to_out", *COARSE, "--end", "0.002", "--checkpoint-every", "0.0005")
        self.assertEqual(content("doors", "precious"), b"precious")
        self.assertEqual([name for name in os.listdir("doors/out") if os.path.islink(f"doors/out/{name}")], [])

    def test_pipes_and_devices(self):
        os.mkfifo("doors/pipe")
        os.mkdir("doors/drop")
        os.mkfifo("doors/drop/summary.json")
        with open("doors/a.bin", "wb") as file:
            file.truncate(120000 * 30)
        for file in ("doors/pipe", "/dev/zero"):
            what = "must be a regular file, not a pipe or a device"
            for option in ("--mesh", "--input"):
                self.refused(f"{option} = {file}: {what}", "drop", option, file, "--out", "doors/out")
            self.refused(f"FILE = {file}: {what}", "reduce", file)
            self.refused(f"--calibration = {file}: {what}", "reduce", "doors/a.bin", "--calibration", file)
        self.refused("summary = doors/drop/summary.json: must be a regular file", "reduce", "doors/drop")
        self.refused("--resume: summary = doors/drop/summary.json: must be a regular file", "drop", "--resume", "--out", "doors/drop")
        # The scripts, in a folder whose names say what each reads.
        for name in ("history.csv", "reduced.json", "paper.json"):
            os.mkfifo(f"doors/drop/{name}")
        for script in ("plot.py", "plot_paper.py", "plot_reduced.py", "report.py"):
            done = subprocess.run(["/usr/bin/python3", os.path.join(os.path.dirname(Study.SCRIPT), script), "doors/drop"],
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 1, script)
            self.assertIn("must be a regular file, not a pipe", done.stderr, script)
        read = "import study; study.Runs.ended('doors/drop')"
        done = subprocess.run([sys.executable, "-c", read], capture_output=True, text=True, timeout=60,
                              env={**os.environ, "PYTHONPATH": os.path.dirname(Study.SCRIPT)})
        self.assertIn("must be a regular file, not a pipe", done.stderr)
        self.refused("--mesh = doors: must be a regular file, not a folder", "drop", "--mesh", "doors", "--out", "doors/out")

    def test_sizes(self):
        for name in ("doors/huge.csv", "doors/huge.bin", "doors/huge.msh", "doors/huge.json"):
            with open(name, "w") as file:
                file.truncate(40 << 30)  # without blocks on the disk
        self.refused("FILE = doors/huge.csv: has 42949672960 bytes; must have at most 1 GiB", "reduce", "doors/huge.csv")
        self.refused("doors/huge.bin = 42949672960 bytes: a BlueDrop's record has 3600000", "reduce", "doors/huge.bin")
        self.refused("--mesh = doors/huge.msh: has 42949672960 bytes; must have at most 16 GiB", "drop", "--mesh", "doors/huge.msh")
        self.refused("--input = doors/huge.json: has 42949672960 bytes; must have at most 16 MiB", "drop", "--input", "doors/huge.json")
        with open("doors/row.csv", "w") as file:
            file.truncate(1 << 30)
        self.refused("doors/row.csv: has a row of more than 1 MiB", "reduce", "doors/row.csv")

    def test_nested(self):
        deep = "[" * 200000 + "]" * 200000
        os.mkdir("doors/drop")
        for text in (deep, '{"delta_deg": ' + deep + "}", '{"a":' * 200000):
            for file in ("doors/deep.json", "doors/drop/summary.json"):
                with open(file, "w") as opened:
                    opened.write(text)
            with open("doors/drop/history.csv", "w"):
                pass
            what = "is nested deeper than 64 levels"
            self.refused(f"--input = doors/deep.json: {what}", "drop", "--input", "doors/deep.json", "--out", "doors/out")
            self.refused(f"summary = doors/drop/summary.json: {what}", "reduce", "doors/drop")
            self.refused(f"--resume: summary = doors/drop/summary.json: {what}", "drop", "--resume", "--out", "doors/drop")

    def test_reduction_of_a_drop_without_its_end(self):
        self.run_drop("doors/drop", *SHORT)
        found = summary("doors/drop")
        for status in ("running", "interrupted", "failed", "disk-full"):
            with open("doors/drop/summary.json", "w") as file:
                json.dump({**found, "status": status}, file)
            self.refused(f"FILE = doors/drop: status = {status}: must be done", "reduce", "doors/drop")
        done = subprocess.run([DRIVER, "reduce", "doors/drop/history.csv", "--impact-time", "0", "--impact-velocity", "5.6", "--out",
                               "doors/table", "--no-picture"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)  # as the sentence says


class Widths(DriverTest):
    """Where the driver is built for several widths of registers it gives the same drop in each, to round-off."""

    def test_widths(self):
        depths = {}
        for width in ("16", "32", "64"):
            with unittest.mock.patch.dict(os.environ, {"ARENITE_REGISTER_BYTES": width}):
                code, _, err = drop(*COARSE, "--end", "0.003", "--fields-every", "0", "--quiet", "--out", "width" + width)
            if code < 0 or "no such build" in err:  # SIGILL: this processor has no such registers
                continue
            self.assertEqual((code, err), (0, ""))
            found = summary("width" + width)
            depths[found["register_bytes"]] = found["final_penetration_m"]
        self.assertGreater(len(depths), 0)
        for depth in depths.values():
            self.assertAlmostEqual(depth, min(depths.values()), delta=1e-9)

    def test_unknown_width(self):
        with unittest.mock.patch.dict(os.environ, {"ARENITE_REGISTER_BYTES": "24"}):
            code, _, err = drop("--help")
        if code != 0:  # not where there is only one
            self.assertEqual(code, 2)
            self.assertIn("ARENITE_REGISTER_BYTES", err)


class Words(DriverTest):
    """What the driver says when all is well."""

    def test_help(self):
        code, out, err = drop("--help")
        self.assertEqual((code, err), (0, ""))
        for option in ("--kinematics", "--delta", "--out", "--mesh", "Exit code"):
            self.assertIn(option, out)

    def on_a_terminal(self, *options):
        """All that the driver writes to a terminal."""
        try:
            main, terminal = pty.openpty()
        except OSError as reason:  # a container without /dev/pts
            self.skipTest(f"no terminal can be opened here: {reason}")
        driver = subprocess.Popen([DRIVER, "drop", *options], stdin=subprocess.DEVNULL, stdout=terminal, stderr=terminal)
        os.close(terminal)
        said = b""
        try:
            while part := os.read(main, 4096):
                said += part
        except OSError:  # the way in which Linux reports that the other end is closed
            pass
        os.close(main)
        self.assertEqual(driver.wait(), 0)
        return said

    def test_progress(self):
        said = self.on_a_terminal(*SHORT, "--out", "progress")
        self.assertIn(b"100.0 %", said)
        self.assertIn(b"s left", said)
        quiet = self.on_a_terminal(*SHORT, "--out", "quiet", "--quiet")
        self.assertEqual(quiet.count(b"\n"), quiet.count(b"arenite-ffp: warning: "))

    def test_lines(self):
        """In a pipe: the steps to come, a line each tenth, and what it came to."""
        code, out, err = drop(*SHORT, "--out", "lines")
        found = summary("lines")
        self.assertEqual(code, 0)
        self.assertIn(f"about {found['expected_steps']} steps of ", err)
        self.assertEqual(err.count(" % "), 10)
        self.assertIn("100.0 %", err)
        self.assertNotIn("\r", err)
        self.assertEqual(out.count("\n"), 1)
        self.assertIn(f"stands at {found['final_penetration_m']:.3g} m", out)
        self.assertIn(f"peaked at {found['peak_deceleration_g']:.3g} g at {found['peak_time_s'] * 1e3:.3g} ms", out)
        self.assertTrue(out.endswith("Files: lines\n"))

    def test_version(self):
        done = subprocess.run([DRIVER, "--version"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^arenite-ffp \d+\.\d+\.\d+\n$")

    def test_report(self):
        """The table that examples/ffp/run.sh prints, of any end."""
        script = os.path.join(os.path.dirname(Study.SCRIPT), "report.py")

        def report(folder):
            done = subprocess.run([sys.executable, script, folder], capture_output=True, text=True)
            return done.returncode, done.stdout, done.stderr

        _, found = self.run_drop("reported", *SHORT)
        code, out, err = report("reported")
        self.assertEqual((code, err), (0, ""))
        self.assertIn(f"depth              {found['final_penetration_m']:.3f} m at 10 ms", out)
        self.assertIn(f"peak deceleration  {found['peak_deceleration_g']:.1f} g at ", out)
        self.assertIn("reported/history.csv", out)
        self.assertNotIn("outline", out)
        self.assertLess(max(map(len, out.splitlines())), 400)
        found.update(status="failed", failure="t = 0.01 s: it failed", warnings=["one", "two"])
        young = {key: found[key] for key in ("status", "failure", "inputs", "points")}  # no row was written
        for summary_then in (found, young):
            with open("reported/summary.json", "w") as file:
                json.dump(summary_then, file)
            code, out, err = report("reported")
            self.assertEqual((code, err), (0, ""))
            self.assertIn("t = 0.01 s: it failed", out)
        self.assertEqual(report("nowhere")[0], 1)

    def test_a_closed_pipe_stops_nothing(self):
        reader, writer = os.pipe()
        os.close(reader)
        driver = subprocess.Popen([DRIVER, "drop", *SHORT, "--out", "closed"], stdout=writer, stderr=writer)
        os.close(writer)
        self.assertEqual(driver.wait(), 0)
        self.assertEqual(summary("closed")["status"], "done")


class Pictures(DriverTest):
    """The pictures that examples/ffp/run.sh draws, with Debian's matplotlib."""

    def test_drawn(self):
        self.run_drop("pictures", *COARSE, "--end", "0.02", "--fields-every", "0.01")
        script = os.path.join(os.path.dirname(Study.SCRIPT), "plot.py")
        done = subprocess.run(["/usr/bin/python3", script, "pictures"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(subprocess.run([DRIVER, "paper", "--quick", "--cell", "0.04", "--law", "mohr-coulomb", "--out", "figures"],
                                        capture_output=True, stdin=subprocess.DEVNULL).returncode, 0)
        for number in (3, 4, 5, 6):
            self.assertGreater(len(content("figures", f"figure{number}.png")), 10000)
            self.assertIn(b"<svg", content("figures", f"figure{number}.svg"))
        done = subprocess.run([DRIVER, "reduce", "pictures"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Pictures: pictures/reduced.png", done.stdout)
        self.assertIn(b"<svg", content("pictures", "reduced.svg"))
        for name in ("histories.png", "strain.png", "reduced.png"):
            self.assertTrue(content("pictures", name).startswith(b"\x89PNG"), name)
            self.assertGreater(len(content("pictures", name)), 10000)


class Meshes(DriverTest):
    """Gmsh files in the place of the generated mesh."""

    def check(self, name, versions, share, *options):
        short = [*options, "--end", "0.003"]
        own, _ = self.run_drop(name, *short)
        mesh = Mesh(name)
        for version in versions:
            path = mesh.write(f"{name}_{version}.msh", version)
            read, found = self.run_drop(f"{name}_{version}", *short, "--mesh", path)
            self.assertEqual(found["inputs"]["mesh"], path)
            self.assert_same_drop(own, read, share)

    def test_triangles(self):
        self.check("mesh2", ("2.2", "4.1"), 1e-9, *COARSE)

    def test_tetrahedra(self):
        self.check("mesh3", ("2.2", "4.1"), 1e-9, *SLICE)

    def test_elastic(self):
        self.check("mesh_elastic", ("2.2",), 1e-9, *COARSE, "--device", "elastic")

    def test_unusable(self):
        def refuse(path, rule, *options):
            code, out, err = drop("--out", "refused", "--mesh", path, *options)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
            self.assertTrue(err.startswith(f"arenite-ffp: --mesh = {path}: "), err)
            self.assertIn(rule, err)
            self.assertFalse(os.path.exists("refused"))

        self.run_drop("mesh_good", *COARSE, "--end", "1e-5")
        self.run_drop("mesh_solid", *SLICE, "--end", "1e-5")
        plane, solid = Mesh("mesh_good"), Mesh("mesh_solid")
        good = plane.write("good.msh", "2.2")
        refuse("absent.msh", "no such file")
        refuse(".", "")
        open("empty.msh", "w").close()
        refuse("empty.msh", "")
        with open("garbage.msh", "wb") as file:
            file.write(bytes(range(256)) * 20)
        refuse("garbage.msh", "")
        with open("cut.msh", "wb") as file:
            file.write(content(".", "good.msh")[:9000])
        refuse("cut.msh", "")
        refuse(good, "tetrahedra", "--kinematics", "slice")
        refuse(solid.write("solid.msh", "4.1"), "triangles")
        for region in ("soil", "device"):
            broken = Mesh("mesh_good")
            broken.region_names = {{region: "stone"}.get(n, n): k for n, k in broken.region_names.items()}
            refuse(broken.write(f"no_{region}.msh", "2.2"), region)
        for name in ("bottom", "wall"):
            broken = Mesh("mesh_good")
            del broken.sets[name]
            refuse(broken.write(f"no_{name}.msh", "2.2"), name)
        for name in ("side_minus", "side_plus"):
            broken = Mesh("mesh_solid")
            del broken.sets[name]
            refuse(broken.write(f"no_{name}.msh", "2.2"), name, "--kinematics", "slice")
        for name, rule, change in (
            ("inch", "must lie in [0.1, 2] m", lambda x, y, z: (x / 0.0254, y / 0.0254, z)),
            ("raised", "tip of the device, y = 0.1: must be 0 m", lambda x, y, z: (x, y + 0.1, z)),
            ("shallow", "bottom of the soil, y = -0.05: must lie below", lambda x, y, z: (x, max(y, y / 8), z)),
        ):
            broken = Mesh("mesh_good")
            broken.nodes = [change(*node) for node in broken.nodes]
            refuse(broken.write(f"{name}.msh", "2.2"), rule)


class Failures(DriverTest):
    """A run that fails: exit code 1, a sentence, and files that can be read."""

    def assert_failed(self, folder, status, *options, **limits):
        done = subprocess.run([DRIVER, "drop", "--quiet", "--out", folder, *options], capture_output=True, text=True, **limits)
        self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
        *warnings, said = done.stderr.splitlines()
        found = summary(folder)
        self.assertEqual(warnings, ["arenite-ffp: warning: " + text for text in found["warnings"]])
        self.assertEqual(found["status"], status)
        self.assertRegex(found["failure"], "^t = 0[.0-9]* s")
        self.assertEqual(said, f"arenite-ffp: {'the run failed: ' if status == 'failed' else ''}{found['failure']}; files: {folder}")
        columns = history(folder)
        self.assertEqual(found["steps"], len(columns["time_s"]) - 1)
        self.assertEqual(found["final_penetration_m"], columns["penetration_m"][-1])
        self.assert_readable(folder)
        return columns, found

    def test_used_up(self):
        columns, found = self.assert_failed(
            "used_up", "failed", *COARSE, "--delta", "0", "--velocity", "12", "--mass", "20", "--fields-every", "0.01")
        self.assertIn("the compressing zone below -0.06 m is used up after a travel of", found["failure"])
        self.assert_consistent(columns, mass=20, velocity=12)

    def test_watch(self):
        """Past a limit the run stops; the step at which it did has its fields; a tenth of the limit warns."""
        options = [*COARSE, "--flip", "0.999"]
        free, found = self.run_drop("free", *options, "--no-watch", "--fields-every", "0")
        self.assertNotIn("watch", found)
        self.assertEqual(found["warnings"], [])
        swelling = max(abs(ratio - 1) for ratio in free["mean_volume_ratio"])
        limit = str(swelling / 2)
        columns, found = self.assert_failed("watched", "failed", *options, "--watch-volume", limit, "--fields-every", "0.09")
        self.assertIn(f"volume = ", found["failure"])
        self.assertGreater(found["watch"]["volume"]["worst"], float(limit))
        self.assertEqual(len(found["watch"]["volume"]["place_m"]), 2)
        self.assertTrue(any("volume" in text for text in found["warnings"]))
        self.assertEqual([time for time, _ in field_files("watched")][-1], columns["time_s"][-1])
        watched = history("watched")  # and to look on changes nothing
        for name in ("time_s", "penetration_m", "reaction_N"):
            self.assertEqual(watched[name], free[name][: len(watched[name])])

    def test_disk_full(self):
        """No byte of a file beyond 20 kB: the history ends with a whole row, and the summary says why."""
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, resource.getrlimit(resource.RLIMIT_FSIZE)[1]))

        columns, found = self.assert_failed("full", "disk-full", *COARSE, "--fields-every", "0", preexec_fn=limit)
        self.assertIn("history.csv: cannot be written", found["failure"])
        self.assertGreater(len(columns["time_s"]), 50)
        columns, found = self.assert_failed("full_fields", "disk-full", *COARSE, "--fields-every", "0.02", preexec_fn=limit)
        self.assertIn("fields_soil_0000.vtu: cannot be written", found["failure"])


class Ends(DriverTest):
    """One folder, one run, and its summary says how it stands."""

    LONG = [*COARSE, "--end", "10", "--fields-every", "1", "--quiet"]

    def start(self, folder):
        """A long run, once it has taken some steps."""
        shutil.rmtree(folder, ignore_errors=True)

        def default_signals():  # a test in the background may have been given SIGINT to ignore
            signal.signal(signal.SIGINT, signal.SIG_DFL)

        driver = subprocess.Popen([DRIVER, "drop", *self.LONG, "--out", folder], stderr=subprocess.PIPE, text=True,
                                  preexec_fn=default_signals)
        path = os.path.join(folder, "history.csv")
        while not os.path.exists(path) or os.path.getsize(path) < 3000:
            self.assertIsNone(driver.poll())
            time.sleep(0.01)
        return driver

    def test_interrupted(self):
        for number, code, name in ((signal.SIGINT, 130, "SIGINT"), (signal.SIGTERM, 143, "SIGTERM")):
            folder = f"interrupted_{code}"
            driver = self.start(folder)
            found = summary(folder)
            self.assertEqual((found["status"], found["process_id"]), ("running", driver.pid))
            self.assertNotIn("final_penetration_m", found)
            driver.send_signal(number)
            _, err = driver.communicate()
            self.assertEqual(driver.returncode, code, err)
            columns, found = history(folder), summary(folder)
            self.assertEqual(found["status"], "interrupted")
            self.assertRegex(found["failure"], f"^t = [0-9.e-]+ s: interrupted by {name}$")
            self.assertEqual(err.splitlines()[-1], f"arenite-ffp: {found['failure']}; files: {folder}")
            self.assertEqual(found["end_s"], columns["time_s"][-1])
            self.assertEqual(found["final_penetration_m"], columns["penetration_m"][-1])
            self.assertAlmostEqual(field_files(folder)[-1][0], found["end_s"], delta=1e-9)  # the last step has its fields
            self.assert_readable(folder)

    def test_in_use(self):
        driver = self.start("in_use")
        before = summary("in_use")
        code, out, err = drop(*SHORT, "--out", "in_use")
        self.assertEqual((code, out), (2, ""), err)
        self.assertEqual(err, f"arenite-ffp: --out = in_use: is in use by the drop with process id {driver.pid}\n")
        self.assertEqual(summary("in_use"), before)
        driver.kill()
        driver.communicate()
        self.assertEqual(summary("in_use")["status"], "running")  # it had no time to say more
        self.run_drop("in_use", *SHORT)  # the lock went with it
        self.assertEqual(summary("in_use")["status"], "done")

    def test_old_results_go(self):
        shutil.rmtree("again", ignore_errors=True)
        self.run_drop("again", *COARSE, "--end", "0.01", "--fields-every", "0.001")
        self.assertEqual(len(field_files("again")), 11 * 3)
        for name in ("notes.txt", "fields.txt", "history.csv.old"):
            with open(os.path.join("again", name), "w") as file:
                file.write("mine\n")
        for name in ("histories.png", "reduced.png", "reduced.svg", "fields_soil_0099.vtu", "history.csv.part"):
            with open(os.path.join("again", name), "w") as file:
                file.write("of an earlier run\n")
        self.run_drop("again", *COARSE, "--end", "0.005", "--fields-every", "0.005")
        self.assertEqual(sorted(os.listdir("again")), sorted(
            [".arenite-ffp.lock", "notes.txt", "fields.txt", "history.csv.old", "history.csv", "summary.json", "fields.pvd",
             "reduced.csv", "reduced.json",
             *(f"fields_{part}_000{k}.vtu" for part in ("soil", "mesh", "device") for k in (0, 1))]))
        # Refused options leave what is there.
        self.assertEqual(drop("--out", "again", "--courant", "1e-9")[0], 2)
        self.assertEqual(summary("again")["status"], "done")

    def test_same_input_same_hash(self):
        found = [self.run_drop(f"hash{k}", *SHORT, "--threads", str(k))[1] for k in (1, 2)]
        found.append(self.run_drop("hash3", *SHORT, "--delta", "21")[1])
        self.assertEqual(found[0]["inputs_hash"], found[1]["inputs_hash"])
        self.assertNotEqual(found[0]["inputs_hash"], found[2]["inputs_hash"])


class Killed(DriverTest):
    """kill -9 at 50 moments of a run: what it leaves can be read, and the next run takes the folder."""

    def test_killed(self):
        options = ["--cell", "0.04", "--points-per-element", "10", "--end", "0.02", "--fields-every", "0.002", "--quiet"]
        shutil.rmtree("killed", ignore_errors=True)
        begin = time.monotonic()
        self.run_drop("killed", *options)
        whole = time.monotonic() - begin
        killed, moments = 0, 50 if whole < 1 else 20  # fewer under a sanitizer
        for moment in range(moments):
            begin = time.monotonic()
            driver = subprocess.Popen([DRIVER, "drop", *options, "--out", "killed"], stderr=subprocess.DEVNULL)
            try:
                driver.wait(whole * moment / moments)
                whole = min(whole, time.monotonic() - begin)  # it was faster than the run before it
            except subprocess.TimeoutExpired:
                driver.kill()
            killed += driver.wait() == -signal.SIGKILL
            self.assert_readable("killed")
        self.assertGreater(killed, moments // 2)
        self.run_drop("killed", *options)
        self.assertFalse([name for name in os.listdir("killed") if name.endswith(".part")])


class Resumed(DriverTest):
    """A run that was stopped goes on from its last saved state, to the byte as if it had never been stopped."""

    CASES = {
        "resumed_rigid": ["--cell", "0.02", "--points-per-element", "10", "--end", "0.06", "--fields-every", "0.004"],
        "resumed_grid": ["--mesh-kind", "grid", "--cell", "0.03", "--cell-at-cone", "0.02", "--end", "0.04", "--fields-every", "0.01"],
        "resumed_elastic": [*COARSE, "--device", "elastic", "--end", "0.05", "--fields-every", "0.01"],
    }

    def assert_same_files(self, folder, whole):
        names = sorted(os.listdir(whole))
        self.assertEqual(sorted(os.listdir(folder)), names)
        for name in names:
            if name not in ("summary.json", "reduced.json", ".arenite-ffp.lock"):  # these name the folder
                self.assertEqual(content(folder, name), content(whole, name), name)
        a, b = summary(folder), summary(whole)
        for key in set(a) | set(b):
            if key not in ("started", "process_id", "wall_s", "point_steps_per_s", "resumed_at_s", "threads"):
                self.assertEqual(a[key], b[key], key)
        return a

    def stop_until_done(self, folder, options, how, after):
        """Begins a run, stops it after so many seconds and resumes it, until it is done. Returns how often it was stopped."""
        shutil.rmtree(folder, ignore_errors=True)
        for attempt in range(12):
            driver = subprocess.Popen(
                [DRIVER, "drop", *options, "--quiet", "--out", folder, "--resume", "--checkpoint-every", "0.002",
                 "--threads", str(1 + attempt % 3)], stderr=subprocess.DEVNULL)
            if attempt < 11:
                time.sleep(after)
                driver.send_signal(how)
            code = driver.wait()
            self.assertIn(code, (0, -signal.SIGKILL, 130, -signal.SIGINT))
            self.assert_readable(folder)
            if code == 0:
                break
        self.assertEqual(code, 0)
        return attempt

    def test_stopped_again_and_again(self):
        for folder, options in self.CASES.items():
            whole = folder + "_whole"
            begin = time.monotonic()
            self.run_drop(whole, *options)
            spent = time.monotonic() - begin
            for how in (signal.SIGKILL, signal.SIGINT):
                stopped = 0
                for share in (0.25, 0.1, 0.03):  # the first run may have been the slowest
                    if stopped == 0:
                        stopped = self.stop_until_done(folder, options, how, share * spent)
                self.assertGreater(stopped, 0)
                found = self.assert_same_files(folder, whole)
                self.assertEqual(found["status"], "done")
                self.assertEqual(found["resumed_at_s"], sorted(found["resumed_at_s"]))

    def test_finished(self):
        self.run_drop("finished", *SHORT)
        before = content("finished", "summary.json")
        code, out, err = drop(*SHORT, "--out", "finished", "--resume")
        self.assertEqual((code, out, err), (0, "", "arenite-ffp: the run in finished is finished; nothing to do\n"))
        self.assertEqual(content("finished", "summary.json"), before)
        code, out, err = drop(*SHORT, "--out", "finished", "--resume", "--delta", "21")
        self.assertEqual((code, out), (2, ""))
        self.assertIn("is of a run with other inputs: delta_deg is 20.0 there, 21.0 here", err)
        self.assertEqual(content("finished", "summary.json"), before)

    def test_from_the_start(self):
        shutil.rmtree("anew", ignore_errors=True)
        code, out, err = drop(*SHORT, "--out", "anew", "--resume")
        self.assertEqual(code, 0, err)
        self.assertIn("no state is saved in anew: from the start", err)
        self.assertNotIn("resumed_at_s", summary("anew"))

    def test_refused(self):
        """A state that cannot be used: exit code 2, one sentence, nothing touched."""
        shutil.rmtree("bad_state", ignore_errors=True)
        options = [*COARSE, "--end", "10", "--fields-every", "1", "--quiet", "--checkpoint-every", "0.001", "--out", "bad_state"]
        driver = subprocess.Popen([DRIVER, "drop", *options], stderr=subprocess.DEVNULL)
        while not os.path.exists("bad_state/checkpoint.state"):
            time.sleep(0.01)
        driver.kill()
        driver.wait()
        good = content("bad_state", "checkpoint.state")
        files = sorted(os.listdir("bad_state"))
        for bad, reason in ((good[: len(good) // 2], "is truncated"), (good[:-9] + b"x" + good[-8:], "is damaged"),
                            (b"something", "is no state file of Arenite"), (good.replace(b"recipe: ", b"recipe: 1", 1), "is damaged")):
            with open("bad_state/checkpoint.state", "wb") as file:
                file.write(bad)
            before = {name: content("bad_state", name) for name in files}
            code, out, err = drop(*options, "--resume")
            self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
            self.assertTrue(err.startswith("arenite-ffp: state file = bad_state/checkpoint.state: " + reason), err)
            self.assertEqual({name: content("bad_state", name) for name in sorted(os.listdir("bad_state")) if not name.startswith(".")}, {
                name: data for name, data in before.items() if not name.startswith(".")})


class ErrorBar(DriverTest):
    """A drop with the drops around it."""

    OPTIONS = ["--cell", "0.02", "--points-per-element", "10", "--end", "0.03", "--fields-every", "0.01"]
    NAMES = ["cells-2", "points-6", "points-15", "jitter-1", "jitter-2", "cells-1.41", "offset-in", "offset-out", "flip-time"]
    RESULTS = ("final_penetration_m", "peak_deceleration_g")

    def run_bar(self, folder, *options):
        """Runs the drop with its error bar; returns output, errors and summary."""
        code, out, err = drop(*self.OPTIONS, "--error-bar", "--out", folder, *options)
        self.assertEqual(code, 0, err)
        return out, err, summary(folder)

    def companions(self, folder):
        return {name: summary(os.path.join(folder, "error-bar", name)) for name in self.NAMES}

    def test_parts(self):
        shutil.rmtree("bar", ignore_errors=True)
        out, err, found = self.run_bar("bar")
        self.assertEqual(sorted(os.listdir("bar/error-bar")), sorted(self.NAMES))
        self.assertEqual([line.split(": ")[-1] for line in err.splitlines() if ": error bar, " in line], self.NAMES)
        self.assertEqual(len(field_files("bar")), 4 * 3)
        runs = self.companions("bar")
        for name, run in runs.items():
            self.assertEqual(run["status"], "done")
            self.assertFalse(os.path.exists(os.path.join("bar/error-bar", name, "fields.pvd")))
        self.assertEqual(runs["points-6"]["inputs"]["points_per_element"], 6)
        self.assertEqual(runs["jitter-2"]["inputs"]["jitter"], 1)
        self.assertNotEqual(content("bar/error-bar/jitter-1"), content("bar/error-bar/jitter-2"))
        for key in self.RESULTS:
            bar, of = found["uncertainty"][key], {name: run[key] for name, run in runs.items()}
            self.assertEqual(bar["value"], found[key])
            spread = [of[name] for name in self.NAMES[:5]]
            cells = [of["cells-2"], of["cells-1.41"], found[key]]
            self.assertAlmostEqual(bar["parts"]["points"], (max(spread) - min(spread)) / 2, delta=1e-12)
            self.assertAlmostEqual(bar["parts"]["contact_offset"], abs(of["offset-in"] - of["offset-out"]) / 2, delta=1e-12)
            self.assertAlmostEqual(bar["parts"]["flip_time"], abs(of["flip-time"] - of["cells-1.41"]), delta=1e-12)
            if not bar["converged"]:
                self.assertAlmostEqual(bar["parts"]["cells"], 3 * (max(cells) - min(cells)), delta=1e-9)
            self.assertAlmostEqual(bar["u"], sum(u * u for u in bar["parts"].values()) ** 0.5, delta=1e-9)
            self.assertGreater(bar["u"], 0)
            self.assertEqual(found["uncertainty"]["runs"]["cells-2"][key], of["cells-2"])
        depth = found["uncertainty"]["final_penetration_m"]
        line = next(line for line in out.splitlines() if line.startswith("final penetration "))
        self.assertAlmostEqual(float(line.split()[2]), depth["value"], delta=0.1 * depth["u"])
        self.assertAlmostEqual(float(line.split()[4]), depth["u"], delta=0.06 * depth["u"])
        for key, value in found["uncertainty"].items():
            if key in self.RESULTS and not value["converged"]:
                self.assertIn("not converged", out)
        # A companion is the drop that its inputs say.
        self.run_drop("bar_cells", "--cell", "0.04", *self.OPTIONS[2:-1], "0")
        self.assertEqual(content("bar_cells"), content("bar/error-bar/cells-2"))
        report = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "ffp", "scripts", "report.py")
        done = subprocess.run([sys.executable, report, "bar"], capture_output=True, text=True)
        self.assertIn(" ".join(line.split()[2:6]).rstrip(","), done.stdout)

    def test_resumed(self):
        shutil.rmtree("bar_again", ignore_errors=True)
        _, _, before = self.run_bar("bar_again", "--quiet")
        runs = self.companions("bar_again")
        shutil.rmtree("bar_again/error-bar/jitter-1")
        out, _, found = self.run_bar("bar_again", "--quiet", "--resume")
        self.assertEqual(out, "")
        for name, run in self.companions("bar_again").items():
            if name == "jitter-1":  # anew, to the same end
                self.assertEqual(run["final_penetration_m"], runs[name]["final_penetration_m"])
            else:
                self.assertEqual(run, runs[name])
        for key in self.RESULTS:
            self.assertEqual(found["uncertainty"][key], before["uncertainty"][key])
        # Drops of other inputs are not taken over, and one without the option claims nothing.
        code, _, err = drop(*self.OPTIONS, "--out", "bar_again", "--delta", "30", "--quiet")
        self.assertEqual(code, 0, err)
        self.assertNotIn("uncertainty", summary("bar_again"))
        _, _, found = self.run_bar("bar_again", "--quiet", "--resume", "--delta", "30")
        self.assertEqual(self.companions("bar_again")["cells-2"]["inputs"]["delta_deg"], 30)

    def test_unknown(self):
        """A companion that cannot run makes its parts unknown, not a number."""
        shutil.rmtree("bar_unknown", ignore_errors=True)
        os.makedirs("bar_unknown/error-bar")
        with open("bar_unknown/error-bar/offset-in", "w"):
            pass  # where a folder should be
        out, err, found = self.run_bar("bar_unknown")
        self.assertIn("arenite-ffp: warning: error bar, offset-in: --out = bar_unknown/error-bar/offset-in: ", err)
        self.assertIn("+- unknown (at least ", out)
        bar = found["uncertainty"]["final_penetration_m"]
        self.assertIsNone(bar["u"])
        self.assertIsNone(bar["parts"]["contact_offset"])
        self.assertGreater(bar["u_at_least"], 0)
        self.assertIn("failure", found["uncertainty"]["runs"]["offset-in"])

    def test_interrupted(self):
        shutil.rmtree("bar_ended", ignore_errors=True)
        options = [*self.OPTIONS, "--end", "0.1", "--points-per-element", "28", "--error-bar", "--quiet", "--out", "bar_ended"]
        driver = subprocess.Popen([DRIVER, "drop", *options], stderr=subprocess.PIPE, text=True)
        while not os.path.exists("bar_ended/error-bar/cells-1.41/history.csv"):
            self.assertIsNone(driver.poll())
            time.sleep(0.001)
        driver.send_signal(signal.SIGINT)
        self.assertIn("arenite-ffp: error bar, cells-1.41: ", driver.communicate()[1])
        self.assertEqual(driver.returncode, 130)
        self.assertEqual(summary("bar_ended")["status"], "done")
        self.assertNotIn("uncertainty", summary("bar_ended"))
        self.assertEqual(summary("bar_ended/error-bar/cells-1.41")["status"], "interrupted")
        self.assertFalse(os.path.exists("bar_ended/error-bar/flip-time"))
        code, _, err = drop(*options, "--resume")
        self.assertEqual(code, 0, err)
        for line in err.splitlines():  # warnings say whose they are
            self.assertTrue(line.startswith("arenite-ffp: error-bar/"), line)
        self.assertTrue(summary("bar_ended/error-bar/cells-1.41")["resumed_at_s"])
        self.assertGreater(summary("bar_ended")["uncertainty"]["peak_deceleration_g"]["u"], 0)


class FineCells(DriverTest):
    """Error bars of drops with cells of 1 cm: each holds what cells of 0.25 cm at the cone gave (docs/ffp.md)."""

    RECORDED = {("mohr-coulomb", 20): (0.1906, 17.75), ("mohr-coulomb", 40): (0.1589, 21.74),
                ("linear-rate", 20): (0.1792, 18.89), ("linear-rate", 40): (0.1425, 24.67)}

    def test_bars(self):
        for (law, delta), fine in self.RECORDED.items():
            with self.subTest(law=law, delta=delta):
                folder = f"bar_{law}_{delta}"
                self.run_drop(folder, "--error-bar", "--fields-every", "0", "--law", law, "--delta", str(delta))
                found = summary(folder)
                for key, value, widest in zip(ErrorBar.RESULTS, fine, (0.05, 10)):
                    bar = found["uncertainty"][key]
                    self.assertLess(abs(bar["value"] - value), bar["u"])
                    self.assertLess(bar["u"], widest)
                work = [run["points"] * run["steps"] for run in (found, *map(
                    summary, sorted(f"{folder}/error-bar/{name}" for name in found["uncertainty"]["runs"])))]
                self.assertLess(sum(work[1:]), 3 * work[0])  # as the time, but whatever else the machine does


class Inputs(DriverTest):
    """Inputs as JSON."""

    def write(self, inputs, encoding="utf-8"):
        with open("case.json", "w", encoding=encoding) as file:
            file.write(inputs if isinstance(inputs, str) else json.dumps(inputs))

    def test_a_summary_is_taken_back(self):
        for name, options in (("taken", SHORT), ("taken_odd", [*SHORT, "--shoulder", "fillet", "--fillet", "0.011", "--no-slip",
                                                              "--k0", "0.45", "--young", "6.1e6", "--anti-locking", "off", "--flip", "0.99"]),
                              ("taken_elastic", [*SHORT, "--device", "elastic"]),
                              ("taken_grid", [*GRID, "--end", "0.01", "--fields-every", "0"]),
                              ("taken_refined", [*SHORT, "--cell-at-cone", "0.02", "--split", "12"]),
                              ("taken_law", [*SHORT, "--law", "softening-rate", "--residual-friction", "35.5", "--decay", "7"])):
            _, found = self.run_drop(name, *options)
            _, again = self.run_drop(name + "_again", "--input", f"{name}/summary.json")
            self.assertEqual(again["inputs"], found["inputs"])
            self.assertEqual(again["inputs_hash"], found["inputs_hash"])
            self.assertEqual(content(name + "_again"), content(name))

    def test_what_is_typed_wins(self):
        self.write({"inputs": {"delta_deg": 33, "cell_m": 0.04, "points_per_element": 10, "end_s": 0.002, "threads": 1, "quiet": True}})
        for options in (["--input", "case.json", "--delta", "22"], ["--delta", "22", "--input=case.json"]):
            code, out, err = drop(*options, "--out", "typed")
            self.assertEqual((code, out, err), (0, "", ""))
            self.assertEqual(summary("typed")["inputs"]["delta_deg"], 22)
            self.assertEqual(summary("typed")["inputs"]["end_s"], 0.002)

    def test_mistakes(self):
        for inputs, sentence, *encoding in (
            ({"delta": 20}, "--input = case.json: delta: no such input"),
            ({"delta_deg": "steep"}, "--delta = steep: must be a number"),
            ({"delta_deg": [20]}, "--input = case.json: delta_deg = [20]: must be a number or a word"),
            ({"no_slip": 1}, "--input = case.json: no_slip = 1: must be true or false"),
            ({"delta_deg": 99}, "--delta = 99: must lie in [0, 60] deg"),
            ({"gravity_m_s2": 1.62}, "--input = case.json: gravity_m_s2 = 1.62: must be 9.81"),
            ({"mesh": "--force"}, "--mesh = --force: must be a name"),
            ("[1, 2]", "--input = case.json: must hold an object"),
            ("{", "--input = case.json: is no JSON"),
            ("", "--input = case.json: must be a file that is not empty"),
            ('{"k0": 1, "k0": 2}', "--input = case.json: gives k0 twice"),
            ({"delta_deg": "0,5"}, "--delta = 0,5: must be a number"),
            ('{"delta_deg": 0,5}', "--input = case.json: is no JSON"),
            ('{"inputs": {"k0": 1}, "delta_deg": 30}', "--input = case.json: delta_deg stands beside \"inputs\"; put it there"),
            ({"delta_deg": 99}, "--delta = 99: must lie in", "utf-8-sig"),
            ({"delta_deg": 99}, "--input = case.json: is UTF-16, or no text; save it as UTF-8", "utf-16"),
        ):
            self.write(inputs, *encoding)
            self.assert_refused(sentence, "--input", "case.json")
        self.assert_refused("--input = absent.json: no such file\n", "--input", "absent.json")
        self.assert_refused("--input = case.json: is given twice", "--input", "case.json", "--input=case.json")
        self.assert_refused("--input = : needs a value", "--input")


class Reduced(DriverTest):
    """`arenite-ffp reduce`; tests/ffp/reduce.cpp has its numbers."""

    def reduce(self, *words, scripts="nowhere"):
        """Exit code, standard output and error; without scripts, and so without pictures, unless said."""
        with unittest.mock.patch.dict(os.environ, {"ARENITE_FFP_SCRIPTS": scripts}):
            done = subprocess.run([DRIVER, "reduce", *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        return done.returncode, done.stdout, done.stderr

    def reduced(self, folder):
        with open(os.path.join(folder, "reduced.json")) as file:
            return json.load(file)

    def test_drop(self):
        """A drop leaves its reduction, which gives back its depth and its peak; the same again gives the same bytes."""
        columns, found = self.run_drop("reduced", *COARSE, "--fields-every", "0", "--contact-offset", "0.001")
        mine = self.reduced("reduced")
        step = found["dt_max_s"]
        largest = max(map(abs, columns["acceleration_m_s2"]))
        self.assertAlmostEqual(mine["depth_cm"] / 100, found["max_penetration_m"], delta=step * 5.6 + largest * step * 0.1)
        self.assertAlmostEqual(mine["peak_deceleration_g"], found["peak_deceleration_g"], delta=1e-9)
        self.assertAlmostEqual(mine["peak_depth_cm"] / 100, found["peak_penetration_m"], delta=step * 5.6)
        self.assertEqual(mine["settings"]["mass_kg"], 7.71)
        before = {name: content("reduced", name) for name in ("reduced.csv", "reduced.json")}
        code, out, err = self.reduce("reduced", "--no-picture")
        self.assertEqual((code, err), (0, ""))
        self.assertIn(f"{mine['peak_deceleration_g']:.3g} g at", out)
        self.assertEqual({name: content("reduced", name) for name in before}, before)

    def test_short(self):
        """A drop that ends before rest: what there is no answer to is null."""
        self.run_drop("too_short", *COARSE, "--end", "1e-5", "--fields-every", "0")
        mine = self.reduced("too_short")
        self.assertIsNone(mine["penetration_time_s"])
        self.assertIsNone(mine["q_dyn"]["mantle"]["largest_kPa"])
        self.assertEqual({one["value"] for one in mine["estimates"]}, {None})

    def record(self, offset=0.0):
        """At rest, in free fall for half a second, slowed by half a sine of 40 ms, at rest: time in ms and deceleration in g."""
        values = [0 if t < 200 else -1 if t < 1200 else 6.25 * math.pi * math.sin(math.pi * (t - 1200) / 80) if t < 1280 else 0
                  for t in range(2000)]
        return [(t * 0.5, value + offset) for t, value in enumerate(values)]

    def test_table(self):
        with open("measured.csv", "w") as file:
            file.write("time_ms,deceleration_g\n")
            file.writelines(f"{t},{value}\n" for t, value in self.record())
        code, out, err = self.reduce("measured.csv", "--out", "measured")
        self.assertEqual(code, 0)
        self.assertIn("nothing is drawn; the command: /usr/bin/python3 plot_reduced.py 'measured'", err)
        self.assertIn("time is time_ms (times 0.001 s), deceleration is deceleration_g", out)
        self.assertAlmostEqual(self.reduced("measured")["impact_velocity_m_s"], 0.5 * GRAVITY, delta=0.02)
        self.assertEqual(self.reduced("measured")["warnings"], [])
        self.assertEqual(self.reduce("measured.csv", "--out", "measured", "--quiet", "--no-picture"), (0, "", ""))

    def test_as_europe_writes_it(self):
        """Decimal commas and semicolons give the bytes that points and commas give; between commas they are refused."""
        self.test_table()
        before = content("measured", "reduced.csv")
        for separator, code in (";", 0), ("\t", 0), (",", 2):
            with open("comma.csv", "w", encoding="utf-8-sig", newline="\r\n") as file:
                file.write(f"time_ms{separator}deceleration_g\n")
                file.writelines(f"{t}{separator}{value}\n".replace(".", ",") for t, value in self.record())
            done, _, err = self.reduce("comma.csv", "--out", "comma", "--quiet", "--no-picture")
            self.assertEqual(done, code, err)
            self.assertEqual(content("comma", "reduced.csv"), before)
        self.assertIn("comma.csv: line 2, number of fields = 4: must be 2", err)

    def test_offset(self):
        """An accelerometer that is off is told on standard error and in the summary, with the depth that it should be."""
        with open("off.csv", "w") as file:
            file.write("time_ms,deceleration_g\n")
            file.writelines(f"{t},{value}\n" for t, value in self.record(-0.05))
        code, out, err = self.reduce("off.csv", "--out", "off", "--quiet", "--no-picture")
        found = self.reduced("off")
        self.assertEqual((code, out, err), (0, "", f"arenite-ffp: warning: {found['warnings'][0]}\n"))
        self.assertIn("is off by -0.05 g at rest before the release", err)
        self.assertEqual([round(level, 6) for level in found["levels_g"].values()], [-0.05, -1.05, -0.05])
        self.assertEqual(self.reduce("off.csv", "--out", "taken", "--quiet", "--no-picture", "--zero-at-rest"), (0, "", ""))
        taken = self.reduced("taken")
        self.assertEqual(taken["depth_cm"], found["depth_without_offset_cm"])
        self.assertAlmostEqual(taken["depth_cm"], 0.5 * GRAVITY * 0.02 * 100, delta=0.3)
        self.assertGreater(found["depth_cm"], 1.08 * taken["depth_cm"])
        self.assertAlmostEqual(taken["settings"]["taken_off_g"], -0.05, places=6)

    def test_mistakes(self):
        for words, sentence in (
            (["absent.csv"], "FILE = absent.csv: there is no such file"),
            ([], "FILE = (none): must be given"),
            (["--mass", "0", "x"], "--mass = 0: must lie in"),
            (["measured.csv", "--out", "measured.csv/below"], "--out = measured.csv/below: the folder cannot be made"),
        ):
            if not os.path.exists("measured.csv"):
                self.test_table()
            code, out, err = self.reduce(*words)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
            self.assertTrue(err.startswith("arenite-ffp: " + sentence), err)


class Paper(DriverTest):
    """`arenite-ffp paper`: its cases, coarse."""

    COMMAND = ["paper", "--quick", "--cell", "0.04", "--no-pictures", "--threads", "1"]

    def paper(self, *words):
        done = subprocess.run([DRIVER, *self.COMMAND, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        return done.returncode, done.stdout, done.stderr

    def found(self, folder):
        with open(os.path.join(folder, "paper.json")) as file:
            return json.load(file)

    def setUp(self):
        shutil.rmtree("paper", ignore_errors=True)

    def test_table(self):
        """Every case, then nothing to do; the table has the cases' numbers."""
        code, out, err = self.paper("--out", "paper")
        self.assertEqual(code, 0, err)
        found = self.found("paper")
        self.assertEqual(len(found["cases"]), 14)
        self.assertEqual({case["status"] for case in found["cases"]}, {"done"})
        smooth, rough, other = (summary(f"paper/{name}") for name in ("rigid-20", "rigid-40", "rigid-20-log-rate"))
        self.assertEqual(other["inputs"]["law"], "log-rate")
        lines = {(one["model"], one["quantity"]): one for one in found["comparisons"]}
        plain, rate = "half-section, mohr-coulomb", "half-section, log-rate"
        first = lines[plain, "final penetration, delta = 20 deg"]
        self.assertEqual((first["paper"], first["bar"]), (20, None))
        self.assertAlmostEqual(first["ours"], smooth["final_penetration_m"] * 100, delta=1e-9)
        self.assertAlmostEqual(first["difference"], first["ours"] - 20, delta=1e-9)
        self.assertAlmostEqual(lines[plain, "fully rough over 20 deg"]["ours"],
                               rough["final_penetration_m"] / smooth["final_penetration_m"], delta=1e-12)
        self.assertEqual(lines[rate, "peak deceleration, delta = 20 deg"]["ours"], other["peak_deceleration_g"])
        columns = history("paper/rigid-20")
        later = next(k for k, time in enumerate(columns["time_s"]) if time >= 0.025)
        self.assertTrue(columns["penetration_m"][later - 1] * 100 < lines[plain, "depth at 25 ms, delta = 20 deg"]["ours"]
                        <= columns["penetration_m"][later] * 100)
        self.assertIn("elastic penetrometer has only Mohr-Coulomb", out)
        self.assertNotIn("slice", out)
        self.assertIn(f"{first['ours']:.3g}", out)
        self.assertEqual(len(field_files("paper/rigid-20")), 6 * 3)  # those of figure 4

        before = {case["name"]: content(f"paper/{case['name']}", "summary.json") for case in found["cases"]}
        bar = dict(smooth, uncertainty={"final_penetration_m": {"value": 0.2, "u": 0.0123}})
        with open("paper/rigid-20/summary.json", "w") as file:
            json.dump(bar, file)
        code, again, err = self.paper("--out", "paper")
        self.assertEqual(code, 0, err)
        self.assertIn("+-1.23", again)
        del before["rigid-20"]
        self.assertEqual({name: content(f"paper/{name}", "summary.json") for name in before}, before)

    def test_interrupted(self):
        """A signal ends the case at hand with its exit code; the same command goes on, to the same numbers."""
        driver = subprocess.Popen([DRIVER, *self.COMMAND, "--out", "paper"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True)
        until = time.monotonic() + 60
        while time.monotonic() < until and driver.poll() is None and not os.path.exists("paper/rigid-24/history.csv"):
            time.sleep(0.001)
        driver.send_signal(signal.SIGINT)
        _, err = driver.communicate()
        self.assertEqual(driver.returncode, 130, err)
        self.assertIn("interrupted by SIGINT", err)
        self.assertIn("the same command goes on", err)
        status = {case["name"]: case["status"] for case in self.found("paper")["cases"]}
        self.assertEqual((status["rigid-20"], status["elastic-20"]), ("done", "not run"))
        code, _, err = self.paper("--out", "paper", "--law", "mohr-coulomb")
        self.assertEqual(code, 0, err)
        self.assertEqual(len(self.found("paper")["cases"]), 8)
        alone = self.run_drop("alone", "--cell", "0.04", "--delta", "24", "--fields-every", "0", "--threads", "1")[1]
        self.assertEqual(summary("paper/rigid-24")["final_penetration_m"], alone["final_penetration_m"])

    def test_mistakes(self):
        for words, sentence in (
            (["--law", "softening"], "--residual-friction = (none): must be given"),
            (["--cell", "1"], "--cell = 1: must lie in [0.0025, 0.04] m"),
            (["--wings"], "--wings: no such option; see arenite-ffp paper --help"),
        ):
            code, out, err = self.paper("--out", "paper", *words)
            self.assertEqual((code, out, err), (2, "", "arenite-ffp: " + err[len("arenite-ffp: "):]))
            self.assertTrue(err.startswith("arenite-ffp: " + sentence), err)
        self.assertFalse(os.path.exists("paper"))
        self.run_drop("paper/rigid-20", *SHORT)  # of other inputs
        code, _, err = self.paper("--out", "paper")
        self.assertEqual(code, 2)
        self.assertIn("case rigid-20: --resume: ", err)
        self.assertIn("--anew runs it again", err)


class CommandLine(DriverTest):
    """Random words: an answer, or one sentence and exit code 2. tests/ffp/command_line.cpp tries many more in-process."""

    def test_words(self):
        choose = random.Random(7)
        words = ["drop", "--help", "--version", "--cell", "--cell=1", "-1", "--", "", "\n", "--mesh", "/", "\udcff", "--out", "a" * 9999,
                 "--end=0", "--k0", "nan", "--quiet", "--force", "--no-slip=", "--points-per-element", "7"]
        for _ in range(40):
            line = ["drop", *choose.choices(words, k=choose.randrange(1, 6)), "--end=-1"]  # so that nothing is run
            done = subprocess.run([DRIVER, *line], capture_output=True, stdin=subprocess.DEVNULL)
            self.assertIn(done.returncode, (0, 2), line)
            self.assertEqual(done.stderr.count(b"\n"), 1 if done.returncode else 0, (line, done.stderr))
            self.assertLess(len(done.stderr), 500)


class Study(DriverTest):
    """The script that runs the documentation's tables."""

    SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "ffp", "scripts", "study.py")
    COMMON = " ".join([*COARSE, "--end", "0.03"])

    def study(self, *options):
        command = [sys.executable, self.SCRIPT, "--driver", DRIVER, "--out", "study", *options]
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
        return done.returncode, done.stdout, done.stderr

    def test_table(self):
        shutil.rmtree("study", ignore_errors=True)
        code, out, err = self.study("--only", "delta", "--options", self.COMMON)
        self.assertEqual(code, 0, err)
        self.assertEqual(sum(" drop " in line for line in err.splitlines()), 7, err)  # each drop is told
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in out.splitlines() if line.startswith("|")]
        head, _, *rows = rows
        self.assertEqual([row[0] for row in rows], ["20", "24", "28", "32", "36", "40", "no slip"])
        self.assertEqual({len(row) for row in rows}, {len(head)})
        for row, options in zip(rows, [*(f"delta-{row[0]}" for row in rows[:-1]), "no-slip"]):
            found = summary(os.path.join("study", f"{options}-cell-0.04-points-per-element-10-end-0.03"))
            self.assertEqual(float(row[1]), round(found["final_penetration_m"], 4))
            self.assertEqual(row[3].split(",")[0], f"{found['peak_deceleration_g']:.1f}")
        # What is there is not run again.
        self.assertEqual(self.study("--only", "delta", "--options", self.COMMON), (0, out, ""))

    def test_peaks(self):
        with unittest.mock.patch.object(sys, "path", [os.path.dirname(self.SCRIPT), *sys.path]):
            import study
        runs = study.Runs(DRIVER, "peaks", self.COMMON, 0)
        with open(os.devnull, "w") as nowhere, unittest.mock.patch.object(sys, "stderr", nowhere):
            found = runs.drop("")
        wide, narrow = runs.peaks("", [2e-3, 1e-9])
        self.assertAlmostEqual(wide, found["peak_deceleration_g"], delta=1e-9 * wide)
        self.assertAlmostEqual(narrow, found["raw_peak_deceleration_g"], delta=0.01 * narrow)

    def test_tables(self):
        """Tables as the scripts read them: the program's own, and nothing that looks like one."""
        with unittest.mock.patch.object(sys, "path", [os.path.dirname(self.SCRIPT), *sys.path]):
            import regular_file

        def read(text, *needed, encoding="utf-8"):
            with open("table.csv", "w", encoding=encoding) as file:
                file.write(text)
            try:
                return regular_file.read_table("table.csv", *needed)
            except ValueError as problem:
                return str(problem)

        self.assertEqual(repr(read("a,b\n0,1\n2,\n3,0.", "a")), "{'a': [0.0, 2.0], 'b': [1.0, nan]}")
        self.assertIn("line 3, number of fields = 3: must be 2", read("a,b\n0,1\n0,1,5\n"))
        self.assertIn("line 2, number of fields = 1: must be 2", read("a,b\n0\n"))
        self.assertIn("line 2: must be numbers", read("a,b\n0,x\n"))
        self.assertIn("must have a column a", read("a;b\n0,5;1\n", "a"))
        self.assertIn("codec can't decode", read("a,b\n", encoding="utf-16"))

    def test_convergence(self):
        """What resolution.py repeats of the library's study/convergence.hpp: the numbers of tests/study/convergence.cpp."""
        with unittest.mock.patch.object(sys, "path", [os.path.dirname(self.SCRIPT), *sys.path]):
            import resolution
        for values, expected in (
            ((0.1, 0.173, 0.184, 0.191), (math.log2(11 / 7), 0.20325, 0.0153125)),  # of the last three
            ((0.173, 0.181, 0.182), (3, None, 0.027)),
            ((1, 2, 3), (0, None, 6)),
            ((23.5, 21.9, 22.3), (None, None, 4.8)),
            ((23.5, 21.9, 21.9), (None, None, 4.8)),
        ):
            for found, exact in zip(resolution.convergence(values), expected):
                if exact is None:
                    self.assertIsNone(found, values)
                else:
                    self.assertAlmostEqual(found, exact, places=9, msg=values)

    def test_mistakes(self):
        code, _, err = self.study("--only", "delta", "--options", "--cell -1")
        self.assertEqual(code, 1)
        self.assertIn("--cell = -1: ", err)
        self.assertTrue(err.splitlines()[-1].startswith("study.py: the drop stopped with exit code 2"), err)


if __name__ == "__main__":
    DRIVER = os.path.abspath(sys.argv.pop(1))
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs, and what they start, ignore it
    unittest.main()
