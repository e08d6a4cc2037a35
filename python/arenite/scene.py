"""Scene: bodies, mesh, numerics and parts, made of recipes and stepped by compiled code."""

from __future__ import annotations

import enum
import os
import tempfile
from typing import Any, Callable, ContextManager, Dict, Iterable, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core, _plugins
from ._errors import ArgumentError, Error, bodies_named, checks
from ._html import members, table
from ._pickle import refuse_unpicklable
from ._recipe import Recipe, check_together, function_value
from .boundary import PointLoad, Surface, Wall
from .fill import Fill
from .laws import Law
from .meshes import Mesh
from .numerics import Numerics
from .rigid import MovingMesh, Rigid, RigidContact
from .views import Body, Named, RigidState, State
from .watch import Progress, Watch, Watched

DAMP = ": name a part that damps: LocalDamping or ViscousDamping"


class Stop(enum.Enum):
    """Its one value is what a function of `run` returns to end the run there."""

    STOP = "ar.STOP"

    def __repr__(self) -> str:
        return str(self.value)

    __str__ = __repr__


STOP = Stop.STOP


class Restored(NamedTuple):
    """The state that a scene goes on from, and the files of the series of `Vtu` that do since."""

    steps: int
    time: float  # s
    series: Set[str]


class Energies(NamedTuple):
    """J. residual = kinetic + strain + stored + plastic + contact + transfer + walls - (initial + external +
    inserted): errors alone. transfer: taken by the transfer between points and nodes; walls: taken by walls."""

    kinetic: float
    strain: float
    stored: float
    plastic: float
    contact: float
    external: float
    inserted: float
    transfer: float
    walls: float
    residual: float

    def _repr_html_(self) -> str:
        return members(self, self._fields, "J")


class Nodes(NamedTuple):
    """Nodes of the mesh: position [n, D], m; mass [n], kg, and velocity [n, D], m/s, of the last step."""

    position: NDArray[np.float64]
    mass: NDArray[np.float64]
    velocity: NDArray[np.float64]


class Reaction(NamedTuple):
    """Of a wall on the matter: force [D], N, mean of the last step; impulse [D], N s, since the start."""

    force: List[float]
    impulse: List[float]

    def _repr_html_(self) -> str:
        return members(self, self._fields)


def _check_number(name: str, number: Union[str, int], names: Sequence[Optional[str]], of: str) -> None:
    count = len(names)
    if isinstance(number, str):
        if number not in names:
            raise Error(f"{name} = {number}: the scene has no such {name.split('.')[1]}; it has {', '.join(n for n in names if n)}")
    elif not 0 <= number < count:
        raise Error(f"{name} = {number}: the scene has {count} {of}, numbered from 0")


def _numbered(value: Any, names: List[str]) -> Any:
    """The value of a part with the number of the body that it names: the compiled scene has no names."""
    if not isinstance(value, dict):
        return value
    changed = {key: _numbered(value[key], names) for key in ("where",) if key in value}
    if value.get("body") in names:
        changed["body"] = names.index(value["body"])
    return {**value, **changed}


class Scene:
    """A scene, complete when constructed. Raises `Error` where a recipe does not fit.

    kinematics: PlaneStrain(), Axisymmetric() or ThreeDimensional(); mesh; numerics: `Numerics(..)`; bodies: `fill(..)` each; walls; gravity, m/s2: a
    vector or a function of time; rigids: `Rigid(..)` each; rigid_contact between them; contact: `Coulomb(..)` between
    deformable bodies (none: they stick); moving_mesh; parts: loads, damping, driven walls and parts of one's own;
    energy: whether the energy balance is kept; reactions: whether walls' reactions are summed.

    Bodies of one law, two or more, are one composition in any number.

    A composition that is neither prebuilt nor in the cache runs in a prebuilt one that stands for it (`compiled_as`), with the same
    bits; if there is none, it is compiled, which takes some ten seconds, and cached. `ar.compile(scene)` compiles it in any case."""

    def __init__(self, kinematics: Recipe, mesh: Mesh, numerics: Numerics, *, bodies: Sequence[Fill],
                 walls: Sequence[Wall] = (), gravity: Any = None, rigids: Sequence[Rigid] = (),
                 rigid_contact: Optional[RigidContact] = None, contact: Optional[Recipe] = None,
                 moving_mesh: Optional[MovingMesh] = None, parts: Sequence[Recipe] = (), energy: bool = True,
                 reactions: bool = False) -> None:
        self._recipes = dict(kinematics=kinematics, mesh=mesh, numerics=numerics, bodies=list(bodies),
                             walls=list(walls), gravity=gravity, rigids=list(rigids), rigid_contact=rigid_contact,
                             contact=contact, moving_mesh=moving_mesh, parts=list(parts), energy=energy,
                             reactions=reactions)
        self._take(self._make())

    def _check_together(self) -> None:
        """Refuses what does not go together, before it is compiled."""
        r = self._recipes
        mesh, numerics = r["mesh"].cpp().split("<")[0], r["numerics"].kinds()
        check_together(type(r["kinematics"]).__name__, str(r["mesh"].dimension))
        check_together(numerics[0], mesh)
        rigids, bodies = [b.name for b in r["rigids"]], [b.name for b in r["bodies"]]
        if r["moving_mesh"] is not None:
            check_together("MovingMesh", mesh)
            _check_number("MovingMesh.leader", r["moving_mesh"].leader, rigids, "rigid bodies")
        if r["rigid_contact"] is not None:
            for pair in r["rigid_contact"].pairs:
                _check_number("RigidPair.first", pair.first, rigids, "rigid bodies")
                _check_number("RigidPair.second", pair.second, rigids, "rigid bodies")
        for part in r["parts"]:
            for on_body in (part, getattr(part, "where", None)):
                if isinstance(on_body, (PointLoad, Surface)):
                    _check_number(f"{type(on_body).__name__}.body", on_body.body, bodies, "bodies")
        for rigid in r["rigids"]:
            surface, _, contact = rigid.kinds()
            check_together(surface, mesh)
            check_together(contact, *numerics[:3])
            if r["rigid_contact"] is not None:
                check_together("RigidContact", surface)
                check_together("RigidContact", contact)

    def _composition(self) -> Tuple[str, Dict[str, Any], List[str], List[str]]:
        """The C++ type, the values of its recipes, headers of one's own, and the types of its parts."""
        r = self._recipes
        types: List[str] = []
        values: List[Any] = []
        self._check_together()
        if not r["bodies"]:
            raise Error("Scene: bodies(..) needs at least one fill(..)")
        names = [b.name for b in r["bodies"]]
        if len(set(names)) < len(names):
            raise Error(f"Scene.bodies = {names}: each body must have a name of its own")
        for k, b in enumerate(r["bodies"]):
            self._check_history(k, b.history)
        fills = [b.cpp() for b in r["bodies"]]
        listed = len(fills) > 1 and len(set(fills)) == 1  # of one law: one composition for any number of them
        types.append(f"BodyList<{fills[0]}>" if listed else f"Bodies<{', '.join(fills)}>")
        values.append([b.value() for b in r["bodies"]])
        if r["walls"]:
            types.append("Walls")
            values.append({"list": [w.value() for w in r["walls"]]})
        if r["gravity"] is not None:
            given = function_value(r["gravity"])
            uniform = isinstance(given, (list, np.ndarray))
            types.append("Gravity" if uniform else "GravityInTime")
            values.append({"g": given})
        for part in [r["contact"], *r["rigids"], r["rigid_contact"], *r["parts"], r["moving_mesh"]]:
            if part is not None:
                types.append(part.cpp())
                values.append(_numbered(part.value(), names))
        if r["reactions"]:
            types.append("Reactions")
            values.append({})
        if r["energy"]:
            types.append("TrackEnergy")
            values.append({})
        head = [r["kinematics"].cpp(), r["mesh"].cpp(), r["numerics"].cpp()]
        own = [x.header() for x in [*(b.law for b in r["bodies"]), *r["parts"]] if hasattr(x, "header")]
        return (f"Scene<{', '.join(head + types)}>",
                {"kinematics": r["kinematics"].value(), "mesh": r["mesh"].value(), "numerics": r["numerics"].value(),
                 "parts": values}, sorted({h for h in own if h}), types)

    def _make(self, which: _plugins.Which = "first") -> Any:
        self._type, values, headers, types = self._composition()

        plugin, self._stand_in = _plugins.scene_plugin(self._type, headers, lambda: self._check(values, types), values["parts"],
                                                       self._recipes["mesh"].dimension, which)
        with self._named():
            if self._stand_in is None:
                return plugin.scene(self._type, values)
            core = plugin.scene(self._stand_in.type, {**values, "parts": self._stand_in.parts})
        if "LocalDamping" in self._stand_in.neutral:
            core.switch_off_damping()
        return core

    def _check(self, values: Dict[str, Any], types: List[str]) -> None:
        _core.check_scene(self._recipes["mesh"].in_double(), values["mesh"], types, values["parts"])

    def _refuse_neutral(self, part: str, said: str) -> None:
        """Refuses what only a scene with a part can do, where the scene that it runs in alone has it."""
        if self._stand_in is not None and part in self._stand_in.neutral:
            raise Error(said)

    def _named(self) -> ContextManager[None]:
        """Within it messages of the compiled scene name its bodies."""
        return bodies_named([b.name for b in self._recipes["bodies"]], [b.name for b in self._recipes["rigids"]])

    def _take(self, core: Any) -> None:
        self._core = core
        self._restored: Optional[Restored] = None
        self._state = State(core, [*(self._stand_in.hidden if self._stand_in else ()), *self._hidden_history()])
        #: deformable bodies by name; rigid bodies by name, or number where one has no name
        self.bodies, self.rigids = self._views(self._state)

    def _hidden_history(self) -> List[str]:
        """Paths of the numbers of a history that are those of another policy."""
        return [f"bodies/{k}/points/history/{name}" for k, b in enumerate(self._recipes["bodies"]) for name in b.law.hidden_history()]

    def _views(self, state: State) -> Tuple[Dict[str, Body], Dict[Union[str, int], RigidState]]:
        """The bodies whose columns a state has."""
        return (Named("bodies", {b.name: Body(state, k, b.name) for k, b in enumerate(self._recipes["bodies"])}),
                Named("rigids", {(b.name or k): RigidState(state, k, b.name or str(k)) for k, b in enumerate(self._recipes["rigids"])}))

    # --- time

    @property
    def time(self) -> float:
        """s"""
        return float(self._core.time())

    @property
    def time_step(self) -> float:
        """Of the last step, s."""
        return float(self._core.time_step())

    @property
    def step_count(self) -> int:
        return int(self._core.steps())

    @property
    def stable_step(self) -> float:
        """Largest step that is stable now, s."""
        return float(self._core.stable_step())

    def step(self, dt: float) -> None:
        """One step of dt, s."""
        with self._named():
            self._core.step(dt)

    @checks("courant", "end", "max_step", "watch")
    def steps(self, courant: float = 0.5, end: float = float("inf"), max_step: float = float("inf"), *,
              watch: Union[bool, Watch] = True) -> Iterator[float]:
        """The steps of `run` until `end`, s, one by one; yields the duration of each, s: between two of them forces, motions and
        fields may be changed. `courant`, `max_step` and `watch` as in `run`; of numbers that you write the watch knows no energy, and begins anew."""
        numbers = number("steps.end", end, "s"), number("steps.courant", courant), number("steps.max_step", max_step, "s")
        take = self._core.steps(*numbers, watch.value() if isinstance(watch, Watch) else bool(watch))
        self._state.written = False
        while True:
            with self._named():
                dt = take(self._state.written)
            if not dt:
                return
            self._state.written = False
            yield float(dt)

    def switch_off_damping(self) -> None:
        """Ends damping by all parts that damp."""
        self._core.switch_off_damping()

    # --- what is there

    @property
    def out_of_balance(self) -> float:
        """Forces out of balance over the forces that are there, -, in the last step of a scene in which a part damps."""
        self._refuse_neutral("LocalDamping", "out_of_balance" + DAMP)
        return float(self._core.out_of_balance())

    @property
    def energy(self) -> Energies:
        """The energy balance, J."""
        return Energies(*self._core.energies())

    @property
    def watched(self) -> Dict[str, Watched]:
        """What the `Watch` given to the last run saw, by quantity; empty if it was given none."""
        return Named("watched", {name: Watched(*seen) for name, *seen in self._core.watched()})

    def nodes(self, body: Union[int, str] = 0) -> Nodes:
        """Nodes with the velocity field of a body."""
        return Nodes(*self._core.nodes(self.number_of(body)))

    def number_of(self, body: Union[int, str]) -> int:
        """Of a deformable body, by its name."""
        names = list(self.bodies)
        if body not in (names if isinstance(body, str) else range(len(names))):
            raise Error(f"body = {body}: must be one of {', '.join(names)}")
        return names.index(body) if isinstance(body, str) else body

    def reaction(self, wall: str) -> Reaction:
        """Of a wall, by its name or face; the scene must have been made with `reactions=True`."""
        self._refuse_neutral("Reactions", "reaction: name Reactions{} among the scene's parts")
        return Reaction(*self._core.reaction(wall))

    @property
    def cells(self) -> Optional[NDArray[np.uint64]]:
        """Nodes of each cell [m, D + 1] of a simplex mesh; None of a grid."""
        cells: Optional[NDArray[np.uint64]] = self._core.cells()
        return cells

    @property
    def state(self) -> Mapping[str, Any]:
        """Every value that a step reads, by path; copies."""
        return Named("state", {path: np.array(column) for path, column in self._state.columns().items()})

    def law(self, body: Union[int, str] = 0) -> Law:
        """The recipe of a body's law."""
        law: Law = self._recipes["bodies"][self.number_of(body)].law
        return law

    @property
    def composition(self) -> str:
        """The C++ type that its recipes name."""
        return self._type

    @property
    def compiled_as(self) -> str:
        """The C++ type that it runs in: `composition`, or a prebuilt one that stands for it."""
        return self._stand_in.type if self._stand_in else self._type

    @property
    def rank(self) -> int:
        """Of this process among those that have a part of the scene (`TiledScene`)."""
        return 0

    def _pieces(self) -> Sequence[str]:
        """What the files of each rank are called beside those of others."""
        return [""]

    def _meet(self, asks: str, **given: Any) -> None:
        """Waits for all ranks, which must ask for the same."""

    def _refuse_ranks(self, what: str, cure: str) -> None:
        """Refuses what looks at all points, where other processes have some of them."""

    def _parts_of(self, body: str) -> Sequence[Body]:
        """The points of a body, by the meshes whose cells they name."""
        return [self.bodies[body]]

    def _test(self, body: str, of: Callable[[Any], Any]) -> Any:
        """A test of all positions of a body, for its points here."""
        return of(np.asarray(self.bodies[body].position))

    def _bare(self) -> "Scene":
        """One of the same recipes that is not made yet."""
        other = object.__new__(type(self))
        other._recipes = self._recipes
        return other

    def _remove_saved(self, path: str) -> None:
        """Removes a saved state that is no file."""

    def _fill_value(self, number: int, fill: Fill) -> Any:
        """The values of a fill of a body."""
        self._check_history(number, fill.history)
        return fill.value()

    def _check_history(self, number: int, names: Iterable[str]) -> None:
        """Refuses numbers of a history that are those of another policy."""
        for name in names:
            if name in self._recipes["bodies"][number].law.hidden_history():
                raise Error(f"history = {name}: is no number of the law's history")

    def __repr__(self) -> str:
        points = sum(len(b) for b in self.bodies.values())
        return f"<{self.composition}: {points} points, t = {self.time:g} s after {self.step_count} steps>"

    def _repr_html_(self) -> str:
        rows = [(b.name, type(b.law).__name__, len(self.bodies[b.name])) for b in self._recipes["bodies"]]
        rigids = [(b.name or k, "rigid: " + type(b.motion).__name__, None) for k, b in enumerate(self._recipes["rigids"])]
        return table(f"Scene at t = {self.time:g} s after {self.step_count} steps", ("body", "law or motion", "points"), [*rows, *rigids],
                     self.composition)

    # --- saved states

    def save(self, path: Union[str, "os.PathLike[str]"], recipe: str = "") -> None:
        """Saves the state in a file `path`; `restore` of a scene of the same recipes goes on with the same bits. `recipe`: a line on what made the
        scene, which `restore` must be given, too."""
        self._core.save(os.fspath(path), recipe)

    def restore(self, path: Union[str, "os.PathLike[str]"], recipe: str = "") -> None:
        """Takes a state saved as `path` with the same line `recipe`. The next `run` goes on with it: `every` calls nothing at its start, which was called before the state
        was saved, and `Vtu` goes on with its series."""
        with self._named():
            self._restore(os.fspath(path), recipe)
        self._restored = Restored(self.step_count, self.time, set())

    def _restore(self, path: str, recipe: str) -> None:
        try:
            self._core.restore(path, recipe)
        except Error as e:
            if self._stand_in is not None:
                raise Error(f"{e}\n  (the scene runs in {self.compiled_as}, which stands for its own composition; ar.compile(scene) "
                            "compiles that)") from e
            try:  # saved where another composition stood for this one
                other = self._bare()
                core = other._make("stand-in")
                core.restore(path, recipe)
            except Error:
                raise e from None
            self._stand_in = other._stand_in
            self._take(core)

    def copy(self) -> "Scene":
        """Another scene in the same state."""
        other = self._bare()
        other._type, other._stand_in = self._type, self._stand_in
        other._take(self._core.copy())
        return other

    def __copy__(self) -> "Scene":
        return self.copy()

    def __deepcopy__(self, memo: Any) -> "Scene":
        return self.copy()

    def __getstate__(self) -> Any:
        refuse_unpicklable(self._recipes, "Scene")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "state")
            self.save(path)
            with open(path, "rb") as file:
                return self._recipes, file.read()

    def __setstate__(self, saved: Any) -> None:
        self._recipes, state = saved
        self._take(self._make())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "state")
            with open(path, "wb") as file:
                file.write(state)
            self._restore(path, "")


def compiled(scene: Scene) -> Scene:
    """A scene of the same recipes, at their start, in its own composition, which is compiled if it is not there."""
    own = scene._bare()
    own._take(own._make("own"))
    return own


Observer = Callable[[Scene], Any]
#: Functions by their period, s: an observer or several each (Any: checkers infer no union of functions); or pairs of a period and a function.
Every = Union[Mapping[float, Any], Iterable[Tuple[float, Any]]]


def number(name: str, value: Any, unit: str = "") -> float:
    """What is given as a number."""
    try:
        if isinstance(value, (bool, np.bool_, str, bytes)):
            raise TypeError
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise ArgumentError(f"{name} = {value!r}: must be a number{', ' * bool(unit)}{unit}") from None


def observers_of(name: str, every: Optional[Every]) -> List[Tuple[float, Observer]]:
    """Each function with its period, s, in the order in which they are called."""
    found: List[Tuple[float, Observer]] = []
    try:
        pairs = [(period, called) for period, called in (every.items() if isinstance(every, Mapping) else every or ())]
    except (TypeError, ValueError):
        raise Error(f"{name} = {every!r}: must be functions of the scene by their period, {{0.1: f}}, or pairs, [(0.1, f), (0.1, g)]") from None
    for given, called in pairs:
        period = number(f"{name}: period", given, "s")
        if not period > 0:
            raise Error(f"{name}: period = {period:g}: must be positive, s")
        for one in called if isinstance(called, (list, tuple)) else [called]:
            found.append((period, check_observer(f"{name}[{period:g}]", one)))
    return found


def check_observer(name: str, observer: Any) -> Observer:
    if not callable(observer):
        raise Error(f"{name} = {observer!r}: must be a function of the scene")
    checked: Observer = observer
    return checked


def _stops(name: str, told: Any) -> bool:
    """Whether what an observer returned ends the run."""
    if isinstance(told, (bool, np.bool_)) and told:
        raise Error(f"{name}: a function returned True: return ar.STOP to end the run, or nothing")
    return told is STOP


@checks("end", "courant", "max_step", "every", "after_step", "watch", "progress")
def run(scene: Scene, end: float, courant: float = 0.5, max_step: float = float("inf"),
        every: Optional[Every] = None, after_step: Optional[Observer] = None, *,
        watch: Union[bool, Watch] = True, progress: Union[bool, Progress] = False) -> None:
    """Steps a scene to `end`, s. `every`: functions of the scene by their period, s, called at the start and at the
    first step at or after each multiple, which shortens no step: {0.1: f}, {0.1: [f, g]} or [(0.1, f), (0.1, g)], in this order;
    `after_step` after each step. One that returns `STOP` ends the run; True is refused, whatever else one returns is ignored. The
    last two steps are shortened to hit `end`: a run that goes on from there has not the bits of one to a later `end`; to have them, save the
    scene by a function of `every`, or end the run by `STOP`. Raises `RunError` if the run fails physically, or goes past a limit of the
    `watch` (False: nobody watches); Ctrl-C stops it after the step.

    courant   Courant number, -: share of the greatest stable step that is taken
    max_step  longest step, s
    progress  whether to show how far the run is, or a `Progress`"""
    shown = Progress() if progress is True else progress or None
    _run("run", scene, end, courant, max_step, None, every, after_step, watch, shown)


@checks("end", "ratio", "courant", "every", "after_step", "watch")
def settle(scene: Scene, end: float, ratio: float = 1e-3, courant: float = 0.5,
           every: Optional[Every] = None, after_step: Optional[Observer] = None, *,
           watch: Union[bool, Watch] = True) -> bool:
    """Steps a scene in which a part damps (`LocalDamping`) until its forces are in balance to `ratio`, -, for ten
    steps. `courant`, `every`, `after_step` and `watch` are those of `run`. Returns whether it has settled: False if a function ended
    it before by `STOP`. Raises `RunError` if `end`, s, comes first. Go on with `run` after `scene.switch_off_damping()`."""
    return _run("settle", scene, end, courant, float("inf"), number("settle.ratio", ratio), every, after_step, watch)


def _run(name: str, scene: Scene, end: float, courant: float, max_step: float, ratio: Optional[float],
         every: Optional[Every], after_step: Optional[Observer], watch: Union[bool, Watch],
         progress: Optional[Progress] = None) -> bool:
    if ratio is not None:
        scene._refuse_neutral("LocalDamping", "settle" + DAMP)
    numbers = number(f"{name}.end", end, "s"), number(f"{name}.courant", courant), number(f"{name}.max_step", max_step, "s")
    observers = observers_of(f"{name}.every", every)
    after = None if after_step is None else check_observer(f"{name}.after_step", after_step)
    if not isinstance(watch, (bool, np.bool_, Watch)):
        raise Error(f"{name}.watch = {watch!r}: must be True, False or a Watch")
    if progress and not isinstance(progress, Progress):
        raise Error(f"{name}.progress = {progress!r}: must be True, False or a Progress")
    if scene.rank != 0:
        progress = None
    if progress:
        progress.start(scene.time, numbers[0])
    resumed = scene._restored is not None and scene._restored.steps == scene.step_count
    with scene._named():
        came_to_end: bool = scene._core.run(*numbers, ratio, resumed, [period for period, _ in observers],
                                            lambda k: _stops(f"{name}.every[{observers[k][0]:g}]", observers[k][1](scene)),
                                            None if after is None else lambda: _stops(f"{name}.after_step", after(scene)),
                                            watch.value() if isinstance(watch, Watch) else bool(watch), progress and (lambda: progress(scene)))
    if progress:
        progress(scene, done=True)
    return came_to_end


__all__ = ["Energies", "Nodes", "Reaction", "STOP", "Scene", "run", "settle"]
