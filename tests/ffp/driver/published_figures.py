"""The figures of the paper, the tables of the documentation, the pictures."""

import json
import math
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest.mock

import shared
from shared import COARSE, SHORT, history, summary, content, field_files, DriverTest


class Paper(DriverTest):
    """`arenite-ffp paper`: its cases, coarse."""

    COMMAND = ["paper", "--quick", "--cell", "0.04", "--no-pictures", "--threads", "1"]

    def paper(self, *words):
        done = subprocess.run([shared.DRIVER, *self.COMMAND, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
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
        driver = subprocess.Popen([shared.DRIVER, *self.COMMAND, "--out", "paper"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
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


class Study(DriverTest):
    """The script that runs the documentation's tables."""

    COMMON = " ".join([*COARSE, "--end", "0.03"])

    def study(self, *options):
        command = [sys.executable, os.path.join(shared.SCRIPTS, "study.py"), "--driver", shared.DRIVER, "--out", "study", *options]
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
        with unittest.mock.patch.object(sys, "path", [shared.SCRIPTS, *sys.path]):
            import study
        runs = study.Runs(shared.DRIVER, "peaks", self.COMMON, 0)
        with open(os.devnull, "w") as nowhere, unittest.mock.patch.object(sys, "stderr", nowhere):
            found = runs.drop("")
        wide, narrow = runs.peaks("", [2e-3, 1e-9])
        self.assertAlmostEqual(wide, found["peak_deceleration_g"], delta=1e-9 * wide)
        self.assertAlmostEqual(narrow, found["raw_peak_deceleration_g"], delta=0.01 * narrow)

    def test_tables(self):
        """Tables as the scripts read them: the program's own, and nothing that looks like one."""
        with unittest.mock.patch.object(sys, "path", [shared.SCRIPTS, *sys.path]):
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
        """What resolution.py repeats of the library's error_bar/convergence.hpp: the numbers of tests/error_bar/convergence.cpp."""
        with unittest.mock.patch.object(sys, "path", [shared.SCRIPTS, *sys.path]):
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


class Pictures(DriverTest):
    """The pictures that examples/ffp/run.sh draws, with Debian's matplotlib."""

    def test_drawn(self):
        self.run_drop("pictures", *COARSE, "--end", "0.02", "--fields-every", "0.01")
        script = os.path.join(shared.SCRIPTS, "plot.py")
        done = subprocess.run(["/usr/bin/python3", script, "pictures"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(subprocess.run([shared.DRIVER, "paper", "--quick", "--cell", "0.04", "--law", "mohr-coulomb", "--out", "figures"],
                                        capture_output=True, stdin=subprocess.DEVNULL).returncode, 0)
        for number in (3, 4, 5, 6):
            self.assertGreater(len(content("figures", f"figure{number}.png")), 10000)
            self.assertIn(b"<svg", content("figures", f"figure{number}.svg"))
        done = subprocess.run([shared.DRIVER, "reduce", "pictures"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Pictures: pictures/reduced.png", done.stdout)
        self.assertIn(b"<svg", content("pictures", "reduced.svg"))
        for name in ("histories.png", "strain.png", "reduced.png"):
            self.assertTrue(content("pictures", name).startswith(b"\x89PNG"), name)
            self.assertGreater(len(content("pictures", name)), 10000)

    def test_values_of_the_paper_belong_to_its_case(self):
        """Other penetrometers, sands and impacts are drawn under their own names, without the paper's values."""
        paper = [*COARSE, "--end", "0.01", "--fields-every", "0"]
        cases = {"as_paper": ([], "bluedrop, cone"), "rough": (["--delta", "40"], "bluedrop, cone"),
                 "other_sand": (["--friction", "35"], "bluedrop, cone"), "slow": (["--velocity", "3"], "bluedrop, cone"),
                 "blunt": (["--tip", "blunt"], "bluedrop, blunt"),
                 "ball": (["--penetrometer", "ball-100cm2", "--mass", "8"], "ball-100cm2")}
        for folder, (options, _) in cases.items():
            self.run_drop(folder, *paper, *options)
        ask = "import sys, plot\nfor f in sys.argv[1:]: d = plot.Drop(f); print(f, d.of_paper, d.label([d]), sep='|')"
        done = subprocess.run(["/usr/bin/python3", "-c", ask, *cases], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": shared.SCRIPTS})
        self.assertEqual(done.returncode, 0, done.stderr)
        for line, (folder, (_, name)) in zip(done.stdout.splitlines(), cases.items()):
            of_paper = folder in ("as_paper", "rough")
            label = "δ = 40°" if folder == "rough" else "δ = 20°"
            self.assertEqual(line, f"{folder}|{of_paper}|{label}" + ("" if of_paper else f", {name}"))
        script = os.path.join(shared.SCRIPTS, "plot.py")
        self.assertEqual(subprocess.run(["/usr/bin/python3", script, "ball"], capture_output=True).returncode, 0)
        self.assertGreater(len(content("ball", "histories.png")), 10000)


if __name__ == "__main__":
    shared.main()
