"""What pickle cannot take, named."""

from __future__ import annotations

import dataclasses
import pickle
import sys
from typing import Any, Iterator, Tuple

from ._errors import Error


def parts(value: Any, name: str) -> Iterator[Tuple[Any, str]]:
    """What a value consists of, with names."""
    if isinstance(value, dict):
        yield from ((v, f"{name}.{key}") for key, v in value.items())
    elif isinstance(value, (list, tuple)):
        yield from ((v, f"{name}[{k}]") for k, v in enumerate(value))
    elif dataclasses.is_dataclass(value) and not isinstance(value, type):
        yield from ((getattr(value, f.name), f"{name}.{f.name}") for f in dataclasses.fields(value))
    elif not callable(value):
        yield from ((v, f"{name}.{key}") for key, v in getattr(value, "__dict__", {}).items())


def _takes_any_function() -> bool:
    """Whether a pickler is at work that stores functions by their code."""
    frame = sys._getframe()
    while frame is not None:
        if frame.f_globals.get("__name__", "").split(".")[-1] in ("cloudpickle", "cloudpickle_fast", "_dill"):
            return True
        frame = frame.f_back  # type: ignore[assignment]
    return False


def refuse_unpicklable(value: Any, name: str) -> None:
    """Raises `Error` that names the innermost value that pickle cannot take."""
    try:
        pickle.dumps(value)
        return
    except (pickle.PicklingError, AttributeError, TypeError) as e:
        if _takes_any_function():
            return
        for part, of in parts(value, name):
            refuse_unpicklable(part, of)
        cure = ("a function must be one of a module, made by `def` at its top level: pickle stores its name alone"
                if callable(value) else str(e))
        raise Error(f"{name} = {value!r}: cannot be pickled: {cure}") from e
