"""Writes python/arenite/_recipes.py: the recipes of Python that are aggregates of the C++ library. Names, defaults, units, rules and
meanings come from the headers (by Doxygen's XML), the text of a class from the first paragraph of its comment.

    python3 python/tools/recipes.py [--check]

--check: writes nothing; fails if the file is not what the headers say.

A member's comment is `meaning, unit, rule; more`, each of which may be absent: `double friction = 0;  ///< angle of friction, rad;
required, in [0, 1.55]; 0: Tresca`. Rules are `required`, `positive`, `> 1`, `>= 0`, `in [0, 1)`, `any`. A member of Python alone, as of a
template's argument, stands in RECIPES below."""

from __future__ import annotations

import argparse
import math
import os
import re
import subprocess
import sys
import tempfile
import textwrap
import xml.etree.ElementTree as xml
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Dict, List, Optional, Tuple

ROOT = Path(__file__).resolve().parents[2]
OUTPUT = ROOT / "python" / "arenite" / "_recipes.py"
WIDTH = 120


@dataclass(frozen=True)
class Member:
    """A field of a recipe, as Python spells it."""

    name: str
    type: str
    default: str  # an expression; empty: none
    range: str
    meaning: str = ""
    unit: str = "-"
    is_function: bool = False  # of time or place

    def shown(self) -> str:
        """The default in the table."""
        made = re.match(r"field\(default_factory=(?:lambda: )?(.*)\)$", self.default)
        text = {"dict": "{}"}.get(made[1], made[1]) if made else self.default
        if not text or text.startswith("NOT_GIVEN") or "NOT_GIVEN" in text:
            return "needed"
        return re.sub(r'float\("inf"\)', "inf", text)


@dataclass(frozen=True)
class Recipe:
    """A class to write: `of` is the C++ class of its members (by default that of the same name, - for none), `doc` the one
    whose comment tells of it (by default that of the same name)."""

    name: str
    base: str = "Recipe"
    of: str = ""
    doc: str = ""
    extended: bool = False  # by a class of the same name in the module that shows it
    first: Tuple[Member, ...] = ()
    more: Tuple[Member, ...] = ()
    without: Tuple[str, ...] = ()
    renamed: Tuple[Tuple[str, str], ...] = ()


def parameters(name: str, base: str, **more: object) -> Recipe:
    return replace(Recipe(name, base, of=f"{name}::Parameters"), **more)  # type: ignore[arg-type]


def frictional(name: str) -> Recipe:
    def policy(field: str, default: str, what: str, meaning: str = "") -> Member:
        return Member(field, "Policy", f"field(default_factory={default})", what, meaning)

    return Recipe(name, "Frictional", of=f"{name}Parameters",
                  more=(policy("memory", "ForgetsOpening", "a memory of opening"),
                        policy("friction_law", "ConstantFriction", "a friction", "by point"),
                        policy("stiffness_law", "ConstantStiffness", "a stiffness", "by point")))


def plain(base: str, *names: str) -> List[Recipe]:
    return [Recipe(name, base) for name in names]


# By the module that shows them.
RECIPES: Dict[str, List[Recipe]] = {
    "laws": [
        Recipe("LinearElastic", "Law", of="LinearElasticParameters"),
        *plain("Policy", "ForgetsOpening"), parameters("RemembersOpening", "Policy"),
        *plain("Policy", "ConstantFriction"), parameters("LinearRateFriction", "Policy"), parameters("InertialFriction", "Policy"),
        parameters("LogarithmicFriction", "Policy"), Recipe("SofteningFriction", "Policy", of="SofteningParameters"),
        parameters("RateSofteningFriction", "Policy"),
        *plain("Policy", "ConstantStiffness"), parameters("PressureStiffness", "Policy"), parameters("RateStiffness", "Policy"),
        frictional("MohrCoulomb"), replace(frictional("DruckerPrager"), extended=True),
    ],
    "numerics": [
        *plain("Kind", "LinearSimplex", "LinearGrid", "QuadraticBSpline", "CubicBSpline"),
        Recipe("UGimp", "Kind", of="-", extended=True, more=(Member("points", "int", "2", ">= 1", "along each axis of a cell at first"),)),
        *plain("Kind", "Flip", "Apic", "Tpic", "Aflip"),
        Recipe("Fmpm", "Kind", of="CorrectedFlip", without=("kept",)), Recipe("Xpic", "Kind", of="CorrectedFlip", without=("kept",)),
        *plain("Kind", "Musl", "Usl", "Usf", "NoAntiLocking", "NodalAveraging", "ElementAverage", "NodalAndElementAverage"),
    ],
    "boundary": plain("Part", "ViscousDamping", "LocalDamping"),
    "rigid": [
        *plain("Recipe", "Guided", "PrescribedPose", "Anchor"), Recipe("Free", extended=True),
        *plain("Contact", "RigidVelocity", "NodalGap", "CentreOfMass", "PointContact"),
        Recipe("MovingMesh", extended=True, without=("leader",), more=(Member("leader", "int", "0", ">= 0", "number of the rigid body that leads it"),)),
    ],
    "shapes": [parameters("ConeCylinder", "Recipe", extended=True)],
    "fill": [
        Recipe("Geostatic", extended=True),
        Recipe("Fill", of="FillOptions", extended=True,
               first=(Member("name", "str", "", "a name"), Member("region", "Region", "", "a shape, `Cells`, or a test of positions"),
                      Member("law", "Law", "", "a law"))),
    ],
    "watch": [Recipe("Watch", of="WatchLimits", doc="WatchLimits")],
    "functions": [Recipe("Ramp", extended=True, renamed=(("from", "start_value"),))],
}

HEAD = '''"""Recipes that are aggregates of the C++ library. Written by python/tools/recipes.py out of its headers: change those."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Dict, Optional, Sequence, Union

from ._bases import Contact, Cone, Frictional, Kind, Law, NOT_GIVEN, Part, Policy
from ._recipe import Recipe

if TYPE_CHECKING:
    from .shapes import Region
'''

UNITS = ("kg/m3", "N m s/rad", "N m/rad", "N s/m", "kg m2", "m/s2", "rad/s", "N/m", "N m", "1/s", "m/s", "Pa", "rad", "kg", "N", "m", "s", "any", "-")
FUNCTION = "up to 3 numbers, a `Signal`, or a function of time"


def text_of(element: Optional[xml.Element]) -> str:
    """Its words, code between backquotes."""
    if element is None:
        return ""
    for code in element.iter("computeroutput"):
        code.text, code.tail = "`" + (code.text or ""), "`" + (code.tail or "")
    return re.sub(r"\s+", " ", "".join(element.itertext())).strip()


class Headers:
    """What Doxygen tells of the headers."""

    def __init__(self, folder: Path) -> None:
        settings = (ROOT / "docs" / "Doxyfile").read_text() + "\nHAVE_DOT = NO\n"
        environment = {**os.environ, "ARENITE_ROOT": str(ROOT), "ARENITE_XML": str(folder)}
        run = subprocess.run(["doxygen", "-"], input=settings, text=True, env=environment, capture_output=True, check=False)
        if run.returncode:
            raise SystemExit(f"recipes.py: doxygen failed:\n{run.stderr}")
        self._folder = folder / "xml"
        index = xml.parse(self._folder / "index.xml").getroot()
        self._compounds = {c.findtext("name", ""): c.get("refid", "") for c in index.iter("compound") if c.get("kind") != "dir"}
        namespace = self._compound("arenite")
        assert namespace is not None
        self._aliases = {m.findtext("name", ""): m for m in namespace.iter("memberdef") if m.get("kind") == "typedef"}

    def _compound(self, name: str) -> Optional[xml.Element]:
        refid = self._compounds.get(name)
        return xml.parse(self._folder / f"{refid}.xml").getroot().find("compounddef") if refid else None

    def _class(self, name: str) -> xml.Element:
        found = self._compound("arenite::" + name)
        if found is None:
            raise SystemExit(f"recipes.py: the headers have no class {name}")
        return found

    def description(self, name: str) -> str:
        """The first paragraph of a class's comment."""
        element = self._aliases[name] if name in self._aliases else self._class(name)
        for kind in ("briefdescription", "detaileddescription"):
            if words := text_of(element.find(f"{kind}/para")):
                return words
        raise SystemExit(f"recipes.py: {name}: the header says nothing of it")

    def members(self, name: str, without: Tuple[str, ...]) -> List[Member]:
        found = []
        for m in self._class(name).iter("memberdef"):
            field = m.get("kind") == "variable" and m.get("static") == "no" and m.get("prot") == "public"
            if field and m.findtext("name") not in without:
                comment = " ".join(filter(None, (text_of(m.find("briefdescription")), text_of(m.find("detaileddescription")))))
                found.append(member(name, m.findtext("name", ""), text_of(m.find("type")), text_of(m.find("initializer")), comment))
        return found


def number(text: str) -> str:
    """A number of C++ in Python."""
    if not text or re.search(r"not_given|quiet_NaN", text):
        return "NOT_GIVEN"
    return 'float("inf")' if "infinity" in text else repr(float(text))


def member(of: str, name: str, type: str, initial: str, comment: str) -> Member:
    where = f"recipes.py: {of}::{name}"
    initial = re.sub(r"^=\s*", "", initial)
    comment = uncapitalised(comment.split(". ")[0].rstrip("."))
    unit, rule, meaning = parts_of(comment)
    inner = re.fullmatch(r"\{(.*)\}", initial)
    if re.fullmatch(r"double|Checked<.*>", type.replace(" ", "")):
        made = Member(name, "float", number(initial), rule, meaning, unit)
    elif type in ("int", "std::uint64_t", "std::size_t"):
        made = Member(name, "int", initial, rule, meaning, unit)
    elif type == "std::optional< int >":
        made = Member(name, "Optional[int]", "None", rule, meaning, unit)
    elif type == "InitialVelocity":
        made = Member(name, "Any", "(0.0, 0.0, 0.0)", "up to 3 numbers, or a function of positions", meaning, unit)
    elif type == "std::optional< InitialStress >":
        made = Member(name, "Any", "None", "`Geostatic`, or a function of positions", meaning, unit)
    elif type.startswith("Map< std::string"):
        return Member(name, "Dict[str, Any]", "field(default_factory=dict)", "numbers or functions of positions, by name", comment)
    elif type == "bool":
        return Member(name, "bool", initial.capitalize(), "True, False", comment)
    elif re.fullmatch(r"std::array<double,3>", type.replace(" ", "")):
        numbers = [number(x.strip()) for x in inner[1].split(",")] if inner and inner[1] else ["0.0"] * 3
        made = Member(name, "Sequence[float]", f"({', '.join(numbers)})", rule, meaning, unit)
    elif type == "ScalarFunction":
        made = Member(name, "Any", number(initial), "a number, or a function of time", meaning, unit, True)
    elif type == "VectorFunction":
        made = Member(name, "Any", "(0.0, 0.0, 0.0)", FUNCTION, meaning, unit, True)
    elif type == "Inertia":
        made = Member(name, "Union[float, Sequence[float], None]", "None", rule, meaning, unit)
    elif type == "Cone":
        return Member(name, "Cone", initial.replace("::", "."), "a `Cone`", comment)
    else:  # another recipe
        recipe = type.replace("::Parameters", "").replace("Parameters", "Friction")
        given = re.sub(r"\.(\w+) = (\w+)", lambda m: f"{m[1]}={number(m[2])}", inner[1] if inner else "")
        made = Member(name, recipe, f"field(default_factory={f'lambda: {recipe}({given})' if given else recipe})", f"`{recipe}`", comment)
        return made
    if not made.unit:
        raise SystemExit(f"{where}: its comment names no unit: {comment!r}")
    if not made.range:
        raise SystemExit(f"{where}: its comment names no rule: {comment!r}")
    if ("required" in comment) != ("NOT_GIVEN" in made.default):
        raise SystemExit(f"{where}: its comment says `required` if, and only if, it has no default: {comment!r}, {initial!r}")
    return made


def uncapitalised(comment: str) -> str:
    """That of a sentence above a member; not a name, as in Young's modulus."""
    return comment[0].lower() + comment[1:] if re.match(r"[A-Z][a-z]+ ", comment) else comment


def parts_of(comment: str) -> Tuple[str, str, str]:
    """Unit, rule and meaning."""
    unit = rule = ""
    comment = re.sub(r"\{(.*?)\}", r"(\1)", comment)
    words = re.search(r"(?:^|, )(" + "|".join(re.escape(u) for u in UNITS) + r")(?=$|[,;:.])[,;]? ?", comment)
    if words:
        unit = words[1]
        before, comment = comment[: words.start()], comment[words.end():]
    else:
        before = ""
    comment = re.sub(r"\brequired(, |; |$)", "", comment)
    found = re.search(r"(?:^|(?<=[,;.] ))(positive|any|>=? [\w.]+|in [\[(][^\])]*[\])])(?=$|[,;:.])[,;.]? ?", comment)
    if found:
        rule = re.sub("^in ", "", found[1]).replace("positive", "> 0")
        comment = comment[: found.start()] + comment[found.end():]
    meaning = "; ".join(filter(None, (before.strip(" ,;"), comment.strip(" ,;"))))
    return unit, rule, meaning.strip(" .")


def table(members: List[Member]) -> List[str]:
    rows = [["parameter", "unit", "range", "default", "meaning"]]
    rows += [[m.name, m.unit, m.range, m.shown(), m.meaning] for m in members]
    if not any(row[4] for row in rows[1:]):
        rows = [row[:4] for row in rows]
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    return ["  ".join(cell.ljust(w) for cell, w in zip(row, widths)).rstrip() for row in rows]


def written(recipe: Recipe, headers: Headers) -> str:
    members = [] if recipe.of == "-" else headers.members(recipe.of or recipe.name, recipe.without)
    names = dict(recipe.renamed)
    members = [*recipe.first, *(replace(m, name=names.get(m.name, m.name)) for m in members), *recipe.more]
    lines = textwrap.wrap(headers.description(recipe.doc or recipe.name), WIDTH - 4, initial_indent='"""', break_long_words=False, break_on_hyphens=False)
    if members:
        lines += ["", *table(members)]
    lines[-1] += '"""'
    if functions := [m.name for m in members if m.is_function]:
        lines += ["", f"functions = ({' '.join(f'{chr(34)}{name}{chr(34)},' for name in functions)})"]
    if members:
        lines += [""]
    lines += [f"{m.name}: {m.type}" + (f" = {m.default}" if m.default else "") for m in members]
    body = "\n".join("    " + line if line else "" for line in lines)
    return f"@dataclass(frozen=True)\nclass {recipe.name}({recipe.base}):\n{body}\n"


def text() -> str:
    """What the file is to hold."""
    with tempfile.TemporaryDirectory() as folder:
        headers = Headers(Path(folder))
        classes = [written(recipe, headers) for recipes in RECIPES.values() for recipe in recipes]
    modules = [f'{recipe.name}.__module__ = "arenite.{module}"\n'
               for module, recipes in RECIPES.items() for recipe in recipes if not recipe.extended]
    return "\n\n".join([HEAD, *classes, "# The modules that show them, which pickles name.\n" + "".join(modules)])


def main() -> int:
    options = argparse.ArgumentParser(description=(__doc__ or "").split("\n\n")[0])
    options.add_argument("--check", action="store_true", help="write nothing; fail if the file is not what the headers say")
    made = text()
    if not options.parse_args().check:
        OUTPUT.write_text(made)
    elif made != OUTPUT.read_text():
        print("python/arenite/_recipes.py is not what the headers say: run python3 python/tools/recipes.py", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
