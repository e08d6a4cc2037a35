"""What every recipe has: the C++ type that it names and the values that it carries."""

from __future__ import annotations

import dataclasses
import inspect
from typing import Any, Callable, Tuple

import numpy as np

from . import _core

_WITH_RULES = frozenset(_core.checked_recipes())


class Recipe:
    """A dataclass whose fields are the members of the C++ class of the same name. It is checked when it is made, by the
    rules of that class."""

    functions: Tuple[str, ...] = ()  #: names of the fields that may be functions of time or place

    def __post_init__(self) -> None:
        for name, value in list(vars(self).items()):
            if isinstance(value, np.generic):  # a number of Python's, which a repr shows as such
                object.__setattr__(self, name, value.item())
        if self.rules() in _WITH_RULES:
            _core.check(self.rules(), self.checked())

    def rules(self) -> str:
        """What the native core calls the rules for these values."""
        return self.cpp().split("<")[0]

    def checked(self) -> Any:
        """The values that the rules look at."""
        return self.value()

    def cpp(self) -> str:
        """The C++ type, as a scene's type spells it."""
        return type(self).__name__

    def value(self) -> Any:
        """The values of the fields, by name, for the native core."""
        fields = ((f.name, getattr(self, f.name)) for f in dataclasses.fields(self))  # type: ignore[arg-type]
        return {name: function_value(given) if name in self.functions else plain(given) for name, given in fields}


def check_together(*recipes: str) -> None:
    """Refuses recipes, by their classes, that do not go together."""
    _core.check_together(list(recipes))


def plain(x: Any) -> Any:
    """Recipes within a value as their values."""
    if isinstance(x, Recipe):
        return x.value()
    if isinstance(x, dict):
        return {key: plain(v) for key, v in x.items()}
    if isinstance(x, (list, tuple, range)):
        return [plain(v) for v in x]
    return x


def arguments_of(f: Callable[..., Any]) -> int:
    """How many positional arguments a function takes; 1 if that is not known."""
    try:
        kinds = [p.kind for p in inspect.signature(f).parameters.values() if p.default is inspect.Parameter.empty]
    except (TypeError, ValueError):
        return 1
    return sum(kind in (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD) for kind in kinds)


def function_value(f: Any) -> Any:
    """A number, vector or recipe as it is; a function `f(t)` or `f(x, t)` so that the core calls it with rows."""
    if isinstance(f, Recipe) or not callable(f):
        return plain(f)
    of_place = arguments_of(f) >= 2

    def of_rows(rows: Any) -> Any:
        return f(rows[0, :3], float(rows[0, 3])) if of_place else f(float(rows[0, 0]))

    of_rows.__wrapped__ = f  # type: ignore[attr-defined]  # messages name it
    return {"of_place" if of_place else "of_time": of_rows}

