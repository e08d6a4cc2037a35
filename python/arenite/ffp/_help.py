"""What options there are, as the program lists them."""

from __future__ import annotations

import json
import textwrap

from . import _driver

__all__ = ["Text", "help"]


class Text(str):
    """Text that an interactive session shows as it is."""

    def __repr__(self) -> str:
        return str(self)


def help(command: str = "") -> Text:  # noqa: A001
    """Options of a command, "drop", "push" or "reduce", by their keywords, with units, ranges and defaults. Without one: of all."""
    if not command:
        return Text("\n\n".join(help(one) for one in ("drop", "push", "reduce")))
    ending = _driver.run({"command": "options", "of": command})
    ending.check()
    lines, group = [f"Options of arenite.ffp.{command}:"], ""
    for option in json.loads("\n".join(ending.said)):
        if option["group"] != group:
            group = option["group"]
            lines += ["", f"{group}:"]
        lines.append(f"  {option['option'][2:].replace('-', '_')}={option['takes'] or 'True|False'}")
        lines += textwrap.wrap(option["help"], 120, initial_indent="      ", subsequent_indent="      ")
    return Text("\n".join(lines))
