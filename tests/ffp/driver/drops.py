"""Whole drops: their files and numbers, the same bits on any threads and widths."""

import json
import os
import unittest.mock

import shared
from shared import COARSE, SLICE, GRID, SPACE, SHORT, FIRST_COLUMNS, drop, summary, content, field_files, vtu, DriverTest


class Drops(DriverTest):
    """Whole drops of the default composition, coarse."""

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


class Devices(DriverTest):
    """Penetrometers of other sizes and outlines."""

    def test_a_quarter_of_the_size(self):
        """Lengths over 4, times and velocities over 2, stiffness over 4, mass over 64: the same drop, to the bit, for all are powers of 2."""
        large, _ = self.run_drop("size_1", *SHORT)
        small, found = self.run_drop("size_4", "--diameter", "0.021875", "--length", "0.15775", "--mass", "0.12046875", "--velocity", "2.8",
                                     "--young", "1.25e6", "--cell", "0.01", "--points-per-element", "10", "--end", "0.005",
                                     "--fields-every", "0")
        self.assertGreater(len(large["time_s"]), 50)
        for name, scale in (("time_s", 2), ("penetration_m", 4), ("velocity_m_s", 2), ("acceleration_m_s2", 1), ("reaction_N", 64),
                            ("kinetic_energy_J", 256), ("contact_dissipation_J", 256), ("mean_volume_ratio", 1)):
            self.assertEqual([scale * x for x in small[name]], large[name], name)
        told = found["penetrometer"]
        self.assertEqual((told["name"], told["diameter_m"], told["length_m"]), ("bluedrop, cone, changed", 0.021875, 0.15775))
        self.assertAlmostEqual(told["section_m2"], 3.7582e-4, delta=1e-8)
        self.assertEqual(found["chamber"], {"radius_m": 0.1, "soil_depth_m": 0.1})
        self.assertTrue(any("is coarser than an eighth of the penetrometer's diameter, 0.00273 m" in text for text in found["warnings"]))

    def test_outlines(self):
        """The same cone drawn as an outline drops as itself; a ball and a sphere drop, too, and their reductions know them."""
        profile = '{"name": "drawn", "mass_kg": 7.71, "profile": [[0, 0], [0.04375, 0.07577722283113838], [0.04375, 0.631]]}'
        with open("drawn.json", "w") as file:
            file.write(profile)
        plain, _ = self.run_drop("plain", *SHORT)
        drawn, found = self.run_drop("drawn", *SHORT, "--device-file", "drawn.json")
        self.assertEqual(len(drawn["time_s"]), len(plain["time_s"]))
        for a, b in zip(drawn["penetration_m"], plain["penetration_m"]):
            self.assertAlmostEqual(a, b, delta=1e-9)
        self.assertEqual(found["inputs"]["device_profile"]["profile"][1], [0.04375, 0.07577722283113838])
        again, _ = self.run_drop("again", "--input", "drawn/summary.json")
        self.assertEqual(again["penetration_m"], drawn["penetration_m"])
        for name, mass in (("ball-100cm2", "6"), ("sphere-25cm", "40")):
            columns, found = self.run_drop(name, "--penetrometer", name, "--mass", mass, "--accuracy", "coarse", "--end", "0.03",
                                           "--fields-every", "0")
            self.assert_consistent(columns, mass=float(mass))
            self.assertEqual(found["penetrometer"]["name"], name)
            with open(os.path.join(name, "reduced.json")) as file:
                self.assertEqual(json.load(file)["penetrometer"], found["penetrometer"])


class OtherDrops(DriverTest):
    """Whole drops of the other compositions, coarse."""

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

    def test_space(self):
        """Upright it goes straight down, about as far as the half-section; tilted it turns on, and the tip goes where it pointed."""
        section, _ = self.run_drop("space_section", *GRID, "--cell", "0.02", "--contact", "rigid", "--end", "0.02", "--fields-every", "0")
        upright, _ = self.run_drop("space", *SPACE, "--cell", "0.02", "--end", "0.02", "--fields-every", "0")
        tilted, found = self.run_drop("space_tilted", *SPACE, "--end", "0.05", "--tilt", "10", "--fields-every", "0.05")
        for columns in (upright, tilted):
            self.assert_consistent(columns, residual=0.01, turns=columns is tilted)
            self.assertTrue(all(f != f for f in columns["fill_ratio"]))
        self.assert_summary(found, tilted)
        self.assertLess(max(map(abs, upright["tilt_deg"] + upright["aside_m"])), 1e-9)
        self.assertLess(abs(upright["penetration_m"][-1] / section["penetration_m"][-1] - 1), 0.04)  # 2.5 %
        self.assertEqual((tilted["tilt_deg"][0], tilted["aside_m"][0]), (10, 0))
        self.assertAlmostEqual(tilted["penetration_m"][0], 0, delta=1e-15)
        self.assertTrue(12 < found["final_tilt_deg"] == tilted["tilt_deg"][-1] < 30)
        self.assertTrue(0.005 < found["final_aside_m"] == tilted["aside_m"][-1] < 0.1)
        # Momentum aside and angular momentum: what the sand gives in each step is what changes.
        self.assertLess(max(map(abs, upright["aside_reaction_N"])), 1e-6 * max(upright["reaction_N"]))
        for velocity, force in ("aside_velocity_m_s", "aside_reaction_N"), ("spin_rad_s", "moment_N_m"):
            given = [0.0]
            for value, step in zip(tilted[force][1:], tilted["time_step_s"][1:]):
                given.append(given[-1] + value * step)
            change = [value - tilted[velocity][0] for value in tilted[velocity]]
            mass = given[-1] / change[-1]  # or moment of inertia, kg m^2
            if force == "aside_reaction_N":
                self.assertAlmostEqual(mass, 7.71, delta=1e-6)
            else:
                self.assertTrue(0.1 < mass < 7.71 * 0.631 ** 2 / 4, mass)
            for one, other in zip(given, change):
                self.assertAlmostEqual(one, mass * other, delta=1e-6 * max(map(abs, given)))
        turned = sum(spin * step for spin, step in zip(tilted["spin_rad_s"][1:], tilted["time_step_s"][1:]))
        self.assertAlmostEqual(10 + turned * 180 / 3.141592653589793, tilted["tilt_deg"][-1], delta=0.1)
        self.assertEqual(len(vtu(field_files("space_tilted")[0][1])["deviatoric_strain"]), found["points"])
        self.assertNotIn("tilt_deg", section)

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


class OtherSameBits(DriverTest):
    """The same of the other compositions."""

    check = SameBits.check

    def test_grid(self):
        self.check("bits_grid", *GRID, "--cell-at-cone", "0.02", "--end", "0.01")

    def test_centre_of_mass(self):
        self.check("bits_centre", *COARSE, "--end", "0.01", "--contact", "centre-of-mass")

    def test_elastic(self):
        self.check("bits_elastic", *COARSE, "--end", "0.01", "--device", "elastic")

    def test_slice(self):
        self.check("bits_slice", *SLICE, "--end", "0.002")


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


if __name__ == "__main__":
    shared.main()
