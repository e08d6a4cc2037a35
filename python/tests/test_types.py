"""What type checkers say of scripts as users write them, against the installed package: the Python of the README and of docs, the
examples and the notebooks, with mypy and with pyright (here basedpyright, which pip installs with all that it needs) as they begin."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]

# What the text around the blocks of a page speaks of.
AROUND = {"restart.md": "import h5py\n",
          "python.md": "import numpy as np\nstress = strain = spin = history = np.zeros((2, 6))\ndt = 1e-4\ndef toe(friction: float, cell: float) -> float:\n    return friction * cell\n"}


def scripts():
    """Every script, by its name."""
    found = {p.name: p.read_text() for p in sorted((SOURCE / "examples" / "python").glob("*.py"))}
    for page in [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]:
        blocks = re.findall(r"^```python\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE)
        if blocks:
            found[page.stem.replace("-", "_") + "_page.py"] = AROUND.get(page.name, "") + "\n".join(blocks)
    for notebook in sorted((SOURCE / "docs" / "notebooks").glob("*.ipynb")):
        cells = [c["source"] for c in json.loads(notebook.read_text())["cells"] if c["cell_type"] == "code"]
        found[notebook.stem + "_notebook.py"] = "\n".join("".join(c) for c in cells)
    return found


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with every script, outside of the source: what is not installed is not found."""
    pytest.importorskip("arenite")
    place = tmp_path_factory.mktemp("scripts")
    for name, text in scripts().items():
        (place / name).write_text(text)
    # Each public name is there for a checker, as it is for Python.
    import arenite as ar

    (place / "names.py").write_text("import arenite as ar\n" + "".join(f"ar.{name}\n" for name in ar.__all__))
    return place


def said(folder, *command):
    done = subprocess.run([sys.executable, "-m", *command], cwd=folder, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def test_there_are_scripts():
    names = set(scripts())
    assert {"footing.py", "first_python_page.py", "README_page.py", "penetrometer_notebook.py"} <= names and len(names) > 15


def test_mypy(folder):
    pytest.importorskip("mypy")
    code, text = said(folder, "mypy", "--check-untyped-defs", "--ignore-missing-imports", ".")
    assert code == 0, text


def test_pyright(folder):
    pytest.importorskip("basedpyright")
    (folder / "pyrightconfig.json").write_text(json.dumps(
        {"typeCheckingMode": "standard", "reportMissingImports": "none", "reportMissingModuleSource": "none"}))
    code, text = said(folder, "basedpyright", "--pythonpath", sys.executable)
    assert code == 0, text


def test_checkers_find_a_wrong_word(tmp_path):
    """That the package is seen with its types: a parameter that is none is an error."""
    (tmp_path / "wrong.py").write_text("import arenite as ar\nar.MohrCoulomb(desnity=1)\n")
    pytest.importorskip("mypy")
    code, text = said(tmp_path, "mypy", "wrong.py")
    assert code == 1 and "desnity" in text
