"""What every recipe has: the C++ type that it names and the values that it carries."""

from __future__ import annotations

import contextlib
import dataclasses
import enum
import inspect
import math
import re
from typing import Any, Callable, Dict, Tuple

import numpy as np

from . import _core
from ._errors import Error

_WITH_RULES = frozenset(_core.checked_recipes())

NOT_GIVEN = float("nan")  #: the default of what must be given


class Recipe:
    """A dataclass whose fields are the members of the C++ class of the same name. It is checked when it is made, by the
    rules of that class."""

    functions: Tuple[str, ...] = ()  #: names of the fields that may be functions of time or place

    def __init_subclass__(cls, **more: Any) -> None:
        super().__init_subclass__(**more)
        # Before `dataclass` writes its own, which compare no arrays and show what cannot be pasted.
        for name in "__repr__", "__eq__":
            if name not in vars(cls):
                setattr(cls, name, next(vars(base)[name] for base in cls.__mro__[1:] if name in vars(base)))
        if not vars(cls).get("__doc__"):
            cls.__doc__ = inspect.getdoc(cls)  # `help` shows no inherited one

    @classmethod
    def _fields(cls) -> Tuple[dataclasses.Field[Any], ...]:
        return tuple(getattr(cls, "__dataclass_fields__", {}).values())

    def _given(self) -> Dict[str, Any]:
        """What it is made of, by name, without what is as by default."""
        made_by: Dict[str, Any] = {f.name: f.default_factory for f in self._fields()}
        given: Dict[str, Any] = {}
        for name, p in inspect.signature(type(self)).parameters.items():
            value, default = getattr(self, name), p.default
            make = made_by.get(name, dataclasses.MISSING)
            make = default if make is dataclasses.MISSING and isinstance(default, type) and not isinstance(value, type) else make
            with contextlib.suppress(Error):  # of one that has no default of its own
                default = default if make is dataclasses.MISSING else make()
            if not same(value, default):
                given[name] = value
        return given

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={pasted(value)}' for name, value in self._given().items())})"

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and same(vars(self), vars(other))

    def __hash__(self) -> int:
        return hash(type(self))  # the same for equal ones, of whatever they are made

    def __post_init__(self) -> None:
        for f in self._fields():
            parts = f.default if isinstance(f.default, tuple) else (f.default,)
            if getattr(self, f.name) is f.default and any(x is NOT_GIVEN for x in parts):
                raise Error(f"{type(self).__name__}.{f.name}: {not_given(type(self), f.name)}")
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


def parameter_table(recipe: type) -> Dict[str, str]:
    """What the table of a recipe's docstring tells of each parameter: meaning, unit and range."""
    _, _, rows = (inspect.getdoc(recipe) or "").partition("\nparameter  ")
    found: Dict[str, str] = {}
    for row in rows.split("\n")[1:]:
        name, unit, range_, *rest = re.split(r"  +", row)
        found[name] = ", ".join([*rest[1:], *([unit] if unit not in ("-", "any") else []), *([range_] if range_ != "any" else [])])
    return found


def not_given(recipe: type, name: str) -> str:
    told = parameter_table(recipe).get(name)
    return f"not given{told and ' (' + told + ')' or ''}"


def shown(value: Any) -> str:
    """A value in a message."""
    text = repr(value)
    return text if len(text) <= 80 else text[:80] + " .."


_MOST = 24  #: numbers of a list that a recipe shows


def pasted(value: Any) -> str:
    """A value as Python reads it, with the names of the package; long lists and functions by what they are alone."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return f"float('{value}')"
    if isinstance(value, enum.Enum):
        return f"{type(value).__name__}.{value.name}"
    if isinstance(value, type):
        return value.__name__
    if isinstance(value, np.ndarray):
        return pasted(value.tolist()) if value.size <= _MOST else f"<array {list(value.shape)}>"
    if isinstance(value, (list, tuple)):
        if _count(value) > _MOST:
            return f"<{len(value)} entries>"
        inner = ", ".join(map(pasted, value))
        return f"[{inner}]" if isinstance(value, list) else f"({inner}{',' * (len(value) == 1)})"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key!r}: {pasted(one)}' for key, one in value.items())}}}"
    if callable(value) and hasattr(value, "__qualname__"):
        return f"<function {value.__qualname__}>"
    return repr(value)


def _count(value: Any) -> int:
    return sum(map(_count, value)) if isinstance(value, (list, tuple)) else 1


def same(a: Any, b: Any) -> bool:
    """Whether two values of recipes are equal: arrays by their numbers, also to lists; NaN is itself."""
    if a is b:
        return True
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        try:
            return np.array_equal(np.asarray(a), np.asarray(b))
        except ValueError:  # ragged rows
            return False
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if isinstance(a, (list, tuple)) and type(a) is type(b):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, float) and isinstance(b, float) and math.isnan(a) and math.isnan(b):
        return True
    return bool(a == b)


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

