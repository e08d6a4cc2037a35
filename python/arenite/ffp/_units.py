"""Drops that the package's program was built without: it holds the composition of the default drop, and one for the others is compiled
when they are first asked for."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Callable, List, Optional, Sequence

from .. import _compile, _core
from .._errors import Error
from .._plugins import WIDTHS

__all__ = ["program_with"]

PACKAGE = Path(__file__).resolve().parent.parent


def program_with(units: Sequence[str], check: Callable[[], None]) -> Optional[Path]:
    """The program with these units, "slice-law" of drop_slice.cpp; None if the package has nothing to make it of. `check` is called before it is
    compiled."""
    width = _width()
    objects = PACKAGE / "lib" / f"libffp_{width}.a"
    models = sorted({unit.partition("-")[0] for unit in units})
    share = PACKAGE / "share" / "arenite" / "ffp"
    sources = [share / "push" / "push_scene.cpp" if model == "push" else share / "drop" / f"drop_{model}.cpp" for model in models]
    if not all(path.is_file() for path in (objects, *sources)):
        return None

    def checked() -> Path:
        check()
        return objects

    named = ", ".join(units)
    text = f'#define ARENITE_FFP_UNITS "{named}"\n' + "".join(f'#include "{path}"\n' for path in sources)
    return _compile.program(text, f"arenite-ffp for drops of the kind {named}", WIDTHS[width]["flags"], checked, "half a minute each")


def _width() -> str:
    """Bytes of the registers of the program that the launcher starts."""
    wanted = os.environ.get("ARENITE_REGISTER_BYTES")
    if wanted is not None and wanted not in WIDTHS:
        raise Error(f"ARENITE_REGISTER_BYTES = {wanted}: must be one of {', '.join(WIDTHS)}")
    known: List[str] = [w for w in WIDTHS if _core.supports(WIDTHS[w]["needs"])]
    built = [w for w in known if (PACKAGE / "lib" / f"libffp_{w}.a").is_file()]
    return wanted or max(built or known, key=int)
