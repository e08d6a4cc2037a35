"""Shared objects with compositions: the prebuilt ones of the widest registers that the processor has, and those
compiled on first use."""

from __future__ import annotations

import json
import os
import threading
from pathlib import Path
from typing import Any, Callable, Dict, List, Literal, Optional, Sequence, Tuple

import numpy as np

from . import _compile, _core, _stand_ins
from ._errors import Error

PACKAGE = Path(__file__).parent
WIDTHS: Dict[str, Any] = json.loads((PACKAGE / "_widths.json").read_text())

_lock = threading.RLock()
_plugins: Dict[str, Any] = {}
_scenes: Dict[str, Any] = {}
_laws: Dict[str, Any] = {}
_tiles: Dict[str, Any] = {}
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
    for kind, names in ((_scenes, plugin.scenes()), (_laws, plugin.laws()), (_tiles, plugin.tiles())):
        for name in names:
            kind.setdefault(name, plugin)
    return plugin


def _ensure_prebuilt() -> None:
    path = prebuilt(width())
    if str(path) not in _plugins and path.exists():
        _open(path)


class _NotThere(Exception):
    pass


def _built(what: str, type_name: str, headers: Sequence[str], check: Callable[[], None] = lambda: None) -> Any:
    path = _compile.built(what, type_name, headers, WIDTHS[width()]["flags"], loaded=_plugins, check=check, host=_host(width()))
    return _plugins[str(path)] if str(path) in _plugins else _open(path)


def _at_hand(kind: Dict[str, Any], what: str, type_name: str) -> Optional[Any]:
    """The plugin of a composition that is prebuilt or in the cache."""
    _ensure_prebuilt()
    if type_name in kind:
        return kind[type_name]

    def stop() -> None:
        raise _NotThere

    try:
        return _built(what, type_name, [], stop)
    except (_NotThere, Error):  # an error: no compiler, whose name is part of what is looked for
        return None


def _prebuilt_names(kind: Dict[str, Any]) -> List[str]:
    return [name for name, plugin in kind.items() if plugin is _plugins.get(str(prebuilt(width())))]


Which = Literal["first", "own", "stand-in"]


def scene_plugin(type_name: str, headers: Sequence[str], check: Callable[[], None], values: List[Any], dimension: int,
                 which: Which = "first") -> Tuple[Any, Optional[_stand_ins.StandIn]]:
    """The plugin of a composition, and what stands for it there, if it is neither prebuilt nor in the cache. `check`: called before
    another one is taken or it is compiled; `values`: of its parts. `which`: the first of these that there is, its own alone, or what
    stands for it alone, else `Error`."""
    with _lock:
        if not headers:
            plugin = None if which == "stand-in" else _at_hand(_scenes, "scene", type_name)
            if plugin is not None:
                return plugin, None
            _ensure_prebuilt()
            found = None if which == "own" else _stand_ins.find(type_name, values, dimension, _prebuilt_names(_scenes))
            if found:
                check()
                return _scenes[found.type], found
        if which == "stand-in":
            raise Error(f"composition = {type_name}: no prebuilt one stands for it")
        return _built("scene", type_name, headers, check), None


def tiles_plugin(type_name: str, headers: Sequence[str], check: Callable[[], None]) -> Any:
    """The plugin of a composition that is cut into tiles, compiled if it is not in the cache."""
    with _lock:
        return _tiles[type_name] if type_name in _tiles and not headers else _built("tiles", type_name, headers, check)


def ranks(communicator: Any) -> Any:
    """The ranks of a communicator of mpi4py; None: this process alone."""
    if communicator is None:
        return _core.Ranks()
    try:
        from mpi4py import MPI
    except ImportError as e:
        raise Error(f"TiledScene.ranks = {communicator!r}: must be a communicator of mpi4py, which is not installed") from e
    if not isinstance(communicator, MPI.Comm):
        raise Error(f"TiledScene.ranks = {communicator!r}: must be a communicator of mpi4py")
    with _lock:
        path = str(_compile.ranks())
    ours, theirs = (v.strip("\0 \n") for v in (_core.Ranks.version(path), MPI.Get_library_version()))
    if ours != theirs:
        raise Error(f"TiledScene.ranks: mpi4py runs on {theirs}, mpicxx links {ours}: both must be the same; name the other one's in the "
                    "environment's MPICXX")
    return _core.Ranks(path, MPI._addressof(communicator))


class _NarrowLaw:
    """A law whose history has only the numbers of its own policies."""

    def __init__(self, native: Any, hidden: Sequence[str]) -> None:
        self._native = native
        names = native.history_names()
        self._kept = [k for k, name in enumerate(names) if name not in hidden]
        self._count = len(names)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._native, name)

    def history_names(self) -> List[str]:
        names = self._native.history_names()
        return [names[k] for k in self._kept]

    def history_start(self) -> List[float]:
        start = self._native.history_start()
        return [start[k] for k in self._kept]

    def _wide(self, history: Any) -> Any:
        if history is None:
            return None
        given = np.asarray(history, dtype=float)
        if given.shape[-1:] != (len(self._kept),):
            raise Error(f"history = {given.shape}: must have {len(self._kept)} columns, those of history_names")
        wide = np.broadcast_to(np.asarray(self._native.history_start()), given.shape[:-1] + (self._count,)).copy()
        wide[..., self._kept] = given
        return wide

    def update(self, stress: Any, strain: Any, spin: Any, dt: float, history: Any) -> Any:
        stress, history, *rest = self._native.update(stress, strain, spin, dt, self._wide(history))
        return (stress, history[:, self._kept], *rest)

    def drive(self, dimension: int, stages: Any, stress: Any, history: Sequence[float]) -> Any:
        path = self._native.drive(dimension, stages, stress, list(self._wide(history)) if len(history) else [])
        return {**path, "history": path["history"][:, self._kept]}

    def elastic_energy(self, stress: Any, history: Any) -> Any:
        if history is None and self._kept == []:
            history = np.zeros((len(np.asarray(stress)), 0))
        return self._native.elastic_energy(stress, self._wide(history))


def law(recipe: Any) -> Any:
    header, type_name = recipe.header(), recipe.cpp()
    with _lock:
        plugin = None if header else _at_hand(_laws, "law", type_name)
        native = (plugin or _built("law", type_name, [header] if header else [])).law(type_name, recipe.value())
    return _NarrowLaw(native, recipe.hidden_history()) if recipe.hidden_history() else native


def set_threads(n: int) -> None:
    """Steps may use n threads from here on. Not while a scene steps in another thread."""
    global _threads
    if n < 1:
        raise Error(f"set_threads: n = {n}: must be at least 1")
    with _lock:
        _threads = n
        for plugin in _plugins.values():
            plugin.set_threads(n)
