"""Errors and warnings of the package."""

import contextlib
import re
import threading
from typing import Iterator, Sequence, Tuple

_Names = Tuple[Sequence[str], Sequence[str]]
_at_work = threading.local()  # names of the bodies of the scene that this thread is in


@contextlib.contextmanager
def bodies_named(bodies: Sequence[str], rigids: Sequence[str]) -> Iterator[None]:
    """Within it messages call bodies by these names, a rigid body without one by its number: compiled scenes know numbers alone."""
    before: _Names = getattr(_at_work, "names", ([], []))
    _at_work.names = (bodies, rigids)
    try:
        yield
    finally:
        _at_work.names = before


def _named(text: str) -> str:
    names: _Names = getattr(_at_work, "names", ([], []))

    def name(found: "re.Match[str]") -> str:
        among, number = names[1 if found[1] else 0], int(found[2])
        return f"{found[1]}body {(among[number] if number < len(among) else '') or number}"

    return re.sub(r"\b(rigid |)body (\d+)\b(?!\.\d)", name, text)


class Error(ValueError):
    """A value that breaks a rule; the message names the value and the rule."""

    def __init__(self, text: str = "") -> None:
        super().__init__(_named(text))


class RunError(Error):
    """A run that failed physically; the message names time, place and cause."""


class Warning(UserWarning):
    """Something worth a line although nothing is forbidden."""

    def __init__(self, text: str = "") -> None:
        super().__init__(_named(text))
