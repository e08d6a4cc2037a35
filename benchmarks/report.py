"""Makes report.md and report.json of the raw results that run.sh left: report.py RAW OUT [--quick]."""

import datetime
import json
import os
import re
import statistics
import subprocess
import sys
from pathlib import Path

import results

# A point's columns read and written once, double; half of it in float.
BYTES_A_POINT_STEP = 480

# Million point-steps a second on one thread, and how much faster two threads must be.
TARGETS = {
    ("tetrahedra_mohr_coulomb", "double"): (40, 1.85),
    ("tetrahedra_mohr_coulomb", "float"): (55, 1.85),
    ("tetrahedra_elastic", "double"): (60, 1.85),
    ("bspline_3d_drucker_prager", "double"): (22, 1.85),
    ("bspline_2d_elastic", "double"): (35, 1.85),
    ("bspline_2d_elastic", "float"): (60, 1.85),
    ("drop_axisymmetric", "double"): (50, 1.7),
}
LARGEST_GROWTH = 1.5  # of the cost of a point-step from 10,000 points on


def output(command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def first_line(path, start=""):
    try:
        for line in Path(path).read_text().splitlines():
            if line.startswith(start):
                return line
    except OSError:
        pass
    return ""


def machine(raw, out):
    """What the numbers depend on."""
    try:
        commands = json.loads((out / "compile_commands.json").read_text())
        compiler, *words = next(
            c["command"].replace("ccache ", "") for c in commands if c["file"].endswith("benchmarks/whole_step.cpp")
        ).split()
    except (OSError, StopIteration, ValueError):
        compiler, words = "c++", []
    flags = [w for w in words if re.match(r"-(O|D|m|f|std)", w)]
    return {
        "date": datetime.datetime.now().astimezone().isoformat(timespec="seconds"),
        "processor": first_line("/proc/cpuinfo", "model name").partition(": ")[2] or os.uname().machine,
        "cores": os.cpu_count(),
        "caches": ", ".join(" ".join(line.split()) for line in output(["lscpu", "-C=NAME,ONE-SIZE"]).splitlines()[1:]),
        "memory_GB": round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 1e9),
        "system": first_line("/etc/os-release", "PRETTY_NAME").partition("=")[2].strip('"'),
        "compiler": output([compiler, "--version"]).partition("\n")[0],
        "flags": " ".join(flags),
        "load_before": first_line(raw / "load_before"),
        "load_after": first_line(raw / "load_after"),
    }


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def number(value, digits=3):
    """Significant digits without an exponent; an empty cell for None."""
    if value is None:
        return ""
    return f"{float(f'{value:.{digits}g}'):,.10g}"


def limits(found):
    """{(where, threads): bytes/s}, {scalar: flop/s}."""
    bandwidth, fma = {}, {}
    for name, series in found.items():
        if m := re.fullmatch(r"machine/triad_(\w+)/threads:(\d+)", name):
            bandwidth[m[1], int(m[2])] = series.counter("bytes/s")
        elif m := re.fullmatch(r"machine/fma/(\w+)", name):
            fma[m[1]] = series.counter("flop/s")
    return bandwidth, fma


def steps(found, bandwidth):
    """One row of values for each scene, who and number of threads."""
    rows = []
    for name, series in found.items():
        m = re.fullmatch(r"step/(\w+)/(float|double)/(arenite|rival)/threads:(\d+)", name)
        if not m:
            continue
        scene, scalar, who, threads = m[1], m[2], m[3], int(m[4])
        ns = series.per_point()
        row = {
            "scene": scene,
            "scalar": scalar,
            "who": who,
            "threads": threads,
            "points": round(series.counter("points")),
            "bytes_per_point": series.counter("bytes_per_point"),
            "repetitions": len(series.ns),
            "ns_per_point_step": ns,
            "million_point_steps_per_s": 1e3 / ns,
            "lowest": 1e3 / series.per_point(max(series.ns)),
            "highest": 1e3 / series.per_point(min(series.ns)),
        }
        bytes_moved = BYTES_A_POINT_STEP * (0.5 if scalar == "float" else 1)
        if (limit := bandwidth.get(("64MB", threads))) is not None:
            row["share_of_limit"] = bytes_moved / limit / (ns * 1e-9)
        if who == "arenite":
            one = found.get(f"step/{scene}/{scalar}/arenite/threads:1")
            rival = found.get(f"step/{scene}/{scalar}/rival/threads:1")
            row["over_one_thread"] = one.per_point() / ns if one and threads > 1 else None
            row["over_rival"] = rival.per_point() / ns if rival else None
            if (target := TARGETS.get((scene, scalar))) is not None:
                row["target"] = target[0] if threads == 1 else target[1] if threads == 2 else None
        rows.append(row)
    return sorted(rows, key=lambda r: (r["scene"], r["scalar"], r["who"], r["threads"]))


def steps_table(rows):
    cells = []
    for r in rows:
        target = ""
        if r.get("target") is not None:
            speed = r["threads"] == 1
            reached = r["million_point_steps_per_s"] if speed else r["over_one_thread"]
            target = f"{r['target']:g}{'' if speed else ' x'} {'reached' if reached >= r['target'] else 'missed'}"
        share = r.get("share_of_limit")
        cells.append([
            r["scene"].replace("_", " "),
            r["scalar"],
            r["who"],
            str(r["threads"]),
            f"{r['points']:,}",
            number(r["million_point_steps_per_s"]),
            f"{number(r['lowest'])} .. {number(r['highest'])}",
            number(r["ns_per_point_step"]),
            number(r.get("over_rival"), 2),
            number(r.get("over_one_thread")),
            "" if share is None else f"{100 * share:.0f} %",
            target,
            number(r["bytes_per_point"]),
        ])
    head = ["scene", "scalar", "who", "threads", "points", "million point-steps/s", "of the repetitions",
            "ns a point", "x over rival", "x over 1 thread", "of the limit", "target", "bytes a point"]
    return table(head, cells)


def scaling(found):
    rows = []
    for name, series in found.items():
        if m := re.fullmatch(r"scaling/(\w+)/(\w+)/points:(\d+)/threads:(\d+)", name):
            rows.append({"scene": m[1], "scalar": m[2], "threads": int(m[4]),
                         "points": round(series.counter("points")), "ns_per_point_step": series.per_point()})
    rows.sort(key=lambda r: (r["threads"], r["points"]))
    least = {}
    for row in rows:
        least.setdefault(row["threads"], row["ns_per_point_step"])
        row["over_fewest_points"] = row["ns_per_point_step"] / least[row["threads"]]
    return rows


def laws(found, fma):
    rows = {}
    for name, series in found.items():
        m = re.fullmatch(r"law/(\w+)/(\d)d/(\w+)/(\w+)/(?:width:(\d+)|rival)", name)
        if not m:
            continue
        row = rows.setdefault(m.groups()[:4], {"law": m[1], "dimension": int(m[2]), "scalar": m[3], "states": m[4],
                                               "ns_per_point": {}, "rival_ns_per_point": None})
        if m[5]:
            row["ns_per_point"][int(m[5])] = series.per_point()
            row["flop_per_point"] = series.counter("flop_per_point")
        else:
            row["rival_ns_per_point"] = series.per_point()
    for row in rows.values():
        best = min(row["ns_per_point"].values())
        row["over_rival"] = row["rival_ns_per_point"] / best if row["rival_ns_per_point"] else None
        row["share_of_fma_peak"] = row["flop_per_point"] / best * 1e9 / fma[row["scalar"]] if row["scalar"] in fma else None
    return [rows[key] for key in sorted(rows)]


def laws_table(rows):
    widths = sorted({w for r in rows for w in r["ns_per_point"]})
    cells = [
        [r["law"].replace("_", " "), str(r["dimension"]), r["scalar"], r["states"]]
        + [number(r["ns_per_point"].get(w)) for w in widths]
        + [number(r["rival_ns_per_point"]), number(r["over_rival"], 2), number(r["flop_per_point"]),
           "" if r["share_of_fma_peak"] is None else f"{100 * r['share_of_fma_peak']:.0f} %"]
        for r in rows
    ]
    head = ["law", "D", "scalar", "states", *(f"W = {w}" for w in widths), "rival", "x over rival", "operations",
            "of the FMA peak"]
    return table(head, cells)


def others(found):
    """Whatever else was timed with a number of points: the stages of a step, the search for cells."""
    known = re.compile(r"(machine|step|scaling|law)/")
    return [{"name": n, "points": round(s.counter("points")), "ns_per_point": s.per_point()}
            for n, s in found.items() if not known.match(n) and s.has("points")]


STAGES = ["relocate", "p2g", "nodes", "contact", "remap", "deform", "step"]


def others_table(rows, first, stages):
    """The stages (else all the rest): a row for each scene, in the order of their names."""
    scenes = {}
    for r in rows:
        scene, _, what = r["name"].rpartition("/")
        if (what in STAGES) == stages:
            scenes.setdefault(scene, {})[what] = r["ns_per_point"]
    columns = STAGES if stages else sorted({what for v in scenes.values() for what in v})
    return table([first, *(c.replace("_", " ") for c in columns)],
                 [[s.replace("_", " "), *(number(v.get(c)) for c in columns)] for s, v in sorted(scenes.items())])


def main(raw, out, quick):
    found = results.read(sorted(raw.glob("*.json")))
    described = machine(raw, out)
    bandwidth, fma = limits(found)
    compile_seconds = statistics.median(map(float, (raw / "compile_seconds").read_text().split()))
    whole, sizes, law_rows, rest = steps(found, bandwidth), scaling(found), laws(found, fma), others(found)

    parts = ["# Benchmarks\n"]
    if quick:
        parts.append("**A quick run: small scenes, short times. Not for comparison.**\n")
    if float((described["load_before"] or "0").split()[0]) > 0.5:
        parts.append(f"**The machine was busy (load {described['load_before'].split()[0]} at the start): "
                     "times are longer, on two threads above all.**\n")
    parts.append(table(["machine", ""], [[k.replace("_", " "), str(v)] for k, v in described.items()]))
    parts.append("\n## Limits of the machine\n")
    parts.append(table(["limit", "threads", ""],
                       [[f"triad, arrays of {where} together", str(n), f"{number(v / 1e9)} GB/s"]
                        for (where, n), v in sorted(bandwidth.items())]
                       + [[f"multiply-add, {s}", "1", f"{number(v / 1e9)} GFLOP/s"] for s, v in fma.items()]))
    parts.append("\n## Whole steps\n\nMedians. The limit moves 480 bytes a point-step (240 in float) at the bandwidth of the "
                 "triad over 64 MB on as many threads.\n")
    parts.append(steps_table(whole))
    parts.append(f"\n## Scaling with points\n\nA point-step must not cost more than {LARGEST_GROWTH} times that of the "
                 "fewest points.\n")
    parts.append(table(["scene", "scalar", "threads", "points", "ns a point", "x that of the fewest"],
                       [[r["scene"].replace("_", " "), r["scalar"], str(r["threads"]), f"{r['points']:,}",
                         number(r["ns_per_point_step"]), number(r["over_fewest_points"])] for r in sizes]))
    if law_rows:
        parts.append("\n## Laws\n\nns a point by width W of the packs, from the second-level cache. Operations: those of one "
                     "point alone; the share of the FMA peak is that of the fastest width.\n")
        parts.append(laws_table(law_rows))
    if rest:
        parts.append("\n## Stages of a step, ns a point, one thread\n")
        parts.append(others_table(rest, "scene", stages=True))
        parts.append("\n## Finding a point's cell, ns a point, from a cell so many faces away or from nothing\n")
        parts.append(others_table(rest, "mesh", stages=False))
    parts.append(f"\n## Compile time\n\nThe README's scene, `g++ -O2`: {compile_seconds:.1f} s.\n")
    (out / "report.md").write_text("\n".join(parts))
    (out / "report.json").write_text(json.dumps({
        "quick": quick,
        "machine": described,
        "bandwidth_bytes_per_s": {f"{where}/threads:{n}": v for (where, n), v in bandwidth.items()},
        "fma_flop_per_s": fma,
        "steps": whole,
        "scaling": sizes,
        "laws": law_rows,
        "stages": rest,
        "compile_seconds": compile_seconds,
    }, indent=1) + "\n")
    print("\n" + steps_table(whole), end="")


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]), Path(sys.argv[2]), "--quick" in sys.argv[3:])
    except (ValueError, OSError) as e:
        sys.exit(f"benchmarks/report.py: {e}")
