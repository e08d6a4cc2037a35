"""What random scenes came to: reads the lines that the units print (runner.hpp), prints shares by composition, causes and faults, and ends
with 1 if there is a fault. With --page it writes docs/envelope.md with its picture, and what `arenite.check` asks.

    python3 report.py FOLDER-OF-LINES [--page]
"""

import collections
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "envelope.md"
PICTURE = ROOT / "docs" / "images" / "envelope.svg"
DATA = ROOT / "python" / "arenite" / "_envelope.json"

ENDINGS = ["sound", "damped", "left", "stopped", "refused", "fault"]
COLOURS = ["#009E73", "#56B4E9", "#E69F00", "#D55E00", "#6b6b6b", "#000000"]  # Okabe and Ito
GROUPS = {  # classes of a scene that a user names, by what they are
    "kinematics": "PlaneStrain Axisymmetric ThreeDimensional",
    "mesh": "CartesianGrid RectilinearGrid PeriodicGrid SimplexMesh MovingMesh",
    "shape": "LinearGrid UGimp QuadraticBSpline CubicBSpline LinearSimplex",
    "transfer": "Flip Apic Aflip Tpic Xpic Fmpm",
    "stress update": "Usl Musl Usf MidpointStrain",
    "average against locking": "NodalAveraging ElementAverage NodalAndElementAverage",
    "law": "LinearElastic MohrCoulomb DruckerPrager WithDeviatoricStrain",
    "policy of a law": "RemembersOpening SofteningFriction RateSofteningFriction LinearRateFriction InertialFriction LogarithmicFriction "
                       "PressureStiffness RateStiffness",
    "contact": "Coulomb RigidContact RigidVelocity NodalGap PointContact CentreOfMass",
    "surface and motion of a rigid body": "DistanceSurface MeshSurface Guided Free Prescribed PrescribedPose",
    "load and boundary": "Walls Gravity GravityInTime BodyForce PointLoad PointTraction FaceTraction FacePressure AbsorbingFaces FrictionalWall Driven "
                         "ViscousDamping LocalDamping",
    "points": "SplitPoints Renewal",
}
ALIASES = {"FmpmStart": "Fmpm", "XpicStart": "Xpic", "Traction": "FaceTraction", "Pressure": "FacePressure", "FrictionalFaces": "FrictionalWall"}
CONTACTS = GROUPS["contact"].split()[3:]
NUMERICS = ["kinematics", "mesh", "shape", "transfer", "stress update", "average against locking"]
QUANTITIES = {  # name: (meaning, unit, logarithmic axis in the picture or None)
    "cell": ("edge of a cell", "m", None),
    "young": ("Young's modulus", "Pa", None),
    "poisson": ("Poisson's ratio", "-", False),
    "density": ("density", "kg/m3", None),
    "friction": ("angle of friction", "deg", None),
    "cohesion": ("cohesion", "Pa", None),
    "dilatancy": ("angle of dilatancy", "deg", None),
    "contact_friction": ("angle of friction in contact", "deg", None),
    "gravity": ("gravity", "m/s2", None),
    "speed": ("greatest speed at the start", "m/s", None),
    "mach": ("speed over that of pressure waves", "-", True),
    "weight": ("weight of ten cells over stiffness, 10 rho g h / M", "-", True),
    "courant": ("Courant number", "-", False),
    "per_cell": ("most points in a cell at the start", "-", True),
    "thinnest": ("smallest cell over the edge drawn", "-", False),
    "stiffness_ratio": ("modulus of one body over that of another", "-", None),
    "mass_ratio": ("mass of a rigid body over that of all matter", "-", None),
    "least_volume": ("least V / V0 of a point", "-", None),
    "greatest_volume": ("greatest V / V0 of a point", "-", None),
}


class Scene:
    """One line: composition, ending, seed, message, classes, quantities."""

    def __init__(self, line):
        _, self.composition, ending, self.seed, figures, draw, *kind = line.rstrip("\n").split("\t")
        self.line, self.ending = (figures, draw), ending if ending in ENDINGS else "fault"
        self.fault = ending
        figures, _, self.message = figures.partition(" | ")
        self.classes = classes(kind[0]) if kind and kind[0] else set()
        self.is_float = bool(kind) and re.search(r"(Grid|Mesh)<\d, float>", kind[0]) is not None
        self.values = self.quantities(numbers(figures), numbers(draw)) if self.classes else {}

    def quantities(self, f, d):
        young, nu, rho = d["E"], d["nu"], d["rho"]
        modulus = young * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
        values = dict(cell=d["cell"], young=young, poisson=nu, density=rho, gravity=d["g"], courant=d["C"], speed=f["speed"],
                      mach=f["speed"] / (modulus / rho) ** 0.5, weight=rho * d["g"] * 10 * d["cell"] / modulus, thinnest=f["thinnest"],
                      per_cell=f["points"], least_volume=f["J"], greatest_volume=f["to"])
        if self.classes & {"MohrCoulomb", "DruckerPrager"}:
            values.update(friction=d["phi"], cohesion=d["c"], dilatancy=d["psi"])
        if self.classes & {"Coulomb", "DistanceSurface", "MeshSurface", "FrictionalWall"}:
            values.update(contact_friction=d["delta"])
        if "Coulomb" in self.classes:
            values.update(stiffness_ratio=d["contrast"])
        if f["rigid"] > 0:
            values.update(mass_ratio=f["rigid"])
        return values


def numbers(text):
    """Numbers of `name=number` and `to number` in a text, by name."""
    found = re.findall(r"(\S+)=(-?[\d.]+(?:e[-+]?\d+)?)\b", text) + re.findall(r"(to) (-?[\d.]+(?:e[-+]?\d+)?)", text)
    return {name: float(number) for name, number in found}


def classes(kind):
    """Classes of GROUPS that a scene's type names, as the compiler writes it: an argument that is the default may be left out."""
    words = {ALIASES.get(w, w) for w in re.findall(r"\w+", kind)}
    usual = {"transfer": "Flip", "stress update": "Musl"}
    words |= {name for group, name in usual.items() if not words & set(GROUPS[group].split())}
    if "Rigid" in words and not words & set(CONTACTS):
        words.add("RigidVelocity")
    return words & {name for names in GROUPS.values() for name in names.split()}


def read(folder):
    return [Scene(line) for path in sorted(Path(folder).glob("*.tsv")) for line in path.read_text().splitlines()]


def cause(scene):
    """What stopped or refused a scene, without its numbers."""
    said = re.sub(r"^t = [^:]*: ", "", scene.message)
    limit = re.match(r"(\w+) = \S+ \(([^,)]*)", said)
    if limit:
        return f"watch: {limit[1]} ({limit[2]})"
    rule = re.match(r"([\w.: ]+) = (?:\([^)]*\)|[^:]*): (.*)", said)
    if rule:
        return f"{rule[1]}: {rule[2]}"
    return re.sub(r"\(?-?\d[\d.e+, -]*\)?", ".. ", re.split(r" after |; |: \.|: -", said)[0]).replace("  ", " ").strip()


def shares(scenes):
    count = collections.Counter(s.ending for s in scenes)
    return [100 * count[e] / len(scenes) for e in ENDINGS]


def by(scenes, key):
    found = collections.defaultdict(list)
    for s in scenes:
        found[key(s)].append(s)
    return found


def text_report(scenes):
    lines = [f"{'composition, % of its scenes':78} {'scenes':>6} " + " ".join(f"{e:>7}" for e in ENDINGS)]
    for name, of in [*by(scenes, lambda s: s.composition).items(), ("all", scenes)]:
        causes = collections.Counter(cause(s) for s in of if s.ending == "stopped")
        stops = "; ".join(f"{c} {100 * n / len(of):.2f}" for c, n in causes.most_common())
        lines.append(f"{name[:78]:78} {len(of):6} " + " ".join(f"{x:7.2f}" if x else " " * 7 for x in shares(of)) + f"  {stops}")
    for s in scenes:
        if s.ending == "fault":
            lines.append(f"\n{s.composition}, {s.fault}, seed {s.seed}: {s.line[0]}\n    {s.line[1]}")
    return "\n".join(lines)


# --- the page

def number(x):
    return f"{x:.3g}".replace("e+0", "e").replace("e-0", "e-")


def ranges(scenes):
    """Least and greatest of each quantity."""
    found = {}
    for q in QUANTITIES:
        values = [s.values[q] for s in scenes if q in s.values]
        if values:
            found[q] = (min(values), max(values))
    return found


def table(first, rows):
    lines = [f"| {first} | scenes | sound | damped | points left | stopped | refused | faults |", "|---|" + "---|" * 7]
    for name, of in rows:
        lines.append(f"| {name} | {len(of)} | " + " | ".join(f"{x:.1f}" if x else "" for x in shares(of)[:-1])
                     + f" | {sum(s.ending == 'fault' for s in of)} |")
    return lines


def limits_in_tests():
    """Titles of the tests that are tagged [limit], by their file."""
    found = []
    for path in sorted((ROOT / "tests").glob("*/*.cpp")):
        for title in re.findall(r'TEST_CASE\(\s*"((?:[^"\\]|\\.)*)",\s*"\[limit\][^"]*"', path.read_text()):
            found.append(f"| {title} | `{path.relative_to(ROOT)}` |")
    return found


def quantiles(scenes, q, count):
    """Scenes in `count` groups of equal number, by a quantity: (least, greatest, scenes) each; where only few values are there, by value."""
    known = sorted((s for s in scenes if q in s.values), key=lambda s: s.values[q])
    if len({s.values[q] for s in known}) <= count:
        return [(v, v, of) for v, of in sorted(by(known, lambda s: s.values[q]).items())]
    parts = [known[k * len(known) // count:(k + 1) * len(known) // count] for k in range(count)]
    return [(p[0].values[q], p[-1].values[q], p) for p in parts if p]


def draw(scenes):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "arenite"
    import matplotlib.pyplot as plt

    shown = [q for q, (_, _, log) in QUANTITIES.items() if log is not None]
    figure, axes = plt.subplots(2, (len(shown) + 1) // 2, figsize=(11, 6), constrained_layout=True, sharey=True)
    for axis, q in zip(axes.flat, shown):
        groups = quantiles([s for s in scenes if s.values.get(q, 0) > 0 or not QUANTITIES[q][2]], q, 8)
        below = [0.0] * len(groups)
        for e, colour in zip(ENDINGS, COLOURS):
            heights = [100 * sum(s.ending == e for s in of) / len(of) for _, _, of in groups]
            axis.bar(range(len(groups)), heights, bottom=below, color=colour, label=e, width=0.9)
            below = [a + b for a, b in zip(below, heights)]
        axis.set_xticks(range(len(groups)), [number(high) for _, high, _ in groups], rotation=60, fontsize=8)
        axis.set_xlabel(f"{QUANTITIES[q][0]}, up to", fontsize=9)
    for axis in axes[:, 0]:
        axis.set_ylabel("share of scenes, %")
    for axis in list(axes.flat)[len(shown):]:
        axis.axis("off")
    figure.suptitle(" ")  # room for the legend
    figure.legend(*axes.flat[0].get_legend_handles_labels(), loc="upper center", ncol=len(ENDINGS), fontsize=9)
    figure.savefig(PICTURE, metadata={"Date": None})


def page(scenes):
    known = [s for s in scenes if s.classes]
    tried = {c for s in known for c in s.classes}
    of_all = ranges(known)
    stops = by([s for s in known if s.ending == "stopped"], cause)
    median = lambda of, q: sorted(s.values[q] for s in of)[len(of) // 2]  # noqa: E731
    faults = [s for s in scenes if s.ending == "fault"]
    lines = [
        "# What was tried: the envelope", "",
        "(written by `tests/extremes/report.py` from the scenes that `tests/extremes/run.sh` runs; not by hand)", "",
        f"{len(scenes):,} random scenes of {len(by(scenes, lambda s: s.composition))} compositions, "
        f"{100 * sum(s.is_float for s in known) / len(known):.0f} % of them in float, each drawn from one seed and run for 100 to 200 steps, with the watch that `run` has on. "
        "Laws of nature judge how each ends: momentum is what forces gave, to round-off; no energy comes from nowhere.", "",
        "| ending | share, % | what it means |", "|---|---|---|"]
    meanings = ["ran to its end, laws kept", "the same, and the transfer took more than a tenth of the energy (affine transfers, a share of PIC, motion at the scale of a cell)",
                "the same, and points left the mesh", "an error that names time and cause", "an error as it was made, that names value and rule",
                "ended in silence with energy or momentum from nowhere, numbers that are not finite, or another exception"]
    lines += [f"| {e} | {x:.2f} | {m} |" for e, x, m in zip(ENDINGS, shares(scenes), meanings)]
    lines += ["", "`arenite.check(scene)` in Python says which parts and values of a scene lie outside of what is on this page.", "",
              "![Shares of the endings by quantity](images/envelope.svg)", "", "(each bar an eighth of the scenes)", "",
              "## Ranges", "", "(of all scenes; the watch had no limits for volume, speed and points that leave, so that points are torn apart or crushed without end)", "", "| quantity | unit | from | to |", "|---|---|---|---|"]
    lines += [f"| {QUANTITIES[q][0]} | {QUANTITIES[q][1]} | {number(a)} | {number(b)} |" for q, (a, b) in of_all.items()]
    lines += ["", "## By part", "", "In % of the scenes that have it.", ""]
    for group, names in GROUPS.items():
        rows = [(f"`{n}`", [s for s in known if n in s.classes]) for n in names.split() if n in tried]
        lines += table(group, rows)
        left = [f"`{n}`" for n in names.split() if n not in tried]
        lines += ["", f"In no random scene: {', '.join(left)}.", ""] if left else [""]
    lines += ["## What stopped them", "", "| cause | scenes | median of speed over wave speed | median of weight over stiffness |", "|---|---|---|---|"]
    lines += [f"| {c} | {len(of)} | {number(median(of, 'mach'))} | {number(median(of, 'weight'))} |" for c, of in sorted(stops.items(), key=lambda i: -len(i[1]))]
    refused = by([s for s in scenes if s.ending == "refused"], cause)
    lines += ["", "Refused as they were made:", "", *(f"- {c}: {len(of)}" for c, of in sorted(refused.items()))]
    lines += ["", "## By composition", ""]
    lines += table("composition", sorted(by(scenes, lambda s: s.composition).items()))
    lines += ["", "## Single limits", "", "Tests that go to one limit each, in every run of the tests:", "", "| what holds | where |", "|---|---|", *limits_in_tests(), "",
              "A Courant number above 1 is refused by `run` (`RunOptions.courant`)."]
    if faults:
        lines += ["", "## Faults", "", *(f"- {s.composition}, seed {s.seed}: {s.line[0]}" for s in faults)]
    PAGE.write_text("\n".join(lines) + "\n")
    draw(known)
    numerics = [n for g in NUMERICS for n in GROUPS[g].split()]
    together = by(known, lambda s: tuple(sorted(s.classes & set(numerics))))
    data = {
        "scenes": len(known),
        "quantities": {q: {"meaning": QUANTITIES[q][0], "unit": QUANTITIES[q][1], "from": a, "to": b} for q, (a, b) in of_all.items()},
        "parts": {n: {"what": g, "scenes": len(of), **{e: round(x, 2) for e, x in zip(ENDINGS, shares(of))}}
                  for g, names in GROUPS.items() for n in names.split() for of in [[s for s in known if n in s.classes]] if of},
        "numerics": numerics,
        "together": [{"classes": list(names), "scenes": len(of), "endings": {e: round(x, 2) for e, x in zip(ENDINGS, shares(of))}}
                     for names, of in sorted(together.items())]}
    DATA.write_text(json.dumps(data) + "\n")


def main(folder, *options):
    scenes = read(folder)
    print(text_report(scenes))
    if "--page" in options:
        page(scenes)
    return any(s.ending == "fault" for s in scenes)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
