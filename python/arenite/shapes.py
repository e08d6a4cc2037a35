"""Shapes: regions to fill and surfaces of rigid bodies. Lengths in m, angles in rad. `a | b`, `a & b` and `a - b`
join two; `placed` moves one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from ._recipe import Recipe, plain


class Shape(Recipe):
    def value(self) -> Any:
        return {"shape": type(self).__name__, **super().value()}

    def __or__(self, other: "Shape") -> "Shape":
        return Combined("Union", self, other)

    def __and__(self, other: "Shape") -> "Shape":
        return Combined("Intersection", self, other)

    def __sub__(self, other: "Shape") -> "Shape":
        return Combined("Difference", self, other)


@dataclass(frozen=True)
class Box(Shape):
    """lower <= x < upper, [2 or 3]."""

    lower: Sequence[float]
    upper: Sequence[float]


@dataclass(frozen=True)
class Ball(Shape):
    """A disc in the plane, a ball in space."""

    centre: Sequence[float]
    radius: float


@dataclass(frozen=True)
class RoundedBox(Shape):
    lower: Sequence[float]
    upper: Sequence[float]
    radius: float


@dataclass(frozen=True)
class Capsule(Shape):
    """Nearer than the radius to the line from a to b."""

    a: Sequence[float]
    b: Sequence[float]
    radius: float


@dataclass(frozen=True)
class Cylinder(Shape):
    """Circular, with flat ends at a and b; in space."""

    a: Sequence[float]
    b: Sequence[float]
    radius: float


@dataclass(frozen=True)
class Polygon(Shape):
    """Inside of a closed line of corners [n, 2]; in the plane."""

    corners: Sequence[Sequence[float]]


@dataclass(frozen=True)
class ConeCylinder(Shape):
    """Cylinder about the y axis with a cone that points down, its lowest point at height `tip`."""

    radius: float
    apex: float  #: full angle, rad
    length: float
    tip: float = 0.0
    tip_radius: float = 0.0
    fillet: float = 0.0

    def value(self) -> Any:
        return {"shape": "ConeCylinder", "parameters": Recipe.value(self)}


@dataclass(frozen=True)
class TriangleSurface(Shape):
    """Inside of closed surfaces: vertices [n, 3], m, and triangles [m, 3], counter-clockwise from outside."""

    vertices: ArrayLike
    triangles: ArrayLike

    def value(self) -> Any:
        return {"shape": "TriangleSurface", "vertices": np.asarray(self.vertices, float),
                "triangles": np.asarray(self.triangles, float)}


@dataclass(frozen=True)
class Combined(Shape):
    rule: str
    a: Shape
    b: Shape

    def value(self) -> Any:
        return {"shape": self.rule, "a": plain(self.a), "b": plain(self.b)}


@dataclass(frozen=True)
class Placed(Shape):
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
    """All cells of named regions of a simplex mesh."""

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
