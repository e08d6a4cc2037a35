"""Penetrometers that are pushed."""

import csv
import json
import math
import os
import shutil
import signal
import subprocess

import shared
from shared import DriverTest, history, summary

#: A cone of 0.3 diameters a cell, in a narrow chamber.
COARSE = ["--cell", "0.0107", "--chamber-radius", "0.25", "--start-depth", "0.09", "--distance", "0.072", "--no-picture"]


def push(*options, **kinds):
    return subprocess.run([shared.DRIVER, "push", *options], capture_output=True, text=True, stdin=subprocess.DEVNULL, **kinds)


class Pushes(DriverTest):
    def test_a_cone_in_clay(self):
        done = push(*COARSE, "--cell", "0.0071", "--start-depth", "0.1428", "--out", "cone")
        self.assertEqual(done.returncode, 0, done.stderr)
        found, rows = summary("cone"), history("cone")
        self.assertEqual(found["status"], "done")
        self.assertIn(f"net {found['resistance_factor']:.3g} strengths", done.stdout)
        (form,) = found["closed_forms"]
        self.assertAlmostEqual(form["kPa"], 20 * 9.716, delta=0.05)
        self.assertLess(abs(form["ratio"] - 1), 0.08, done.stdout)
        # Energy: what the penetrometer puts in is used up by the clay.
        self.assertLess(abs(found["energy_residual"]), 0.1)
        self.assertGreater(rows["plastic_work_J"][-1], 0.8 * rows["external_work_J"][-1])
        # Work is force times way; the force is the tip's, for the shaft is smooth.
        way, force = rows["pushed_m"], rows["force_N"]
        work = sum((b - a) * f for a, b, f in zip([0, *way], way, force))
        self.assertAlmostEqual(work / rows["external_work_J"][-1], 1, delta=0.03)
        section = math.pi * 0.0357**2 / 4
        for q, f in zip(rows["q_c_kPa"], force):
            self.assertAlmostEqual(q * 1e3 * section, f, delta=0.02 * abs(f) + 1)
        self.assertEqual({round(b - a, 4) for a, b in zip(way[:-2], way[1:-1])} - {0.0017, 0.0018, 0.0019}, set())

    def test_a_rough_one_bears_more(self):
        """By 2.2 strengths times roughness (Teh and Houlsby 1991); the sleeve bears roughness times strength, where it touches clay."""
        for roughness in ("0", "0.5"):
            done = push(*COARSE, "--roughness", roughness, "--out", roughness)
            self.assertEqual(done.returncode, 0, done.stderr)
        smooth, half = summary("0"), summary("0.5")
        self.assertAlmostEqual(half["resistance_factor"], smooth["resistance_factor"] + 1.1, delta=0.4)
        self.assertEqual(smooth["f_s_kPa"], 0)
        self.assertLess(half["f_s_kPa"], 10 * (1 + 1e-9))
        self.assertGreater(half["f_s_kPa"], 8)

    def test_twice_the_size_is_the_same(self):
        """In the ground, unit weight and gravity apart: without weight lengths scale, and times with them."""
        light = ["--unit-weight", "1000"]
        twice = [str(2 * float(word)) if word.startswith("0.") else word for word in COARSE]
        self.assertEqual(push(*COARSE, *light, "--out", "one").returncode, 0)
        self.assertEqual(push(*twice, "--diameter", "0.0714", "--length", "0.514896", "--unit-weight", "1000", "--out", "two").returncode, 0)
        self.assertAlmostEqual(summary("two")["resistance_factor"] / summary("one")["resistance_factor"], 1, delta=0.01)

    def test_sand_bears_more_under_more(self):
        found = []
        for pressure in ("2e4", "1e5"):
            done = push(*COARSE, "--ground", "sand", "--overburden", pressure, "--out", pressure)
            self.assertEqual(done.returncode, 0, done.stderr)
            found.append(summary(pressure))
            self.assertGreater(found[-1]["closed_forms"][0]["ratio"], 0.5)
            self.assertGreater(found[-1]["f_s_kPa"], 0)
        self.assertGreater(found[1]["q_c_kPa"], 1.5 * found[0]["q_c_kPa"])

    def test_interrupted(self):
        shutil.rmtree("stopped", ignore_errors=True)
        process = subprocess.Popen([shared.DRIVER, "push", *COARSE, "--quiet", "--out", "stopped"], stderr=subprocess.PIPE, text=True)
        try:
            while not os.path.exists("stopped/history.csv") or os.path.getsize("stopped/history.csv") < 400:
                self.assertIsNone(process.poll())
            process.send_signal(signal.SIGINT)
            said = process.communicate(timeout=60)[1]
        finally:
            process.kill()
        self.assertEqual(process.returncode, 130, said)
        self.assertEqual(summary("stopped")["status"], "interrupted")
        with open("stopped/history.csv", newline="") as file:
            self.assertEqual({len(row) for row in csv.reader(file)}, {17})

    def test_values(self):
        done = subprocess.run([shared.DRIVER, "values"], capture_output=True, text=True,
                              input=json.dumps({"command": "push", "options": {"cell": "1"}}))
        self.assertEqual(done.returncode, 2)
        self.assertIn("--cell = 1: must lie in [0.001071, 0.01071] m", done.stderr)


if __name__ == "__main__":
    shared.main()
