"""The documentation site: `tests/run.sh --docs`, or `sphinx-build -W docs build/docs/html` with docs/requirements.txt and Doxygen.

The pages are Markdown that reads as well without Sphinx: links are those of files. What there is beside Sphinx's settings, in site/: the
reference of C++ is made from the headers (cpp_reference.py), links to sources lead to pages of source (source_pages.py), and formulas
need no script (mathml.py). The tables of the trade are made from their rows (benchmarks/trade/page.py)."""

import re
import sys
from pathlib import Path

DOCS = Path(__file__).parent
sys.path[:0] = [str(DOCS / "site"), str(DOCS.parent / "python"), str(DOCS.parent / "benchmarks" / "trade")]

project = "Arenite"
author = "the Arenite authors"
copyright = "the Arenite authors, BSD 3-Clause"
_version = (DOCS.parent / "include" / "arenite" / "version.hpp").read_text()
release = version = ".".join(re.search(rf"#define ARENITE_VERSION_{part} (\d+)", _version)[1] for part in ("MAJOR", "MINOR", "PATCH"))

extensions = ["myst_parser", "sphinx.ext.autodoc", "breathe", "source_pages", "mathml"]
exclude_patterns = ["_build", "notebooks", "README.md"]
highlight_language = "text"  # of blocks that name none
nitpicky = False

# --- Markdown
myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 4  # page.md#heading, as forges have it
myst_links_external_new_tab = False

# --- Python: the package as it is; its native core is not built for this.
autodoc_mock_imports = ["arenite._core"]
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_default_options = {"members": True, "undoc-members": True, "show-inheritance": False}
python_use_unqualified_type_names = True

# --- C++
breathe_default_project = "arenite"
breathe_projects = {}  # set below: the build folder is not known yet
breathe_show_include = False
cpp_id_attributes = ["ARENITE_INLINE", "ARENITE_KERNEL"]

# --- HTML
html_math_renderer = "mathml"
html_theme = "furo"
html_title = f"Arenite {release}"
html_static_path = ["site/static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False


def _write_cpp_reference(app):
    import cpp_reference

    xml = Path(app.doctreedir) / "doxygen"
    cpp_reference.run_doxygen(xml)
    cpp_reference.write_pages(xml)
    app.config.breathe_projects["arenite"] = str(xml / "xml")


def _write_trade_tables(app):
    import page

    path, text = DOCS / "trade_tables.md", page.tables(page.HERE)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def _inline(text):
    """`code` in single backquotes as reStructuredText has it; its other marks are plain characters."""
    text = re.sub(r"`[^`]*`|[*|]", lambda m: f"`{m[0]}`" if len(m[0]) > 1 else f"\\{m[0]}", text)
    return re.sub(r"``[^`]*``", lambda m: re.sub(r"\s*\n\s*", " ", m[0]), text)  # one that goes over the end of a line


def _table(lines):
    """Lines whose columns stand two spaces apart, the first of them the head."""
    rows = [[_inline(cell) for cell in re.split(r"  +", line.strip())] for line in lines]
    table = ["", ".. list-table::", "   :header-rows: 1", ""]
    for row in rows:
        cells = row + [""] * (len(rows[0]) - len(row))
        table += [f"   {'*' if k == 0 else ' '} - {chr(0x2013) if cell == '-' else cell}".rstrip() for k, cell in enumerate(cells)]
    return [*table, ""]


def _text(lines):
    """Plain text, with parameters as lines `name   meaning`."""
    text = re.sub(r"^ +", "  ", _inline("\n".join(lines)), flags=re.MULTILINE)
    return re.sub(r"^(\w+)  +(?=\S)", r"- *\1*: ", text, flags=re.MULTILINE).split("\n")


def _plain_docstring(app, what, name, obj, options, lines):
    """Our docstrings are plain text; the block under a line `parameter  unit  range  default` is a table."""
    if lines and lines[0].startswith("Alias for field number"):  # of a NamedTuple, whose docstring tells its fields
        lines.clear()
    begin = next((k for k, line in enumerate(lines) if line.startswith("parameter  ")), len(lines))
    end = next((k for k in range(begin, len(lines)) if not lines[k].strip()), len(lines))
    table = _table(lines[begin:end]) if begin < end else []
    lines[:] = [*_text(lines[:begin]), *table, *_text(lines[end:])]


def setup(app):
    app.connect("autodoc-process-docstring", _plain_docstring)
    app.connect("builder-inited", _write_cpp_reference, priority=1)
    app.connect("builder-inited", _write_trade_tables, priority=1)
