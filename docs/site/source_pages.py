"""Pages of source: a link of a page to a source file, as `../examples/own_law.cpp`, leads on the site to that file, coloured; one to a
folder leads to the list of its files. On a forge the same link leads to the file itself."""

from __future__ import annotations

import html
import posixpath
from pathlib import Path
from typing import Any, Dict, Iterator, Tuple

from docutils import nodes
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import TextLexer, get_lexer_for_filename
from pygments.util import ClassNotFound
from sphinx import addnodes
from sphinx.application import Sphinx

ROOT = Path(__file__).resolve().parents[2]
SHOWN = {".cpp", ".hpp", ".py", ".sh", ".cmake", ".txt", ".md", ".cff", ""}


def page_of(path: Path) -> str:
    return f"source/{path.relative_to(ROOT).as_posix()}"


def lead_to_pages(app: Sphinx, doctree: nodes.document) -> None:
    """Turns links to files outside of docs/, and to sources within, into links to pages of source."""
    if app.builder.format != "html":
        return
    for node in list(doctree.findall(lambda n: isinstance(n, (addnodes.download_reference, addnodes.pending_xref)))):
        target = node.get("reftarget", "").split("#")[0]
        if node.get("reftype") != "myst" or not target:
            continue
        path = (Path(app.srcdir) / app.env.docname).parent.joinpath(target).resolve()
        if not path.is_relative_to(ROOT) or not path.exists() or not (path.is_dir() or path.suffix in SHOWN):
            continue
        if path.suffix == ".md" and path.is_relative_to(app.srcdir):
            continue
        for shown in [path, *(sorted(p for p in path.iterdir() if p.suffix in SHOWN - {""}) if path.is_dir() else [])]:
            app.env.arenite_sources.setdefault(app.env.docname, set()).add(shown)
        uri = posixpath.relpath(f"{page_of(path)}.html", posixpath.dirname(app.env.docname) or ".")
        node.replace_self(nodes.reference("", "", *node.children, internal=True, refuri=uri))


def forget(app: Sphinx, env: Any, docname: str) -> None:
    env.arenite_sources.pop(docname, None)


def merge(app: Sphinx, env: Any, docnames: Any, other: Any) -> None:
    env.arenite_sources.update({d: s for d, s in other.arenite_sources.items() if d in docnames})


def begin(app: Sphinx) -> None:
    if not hasattr(app.env, "arenite_sources"):
        app.env.arenite_sources = {}
    app.env.arenite_trees = {}


def source_pages(app: Sphinx) -> Iterator[Tuple[str, Dict[str, Any], str]]:
    shown = set().union(*app.env.arenite_sources.values())
    for path in sorted(shown):
        title = html.escape(path.relative_to(ROOT).as_posix())
        if path.is_dir():
            inside = sorted(p for p in shown if p.parent == path and p.is_file())
            body = "<ul>" + "".join(f'<li><a href="{path.name}/{p.name}.html">{p.name}</a></li>' for p in inside) + "</ul>"
        else:
            try:
                lexer = get_lexer_for_filename(path.name)
            except ClassNotFound:
                lexer = TextLexer()
            body = highlight(path.read_text(), lexer, HtmlFormatter(linenos="inline", cssclass="highlight"))
        yield page_of(path), {"title": title, "body": f"<h1>{title}</h1>\n{body}"}, "page.html"


def share_tree(app: Sphinx, pagename: str, templatename: str, context: Dict[str, Any], doctree: Any) -> None:
    """Pages of source of one folder have the same tree of pages beside them: it is made once, not for each of hundreds of pages."""
    if pagename.startswith("source/") and "toctree" in context:
        made, tree, folder = app.env.arenite_trees, context["toctree"], posixpath.dirname(pagename)

        def toctree(**options: Any) -> str:
            key = (folder, *sorted(options.items()))
            if key not in made:
                made[key] = tree(**options)
            return made[key]

        context["toctree"] = toctree


def setup(app: Sphinx) -> Dict[str, Any]:
    app.connect("builder-inited", begin)
    app.connect("env-purge-doc", forget)
    app.connect("env-merge-info", merge)
    app.connect("doctree-read", lead_to_pages, priority=100)  # before Sphinx collects what is to be downloaded
    app.connect("html-collect-pages", source_pages)
    app.connect("html-page-context", share_tree, priority=100)  # before the theme asks for the tree
    return {"parallel_read_safe": True}
