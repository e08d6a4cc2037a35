"""Keywords as values for the program. Which options there are, and what they may be, only the program knows."""

from __future__ import annotations

import os
from typing import Dict, Iterable, Mapping, Union

import numpy

from .._errors import Error

__all__ = ["text_of", "values_of"]


def values_of(command: str, options: Mapping[str, object]) -> Dict[str, Union[bool, str]]:
    """Options given as keywords as the program takes them: True, False, or a text; those that are None are left out."""
    for keyword in options:
        if keyword in ("help", "version"):
            raise Error(f"--{keyword}: is no option of a run; arenite.ffp.help({command!r}) lists them")
    return {keyword: bool(value) if isinstance(value, (bool, numpy.bool_)) else text_of(value)
            for keyword, value in options.items() if value is not None}


def text_of(value: object) -> str:
    """A value as the program takes it: numbers with all of their digits, a mapping as "a=1,b=2", other iterables as "1,2",
    with quotes around a text that has a comma."""
    if isinstance(value, (numpy.generic, numpy.ndarray)) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (str, os.PathLike)):
        return str(os.fspath(value))
    if isinstance(value, float):
        return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
    if isinstance(value, Mapping):
        return ",".join(f"{key}={text_of(one)}" for key, one in value.items())
    if isinstance(value, Iterable):
        return ",".join(f'"{text}"' if "," in text else text for text in map(text_of, value))
    return str(value)
