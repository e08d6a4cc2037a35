"""The reduction of a record."""

import json
import math
import os
import subprocess
import unittest.mock

import shared
from shared import GRAVITY, COARSE, content, DriverTest


class Reduced(DriverTest):
    """`arenite-ffp reduce`; tests/ffp/reduce.cpp has its numbers."""

    def reduce(self, *words, scripts="nowhere"):
        """Exit code, standard output and error; without scripts, and so without pictures, unless said."""
        with unittest.mock.patch.dict(os.environ, {"ARENITE_FFP_SCRIPTS": scripts}):
            done = subprocess.run([shared.DRIVER, "reduce", *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
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


if __name__ == "__main__":
    shared.main()
