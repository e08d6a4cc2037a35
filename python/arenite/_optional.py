"""Packages that are asked for only where they are used."""

from __future__ import annotations

import importlib
from typing import Any

from ._errors import Error

__all__ = ["need"]


def need(module: str, what: str) -> Any:
    """The module; raises `Error` that names the cure if it is not installed."""
    try:
        return importlib.import_module(module)
    except ImportError:
        package = module.split(".")[0]
        raise Error(f"{what} needs {package}: pip install {package}") from None
