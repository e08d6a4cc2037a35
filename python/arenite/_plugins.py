"""Shared objects with compositions: the prebuilt ones of the widest registers that the processor has, and those
compiled on first use."""

from __future__ import annotations

import json
import os
import threading
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence

from . import _compile, _core
from ._errors import Error

PACKAGE = Path(__file__).parent
WIDTHS: Dict[str, Any] = json.loads((PACKAGE / "_widths.json").read_text())

_lock = threading.RLock()
_plugins: Dict[str, Any] = {}
_scenes: Dict[str, Any] = {}
_laws: Dict[str, Any] = {}
_threads: Optional[int] = None


def width() -> str:
    """Bytes of the registers that compositions are compiled for: the widest of the processor, or that of the
    environment's ARENITE_WIDTH (16, 32 or 64)."""
    wanted = os.environ.get("ARENITE_WIDTH")
    if wanted is not None:
        if wanted not in WIDTHS:
            raise Error(f"ARENITE_WIDTH = {wanted}: must be one of {', '.join(WIDTHS)}")
        return wanted
    known = [w for w in WIDTHS if _core.supports(WIDTHS[w]["needs"])]
    built = [w for w in known if prebuilt(w).exists()]
    return max(built or known, key=int)


def prebuilt(of_width: str) -> Path:
    return PACKAGE / "lib" / f"compositions_{of_width}.so"


def _host(of_width: str) -> Path:
    """What compositions compiled on first use are linked with."""
    return PACKAGE / "lib" / f"libhost_{of_width}.a"


def _open(path: Path) -> Any:
    plugin = _core.Plugin(str(path))
    if _threads is not None:
        plugin.set_threads(_threads)
    _plugins[str(path)] = plugin
    for kind, names in ((_scenes, plugin.scenes()), (_laws, plugin.laws())):
        for name in names:
            kind.setdefault(name, plugin)
    return plugin


def _ensure_prebuilt() -> None:
    path = prebuilt(width())
    if str(path) not in _plugins and path.exists():
        _open(path)


def _find(kind: Dict[str, Any], what: str, type_name: str, headers: Sequence[str],
          check: Callable[[], None] = lambda: None) -> Any:
    with _lock:
        _ensure_prebuilt()
        if headers or type_name not in kind:
            path = _compile.built(what, type_name, headers, WIDTHS[width()]["flags"], loaded=_plugins, check=check,
                                   host=_host(width()))
            if str(path) not in _plugins:
                _open(path)
            return _plugins[str(path)]
        return kind[type_name]


def scene_plugin(type_name: str, headers: Sequence[str], check: Callable[[], None]) -> Any:
    return _find(_scenes, "scene", type_name, headers, check)


def law(recipe: Any) -> Any:
    header = recipe.header()
    type_name = recipe.cpp()
    return _find(_laws, "law", type_name, [header] if header else []).law(type_name, recipe.value())


def recipes() -> List[Any]:
    """Plugins that tell the parameters of recipes, for tests."""
    with _lock:
        _ensure_prebuilt()
        return [p for p in _plugins.values() if p.recipes()]


def set_threads(n: int) -> None:
    """Threads that steps may use from here on."""
    global _threads
    if n < 1:
        raise Error(f"set_threads: n = {n}: must be at least 1")
    with _lock:
        _threads = n
        for plugin in _plugins.values():
            plugin.set_threads(n)
