"""Keywords as words of the command line. Which options there are, and what they may be, only the program knows."""

from __future__ import annotations

import functools
import os
import re
from typing import Dict, Iterable, List, Mapping

import numpy

from .._errors import Error
from . import _driver

__all__ = ["option_of", "text_of", "words_of"]


def option_of(keyword: str) -> str:
    """Option that a keyword stands for: "cell_at_cone" is "--cell-at-cone"."""
    return "--" + keyword.replace("_", "-")


def words_of(command: str, options: Mapping[str, object]) -> List[str]:
    """Words of the command line for options given as keywords; those that are None are left out. Flags take True or False, as
    do options of the words on and off."""
    words = []
    for keyword, value in options.items():
        option = option_of(keyword)
        if option in ("--help", "--version"):
            raise Error(f"{option}: is no option of a run; arenite.ffp.help({command!r}) lists them")
        if value is None:
            continue
        if isinstance(value, (bool, numpy.bool_)):
            values = _values(os.fspath(_driver.program()), command).get(option)
            if values == "":
                words += [option] if value else []
                continue
            if values == "on|off":
                value = "on" if value else "off"
        words.append(f"{option}={text_of(value)}")
    return words


def text_of(value: object) -> str:
    """A value as the command line takes it: numbers with all of their digits, a mapping as "a=1,b=2", other iterables as "1,2"."""
    if isinstance(value, (numpy.generic, numpy.ndarray)) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (str, os.PathLike)):
        return str(os.fspath(value))
    if isinstance(value, float):
        return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
    if isinstance(value, Mapping):
        return ",".join(f"{key}={text_of(one)}" for key, one in value.items())
    if isinstance(value, Iterable):
        return ",".join(text_of(one) for one in value)
    return str(value)


@functools.cache
def _values(program: str, command: str) -> Dict[str, str]:
    """What each option of a command takes, as its help words it: "" for a flag, "on|off", "DEG" and so on."""
    lines = _driver.run([command, "--help"]).said
    found = (re.match(r"  (--[a-z0-9-]+)(?: (\S+))?(?:  |$)", line) for line in lines)
    return {match[1]: match[2] or "" for match in found if match}
