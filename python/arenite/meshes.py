"""Kinematics and meshes."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._errors import Error
from ._recipe import Recipe


@dataclass(frozen=True)
class PlaneStrain(Recipe):
    """x and y, a metre of thickness, no strain out of plane."""


@dataclass(frozen=True)
class Axisymmetric(Recipe):
    """x = r >= 0 and y along the axis; masses and forces are those of the full circle."""


@dataclass(frozen=True)
class ThreeDimensional(Recipe):
    """x, y and z."""


class Mesh(Recipe):
    dimension: int


@dataclass(frozen=True)
class CartesianGrid(Mesh):
    """Equal square or cubic cells in a box, [2 or 3], m.

    parameter  unit  range           default  meaning
    lower      m     2 or 3 numbers  needed
    upper      m     as many         needed   above lower
    cell       m     > 0             needed   divides the box"""

    lower: Sequence[float]
    upper: Sequence[float]
    cell: float

    @property
    def dimension(self) -> int:  # type: ignore[override]
        return len(self.lower)

    def cpp(self) -> str:
        return f"CartesianGrid<{self.dimension}>"


@dataclass(frozen=True)
class RectilinearGrid(Mesh):
    """Cells between lines at given places, m; z in space alone.

    parameter  unit  range              default  meaning
    x          m     2 or more numbers  needed   that rise
    y          m     2 or more numbers  needed   that rise
    z          m     2 or more numbers  ()       in space alone"""

    x: Sequence[float]
    y: Sequence[float]
    z: Sequence[float] = ()

    @property
    def dimension(self) -> int:  # type: ignore[override]
        return 3 if len(self.z) else 2

    def cpp(self) -> str:
        return f"RectilinearGrid<{self.dimension}>"


@dataclass(frozen=True)
class Periodic(Mesh):
    grid: CartesianGrid
    axes: Sequence[int]

    @property
    def dimension(self) -> int:  # type: ignore[override]
        return self.grid.dimension

    def cpp(self) -> str:
        return f"PeriodicGrid<{self.grid.cpp()}, {sum(1 << a for a in set(self.axes))}>"

    def value(self) -> Any:
        return self.grid.value()


def periodic(grid: CartesianGrid, *axes: int) -> Periodic:
    """The grid closed along axes, 0 for x."""
    return Periodic(grid, axes)


@dataclass(frozen=True, eq=False)
class SimplexMesh(Mesh):
    """Triangles or tetrahedra: nodes [n, D], m; cells [m, D + 1]; the region of each cell [m]; names of regions
    (name to number) and of sets of nodes (name to numbers).

    parameter     unit  range                     default  meaning
    nodes         m     [n, D]                    needed
    cells         -     [m, D + 1]                needed   numbers of nodes
    region        -     [m]                       None     of each cell
    region_names  -     numbers by name           {}
    node_sets     -     numbers of nodes by name  {}"""

    nodes: ArrayLike
    cells: ArrayLike
    region: Optional[ArrayLike] = None
    region_names: Dict[str, int] = field(default_factory=dict)
    node_sets: Dict[str, ArrayLike] = field(default_factory=dict)

    @property
    def dimension(self) -> int:  # type: ignore[override]
        shape = np.shape(self.nodes)
        return int(shape[1]) if len(shape) == 2 else 0

    def cpp(self) -> str:
        if self.dimension not in (2, 3):
            raise Error(f"SimplexMesh.nodes: shape {np.shape(self.nodes)}: must be [n, 2] or [n, 3]")
        return f"SimplexMesh<{self.dimension}>"

    def value(self) -> Any:
        value = {"nodes": np.asarray(self.nodes, float), "cells": np.asarray(self.cells, float),
                 "region_names": dict(self.region_names),
                 "node_sets": {name: np.asarray(nodes, float) for name, nodes in self.node_sets.items()}}
        if self.region is not None:
            value["region"] = np.asarray(self.region, float)
        return value

    def __repr__(self) -> str:
        return (f"SimplexMesh({np.shape(self.nodes)[0]} nodes, {np.shape(self.cells)[0]} cells, "
                f"regions {sorted(self.region_names)}, node sets {sorted(self.node_sets)})")

    @classmethod
    def from_meshio(cls, mesh: Any, dimension: Optional[int] = None) -> "SimplexMesh":
        """Out of a meshio mesh: its triangles, or tetrahedra if it has any; regions by the cell data
        "gmsh:physical" with the names of the field data, sets of nodes by the mesh's point sets and by its
        physical groups of lower dimension."""
        kinds = {"triangle": 2, "tetra": 3}
        d = dimension or (3 if any(b.type == "tetra" for b in mesh.cells) else 2)
        blocks = [k for k, b in enumerate(mesh.cells) if kinds.get(b.type) == d]
        if not blocks:
            raise Error(f"SimplexMesh.from_meshio: cells = {[b.type for b in mesh.cells]}: must hold triangles or tetrahedra")
        cells = np.concatenate([mesh.cells[k].data for k in blocks])
        physical = mesh.cell_data.get("gmsh:physical")
        region = None if physical is None else np.concatenate([physical[k] for k in blocks])
        names = {name: int(tag[0]) for name, tag in mesh.field_data.items() if int(tag[1]) == d}
        sets: Dict[str, ArrayLike] = {name: np.asarray(nodes) for name, nodes in mesh.point_sets.items()}
        for name, tag in mesh.field_data.items():
            if int(tag[1]) < d and physical is not None:
                own = [np.ravel(b.data[physical[k] == int(tag[0])]) for k, b in enumerate(mesh.cells)
                       if kinds.get(b.type) != d]
                sets[name] = np.unique(np.concatenate(own)) if own else np.array([])
        return cls(np.asarray(mesh.points)[:, :d], cells, region, names, sets)


__all__ = ["Axisymmetric", "CartesianGrid", "PlaneStrain", "RectilinearGrid", "SimplexMesh", "ThreeDimensional",
           "periodic"]
