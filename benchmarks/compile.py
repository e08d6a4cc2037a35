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
        here, there = [{name: unit for name, *unit in rows(tree)} for tree in (trees[0], trees[-1])]
        print(f"{'':40}   user s    MB" + ("   before s    MB   after/before" if options.revision else ""))
        for name in filter(lambda name: re.search(options.only, name), here):
            like = there.get(name) or there.get(name.split(", with arenite::cold")[0])  # cold functions may be new
            units = [(trees[0], *here[name])] + ([(trees[1], *like)] if options.revision and like else [])
            rounds = [[cost(options.compiler.split(), *unit, folder) for unit in units] for _ in range(options.rounds)]
            told = ["{:8.2f} {:5.0f}".format(*map(statistics.median, zip(*of))) for of in zip(*rounds)]
            if len(units) == 2:
                told.append(f"{statistics.median(after[0] / before[0] for after, before in rounds):12.2f}")
            print(f"{name:40}", *told, sep="  ", flush=True)


if __name__ == "__main__":
    try:
        main()
    except (RuntimeError, subprocess.CalledProcessError) as problem:
        sys.exit(str(problem))
