"""Ranks that have the tiles of one scene: what all of them ask is compared before it is done."""

from __future__ import annotations

import atexit
import dataclasses
import functools
import hashlib
import weakref
from typing import Any, Callable, Dict, Iterator, List, Tuple

import numpy as np

from ._pickle import parts
from ._recipe import Recipe
from .functions import Signal

#: Of the compiled scene: what one rank may ask alone,
_HERE = frozenset(("time", "time_step", "steps", "generation", "watched", "columns", "nodes", "cells", "copy"))
#: and what all must, by the names of the user's; an argument without a name may differ.
_ALL: Dict[str, Tuple[str, Tuple[str, ...]]] = {
    "step": ("step", ("dt",)), "energies": ("energy", ()), "reaction": ("reaction", ("wall",)),
    "run": ("run", ("end", "courant", "max_step", "ratio", "is restored", "every", "", "after_step", "watch")),
    "fill": ("fill_points", ("body", "fill")), "insert": ("insert_points", ("body", "points")), "remove": ("remove_points", ("body", "where")),
    "probe": ("probe", ("body", "places")), "section_force": ("section_force", ("body", "section", "of_nodes")),
    "save": ("save", ("path", "recipe")), "restore": ("restore", ("path", "recipe"))}

Told = List[Tuple[str, str]]


def _digest(*data: bytes) -> str:
    return hashlib.sha256(b"\0".join(data)).hexdigest()[:16]


def _code(code: Any) -> bytes:
    """The instructions of a function and of those within it, and the constants that have one text in all processes."""
    constants = [_code(c) if hasattr(c, "co_code") else repr(c).encode() for c in code.co_consts
                 if hasattr(c, "co_code") or isinstance(c, (int, float, str))]
    return b"\0".join([code.co_code, repr(code.co_names).encode(), *constants])


def _of_function(f: Any, name: str) -> Iterator[Tuple[str, str]]:
    """Name and code of a function, and the numbers, words and arrays that it reads besides its arguments."""
    while hasattr(f, "__wrapped__"):
        f = f.__wrapped__
    if isinstance(f, functools.partial):
        yield from _of_function(f.func, name)
        yield from told(list(f.args), f"{name}, given")
        yield from told(f.keywords, f"{name}, given")
        return
    code = getattr(f, "__code__", None)
    if code is None:
        yield name, f"a {type(f).__name__}"
        return
    yield name, f"{f.__qualname__} (line {code.co_firstlineno}) of code {_digest(_code(code))}"
    reads = {n: f.__globals__[n] for n in code.co_names if n in f.__globals__}
    for n, cell in zip(code.co_freevars, f.__closure__ or ()):
        try:
            reads[n] = cell.cell_contents
        except ValueError:  # it has no value yet
            pass
    reads.update(enumerate(f.__defaults__ or ()))
    for n, value in reads.items():
        if isinstance(value, (bool, int, float, str, np.ndarray, np.generic)):
            yield from told(value, f"{name}, which reads {n}")


def told(value: Any, name: str) -> Iterator[Tuple[str, str]]:
    """What a rank was given, each part of it by its name, as text that is the same for the same value."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, Signal):
        value = value.components
    if isinstance(value, (list, tuple)) and value and isinstance(value[0], (int, float, list, tuple)):
        try:
            value = np.asarray(value, dtype=float)
        except (TypeError, ValueError):  # not numbers alone
            pass
    if isinstance(value, np.ndarray):
        numbers = np.ascontiguousarray(value, dtype=None if value.dtype.kind in "OSU" else float)
        few = numbers.size <= 8 or numbers.dtype.kind in "OSU"
        yield name, f"{numbers.tolist()}" if few else f"{list(numbers.shape)} numbers of hash {_digest(numbers.tobytes())}"
    elif value is None:
        yield name, "None"
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield name, repr(float(value)).removesuffix(".0")
    elif isinstance(value, (bool, str)):
        yield name, str(value)
    elif callable(value) and not isinstance(value, Recipe):
        yield from _of_function(value, name)
    else:
        contains = isinstance(value, (list, tuple, dict))
        yield name, f"{len(value)} entries" if contains else type(value).__name__
        if contains or isinstance(value, Recipe) or dataclasses.is_dataclass(value):
            for part, of in parts(value, name):
                yield from told(part, of)


class Asked:
    """The compiled scene of a rank. What all ranks must ask for is compared by all before it is done."""

    def __init__(self, core: Any, ranks: Any) -> None:
        self._core, self._ranks = core, ranks

    def __getattr__(self, name: str) -> Callable[..., Any]:
        asked: Callable[..., Any] = getattr(self._core, name)
        if name in _HERE:
            return asked

        def ask(*given: Any) -> Any:
            asks, names = _ALL.get(name, (name, ()))
            agree(self._ranks, asks, {n: _compared(name, n, value) for n, value in zip(names, given) if n})
            return asked(*given)

        return ask


def _compared(asks: str, name: str, value: Any) -> Any:
    if asks == "run" and callable(value):  # each rank may look in its own way
        return "a function"
    if (asks, name) == ("remove", "where") and isinstance(value, np.ndarray):  # of the rank's own points
        return "an array"
    return value


def agree(ranks: Any, asks: str, given: Dict[str, Any]) -> None:
    """Returns once all ranks ask for this and were given the same; else raises `Error` on all."""
    if ranks.size > 1:
        ranks.agree(asks, [part for name, value in given.items() for part in told(value, name)])


_alive: "weakref.WeakSet[Any]" = weakref.WeakSet()


def leave_at_exit(scene: Any) -> None:
    """Lets other ranks, which ask for something of the scene when this program has ended, end with a sentence."""
    _alive.add(scene)


@atexit.register
def _leave() -> None:
    for scene in list(_alive):
        scene._ranks.leave()
