"""The code in the README and in docs/*.md.

```python: the blocks of a page are run one after the other, in one namespace and an empty folder.
```cpp: a block that holds ` ..` is a sketch, of which parts are left out. Any other one must stand, but for white space and comments,
in a program that is compiled and run: in examples/, docs/snippets/ or tests/install/; paragraph by paragraph, so that its #include
may stand at the program's head.
What is neither stands in LEFT_OUT with the reason."""

import re
import shutil
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]
PAGES = [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]

LEFT_OUT = {
    ("compile_time.md", "cpp", "// slope.hpp"): "the header of slope.cpp, a sketch; arenite/compositions.hpp has such declarations, and tests/install/named.cpp uses them",
    ("python.md", "python", "sweep = ar.sweep(toe"): "its function must be one of a module; test_scene.py makes the same calls",
    ("many_machines.md", "python", "import arenite as ar\n\n\ndef toe"): "a script of its own; test_scene.py makes the same calls",
    ("python.md", "python", "drop = ar.ffp.drop(delta=20)"): "takes a minute; test_ffp.py and the notebook run the same calls",
}


def blocks(page, language):
    """The blocks of a page in a language, without those that are left out."""
    for text in re.findall(rf"^```{language}\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE):
        if not any(page.name == p and language == w and text.startswith(begin) for p, w, begin in LEFT_OUT):
            yield text


def test_mathematics_of_packs_are_listed():
    """In python.md, as the header has them."""
    header = (SOURCE / "include" / "arenite" / "simd" / "pack_functions.hpp").read_text()
    lists = re.findall(r"#define ARENITE_FUNCTIONS_OF_\w+\(list\)((?:.*\\\n)*.*)", header)
    there = {name for text in lists for name in re.findall(r"list\((\w+)\)", text)}
    row = re.search(r"^\| lane by lane \| (.*) \|$", (SOURCE / "docs" / "python.md").read_text(), re.MULTILINE)
    assert len(there) > 20 and set(re.findall(r"`(\w+)`", row[1])) == there


def test_names_are_those_of_the_headers(tmp_path):
    """docs/names.md: each name stands in the header that it is said to be of; with Doxygen, the page is what the headers say."""
    page = (SOURCE / "docs" / "names.md").read_text()
    rows = re.findall(r"^\| `([^`]+)` \| \[([^]]+)\]\((.*?)\) \|", page, re.MULTILINE)
    assert len(rows) > 500 and {("Ball", "geometry/solids.hpp"), ("Scene", "scene/scene.hpp"), ("Rigid", "rigid/body/rigid_body.hpp")} <= {row[:2] for row in rows}
    for name, header, link in rows:
        assert link == f"../include/arenite/{header}"
        assert re.search(rf"\b{re.escape(name.split('::')[-1])}", (SOURCE / "include" / "arenite" / header).read_text()), name
    if shutil.which("doxygen"):
        sys.path.insert(0, str(SOURCE / "docs" / "site"))
        import cpp_reference

        cpp_reference.run_doxygen(tmp_path)
        assert cpp_reference.names(tmp_path) == page, "write it anew: python3 docs/site/cpp_reference.py"


def pages_with(language):
    return [pytest.param(p, id=p.name) for p in PAGES if list(blocks(p, language))]


def test_what_is_left_out_is_there():
    for page, language, begin in LEFT_OUT:
        path = next(p for p in PAGES if p.name == page)
        assert f"```{language}\n{begin}" in path.read_text(), f"{page}: no block begins with {begin}"


def bare(text):
    """C++ without white space and comments."""
    return re.sub(r"\s+", "", re.sub(r"//[^\n]*", "", text))


@pytest.mark.parametrize("page", pages_with("cpp"))
def test_cpp(page):
    folders = [SOURCE / "examples", SOURCE / "docs" / "snippets", SOURCE / "tests" / "install"]
    programs = [bare(p.read_text()) for folder in folders for p in sorted(folder.rglob("*.cpp"))]
    for block in blocks(page, "cpp"):
        if " .." in block:
            assert "int main" not in block, f"{page.name}: a whole program leaves nothing out:\n{block}"
            continue
        whole = bare(block)
        # A program may say less than the file that it was taken from, at its end.
        paragraphs = [whole.removesuffix("}")] if "int main" in block else [bare(p) for p in re.split(r"\n\s*\n", block)]
        assert any(all(p in program for p in paragraphs) for program in programs), f"{page.name}: in no program that is run:\n{block}"


@pytest.mark.parametrize("page", pages_with("python"))
def test_python(ar, page, tmp_path, monkeypatch):
    import numpy as np

    monkeypatch.chdir(tmp_path)
    # What the text around the blocks speaks of.
    space = {"stress": np.zeros((2, 6)), "strain": np.full((2, 6), 1e-6), "spin": np.zeros((2, 3)), "dt": 1e-4, "history": None}
    own = (SOURCE / "python" / "tests" / "own_elastic.hpp").read_text()
    Path("my_law.hpp").write_text(own)
    for block in blocks(page, "python"):
        exec(compile(block, f"{page.name}: {block.splitlines()[0]}", "exec"), space)
    if page.name == "first_python.md":  # what the reader is told to see
        told = re.search(r"x = (\S+) m after (\d+) steps", page.read_text().split("What you should see")[1])
        assert round(float(space["body"].position[:, 0].max()), 3) == pytest.approx(float(told[1]), abs=0.0011)
        assert Path("heap.png").stat().st_size > 0
