"""Runs that fail, are interrupted or killed, and resume."""

import os
import resource
import shutil
import signal
import subprocess
import time

import shared
from shared import COARSE, SHORT, drop, history, summary, content, field_files, DriverTest


class Failures(DriverTest):
    """A run that fails: exit code 1, a sentence, and files that can be read."""

    def assert_failed(self, folder, status, *options, **limits):
        done = subprocess.run([shared.DRIVER, "drop", "--quiet", "--out", folder, *options], capture_output=True, text=True, **limits)
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
        self.assertIn("; the sand is 0.4 m deep: give more --soil-depth", found["failure"])
        self.assert_consistent(columns, mass=20, velocity=12)

    def test_watch(self):
        """Past a limit the run stops; the step at which it did has its fields; a tenth of the limit warns."""
        options = [*COARSE, "--flip", "0.999"]
        free, found = self.run_drop("free", *options, "--no-watch", "--fields-every", "0")
        self.assertNotIn("watch", found)
        self.assertEqual(shared.warnings_of(found), [])
        swelling = max(abs(ratio - 1) for ratio in free["mean_volume_ratio"])
        limit = str(swelling / 2)
        columns, found = self.assert_failed("watched", "failed", *options, "--watch-volume", limit, "--fields-every", "0.09")
        self.assertIn("volume = ", found["failure"])
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


class InterruptedRuns(DriverTest):
    """One folder, one run, and its summary says how it stands."""

    LONG = [*COARSE, "--end", "10", "--fields-every", "1", "--quiet"]

    def start(self, folder):
        """A long run, once it has taken some steps."""
        shutil.rmtree(folder, ignore_errors=True)

        def default_signals():  # a test in the background may have been given SIGINT to ignore
            signal.signal(signal.SIGINT, signal.SIG_DFL)

        driver = subprocess.Popen([shared.DRIVER, "drop", *self.LONG, "--out", folder], stderr=subprocess.PIPE, text=True,
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
            driver = subprocess.Popen([shared.DRIVER, "drop", *options, "--out", "killed"], stderr=subprocess.DEVNULL)
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
                [shared.DRIVER, "drop", *options, "--quiet", "--out", folder, "--resume", "--checkpoint-every", "0.002",
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
        open(os.path.join("finished", "checkpoint.state"), "w").close()  # as of a run that was killed as it ended
        code, out, err = drop(*SHORT, "--out", "finished", "--resume")
        self.assertEqual((code, out, err), (0, "", "arenite-ffp: the run in finished is finished; nothing to do\n"))
        self.assertFalse(os.path.exists(os.path.join("finished", "checkpoint.state")))
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
        driver = subprocess.Popen([shared.DRIVER, "drop", *options], stderr=subprocess.DEVNULL)
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


if __name__ == "__main__":
    shared.main()
