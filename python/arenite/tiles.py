"""A scene cut into tiles: boxes of cells of a grid or sets of cells of a simplex mesh, stepped by a thread each, on one machine or, with
mpi4py, on the ranks of many."""

from __future__ import annotations

import math
from typing import Any, Callable, Dict, List, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, _plugins
from ._errors import Error
from ._recipe import Recipe
from .meshes import Mesh
from .numerics import Numerics
from .scene import Scene
from .views import Body, State


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


class BodyHere:
    """The points of a body in the tiles of this rank, tile by tile: copies, in SI units, as the columns of a `Body`."""

    def __init__(self, scene: "TiledScene", name: str) -> None:
        self._scene, self.name = scene, name

    def _of_tiles(self) -> List[Body]:
        return [tile.bodies[self.name] for tile in self._scene.tiles]

    def column(self, name: str) -> NDArray[Any]:
        """Any column of the points, [n] or [n, k]: "position", "velocity", "mass", "volume", "stress", "id", which is a point's own in all
        tiles, and others by their path."""
        return np.concatenate([np.asarray(body.column(name)) for body in self._of_tiles()])

    position = property(lambda self: self.column("position"), doc="[n, D], m.")
    velocity = property(lambda self: self.column("velocity"), doc="[n, D], m/s.")
    mass = property(lambda self: self.column("mass"), doc="[n], kg.")
    volume = property(lambda self: self.column("volume"), doc="[n], m3.")
    stress = property(lambda self: self.column("stress"), doc="[n, 4 or 6], Pa, tension positive.")

    @property
    def history(self) -> Dict[str, NDArray[Any]]:
        """Columns of the law's history by name, [n] each."""
        return {name: self.column(f"history/{name}") for name in self._of_tiles()[0].history}

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


class TiledScene(Scene):
    """A `Scene` cut into tiles, which `ar.run`, `ar.settle` and `ar.Vtu` take as one. The same tiles give the same bits on any number of ranks.

    ranks: a communicator of mpi4py, whose ranks all make the scene, step it and ask it for energies, reactions and forces, or None: this
    process has all tiles. tiles: how many in all; 0: one for each rank. weights [cells]: what a cell costs, -; tile_of_cell [cells]: of
    simplices, the tiles of a partitioner of your own. Every `rebalance_every` steps of a run, ranks with more than `rebalance_above` of
    the mean share of the points give tiles away. The rest is that of a `Scene`; `watched` is on rank 0.

    Functions that `run` is given are called on all ranks, with the scene, whose bodies are those of the rank. An exception on one rank ends
    the run on all of them; `mpirun -n 4 python -m mpi4py program.py` then ends the program.

    Its own composition is compiled on first use (20 to 30 s), and `mpicxx` (or what the environment's MPICXX names) makes the link to MPI."""

    def __init__(self, kinematics: Recipe, mesh: Mesh, numerics: Numerics, *, ranks: Any = None, tiles: int = 0,
                 weights: Optional[ArrayLike] = None, tile_of_cell: Optional[ArrayLike] = None, rebalance_every: int = 50,
                 rebalance_above: float = 1.05, **scene: Any) -> None:
        if tiles < 0:
            raise Error(f"TiledScene.tiles = {tiles}: must not be negative")
        self._ranks = _plugins.ranks(ranks)
        self._cut = (tiles, [] if weights is None else np.asarray(weights, float).tolist(),
                     [] if tile_of_cell is None else np.asarray(tile_of_cell, int).tolist(), rebalance_every, rebalance_above)
        super().__init__(kinematics, mesh, numerics, **scene)

    def _make(self, which: _plugins.Which = "own") -> Any:
        self._type, values, headers, types = self._composition()
        plugin = _plugins.tiles_plugin(self._type, headers, lambda: self._check(values, types))
        with self._named():
            return plugin.scene_in_tiles(self._type, values, self._ranks, *self._cut)

    def _take(self, core: Any) -> None:
        self._core, self._stand_in = core, None
        self._restored_at = None
        self._state = State(core)
        self.bodies: Dict[str, Any] = {b.name: BodyHere(self, b.name) for b in self._recipes["bodies"]}
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
        return math.fsum(self._gathered(of))

    def least(self, of: Callable[[Tile], float]) -> float:
        """The least of a number of each tile over all ranks, which all ask."""
        return min(self._gathered(of))

    def _gathered(self, of: Callable[[Tile], float]) -> Sequence[float]:
        try:
            here = [float(of(tile)) for tile in self.tiles]
        except Exception as e:
            self._ranks.fail(str(e))
            raise
        numbers: Sequence[float] = self._ranks.gather(here)
        return numbers

    def _restore(self, path: str, recipe: str) -> None:
        self._core.restore(path, recipe)

    def _pieces(self) -> Sequence[str]:
        return [f"_rank{rank}" for rank in range(self._ranks.size)]

    def _meet(self) -> None:
        self._ranks.gather([])

    def copy(self) -> Scene:
        raise Error("TiledScene: cannot be copied; save it, and restore another one")

    def __getstate__(self) -> Any:
        raise Error("TiledScene: cannot be pickled; save it, and restore another one")


__all__ = ["BodyHere", "Tile", "TiledScene"]
