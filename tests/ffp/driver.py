"""The driver arenite-ffp from outside: its files, its numbers, its words when something is wrong. Standard library only.

    driver.py ARENITE_FFP [unittest options]      writes into the working folder
"""

import csv
import json
import os
import pty
import shutil
import struct
import subprocess
import sys
import unittest
import unittest.mock
import xml.etree.ElementTree as ElementTree

DRIVER = ""
GRAVITY = 9.81
COARSE = ["--cell", "0.04", "--points-per-element", "10"]
SLICE = ["--kinematics", "slice", "--cell", "0.04", "--points-per-element", "4", "--end", "0.004"]
SHORT = [*COARSE, "--end", "0.01", "--fields-every", "0"]
FIRST_COLUMNS = "time_s,penetration_m,velocity_m_s,acceleration_m_s2,reaction_N,"
KEYS = """final_penetration_m max_penetration_m peak_deceleration_g peak_time_s peak_penetration_m raw_peak_deceleration_g
    points steps dt_min_s dt_max_s wall_s point_steps_per_s threads register_bytes lost_points energy_residual inputs status""".split()
INPUTS = """kinematics device velocity_m_s mass_kg shoulder fillet_m device_young_Pa device_poisson delta_deg no_slip
    friction_deg dilatancy_deg cohesion_Pa young_Pa poisson unit_weight_N_m3 k0 contact cell_m points_per_element
    moving_depth_m mesh anti_locking flip courant end_s fields_every_s""".split()


def drop(*options):
    """Runs `arenite-ffp drop OPTIONS`; returns exit code, standard output and standard error."""
    done = subprocess.run([DRIVER, "drop", *options], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    return done.returncode, done.stdout, done.stderr


def history(folder):
    """Columns of history.csv by name."""
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.reader(file))
    return {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


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
        """A run that must succeed without a word."""
        self.assertEqual(drop("--out", folder, *options), (0, "", ""))
        return history(folder), summary(folder)

    def assert_refused(self, sentence, *options):
        """Exit code 2 and one line on standard error that begins with the sentence; nothing is written."""
        code, out, err = drop("--out", "refused", *options)
        self.assertEqual((code, out), (2, ""), err)
        self.assertEqual(err.count("\n"), 1, err)
        self.assertTrue(err.startswith("arenite-ffp: " + sentence), err)
        self.assertFalse(os.path.exists("refused"))

    def assert_consistent(self, columns, mass=7.71, velocity=5.6, balance=1e-9):
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
        for i, residual in enumerate(columns["energy_residual_J"]):
            kept = sum(columns[n][i] for n in ("kinetic_energy_J", "strain_energy_J", "plastic_work_J", "contact_dissipation_J"))
            # Without the strain energy at rest, which is not a column.
            start = columns["kinetic_energy_J"][0] + columns["strain_energy_J"][0]
            self.assertAlmostEqual(residual, kept - start - columns["external_work_J"][i], delta=1e-8)
            self.assertLess(abs(residual), 0.05 * put_in)
        self.assertEqual(set(columns["lost_points"]), {0})

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


class Widths(DriverTest):
    """Where the driver is built for several widths of registers it gives the same drop in each, to round-off."""

    def test_widths(self):
        depths = {}
        for width in ("16", "32", "64"):
            with unittest.mock.patch.dict(os.environ, {"ARENITE_REGISTER_BYTES": width}):
                code, _, err = drop(*COARSE, "--end", "0.003", "--fields-every", "0", "--out", "width" + width)
            if code < 0:  # SIGILL: this processor has no such registers
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
        self.assertEqual(self.on_a_terminal(*SHORT, "--out", "quiet", "--quiet"), b"")


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
        refuse("absent.msh", "can be read")
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
    """A run that fails physically: exit code 1, a sentence, and files that can be read."""

    def test_used_up(self):
        code, out, err = drop(*COARSE, "--delta", "0", "--velocity", "12", "--mass", "20", "--fields-every", "0.01", "--out", "used_up")
        self.assertEqual((code, out, err.count("\n")), (1, "", 1), err)
        self.assertTrue(err.startswith("arenite-ffp: the run failed: t = 0.0"), err)
        self.assertIn("the compressing zone below -0.06 m is used up after a travel of", err)
        columns, found = history("used_up"), summary("used_up")
        self.assert_consistent(columns, mass=20, velocity=12)
        self.assertEqual(found["status"], "failed")
        self.assertIn(found["failure"], err)
        self.assertEqual(found["steps"], len(columns["time_s"]) - 1)
        self.assertEqual(found["final_penetration_m"], columns["penetration_m"][-1])
        for _, path in field_files("used_up"):
            self.assertTrue(vtu(path))


class Study(DriverTest):
    """The script that runs the documentation's tables."""

    SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "ffp", "study.py")
    COMMON = " ".join([*COARSE, "--end", "0.03"])

    def study(self, *options):
        command = [sys.executable, self.SCRIPT, "--driver", DRIVER, "--out", "study", *options]
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
        return done.returncode, done.stdout, done.stderr

    def test_table(self):
        shutil.rmtree("study", ignore_errors=True)
        code, out, err = self.study("--only", "delta", "--options", self.COMMON)
        self.assertEqual((code, err.count("\n")), (0, 7), err)  # a line for each drop
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

    def test_mistakes(self):
        code, _, err = self.study("--only", "delta", "--options", "--cell -1")
        self.assertEqual(code, 1)
        self.assertIn("--cell = -1: ", err)
        self.assertTrue(err.splitlines()[-1].startswith("study.py: the drop stopped with exit code 2"), err)


if __name__ == "__main__":
    DRIVER = os.path.abspath(sys.argv.pop(1))
    unittest.main()
