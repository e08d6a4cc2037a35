"""Options of the driver, its inputs, and its messages about mistakes."""

import json
import os
import pty
import random
import subprocess
import sys

import shared
from shared import COARSE, GRID, SHORT, drop, summary, content, Mesh, DriverTest


class Options(DriverTest):
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
        driver = subprocess.Popen([shared.DRIVER, "drop", *options], stdin=subprocess.DEVNULL, stdout=terminal, stderr=terminal)
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
        done = subprocess.run([shared.DRIVER, "--version"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^arenite-ffp \d+\.\d+\.\d+\n$")

    def test_report(self):
        """The table that examples/ffp/run.sh prints, of any end."""
        script = os.path.join(shared.SCRIPTS, "report.py")

        def report(folder):
            done = subprocess.run([sys.executable, script, folder], capture_output=True, text=True)
            return done.returncode, done.stdout, done.stderr

        _, found = self.run_drop("reported", *SHORT)
        code, out, err = report("reported")
        self.assertEqual((code, err), (0, ""))
        self.assertIn("penetrometer       bluedrop, cone: 8.75 cm wide, 63.1 cm long, 7.71 kg (2,209 kg/m3)\n", out)
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
        driver = subprocess.Popen([shared.DRIVER, "drop", *SHORT, "--out", "closed"], stdout=writer, stderr=writer)
        os.close(writer)
        self.assertEqual(driver.wait(), 0)
        self.assertEqual(summary("closed")["status"], "done")


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
        self.assert_refused("--mesh-kind = grid: needs --kinematics axisymmetric or space, --device rigid", "--mesh-kind", "grid", "--device", "elastic")
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
        done = subprocess.run([shared.DRIVER], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertTrue(done.stderr.startswith("arenite-ffp: command: must be drop"), done.stderr)

    def test_folder(self):
        with open("a_file", "w") as file:
            file.write("not a folder\n")
        for folder in ("a_file", "a_file/below"):
            code, out, err = drop(*SHORT, "--out", folder)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
            self.assertIn(f"--out = {folder}: ", err)


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


class CommandLine(DriverTest):
    """Random words: an answer, or one sentence and exit code 2. tests/ffp/command_line.cpp tries many more in-process."""

    def test_words(self):
        choose = random.Random(7)
        words = ["drop", "--help", "--version", "--cell", "--cell=1", "-1", "--", "", "\n", "--mesh", "/", "\udcff", "--out", "a" * 9999,
                 "--end=0", "--k0", "nan", "--quiet", "--force", "--no-slip=", "--points-per-element", "7"]
        for _ in range(40):
            line = ["drop", *choose.choices(words, k=choose.randrange(1, 6)), "--end=-1"]  # so that nothing is run
            done = subprocess.run([shared.DRIVER, *line], capture_output=True, stdin=subprocess.DEVNULL)
            self.assertIn(done.returncode, (0, 2), line)
            self.assertEqual(done.stderr.count(b"\n"), 1 if done.returncode else 0, (line, done.stderr))
            self.assertLess(len(done.stderr), 500)


if __name__ == "__main__":
    shared.main()
