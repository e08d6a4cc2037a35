"""The C++ reference: one page for each room of include/arenite, written into docs/api before Sphinx reads the pages.

Doxygen reads the headers. Of each header a page has the words at its head, its documented classes (by Breathe) and its documented
functions, as they are declared. Namespaces of details are left out."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import textwrap
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Iterator, List, Set

ROOT = Path(__file__).resolve().parents[2]
HEADERS = ROOT / "include" / "arenite"
PAGES = ROOT / "docs" / "api"

# In the order of the includes (docs/design.md): nothing of a room includes a later one.
ROOMS = ("core simd parallel geometry functions mesh shape law fill particles boundary part warnings transfer load contact rigid scene observe watch run "
         "tiles error_bar io").split()


def run_doxygen(xml: Path) -> None:
    """Writes Doxygen's XML into the folder `xml`/xml."""
    xml.mkdir(parents=True, exist_ok=True)
    if shutil.which("doxygen") is None:
        raise FileNotFoundError("doxygen: not found (Debian: apt-get install doxygen)")
    subprocess.run(["doxygen", str(ROOT / "docs" / "Doxyfile")], check=True, stderr=subprocess.DEVNULL,
                   env={**os.environ, "ARENITE_ROOT": str(ROOT), "ARENITE_XML": str(xml)})
    for path in (xml / "xml").glob("*.xml"):  # initial values that Sphinx's C++ cannot read
        text = path.read_text()
        kept = re.sub(r"<initializer>[^<]*(\[\]|requires|\[&amp;\])(.|\n)*?</initializer>", "", text)
        if kept != text:
            path.write_text(kept)


def _head(header: Path) -> str:
    """The comment at the head of a header, as one paragraph."""
    lines = []
    for line in header.read_text().splitlines():
        if not line.startswith("//"):
            break
        lines.append(line.lstrip("/").strip())
    return " ".join(lines)


def _rst(text: str) -> str:
    """Words of a comment, so that reStructuredText takes no sign in them for its own; `code` is code."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(f"`{p}`" if p.startswith("`") else re.sub(r"([*|_\\])", r"\\\1", p) for p in parts)


def _words(node: ET.Element | None) -> str:
    """What a description says; <computeroutput> in backquotes."""
    if node is None:
        return ""

    def walk(e: ET.Element) -> Iterator[str]:
        code = e.tag == "computeroutput"
        if e.tag == "para":
            yield " "
        if e.tag == "listitem":
            yield " - "
        yield "``" if code else ""
        yield (e.text or "") if code else _rst(e.text or "")
        for child in e:
            yield from walk(child)
            yield (child.tail or "") if code else _rst(child.tail or "")
        yield "``\0" if code else ""

    text = re.sub(r"\s+", " ", "".join(walk(node))).strip()
    # Behind code reStructuredText wants a space or a stop; `\ ` is none that is seen.
    return re.sub(r"\0(?=[\w\[(<{=+])", r"\\ ", text).replace("\0", "")


def _plain(node: ET.Element | None) -> str:
    return "" if node is None else re.sub(r"\s+", " ", "".join(node.itertext())).strip()


def _declaration(function: ET.Element) -> str:
    """`template <..> type name(arguments)`."""
    given = []
    for p in function.findall("templateparamlist/param"):
        word = _plain(p.find("type")) + (f" {_plain(p.find('declname'))}" if p.find("declname") is not None else "")
        given.append(word + (f" = {_plain(p.find('defval'))}" if p.find("defval") is not None else ""))
    head = f"template <{', '.join(given)}>\n" if given else ""
    needs = _plain(function.find("requiresclause"))
    return (head + (f"requires {needs}\n" if needs else "") + f"{_plain(function.find('type'))} {function.findtext('name')}"
            f"{function.findtext('argsstring')};").replace(" ;", ";")


def _public(name: str) -> bool:
    return "detail" not in name and "@" not in name and "<" not in name


def documented(xml: Path) -> tuple[dict[str, List[ET.Element]], dict[str, List[ET.Element]]]:
    """The public classes and concepts, and the functions and aliases, that Doxygen's XML has words on, by header."""
    xml = xml / "xml"
    members: dict[str, List[ET.Element]] = {}
    for m in ET.parse(xml / "namespacearenite.xml").iter("memberdef"):
        if m.get("kind") in ("function", "typedef") and m.find("location") is not None \
                and (_words(m.find("briefdescription")) or _words(m.find("detaileddescription"))):
            members.setdefault(m.find("location").get("file"), []).append(m)
    classes: dict[str, List[ET.Element]] = {}
    for path in sorted(xml.glob("*.xml")):
        if not path.name.startswith(("struct", "class", "concept")):
            continue
        for c in ET.parse(path).findall("compounddef"):
            name = c.findtext("compoundname")
            told = _words(c.find("briefdescription")) or _words(c.find("detaileddescription"))
            # A member class stands with the class around it.
            if _public(name) and told and name.count("::") == 1 and c.find("location") is not None:
                classes.setdefault(c.find("location").get("file"), []).append(c)
    return classes, members


def names(xml: Path) -> str:
    """The page docs/names.md."""
    rows: dict[tuple[str, str], str] = {}
    for found in documented(xml):
        for e in (e for elements in found.values() for e in elements):
            name = (e.findtext("name") or e.findtext("compoundname")).removeprefix("arenite::")
            where = e.find("location")
            header = re.sub(r"^arenite/", "", where.get("declfile") or where.get("file"))
            words = " ".join(filter(None, (_plain_words(e.find(kind)) for kind in ("briefdescription", "detaileddescription"))))
            said = re.split(r"(?:[.;]|: .*) (?=[A-Z`-])|: |; |[.]$", re.sub(r" \((?:[^()]|\([^()]*\))*\b\d{4}\b(?:[^()]|\([^()]*\))*\)", "", words))[0]
            rows[name, header] = max(rows.get((name, header), ""), said, key=len)  # of the overloads
    lines = [f"| `{name}` | [{header}](../include/arenite/{header}) | {says} |" for (name, header), says in sorted(rows.items(), key=lambda r: (r[0][0].lower(), r[0]))]
    return NAMES_HEAD + "\n".join(lines) + "\n"


NAMES_HEAD = """# Names of C++

(written by `python3 docs/site/cpp_reference.py` out of the headers; not by hand)

Each class, concept, alias and function of `arenite` that the headers tell of, with the header under `include/arenite` that has it; what an include needs beside, it includes itself.
A name has one meaning: a shape such as `Ball` is a region to fill and the surface of a `Rigid` body alike. In full they stand in the [C++ reference](api_cpp.md).

| name | header | what it is |
|---|---|---|
"""


def _plain_words(node: ET.Element | None) -> str:
    """What a description says in Markdown, for a table."""
    return re.sub(r"``(.*?)``(\\ )?", r"`\1`", _words(node)).replace("\\", "").replace("|", "\\|")


def write_pages(xml: Path) -> None:
    """Writes docs/api/ROOM.rst from the headers and Doxygen's XML."""
    classes, members = documented(xml)
    functions = {header: [m for m in found if m.get("kind") == "function"] for header, found in members.items()}

    PAGES.mkdir(exist_ok=True)
    written: Set[Path] = set()
    for room in ROOMS:
        text = f"{room}\n{'=' * len(room)}\n\n"
        for header in sorted((HEADERS / room).rglob("*.hpp")):
            path = f"arenite/{header.relative_to(HEADERS)}"
            held = sorted(classes.get(path, []), key=lambda c: int(c.find("location").get("line")))
            free = sorted(functions.get(path, []), key=lambda f: int(f.find("location").get("line")))
            title = path.removeprefix("arenite/")
            text += f"{title}\n{'-' * len(title)}\n\n{_rst(_head(header)).replace('`', '``')}\n\n"
            for c in held:
                kind = c.get("kind")
                text += f".. doxygen{kind}:: {c.findtext('compoundname')}\n"
                text += "\n" if kind == "concept" else "   :members:\n\n"
            for f in free:
                says = " ".join(filter(None, (_words(f.find("briefdescription")), _words(f.find("detaileddescription")))))
                text += f".. code-block:: cpp\n\n{textwrap.indent(_declaration(f), '   ')}\n\n{says}\n\n"
        page = PAGES / f"{room}.rst"
        written.add(page)
        if not page.exists() or page.read_text() != text:
            page.write_text(text)
    for old in set(PAGES.glob("*.rst")) - written:
        old.unlink()


if __name__ == "__main__":
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        run_doxygen(Path(folder))
        (ROOT / "docs" / "names.md").write_text(names(Path(folder)))
