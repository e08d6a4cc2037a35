"""What public functions and recipes are given, looked at before they are called: an unknown keyword, an argument that is missing, and a
value of another type than its annotation are refused by name. `guard(..)` puts this around all that the package shows."""

from __future__ import annotations

import collections.abc
import enum
import functools
import inspect
import numbers
import os
import sys
import typing
from types import FunctionType
from typing import Any, Callable, Dict, Iterable, List, Optional, Tuple

import numpy as np

from ._errors import ArgumentError, Error, did_you_mean
from ._recipe import not_given, shown

_MOST_ITEMS = 64  #: of a list that are looked at


class _Numbers:
    """What `ArrayLike` stands for here."""


def _is_number(value: Any) -> bool:
    if isinstance(value, (bool, np.bool_, str, bytes)):
        return False
    if isinstance(value, numbers.Real):
        return True
    try:
        return np.ndim(value) == 0 and isinstance(float(value), float)
    except Exception:  # whatever a quantity with a unit raises
        return False


def _is_whole(value: Any) -> bool:
    """A number without a fraction, also one that is written with a point."""
    return _is_number(value) and float(value).is_integer()


def _are_numbers(value: Any) -> bool:
    try:
        return np.asarray(value).dtype.kind in "biuf"
    except Exception:  # ragged rows, or what a quantity with a unit raises
        return False


def _article(word: str) -> str:
    return f"an {word}" if word[0] in "AEIOU" else f"a {word}"


def _fault(value: Any, hint: Any) -> str:
    """What a value must be; nothing if it is that, or if a hint tells nothing that can be looked at."""
    if isinstance(hint, typing.ForwardRef):
        hint = os.PathLike if hint.__forward_arg__ == "os.PathLike[str]" else Any
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if isinstance(hint, type) and issubclass(hint, enum.Enum) and not isinstance(value, hint):
        return "one of " + ", ".join(f"{hint.__name__}.{name}" for name in hint.__members__)
    if hint is None or hint is type(None):
        return "" if value is None else "None"
    if hint is float:
        return "" if _is_number(value) else "a number in SI units"
    if hint is int:
        return "" if _is_whole(value) else "a whole number"
    if hint is bool:
        return "" if isinstance(value, (bool, np.bool_)) else "True or False"
    if hint is str:
        return "" if isinstance(value, str) else "a text"
    if hint is _Numbers:
        return "" if _are_numbers(value) else "numbers in SI units"
    if origin is typing.Union:
        faults = list(dict.fromkeys(_fault(value, one) for one in inner))
        return "" if "" in faults else " or ".join(rule for rule in faults if rule != "None")
    if origin is type:
        return "" if isinstance(value, type) else f"a class of {inner[0].__name__}"
    if origin is collections.abc.Callable:
        return "" if callable(value) else "a function"
    if origin is tuple:
        inner = inner[:1] if len(set(inner)) == 1 or inner[1:] == (...,) else (Any,)
    if origin in (list, tuple, collections.abc.Sequence, collections.abc.Iterable):
        kind = f"a list of {_many(inner[0])}" if inner and _many(inner[0]) else "a list"
        if isinstance(value, (str, bytes, dict)) or not isinstance(value, collections.abc.Iterable) or np.ndim(_quietly(value)) == 0:
            return kind
        if hasattr(value, "__next__") or not hasattr(value, "__len__"):
            return "" if origin is collections.abc.Iterable else kind
        return kind if inner and any(_fault(one, inner[0]) for one, _ in zip(value, range(_MOST_ITEMS))) else ""
    kind = origin or hint
    if not isinstance(kind, type) or kind.__module__ == "typing":
        return ""
    try:
        if isinstance(value, kind):
            return ""
    except TypeError:
        return ""
    if kind in (dict, collections.abc.Mapping):
        return "values by name, {name: value}"
    if kind is os.PathLike:
        return "a path"
    made = f" (make one: {value.__name__}(..))" if isinstance(value, type) and issubclass(value, kind) else ""
    return _article(kind.__name__.lstrip("_")) + made


def _quietly(value: Any) -> Any:
    return value if isinstance(value, np.ndarray) else [None]


def _many(hint: Any) -> str:
    names = {float: "numbers in SI units", int: "whole numbers", str: "texts"}
    return names.get(hint) or (hint.__name__ if isinstance(hint, type) else "")


class _Parameters:
    """Of a function, looked up when it is first called."""

    def __init__(self, function: FunctionType) -> None:
        from . import shapes

        all_of = inspect.signature(function).parameters
        by_kind = {kind: [n for n, p in all_of.items() if p.kind is kind] for kind in inspect._ParameterKind}
        self.positional: List[str] = by_kind[inspect.Parameter.POSITIONAL_ONLY] + by_kind[inspect.Parameter.POSITIONAL_OR_KEYWORD]
        self.more: Optional[str] = next(iter(by_kind[inspect.Parameter.VAR_POSITIONAL]), None)
        self.named = set(by_kind[inspect.Parameter.POSITIONAL_OR_KEYWORD] + by_kind[inspect.Parameter.KEYWORD_ONLY])
        self.takes_any = bool(by_kind[inspect.Parameter.VAR_KEYWORD])
        self.needed = [n for n, p in all_of.items() if p.default is p.empty and p.kind not in (p.VAR_POSITIONAL, p.VAR_KEYWORD)]
        names = {"ArrayLike": _Numbers, "Region": shapes.Region}
        self.hints: Dict[str, Any] = {}
        for name, p in all_of.items():
            try:
                self.hints[name] = eval(p.annotation, function.__globals__, names) if isinstance(p.annotation, str) else p.annotation
            except NameError:  # of a package that is not there
                self.hints[name] = Any
            if p.annotation is p.empty:
                self.hints[name] = Any


def _guarded(function: FunctionType, of_class: bool) -> Callable[..., Any]:
    """A function of a module, or of a class whose objects are its first argument."""

    @functools.lru_cache(maxsize=None)
    def parameters() -> _Parameters:
        return _Parameters(function)

    def called(args: Tuple[Any, ...]) -> str:
        if not of_class:
            return function.__name__
        owner = args[0] if isinstance(args[0], type) else type(args[0])
        return owner.__name__ if function.__name__ == "__init__" else f"{owner.__name__}.{function.__name__}"

    checked: Tuple[str, ...] = getattr(function, "checks", ())

    def look(args: Tuple[Any, ...], given: Dict[str, Any]) -> None:
        known = parameters()
        by_position = list(zip(known.positional, args))
        if not known.takes_any:
            for word in given:
                if word not in known.named:
                    names = [n for n in [*known.positional, *sorted(known.named - set(known.positional))][of_class:]]
                    raise ArgumentError(f"{called(args)}: {word}: is no parameter{did_you_mean(word, names)}; it has {', '.join(names) or 'none'}")
        have = {*given, *(name for name, _ in by_position)}
        for name in known.needed:
            if name not in have:
                of_recipe = of_class and function.__name__ == "__init__"
                raise ArgumentError(f"{called(args)}.{name}: {not_given(type(args[0]), name) if of_recipe else 'not given'}")
        rest = [(known.more, value) for value in args[len(known.positional):]] if known.more else []
        for name, value in [*by_position[of_class:], *given.items(), *rest]:
            hint = known.hints.get(name, Any)
            quick = name in checked or hint is Any or type(value) is hint or hint is float and type(value) is int
            rule = "" if quick else _fault(value, hint)
            if rule:
                raise ArgumentError(f"{called(args)}.{name} = {shown(value)}: must be {rule}")

    @functools.wraps(function)
    def guarded(*args: Any, **given: Any) -> Any:
        look(args, given)
        try:
            return function(*args, **given)
        except TypeError as e:
            if isinstance(e, Error) or "incompatible function arguments" not in str(e):
                raise
            values = ", ".join(shown(value) for value in [*args[of_class:], *given.values()])
            raise ArgumentError(f"{called(args)}: cannot take these values: {values}") from None

    guarded.__guards__ = function  # type: ignore[attr-defined]
    return guarded


def guard(public: Iterable[Any]) -> None:
    """Guards functions, and methods of classes, wherever the package has them."""
    guarded: Dict[Any, Callable[..., Any]] = {}
    package = __name__.partition(".")[0]
    for x in public:
        if isinstance(x, FunctionType) and not hasattr(x, "__guards__"):
            guarded[x] = _guarded(x, False)
        for owner in x.__mro__ if isinstance(x, type) else ():
            if owner.__module__.partition(".")[0] == package and not issubclass(owner, Exception):
                _guard_methods(owner)
    for module in [m for name, m in list(sys.modules.items()) if name.partition(".")[0] == package]:
        for name, x in list(vars(module).items()):
            if isinstance(x, FunctionType) and x in guarded:
                setattr(module, name, guarded[x])


def _guard_methods(owner: type) -> None:
    for name, x in list(vars(owner).items()):
        function = x.__func__ if isinstance(x, classmethod) else x
        if isinstance(function, FunctionType) and not hasattr(function, "__guards__") and (name == "__init__" or name[0] != "_"):
            guarded = _guarded(function, True)
            setattr(owner, name, classmethod(guarded) if isinstance(x, classmethod) else guarded)
