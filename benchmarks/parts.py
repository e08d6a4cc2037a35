#!/usr/bin/env python3
"""What each optional part of a scene costs: time of a step, bytes a point, seconds of the compiler, size of the program.

    benchmarks/parts.py [--rounds N] [--compiles N] [--only REGEX] [--compiler COMMAND] > docs/parts_cost.md

A scene without the part and one with it are compiled by the same command, and their programs run in turns on one thread. The time is the
median of the ratios, the compiler's CPU seconds the least of `--compiles`. Leave the machine alone meanwhile."""

import argparse
import os
import platform
import re
import resource
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
EIGEN = os.environ.get("ARENITE_EIGEN", "/usr/include/eigen3")
FLAGS = ["-O3", "-march=native"]

PROGRAM = """#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <chrono>
#include <cstdio>
using namespace arenite;
int main() {{
  set_threads(1);
  const double size = 0.6, cell = 0.01;
  const MohrCoulomb sand{{{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg, .cohesion = 100}}}};
  const LinearElastic rubber{{{{.density = 1540, .young = 1_MPa, .poisson = 0.3}}}};
  (void)rubber;
  Scene scene{{PlaneStrain{{}}, {mesh}, {numerics}, {bodies}, walls(bottom(fixed), left(roller), right(roller)), gravity({{0, -9.81}}){parts}}};
  const double dt = 0.3 * stable_step(scene);
  const auto twenty_steps = [&] {{ {steps} }};
  twenty_steps();
  double least = 1e300;
  for (int block = 0; block < 5; ++block) {{
    const auto begin = std::chrono::steady_clock::now();
    twenty_steps();
    least = std::min(least, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
  }}
  std::printf("%.6g %zu\\n", least / 20 / static_cast<double>(scene.point_count()), scene.body<0>().points.bytes_per_point());
}}
"""

GRID = "CartesianGrid<2>{{.lower = {0, 0}, .upper = {size, 1.2 * size}, .cell = cell}}"
TRIANGLES = "SimplexMesh<2>{box_mesh(BoxMesh<2>{.lower = {0, 0}, .upper = {size, size}, .bricks = {60, 60}})}"
SPLINES = "Numerics<QuadraticBSpline>{}"
USL = "Numerics<QuadraticBSpline, Flip, Usl>{}"
LINEAR = "Numerics<LinearSimplex, {}>{{}}"
SAND = "fill<\"sand\">(Box{{0, 0}, {size, size}}, sand, {.per_cell = 4})"
TWO = ("fill<\"low\">(Box{{0, 0}, {size, size / 2}}, sand, {.per_cell = 4}), "
       "fill<\"high\">(Box{{0, size / 2}, {size, size}}, sand, {.per_cell = 4})")
BALL = "DistanceSurface{Ball({size / 2, size + 0.045}, 0.05)}"
FREE = "Free{.mass = 10, .inertia = 0.01, .centre = {size / 2, size + 0.045, 0}}"


NOTHING = "nothing: the same scene again"
STEPS = "for (int k = 0; k < 20; ++k) step(scene, dt);"
RUN = "run(scene, {{.end = scene.time + 20 * dt, .courant = 1, .max_step = dt, .watch = {}}});"


@dataclass
class Row:
    """A part, and the scene without it."""
    name: str
    part: str = ""
    group: str = "B-splines"
    mesh: str = GRID
    numerics: str = SPLINES
    bodies: str = SAND
    beside: str = ""  # numerics of the scene without it, where they are not those of the group's
    steps: str = STEPS

    def code(self):
        parts = f", {self.part}" if self.part else ""
        return PROGRAM.format(mesh=self.mesh, numerics=self.numerics, bodies=f"bodies({self.bodies})", parts=parts, steps=self.steps)


def triangles(name, average="", part=""):
    types = ", ".join(filter(None, ["Flip", "Usl", average]))
    return Row(name, part, "triangles", TRIANGLES, LINEAR.format(types), SAND)


BASES = {"B-splines": Row("sand on quadratic B-splines, 4 points a cell, FLIP, MUSL: nothing named"),
         "triangles": triangles("sand on triangles, 4 points a triangle, FLIP, USL: nothing named")}
ROWS = [
    Row(NOTHING),
    Row("`run` for `step` by hand, its watch off", steps=RUN.format("false")),
    Row("`run` with its watch", steps=RUN.format("true")),
    Row("energy balance", "TrackEnergy{}"),
    Row("reactions of walls", "Reactions{}"),
    Row("numbers of points", "PointIds{}"),
    Row("local damping", "LocalDamping{}"),
    Row("viscous damping", "ViscousDamping{.rate = 40}"),
    Row("body force of place and time", "body_force([](const auto& x, double t) { return std::array{0.1 * x[0] * t, 0.0, 0.0}; })"),
    Row("traction on a surface of points", "traction(surface(\"sand\", Box{{0, size - cell}, {size, size}}, {.normal = {0, 1}, .thickness = cell}), {0, -100})"),
    Row("frictional wall", "frictional(right(), Friction(20_deg))"),
    Row("absorbing faces", "absorbing(right(), {.density = 1540, .pressure_wave = 30, .shear_wave = 16})"),
    Row("deviatoric strain recorded", bodies=SAND.replace("sand", "WithDeviatoricStrain{sand}")),
    Row("strain at the middle (`MidpointStrain`)", numerics="Numerics<QuadraticBSpline, Flip, MidpointStrain<Musl>>{}"),
    Row("second body of the same law, one field", bodies=TWO),
    Row("second body, Coulomb contact", "Coulomb{Friction(20_deg)}", bodies=TWO),
    Row("rigid ball, prescribed", f"rigid({BALL}, Prescribed{{[](double) {{ return std::array{{0.0, -0.01, 0.0}}; }}}}, Friction(20_deg))"),
    Row("rigid ball, prescribed, without gaps of nodes (`RigidVelocity`)",
        f"rigid({BALL}, Prescribed{{[](double) {{ return std::array{{0.0, -0.01, 0.0}}; }}}}, Friction(20_deg), RigidVelocity{{}})"),
    Row("rigid ball, free", f"rigid({BALL}, {FREE}, Friction(20_deg))"),
    Row("rigid ball, free, contact at points", f"rigid({BALL}, {FREE}, Friction(20_deg), PointContact{{}})",
        numerics=USL, beside=USL),
    Row("two rigid balls and their contact", f"rigids(rigid<\"a\">({BALL}, {FREE}, Friction(20_deg)), rigid<\"b\">("
        f"{BALL.replace('0.045', '0.146')}, {FREE.replace('0.045', '0.146')}, Friction(20_deg))), RigidContact{{Friction(20_deg)}}"),
    triangles(NOTHING),
    triangles("averages by node", "NodalAveraging"),
    triangles("averages by cell", "ElementAverage"),
    triangles("averages by node and by cell", "NodalAndElementAverage"),
    triangles("energy balance", part="TrackEnergy{}"),
    triangles("traction on faces of the mesh", part="traction(top(), {0, -100})"),
]


@dataclass
class Program:
    seconds: float  # CPU of the compiler
    kilobytes: float  # of code
    path: Path
    bytes: int = 0  # of a point

    def nanoseconds(self):
        """Of a point and step."""
        said = subprocess.run([self.path], stdout=subprocess.PIPE, check=True, text=True).stdout.split()
        self.bytes = int(said[1])
        return float(said[0])


def compiled(row, number, options, folder):
    unit = Path(folder) / f"{number}.cpp"
    unit.write_text(row.code())
    path = unit.with_suffix("")
    command = [*options.compiler.split(), "-std=c++20", *FLAGS, f"-I{ROOT / 'include'}", "-isystem", EIGEN, str(unit), "-o", str(path), "-pthread"]
    least = float("inf")
    for _ in range(options.compiles):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run(command, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"{row.name}: {done.stderr[:3000]}")
        least = min(least, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    sizes = subprocess.run(["size", path], stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()[1]
    return Program(least, int(sizes.split()[0]) / 1000, path)


def processor():
    found = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text()) if Path("/proc/cpuinfo").exists() else None
    return found.group(1) if found else platform.machine()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--compiles", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--compiler", default="g++")
    options = parser.parse_args()
    version = subprocess.run([*options.compiler.split(), "--version"], stdout=subprocess.PIPE, text=True).stdout.splitlines()[0]
    print("# What each part costs\n\nA scene pays for the parts that it names. Each row is a scene with the part beside the same scene without it, written by",
          f"`benchmarks/parts.py`; {processor()}, one\nthread, {version}, `{' '.join(FLAGS)}`, header-only. Time: the median of {options.rounds} ratios of whole steps, run in turns;",
          "the first row of each table tells the noise. The other columns are\nwhat the part adds. What a scene does not name costs 0: no symbol of it is in the program",
          "(test `compile.unnamed_parts`), and a step beside a loop written by\nhand stands in [performance](performance.md).\n")
    with tempfile.TemporaryDirectory() as folder:
        for group, base in BASES.items():
            rows = [row for row in ROWS if row.group == group and re.search(options.only, row.name)]
            if not rows:
                continue
            without = compiled(base, "base", options, folder)
            told = f"{without.nanoseconds():.0f} ns a point and step, {without.bytes} bytes a point, {without.seconds:.1f} s to compile, {without.kilobytes:.0f} kB"
            print(f"## {base.name[0].upper() + base.name[1:]}\n\n{told}.\n\n| part | time of a step | bytes a point | compiler, s | code, kB |\n|---|---|---|---|---|")
            for number, row in enumerate(rows):
                own = without
                if row.beside:
                    own = compiled(Row(base.name, numerics=row.beside), "own", options, folder)
                part = compiled(row, number, options, folder)
                ratio = statistics.median(part.nanoseconds() / own.nanoseconds() for _ in range(options.rounds))
                print(f"| {row.name} | {ratio:.2f} | {part.bytes - own.bytes:+d} | {part.seconds - own.seconds:+.1f} | {part.kilobytes - own.kilobytes:+.0f} |", flush=True)
            print()


if __name__ == "__main__":
    try:
        main()
    except (RuntimeError, subprocess.CalledProcessError) as problem:
        sys.exit(str(problem))
