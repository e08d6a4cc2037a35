"""The program's own help."""

from __future__ import annotations

from . import _driver

__all__ = ["Text", "help"]


class Text(str):
    """Text that an interactive session shows as it is."""

    def __repr__(self) -> str:
        return str(self)


def help(command: str = "") -> Text:  # noqa: A001
    """Help of a command, "drop" or "reduce": every option with its unit, its range and its default. `cell_at_cone` in Python is
    `--cell-at-cone` there. Without a command the list of commands."""
    ending = _driver.run([*([command] if command else []), "--help"])
    ending.check()
    return Text("\n".join(ending.said))
