"""Error bars."""

import os
import shutil
import signal
import subprocess
import sys
import time

import shared
from shared import drop, summary, content, field_files, DriverTest


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
                widest = max(max(cells) - min(cells), max(spread) - min(spread))
                self.assertAlmostEqual(bar["parts"]["cells"], 3 * widest, delta=1e-9)
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
        report = os.path.join(shared.SCRIPTS, "report.py")
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
        driver = subprocess.Popen([shared.DRIVER, "drop", *options], stderr=subprocess.PIPE, text=True)
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


if __name__ == "__main__":
    shared.main()
