"""Small tables for notebooks."""

from __future__ import annotations

import html
from typing import Any, Iterable, Sequence

import numpy as np


def _cell(value: Any) -> str:
    if isinstance(value, (float, np.floating)):
        return f"{value:.6g}"
    if isinstance(value, (list, tuple, np.ndarray)):
        return ", ".join(map(_cell, value)) if len(value) <= 6 else f"{len(value)} entries"
    return html.escape("-" if value is None else str(value))


def table(title: str, head: Sequence[str], rows: Iterable[Sequence[Any]], below: str = "") -> str:
    """Rows of values under a line of names; what is not a number is escaped."""
    def line(tag: str, row: Sequence[Any]) -> str:
        return "<tr>" + "".join(f"<{tag}>{_cell(value)}</{tag}>" for value in row) + "</tr>"

    body = "".join(line("td", row) for row in rows)
    return (f"<table><caption>{html.escape(title)}</caption><thead>{line('th', head)}</thead><tbody>{body}</tbody></table>"
            + (f"<p>{html.escape(below)}</p>" if below else ""))


def members(value: Any, names: Iterable[str], unit: str = "") -> str:
    """The members of a value, a row each."""
    return table(type(value).__name__ + (f" [{unit}]" if unit else ""), ("", ""), ((name, getattr(value, name)) for name in names))
