"""Views of a scene's columns: NumPy operations on the memory of the points, which refuse once the points moved."""

from __future__ import annotations

import warnings
from typing import Any, Dict, List, Mapping, Sequence, Tuple, TypeVar

import numpy as np

from ._errors import Error, UnknownName, did_you_mean

Key = TypeVar("Key")
Entry = TypeVar("Entry")


class State:
    """Values of a scene's state by path, looked up once between two steps; without those whose path begins with one of `hidden`."""

    def __init__(self, core: Any, hidden: Sequence[str] = ()) -> None:
        self.core, self._hidden = core, tuple(hidden)
        self._at = (-1, -1)
        self._columns: Dict[str, Any] = {}
        self.written = False  #: since somebody asked

    def columns(self) -> Dict[str, Any]:
        now = (self.core.generation(), self.core.steps())
        if now != self._at:
            self._columns = {path: column for path, column in self.core.columns().items() if not path.startswith(self._hidden)}
            self._at = now
        return self._columns


class Named(Dict[Key, Entry]):
    """Entries by name; one that is not there is refused with the names that there are."""

    def __init__(self, of: str, entries: Mapping[Key, Entry]) -> None:
        super().__init__(entries)
        self._of = of

    def __missing__(self, key: Key) -> Entry:
        raise UnknownName(f"{self._of} = {key}: " + (f"must be one of {', '.join(map(str, self))}" if self else "there is none"))

    def __reduce__(self) -> Any:
        return Named, (self._of, dict(self))


class View(np.lib.mixins.NDArrayOperatorsMixin):
    """Numbers of the points of a body, [n] or [n, k], without a copy: `view[:, 0]`, `view.mean(axis=0)`,
    `view[mask] = 0`, `view *= 2`. Each use looks whether the points still lie where the view was taken; after a step
    that may have moved them it raises `Error`: take the view anew. `np.asarray(view)` is a copy, which stays."""

    __array_priority__ = 1000

    def __init__(self, state: State, paths: Sequence[str], single: bool, writable: bool = True) -> None:
        self._state, self._paths, self._single, self._writable = state, tuple(paths), single, writable
        self._generation = state.core.generation()

    def _now(self) -> List[Any]:
        if self._state.core.generation() != self._generation:
            raise Error(f"{self._paths[0]}: the scene has stepped since this view was taken, and its points may lie "
                        "elsewhere: take the view anew, or keep a copy (np.asarray)")
        columns = self._state.columns()
        return [columns[path] for path in self._paths]

    @property
    def shape(self) -> Tuple[int, ...]:
        n = len(self._now()[0])
        return (n,) if self._single else (n, len(self._paths))

    @property
    def ndim(self) -> int:
        return 1 if self._single else 2

    @property
    def dtype(self) -> Any:
        return self._now()[0].dtype

    def __len__(self) -> int:
        return len(self._now()[0])

    def _array(self) -> Any:
        """The memory itself, for the length of one operation; several columns are copied side by side."""
        columns = self._now()
        return columns[0] if self._single else np.stack(columns, axis=-1)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        if copy is False:
            raise ValueError("a view of a scene's points cannot become an array without a copy: it could dangle")
        return np.array(self._array(), dtype=dtype)

    def copy(self) -> Any:
        return np.array(self._array())

    def __reduce__(self) -> Any:  # another process gets a copy
        return np.array, (self.copy(),)

    def __array_ufunc__(self, ufunc: Any, method: Any, /, *inputs: Any, **kwargs: Any) -> Any:
        out = kwargs.pop("out", None)
        result = getattr(ufunc, method)(*(x._array() if isinstance(x, View) else x for x in inputs), **kwargs)
        if out is None:
            return result
        for target, values in zip(out, result if isinstance(result, tuple) else (result,)):
            target[...] = values
        return out[0] if len(out) == 1 else out

    def __getitem__(self, key: Any) -> Any:
        if not self._single and isinstance(key, tuple) and len(key) == 2 and isinstance(key[1], (int, np.integer)) \
                and isinstance(key[0], slice) and key[0] == slice(None):
            self._now()  # or refuses
            return self._one(int(key[1]))
        return np.array(self._array()[key])[()]

    def _one(self, column: int) -> "View":
        view = View(self._state, [self._paths[column]], True, self._writable)
        view._generation = self._generation
        return view

    def __setitem__(self, key: Any, values: Any) -> None:
        if not self._writable:
            raise Error(f"{self._paths[0]}: cannot be written: which cell holds a point, and its mass and volume, hang on it")
        if isinstance(values, View):
            values = values._array()
        columns = self._now()
        self._state.written = True
        if self._single:
            columns[0][key] = values
        else:
            both = np.stack(columns, axis=-1)
            both[key] = values
            for k, column in enumerate(columns):
                column[:] = both[:, k]
        self._put(columns)

    def _put(self, columns: List[Any]) -> None:
        """Takes what was written to the columns of `_now`, which are the memory itself."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(np.asarray(self), name)

    def __repr__(self) -> str:
        return f"View of {', '.join(self._paths)}:\n{self._array()!r}"


class Body:
    """A deformable body: columns of its points, in SI units. `position` [n, D], `velocity` [n, D], `mass` [n],
    `volume` [n], `stress` [n, 4 or 6] (xx, yy, zz, xy(, yz, zx)), tension positive; `history["name"]` [n]."""

    def __init__(self, state: State, number: int, name: str) -> None:
        self._state, self._number, self.name = state, number, name

    def _path(self, rest: str) -> str:
        return f"bodies/{self._number}/{rest}"

    def _view(self, column: str, writable: bool = True) -> View:
        path = self._path("points/" + column)
        known = self._state.columns()
        if path in known:
            return View(self._state, [path], True, writable)
        paths = [p for p in known if p.startswith(path + "/")]
        if not paths:
            begin = self._path("points/")
            names = list(dict.fromkeys(p[len(begin):].split("/")[0] for p in known if p.startswith(begin)))
            raise AttributeError(f"body {self.name!r} has no column {column!r}{did_you_mean(column, names)}; it has {', '.join(names)}")
        return View(self._state, paths, False, writable)

    @property
    def position(self) -> View:
        """[n, D], m; read-only."""
        return self._view("position", False)

    @property
    def velocity(self) -> View:
        """[n, D], m/s."""
        return self._view("velocity")

    @property
    def mass(self) -> View:
        """[n], kg; read-only."""
        return self._view("mass", False)

    @property
    def volume(self) -> View:
        """[n], m3; read-only."""
        return self._view("volume", False)

    @property
    def stress(self) -> View:
        """[n, 4 or 6], Pa, tension positive."""
        return self._view("stress")

    @property
    def history(self) -> Dict[str, View]:
        """Columns of the law's history by name, [n] each."""
        begin = self._path("points/history/")
        return Named("history", {p[len(begin):]: View(self._state, [p], True) for p in self._state.columns() if p.startswith(begin)})

    def column(self, name: str) -> View:
        """Any column of the points by its name, a path such as "velocity_gradient" (of APIC)."""
        if name == "motion":  # its name before 0.2
            warnings.warn('column("motion") is called column("velocity_gradient")', DeprecationWarning, stacklevel=3)
            name = "velocity_gradient"
        return self._view(name, name not in ("cell", "position", "mass", "volume"))

    def _number_at(self, rest: str) -> float:
        return float(self._state.columns()[self._path(rest)][0])

    @property
    def lost(self) -> int:
        """Points that have left the mesh."""
        return int(self._number_at("lost"))

    @property
    def lost_mass(self) -> float:
        """kg"""
        return self._number_at("lost_mass")

    def __len__(self) -> int:
        return len(self.mass)

    def __repr__(self) -> str:
        return f"Body({self.name!r}, {len(self)} points)"


class RigidState:
    """A rigid body of a scene after the last step: `velocity`, `displacement`, `force`, `impulse`, and of one that
    rotates `spin`, `torque`, `angular_impulse`; `contact_nodes`, `dissipated`, `driving_work`. SI units; copies."""

    def __init__(self, state: State, number: int, name: str) -> None:
        self._state, self._begin, self.name = state, f"rigids/{number}/", name

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        column = self._state.columns().get(self._begin + name)
        if column is None:
            raise AttributeError(f"rigid body {self.name!r} has no {name!r}{did_you_mean(name, self.names)}; it has {', '.join(self.names)}")
        return column.copy() if len(column) > 1 else column[0]

    @property
    def names(self) -> List[str]:
        return [p[len(self._begin):] for p in self._state.columns() if p.startswith(self._begin)]

    def __repr__(self) -> str:
        return f"RigidState({self.name!r}, displacement={self.displacement}, velocity={self.velocity}, force={self.force})"


__all__ = ["Body", "RigidState", "View"]
