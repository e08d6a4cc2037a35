"""Shapes: regions to fill and surfaces of rigid bodies. Lengths in m, angles in rad. `a | b`, `a & b` and `a - b`
join two, the second of which may be a signed distance of one's own; `placed` moves one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _recipes
from ._recipe import Recipe, pasted, plain


class Shape(Recipe):
    def rules(self) -> str:
        return "Shape"

    def value(self) -> Any:
        return {"shape": type(self).__name__, **super().value()}

    def __or__(self, other: Union["Shape", Callable[[Any], Any]]) -> "Shape":
        return Combined("Union", self, other)

    def __and__(self, other: Union["Shape", Callable[[Any], Any]]) -> "Shape":
        return Combined("Intersection", self, other)

    def __sub__(self, other: Union["Shape", Callable[[Any], Any]]) -> "Shape":
        return Combined("Difference", self, other)


@dataclass(frozen=True)
class Box(Shape):
    """lower <= x < upper, [2 or 3].

    parameter  unit  range           default
    lower      m     2 or 3 numbers  needed
    upper      m     as many         needed"""

    lower: Sequence[float]
    upper: Sequence[float]


@dataclass(frozen=True)
class Ball(Shape):
    """A disc in the plane, a ball in space.

    parameter  unit  range           default
    centre     m     2 or 3 numbers  needed
    radius     m     > 0             needed"""

    centre: Sequence[float]
    radius: float


@dataclass(frozen=True)
class RoundedBox(Shape):
    """A box with rounded edges.

    parameter  unit  range           default  meaning
    lower      m     2 or 3 numbers  needed
    upper      m     as many         needed   above lower
    radius     m     >= 0            needed   at most half of the shortest edge"""

    lower: Sequence[float]
    upper: Sequence[float]
    radius: float


@dataclass(frozen=True)
class Capsule(Shape):
    """Nearer than the radius to the line from a to b.

    parameter  unit  range           default
    a          m     2 or 3 numbers  needed
    b          m     as many         needed
    radius     m     > 0             needed"""

    a: Sequence[float]
    b: Sequence[float]
    radius: float


@dataclass(frozen=True)
class Cylinder(Shape):
    """Circular, with flat ends at a and b; in space.

    parameter  unit  range      default  meaning
    a          m     3 numbers  needed   centre of an end
    b          m     3 numbers  needed   centre of the other
    radius     m     > 0        needed"""

    a: Sequence[float]
    b: Sequence[float]
    radius: float


@dataclass(frozen=True)
class Polygon(Shape):
    """Inside of a closed line of corners [n, 2]; in the plane.

    parameter  unit  range   default
    corners    m     [n, 2]  needed"""

    corners: Sequence[Sequence[float]]


class ConeCylinder(_recipes.ConeCylinder, Shape):
    def value(self) -> Any:
        return {"shape": "ConeCylinder", "parameters": Recipe.value(self)}


@dataclass(frozen=True)
class TriangleSurface(Shape):
    """Inside of closed surfaces: vertices [n, 3], m, and triangles [m, 3], counter-clockwise from outside.

    parameter  unit  range   default  meaning
    vertices   m     [n, 3]  needed
    triangles  -     [m, 3]  needed   numbers of vertices, counter-clockwise from outside"""

    vertices: ArrayLike
    triangles: ArrayLike

    def value(self) -> Any:
        return {"shape": "TriangleSurface", "vertices": np.asarray(self.vertices, float),
                "triangles": np.asarray(self.triangles, float)}


@dataclass(frozen=True)
class Combined(Shape):
    rule: str
    a: Shape
    b: Union[Shape, Callable[[Any], Any]]

    def value(self) -> Any:
        return {"shape": self.rule, "a": plain(self.a), "b": plain(self.b)}

    def __repr__(self) -> str:
        return f"({pasted(self.a)} {dict(Union='|', Intersection='&', Difference='-')[self.rule]} {pasted(self.b)})"


@dataclass(frozen=True)
class Placed(Shape):
    """A shape turned about its origin, then moved; made by `placed`.

    parameter  unit  range      default  meaning
    of         -     a shape    needed
    at         m     3 numbers  needed   where its origin goes
    turned     rad   3 numbers  needed   rotation vector"""

    of: Shape
    at: Sequence[float]
    turned: Sequence[float]

    def value(self) -> Any:
        return {"shape": "Placed", "of": plain(self.of),
                "placement": {"at": list(self.at), "turned": list(self.turned)}}


def placed(shape: Shape, at: Sequence[float] = (0.0, 0.0, 0.0), turned: Sequence[float] = (0.0, 0.0, 0.0)) -> Placed:
    """The shape turned about its origin by a rotation vector, rad, then moved to `at`, m."""
    return Placed(shape, at, turned)


@dataclass(frozen=True)
class Cells(Recipe):
    """All cells of named regions of a simplex mesh.

    parameter  unit  range             default  meaning
    regions    -     a name, or names  needed   of regions of the mesh"""

    regions: Union[str, Sequence[str]]

    def value(self) -> Any:
        return {"cells": [self.regions] if isinstance(self.regions, str) else list(self.regions)}


Test = Callable[[Any], Any]
Region = Union[Shape, Cells, Test]


def region_value(region: Region) -> Any:
    """A shape, cells, or a test of positions [n, 2 or 3] that returns [n] booleans."""
    if isinstance(region, Recipe):
        return region.value()
    if callable(region):
        return {"where": region}
    raise TypeError(f"region = {region!r}: must be a shape, Cells or a function of positions")


def distance_value(shape: Union[Shape, Test]) -> Any:
    """A shape, or a function of one position [1, 2 or 3] that returns a signed distance, m."""
    return shape.value() if isinstance(shape, Recipe) else shape


__all__ = ["Ball", "Box", "Capsule", "Cells", "ConeCylinder", "Cylinder", "Placed", "Polygon", "RoundedBox", "Shape",
           "TriangleSurface", "placed"]
