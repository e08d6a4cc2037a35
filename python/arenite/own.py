"""Laws of one's own, written in C++, and scenes in compositions of their own."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any, Callable, Union, overload

from . import _compile
from ._errors import Error
from .laws import OwnLaw
from .scene import Scene, compiled


@overload
def compile(law: Scene) -> Scene: ...


@overload
def compile(law: Union[str, "os.PathLike[str]"], name: str = "") -> Callable[..., OwnLaw]: ...


def compile(law: Union[str, "os.PathLike[str]", Scene], name: str = "") -> Union[Scene, Callable[..., OwnLaw]]:
    """A law out of a C++ header (as examples/own_law.hpp): `Viscous = ar.compile(law="viscous.hpp")`, then
    `Viscous(density=.., ..)` is a law like any other. Its parameters are those of its struct `Parameters`, or its own
    members if it is an aggregate. `name`: of its class, with namespaces, where the header holds several.

    Of a law nothing is compiled yet: this looks for the class in the header, and returns at once. The law is compiled when it is first used,
    with the scene that has it, or by its `update` or `drive`; what only the compiler sees, such as a parameter that the class lacks, is
    told then.

    Of a scene, `scene = ar.compile(scene)`: the same recipes, at their start, in a composition of their own (`scene.compiled_as`), compiled
    if it is not in the cache, from which later scenes of these recipes take it."""
    if isinstance(law, Scene):
        return compiled(law)
    path = Path(law).resolve()
    if not path.is_file():
        raise Error(f"compile: law = {law}: there is no such file")
    found = name.removeprefix("::") if name else _compile.law_name(path)
    _compile.check_law(path, found)
    if not re.fullmatch(r"[A-Za-z_][\w:<>, ]*", found):
        raise Error(f"compile: name = {name}: must be that of a class, with its namespaces")

    def make(**parameters: Any) -> OwnLaw:
        return OwnLaw(found, str(path), parameters)

    make.__name__ = make.__qualname__ = found.rpartition("::")[2]
    make.__doc__ = f"The law {found} of {path}."
    return make


__all__ = ["compile"]
