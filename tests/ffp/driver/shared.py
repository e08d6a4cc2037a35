"""What the tests of the driver share: runs of arenite-ffp, its files, what holds for any drop. Standard library only.

    FILE.py ARENITE_FFP [unittest options]      writes into the working folder
"""

import csv
import json
import os
import resource
import shutil
import signal
import struct
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

DRIVER = ""
SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "examples", "ffp", "scripts")
GRAVITY = 9.81
COARSE = ["--cell", "0.04", "--points-per-element", "10"]
SLICE = ["--kinematics", "slice", "--cell", "0.04", "--points-per-element", "4", "--end", "0.004"]
GRID = ["--mesh-kind", "grid", "--cell", "0.04"]
SPACE = ["--kinematics", "space", "--cell", "0.04"]
SHORT = [*COARSE, "--end", "0.01", "--fields-every", "0"]
ARE_COARSE = "is coarser than an eighth of the penetrometer's diameter"
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
    return done.returncode, done.stdout, "".join(line for line in done.stderr.splitlines(True) if ARE_COARSE not in line)


def warnings_of(found):
    """Warnings of a summary, but that cells are coarse, as most here are."""
    return [text for text in found["warnings"] if ARE_COARSE not in text]


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
        self.assertEqual(err.splitlines(), ["arenite-ffp: warning: " + text for text in warnings_of(found)])
        return history(folder), found

    def assert_refused(self, sentence, *options):
        """Exit code 2 and one line on standard error that begins with the sentence; nothing is written."""
        code, out, err = drop("--out", "refused", *options)
        self.assertEqual((code, out), (2, ""), err)
        self.assertEqual(err.count("\n"), 1, err)
        self.assertTrue(err.startswith("arenite-ffp: " + sentence), err)
        self.assertFalse(os.path.exists("refused"))

    def assert_consistent(self, columns, mass=7.71, velocity=5.6, balance=1e-9, residual=0.05, turns=False):
        """What holds for any drop, whatever its numerics. `turns`: depth is the tip's, velocity the centre of mass's."""
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
            if not turns:
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


def main():
    """The tests of the file that is run, for the driver that its first argument names."""
    global DRIVER
    DRIVER = os.path.abspath(sys.argv.pop(1))
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs, and what they start, ignore it
    unittest.main()
