"""Special files: pipes, devices, links and folders in the place of files."""

import json
import os
import shutil
import subprocess
import sys

import shared
from shared import COARSE, SHORT, summary, content, DriverTest


class SpecialFiles(DriverTest):
    """Files that are links, pipes, devices, endless or nested without end: nothing is emptied, waited for or read to its end."""

    def setUp(self):
        super().setUp()
        shutil.rmtree("doors", ignore_errors=True)
        os.mkdir("doors")
        with open("doors/precious", "w") as file:
            file.write("precious")

    def refused(self, sentence, *words):
        done = subprocess.run([shared.DRIVER, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=60)
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
            done = subprocess.run(["/usr/bin/python3", os.path.join(shared.SCRIPTS, script), "doors/drop"],
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 1, script)
            self.assertIn("must be a regular file, not a pipe", done.stderr, script)
        read = "import study; study.Runs.ended('doors/drop')"
        done = subprocess.run([sys.executable, "-c", read], capture_output=True, text=True, timeout=60,
                              env={**os.environ, "PYTHONPATH": shared.SCRIPTS})
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
        done = subprocess.run([shared.DRIVER, "reduce", "doors/drop/history.csv", "--impact-time", "0", "--impact-velocity", "5.6", "--out",
                               "doors/table", "--no-picture"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)  # as the sentence says


if __name__ == "__main__":
    shared.main()
