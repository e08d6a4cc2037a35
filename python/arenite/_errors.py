"""Errors and warnings of the package."""

import contextlib
import difflib
import re
import threading
from typing import Any, Callable, Iterable, Iterator, Sequence, Tuple, TypeVar

__all__ = ["ArgumentError", "Error", "RunError", "UnknownName", "Warning"]

_Names = Tuple[Sequence[str], Sequence[str]]
_Function = TypeVar("_Function", bound=Callable[..., Any])
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


def did_you_mean(word: str, names: Iterable[object]) -> str:
    """Words that name the nearest of the names; none if there is none that is near."""
    near = difflib.get_close_matches(word, [name for name in names if isinstance(name, str) and name != word], 1)
    return f"; did you mean {near[0]}?" if near else ""


def _nearest(text: str) -> str:
    """The nearest name where a message, also one of the library, lists those that there are behind one that is not."""
    told = r"('?)([\w ./-]+)\1: .*\b(?:one of:?|it has|there are|they are) ([\w ./,-]+)$"
    found = re.search("= " + told, text) or re.match(told, text)
    return did_you_mean(found[2], found[3].split(", ")) if found else ""


def checks(*names: str) -> Callable[[_Function], _Function]:
    """Marks a function that checks these arguments itself, in better words than those of their types."""
    def marked(function: _Function) -> _Function:
        function.checks = names  # type: ignore[attr-defined]
        return function
    return marked


class Error(ValueError):
    """A value that breaks a rule; the message names the value and the rule."""

    def __init__(self, text: str = "") -> None:
        named = _named(text)
        super().__init__(named + _nearest(named))


class ArgumentError(Error, TypeError):
    """An argument of a wrong type or name, or one that is missing; also a `TypeError`."""


class UnknownName(Error, KeyError):
    """A name that is not there; also a `KeyError`."""

    __str__ = Error.__str__


class RunError(Error):
    """A run that failed physically; the message names time, place and cause."""


class Warning(UserWarning):
    """Something worth a line although nothing is forbidden."""

    def __init__(self, text: str = "") -> None:
        super().__init__(_named(text))
