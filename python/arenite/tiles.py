"""A scene cut into tiles: boxes of cells of a grid or sets of cells of a simplex mesh, stepped by a thread each, on one machine or, with
mpi4py, on the ranks of many."""

from __future__ import annotations

import math
import operator
import os
import shutil
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core, _plugins, _ranks
from ._errors import Error
from ._recipe import Recipe
from .meshes import Mesh
from .numerics import Numerics
from .scene import Scene
from .views import Named, Body, State, View
from .watch import Watch


class _StateOfTiles(State):
    """Of all tiles here, by "tiles/NUMBER/" and the path in each."""

    def __init__(self, core: Any, hidden: Sequence[str]) -> None:
        super().__init__(core)
        self._hidden_here = tuple(hidden)

    def columns(self) -> Dict[str, Any]:
        if (self.core.generation(), self.core.steps()) != self._at:
            self._columns = {path: column for path, column in super().columns().items()
                             if not path.split("/", 2)[2].startswith(self._hidden_here)}
        return self._columns


class _StateOfTile(State):
    def __init__(self, whole: State, number: int) -> None:
        super().__init__(whole.core)
        self._whole, self._begin = whole, f"tiles/{number}/"

    def columns(self) -> Dict[str, Any]:
        return {path[len(self._begin):]: column for path, column in self._whole.columns().items() if path.startswith(self._begin)}


class Tile:
    """A tile of this rank as it is now: `number` of the whole; `bodies`, views of its points, and `rigids` as of a `Scene`."""

    def __init__(self, scene: "TiledScene", number: int) -> None:
        state = _StateOfTile(scene._state, number)
        self.number = number
        self.bodies, self.rigids = scene._views(state)

    def __repr__(self) -> str:
        return f"<tile {self.number}: {sum(len(b) for b in self.bodies.values())} points>"


class _ViewHere(View):
    """A view of the points of several tiles, tile by tile."""

    def __init__(self, views: Sequence[View]) -> None:
        first = views[0]
        super().__init__(first._state, first._paths, first._single, first._writable)
        self._views, self._generation = views, first._generation

    def _now(self) -> List[Any]:
        return [np.concatenate(column) for column in zip(*(view._now() for view in self._views))]

    def _one(self, column: int) -> View:
        return _ViewHere([view._one(column) for view in self._views])

    def _put(self, columns: List[Any]) -> None:
        begin = 0
        for view in self._views:
            for own, column in zip(view._now(), columns):
                own[:] = column[begin:begin + len(own)]
            begin += len(view)


class BodyHere(Body):
    """A body in the tiles of this rank: its points tile by tile, as views like those of a `Body`. `column("id")`: a point's own in all
    tiles of all ranks."""

    def __init__(self, scene: "TiledScene", name: str) -> None:
        self._scene, self.name = scene, name

    def _of_tiles(self) -> List[Body]:
        return [tile.bodies[self.name] for tile in self._scene.tiles]

    def _view(self, column: str, writable: bool = True) -> View:
        return _ViewHere([body._view(column, writable) for body in self._of_tiles()])

    @property
    def history(self) -> Dict[str, View]:
        """Columns of the law's history by name, [n] each."""
        return {name: self._view(f"history/{name}") for name in self._of_tiles()[0].history}

    @property
    def lost(self) -> int:
        """Points that have left the mesh from these tiles."""
        return sum(body.lost for body in self._of_tiles())

    @property
    def lost_mass(self) -> float:
        """kg"""
        return sum(body.lost_mass for body in self._of_tiles())

    def __len__(self) -> int:
        return sum(len(body) for body in self._of_tiles())

    def __repr__(self) -> str:
        return f"BodyHere({self.name!r}, {len(self)} points)"


def _whole_number(name: str, value: Any) -> int:
    if isinstance(value, bool):
        raise Error(f"TiledScene.{name} = {value}: must be a whole number")
    try:
        return operator.index(value)
    except TypeError:
        raise Error(f"TiledScene.{name} = {value!r}: must be a whole number") from None


class TiledScene(Scene):
    """A `Scene` cut into tiles, which `ar.run`, `ar.settle` and `ar.Vtu` take as one. The same tiles give the same bits on any number of ranks.

    ranks: a communicator of mpi4py, whose ranks all make the scene, step it and ask it for energies, reactions and forces, or None: this
    process has all tiles. tiles: how many in all; 0: one for each rank. weights [cells]: what a cell costs, -; tile_of_cell [cells]: of
    simplices, the tiles of a partitioner of your own. Every `rebalance_every` steps of a run, ranks with more than `rebalance_above` of
    the mean share of the points give tiles away. The rest is that of a `Scene`, but for `steps`, `copy` and pickle; `watched` is on rank 0.
    Functions of positions that recipes hold are called on all ranks, once, with all positions.

    What all ranks ask is compared before it is done: where recipes, options or questions differ, all raise `Error`, which names the rank.
    Functions that `run` is given are called on all ranks, with the scene, whose bodies are those of the rank. An exception on one rank ends
    the run on all of them; `mpirun -n 4 python -m mpi4py program.py` then ends the program.

    Its own composition is compiled on first use (20 to 30 s), and `mpicxx` (or what the environment's MPICXX names) makes the link to MPI."""

    def __init__(self, kinematics: Recipe, mesh: Mesh, numerics: Numerics, *, ranks: Any = None, tiles: int = 0,
                 weights: Optional[ArrayLike] = None, tile_of_cell: Optional[ArrayLike] = None, rebalance_every: int = 50,
                 rebalance_above: float = 1.05, **scene: Any) -> None:
        count, every = _whole_number("tiles", tiles), _whole_number("rebalance_every", rebalance_every)
        if count < 0:
            raise Error(f"TiledScene.tiles = {tiles}: must not be negative")
        numbers = np.asarray([] if tile_of_cell is None else tile_of_cell)
        if numbers.ndim != 1 or (len(numbers) and numbers.dtype.kind not in "iu"):
            raise Error(f"TiledScene.tile_of_cell = an array {list(numbers.shape)} of {numbers.dtype}: must be one row of whole numbers")
        self._ranks = _plugins.ranks(ranks)
        self._cut = (count, [] if weights is None else np.asarray(weights, float).tolist(), numbers.tolist(), every, rebalance_above)
        super().__init__(kinematics, mesh, numerics, **scene)

    def _make(self, which: _plugins.Which = "own") -> Any:
        names = ("tiles", "weights", "tile_of_cell", "rebalance_every", "rebalance_above")
        try:
            self._type, values, headers, types = self._composition()
            _ranks.agree(self._ranks, "a TiledScene", {**self._recipes, **dict(zip(names, self._cut))})
            plugin = _plugins.tiles_plugin(self._type, headers, lambda: self._check(values, types))
            with self._named():
                return plugin.scene_in_tiles(self._type, values, self._ranks, *self._cut)
        except Exception as e:
            self._ranks.fail(str(e))
            raise

    def _take(self, core: Any) -> None:
        self._core, self._stand_in = _ranks.Asked(core, self._ranks), None
        _ranks.leave_at_exit(self)
        self._restored = None
        self._state = _StateOfTiles(self._core, self._hidden_history())
        self.bodies: Dict[str, Any] = Named("bodies", {b.name: BodyHere(self, b.name) for b in self._recipes["bodies"]})
        #: rigid bodies by name, or number where one has no name: the same in all tiles
        self.rigids = self.tiles[0].rigids

    @property
    def rank(self) -> int:
        """Of this process among the ranks."""
        return int(self._ranks.rank)

    @property
    def tiles(self) -> List[Tile]:
        """Those of this rank now; they may be on other ranks after a run."""
        return [Tile(self, n) for n in sorted({int(path.split("/")[1]) for path in self._state.columns()})]

    def sum(self, of: Callable[[Tile], float]) -> float:
        """The sum of a number of each tile over all ranks, which all ask; the same on any number of them."""
        return math.fsum(self._gathered("sum", of))

    def least(self, of: Callable[[Tile], float]) -> float:
        """The least of a number of each tile over all ranks, which all ask."""
        return min(self._gathered("least", of))

    def _gathered(self, asks: str, of: Callable[[Tile], float]) -> Sequence[float]:
        try:
            here = [float(of(tile)) for tile in self.tiles]
        except Exception as e:
            self._ranks.fail(str(e))
            raise
        _ranks.agree(self._ranks, asks, {})
        numbers: Sequence[float] = self._ranks.gather(here)
        return numbers

    def _restore(self, path: str, recipe: str) -> None:
        self._core.restore(path, recipe)

    def _pieces(self) -> Sequence[str]:
        return [f"_rank{rank}" for rank in range(self._ranks.size)]

    def _meet(self, asks: str, **given: Any) -> None:
        _ranks.agree(self._ranks, asks, given)

    def _refuse_ranks(self, what: str, cure: str) -> None:
        if self._ranks.size > 1:
            raise Error(f"{what}: the points of this scene are on {self._ranks.size} ranks: {cure}")

    def _parts_of(self, body: str) -> Sequence[Body]:
        return [tile.bodies[body] for tile in self.tiles]

    def _test(self, body: str, of: Callable[[Any], Any]) -> Any:
        """All ranks see the same positions, in the order of their ids, wherever tiles are."""
        here, ids = np.asarray(self.bodies[body].position), np.asarray(self.bodies[body].column("id"))
        of_rank = self._ranks.gather([float(len(ids))])
        places = np.reshape(self._ranks.gather(here.ravel().tolist()), (-1, here.shape[1]))
        order = np.argsort(self._ranks.gather(ids.astype(float).tolist()))
        found = np.asarray(of(places[order]))
        if found.shape != order.shape:
            raise Error(f"where = a function that returns an array {list(found.shape)}: must be [{len(order)}], one for each point")
        back = np.empty_like(found)
        back[order] = found
        begin = int(sum(of_rank[:self.rank]))
        return back[begin:begin + len(ids)]

    def _bare(self) -> Scene:
        other = super()._bare()
        assert isinstance(other, TiledScene)
        other._ranks, other._cut = self._ranks, self._cut
        return other

    def _remove_saved(self, path: str) -> None:
        if os.path.isfile(os.path.join(path, "tiles.txt")):
            shutil.rmtree(path)

    def steps(self, courant: float = 0.5, end: float = float("inf"), max_step: float = float("inf"), *,
              watch: Union[bool, Watch] = True) -> Iterator[float]:
        raise Error("TiledScene.steps: is not there: give `run` an `after_step`, or take steps of your own: step(0.5 * stable_step)")

    @property
    def cells(self) -> Any:
        if not self._recipes["mesh"].cpp().startswith("SimplexMesh"):
            return None
        raise Error("TiledScene.cells: each tile has some of them, with numbers of its own; those of the whole are `cells` of the mesh")

    def copy(self) -> Scene:
        raise Error("TiledScene: cannot be copied; save it, and restore another one")

    def __getstate__(self) -> Any:
        raise Error("TiledScene: cannot be pickled; save it, and restore another one")


__all__ = ["BodyHere", "Tile", "TiledScene"]
