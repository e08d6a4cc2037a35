"""Kinematics and meshes."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core
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
    """A mesh decides the numbers that a scene computes with: its `dtype`, float64, or float32 for half of the memory and about 7 digits.
    Recipes and observers keep float64."""

    dimension: int
    dtype: Any

    def __post_init__(self) -> None:
        try:
            number = np.dtype(self.dtype).name
        except TypeError:
            number = ""
        if number not in ("float64", "float32"):
            raise Error(f"{type(self).__name__}.dtype = {self.dtype}: must be float64 or float32")
        object.__setattr__(self, "dtype", number)
        super().__post_init__()

    def cpp(self) -> str:
        return f"{type(self).__name__}<{self.dimension}{', float' * (self.dtype == 'float32')}>"

    def in_double(self) -> str:
        """The C++ type of the same mesh in float64, which the checks are compiled for."""
        return self.cpp().replace(", float", "")

    def value(self) -> Any:
        value = super().value()
        del value["dtype"]
        return value


@dataclass(frozen=True)
class CartesianGrid(Mesh):
    """Equal square or cubic cells in a box, [2 or 3], m.

    parameter  unit  range           default    meaning
    lower      m     2 or 3 numbers  needed
    upper      m     as many         needed     above lower
    cell       m     > 0             needed     divides the box
    dtype      -     or 'float32'    'float64'  of all numbers of the scene"""

    lower: Sequence[float]
    upper: Sequence[float]
    cell: float
    dtype: Any = "float64"

    @property
    def dimension(self) -> int:  # type: ignore[override]
        return len(self.lower)


@dataclass(frozen=True)
class RectilinearGrid(Mesh):
    """Cells between lines at given places, m; z in space alone.

    parameter  unit  range              default    meaning
    x          m     2 or more numbers  needed     that rise
    y          m     2 or more numbers  needed     that rise
    z          m     2 or more numbers  ()         in space alone
    dtype      -     or 'float32'       'float64'  of all numbers of the scene"""

    x: Sequence[float]
    y: Sequence[float]
    z: Sequence[float] = ()
    dtype: Any = "float64"

    @property
    def dimension(self) -> int:  # type: ignore[override]
        return 3 if len(self.z) else 2


@dataclass(frozen=True)
class Periodic(Mesh):
    grid: CartesianGrid
    axes: Sequence[int]

    @property
    def dimension(self) -> int:  # type: ignore[override]
        return self.grid.dimension

    @property
    def dtype(self) -> str:
        return str(self.grid.dtype)

    def __post_init__(self) -> None:
        Recipe.__post_init__(self)

    def cpp(self) -> str:
        return f"PeriodicGrid<{self.grid.cpp()}, {sum(1 << a for a in set(self.axes))}>"

    def value(self) -> Any:
        return self.grid.value()

    def __repr__(self) -> str:
        return f"periodic({', '.join(map(repr, [self.grid, *self.axes]))})"


def periodic(grid: CartesianGrid, *axes: int) -> Periodic:
    """The grid closed along axes, 0 for x."""
    return Periodic(grid, axes)


@dataclass(frozen=True)
class SimplexMesh(Mesh):
    """Triangles or tetrahedra: nodes [n, D], m; cells [m, D + 1]; the region of each cell [m]; names of regions
    (name to number) and of sets of nodes (name to numbers). Cells of several names have a region of their own, which
    is among the `shared_regions` of each name.

    parameter       unit  range                     default    meaning
    nodes           m     [n, D]                    needed
    cells           -     [m, D + 1]                needed     numbers of nodes
    region          -     [m]                       None       of each cell
    region_names    -     numbers by name           {}
    node_sets       -     numbers of nodes by name  {}
    dtype           -     or 'float32'              'float64'  of all numbers of the scene
    shared_regions  -     numbers by name           {}         further regions of a name"""

    nodes: ArrayLike
    cells: ArrayLike
    region: Optional[ArrayLike] = None
    region_names: Dict[str, int] = field(default_factory=dict)
    node_sets: Dict[str, ArrayLike] = field(default_factory=dict)
    dtype: Any = "float64"
    shared_regions: Dict[str, ArrayLike] = field(default_factory=dict)

    @property
    def dimension(self) -> int:  # type: ignore[override]
        shape = np.shape(self.nodes)
        return int(shape[1]) if len(shape) == 2 else 0

    def cpp(self) -> str:
        if self.dimension not in (2, 3):
            raise Error(f"SimplexMesh.nodes: shape {np.shape(self.nodes)}: must be [n, 2] or [n, 3]")
        return super().cpp()

    def value(self) -> Any:
        value = {"nodes": np.asarray(self.nodes, float), "cells": np.asarray(self.cells, float),
                 "region_names": dict(self.region_names),
                 "shared_regions": {name: np.asarray(regions, float) for name, regions in self.shared_regions.items()},
                 "node_sets": {name: np.asarray(nodes, float) for name, nodes in self.node_sets.items()}}
        if self.region is not None:
            value["region"] = np.asarray(self.region, float)
        return value

    @classmethod
    def from_gmsh(cls, path: Union[str, "os.PathLike[str]"], dimension: int) -> "SimplexMesh":
        """Out of a Gmsh file, format 2.2 or 4.1, text or binary, by the reader of the C++ library: triangles
        (dimension 2) or tetrahedra (3), regions and node sets by physical groups; of a group without a name the set is
        "dimension:tag". A cell in several groups belongs to the region of each. What is no simplex of first order is refused."""
        return cls(**_core.read_gmsh(os.fspath(path), dimension))

    @classmethod
    def from_meshio(cls, mesh: Any, dimension: Optional[int] = None) -> "SimplexMesh":
        """Out of a meshio mesh, by the rules of `from_gmsh`: its triangles, or tetrahedra if it has elements of a solid.
        Groups are its `cell_sets`, the cell data "gmsh:physical" or "medit:ref" with names out of `field_data`, and
        `point_sets`: those of cells are regions, others node sets. Other cell data
        becomes groups by `mesh.cell_data_to_sets(name)`. With data of Gmsh ("gmsh:..") a cell may be there once for each of its groups,
        as format 2.2 has it."""
        d = dimension or (3 if any(b.dim == 3 for b in mesh.cells) else 2)
        tags = next((mesh.cell_data[key] for key in ("gmsh:physical", "medit:ref") if key in mesh.cell_data), None)
        names = {(int(given[1]), int(given[0])): name for name, given in mesh.field_data.items()
                 if np.shape(given) == (2,) and np.issubdtype(np.asarray(given).dtype, np.integer)}
        by_name = {(group[0], name): group[1] for group, name in names.items()}
        next_tag = 1 + max([0, *(tag for _, tag in names), *(int(np.max(np.abs(t), initial=0)) for t in tags or ())])

        def tag_of(dim: int, name: str) -> int:
            """Of a group, a new one if it has none."""
            nonlocal next_tag
            if (dim, name) not in by_name:
                by_name[dim, name], names[dim, next_tag] = next_tag, name
                next_tag += 1
            return by_name[dim, name]

        blocks: List[Tuple[str, Any, List[Tuple[int, Any]]]] = []
        for k, block in enumerate(mesh.cells):
            groups = [(int(tag), np.flatnonzero(tags[k] == tag)) for tag in np.unique(tags[k]) if tag] if tags else []
            for name, members in mesh.cell_sets.items():
                if name != "gmsh:bounding_entities" and members[k] is not None and len(members[k]):
                    groups.append((tag_of(block.dim, name), np.asarray(members[k])))
            base, order = re.fullmatch(r"(\D*)(\d*)", block.type).groups()  # type: ignore[union-attr]
            word = _GMSH_WORDS.get(base, base)
            blocks.append((f"{order}-node {word}" if order else word, np.asarray(block.data), groups))
        for name, nodes in mesh.point_sets.items():
            blocks.append(("point", np.reshape(nodes, (-1, 1)), [(tag_of(0, name), np.arange(np.size(nodes)))]))
        repeats = any(key.startswith("gmsh:") for key in mesh.cell_data)
        return cls(**_core.gather_mesh(d, mesh.points, [(*group, name) for group, name in names.items()], blocks, repeats))


_GMSH_WORDS = {"vertex": "point", "quad": "quadrangle", "tetra": "tetrahedron", "wedge": "prism"}  #: for meshio's

__all__ = ["Axisymmetric", "CartesianGrid", "PlaneStrain", "RectilinearGrid", "SimplexMesh", "ThreeDimensional",
           "periodic"]
