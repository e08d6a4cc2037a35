"""Compiler time and memory of common units, for compile.sh, which says how to call it."""

import argparse
import os
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
EIGEN = os.environ.get("ARENITE_EIGEN", "/usr/include/eigen3")
SANITIZERS = ["-O1", "-g", "-fsanitize=address,undefined"]


def first_block(readme):
    """The C++ scene that README.md shows first."""
    return re.search(r"```cpp\n(.*?)```", readme.read_text(), re.S).group(1)


def rows(tree):
    """(name, code, flags) of each unit that the tree has."""
    scene, ball = first_block(tree / "README.md"), tree / "examples" / "ball_into_sand.cpp"
    umbrella = "#include <arenite/{}.hpp>\n"
    yield "README's scene", scene, ["-O2"]
    yield "README's scene, front end", scene, ["-fsyntax-only"]
    yield "README's scene, sanitizers", scene, SANITIZERS
    if ball.exists():
        yield "ball_into_sand.cpp", ball.read_text(), ["-O2"]
    yield "arenite.hpp", umbrella.format("arenite"), ["-fsyntax-only"]
    for name in "matter", "rigid", "contact", "loads":
        if (tree / "include" / "arenite" / f"{name}.hpp").exists():
            yield f"{name}.hpp", umbrella.format(name), ["-fsyntax-only"]
    if (tree / "src" / "cold").exists():
        cold = ["-O2", "-DARENITE_COLD_LIBRARY"]
        yield "README's scene, with arenite::cold", scene, cold
        if ball.exists():
            yield "ball_into_sand.cpp, with arenite::cold", ball.read_text(), cold


def cost(compiler, tree, code, flags, folder):
    """CPU seconds of the user's, and MB at most."""
    unit = Path(folder) / "unit.cpp"
    unit.write_text(code)
    command = [*compiler, "-std=c++20", f"-I{tree / 'include'}", "-isystem", EIGEN, "-c", str(unit), "-o", str(unit.with_suffix(".o")), *flags]
    child = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    said = child.stderr.read()
    _, status, used = os.wait4(child.pid, 0)
    if status != 0:
        raise RuntimeError(f"{' '.join(command)}\n{said}")
    return used.ru_utime, used.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("revision", nargs="?")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--only", default="")
    parser.add_argument("--compiler", default="g++")
    options = parser.parse_args()
    if options.rounds < 1:
        parser.error(f"--rounds = {options.rounds}: must be at least 1")
    with tempfile.TemporaryDirectory() as folder:
        trees = [ROOT]
        if options.revision:
            before = Path(folder) / "before"
            before.mkdir()
            archive = subprocess.run(["git", "-C", ROOT, "archive", options.revision], stdout=subprocess.PIPE, check=True).stdout
            subprocess.run(["tar", "x", "-C", before], input=archive, check=True)
            trees.append(before)
        units = [{name: unit for name, *unit in rows(tree) if options.only in name} for tree in trees]
        print(f"{'':40}   user s    MB" + ("   before s    MB   after/before" if options.revision else ""))
        for name, unit in units[0].items():
            pairs = [[cost(options.compiler.split(), tree, *of.get(name, of.get(name.split(", with")[0], unit)), folder) if k == 0 or name.split(", with")[0] in of else None
                      for k, (tree, of) in enumerate(zip(trees, units))] for _ in range(options.rounds)]
            told = [f"{name:40}"]
            for of in zip(*pairs):
                told.append("{:8.2f} {:5.0f}".format(*map(statistics.median, zip(*of))) if None not in of else " " * 14)
            if options.revision and None not in pairs[0]:
                told.append(f"{statistics.median(a[0] / b[0] for a, b in pairs):12.2f}")
            print("  ".join(told), flush=True)


if __name__ == "__main__":
    try:
        main()
    except (RuntimeError, subprocess.CalledProcessError) as problem:
        sys.exit(str(problem))
