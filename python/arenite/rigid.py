"""Rigid bodies: a surface, a motion, friction and the kind of contact."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Optional, Sequence, Type, Union

from ._recipe import Recipe, function_value, plain
from .shapes import Shape, distance_value


@dataclass(frozen=True)
class Guided(Recipe):
    """A mass that slides along one axis under gravity, a load and contact."""

    mass: float = float("nan")  #: kg
    axis: Sequence[float] = (0.0, 1.0, 0.0)
    velocity: float = 0.0  #: m/s
    load: float = 0.0  #: N


@dataclass(frozen=True)
class Prescribed(Recipe):
    """A velocity, m/s: a vector, a `Signal`, or a function of time."""

    velocity: Any

    def value(self) -> Any:
        return function_value(self.velocity)


@dataclass(frozen=True)
class PrescribedPose(Recipe):
    """Velocity of one point, m/s, and the spin about it, rad/s."""

    centre: Sequence[float] = (0.0, 0.0, 0.0)
    velocity: Any = (0.0, 0.0, 0.0)
    spin: Any = (0.0, 0.0, 0.0)

    def value(self) -> Any:
        return {"centre": list(self.centre), "velocity": function_value(self.velocity),
                "spin": function_value(self.spin)}


@dataclass(frozen=True)
class Anchor(Recipe):
    """Springs, N/m and N m/rad, and dashpots, N s/m and N m s/rad, to the place at the start."""

    stiffness: Sequence[float] = (0.0, 0.0, 0.0)
    damping: Sequence[float] = (0.0, 0.0, 0.0)
    rotational_stiffness: Sequence[float] = (0.0, 0.0, 0.0)
    rotational_damping: Sequence[float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Free(Recipe):
    """A mass that moves and turns freely; force, N, and moment, N m, may be vectors, signals or functions."""

    mass: float = float("nan")  #: kg
    inertia: Union[float, Sequence[float], None] = None  #: kg m2: one number, three, or six
    centre: Sequence[float] = (float("nan"), float("nan"), 0.0)  #: m
    velocity: Sequence[float] = (0.0, 0.0, 0.0)  #: m/s
    spin: Sequence[float] = (0.0, 0.0, 0.0)  #: rad/s
    anchor: Anchor = field(default_factory=Anchor)
    force: Any = (0.0, 0.0, 0.0)
    moment: Any = (0.0, 0.0, 0.0)

    def value(self) -> Any:
        value = Recipe.value(self)
        value["force"], value["moment"] = function_value(self.force), function_value(self.moment)
        if self.inertia is None:
            del value["inertia"]
        return value


class Contact(Recipe):
    pass


@dataclass(frozen=True)
class RigidVelocity(Contact):
    """At nodes: a touched one may not move into the body."""


@dataclass(frozen=True)
class CentreOfMass(Contact):
    """At nodes, through the centre-of-mass velocity; needs a `MeshSurface`."""


@dataclass(frozen=True)
class PointContact(Contact):
    """At the material points; needs `Usl` and a shape."""


@dataclass(frozen=True)
class MeshSurface(Recipe):
    """The surface of a region of a simplex mesh that moves with the body."""

    region: str


class Rigid(Recipe):
    """A rigid body: a shape (or a signed distance), how it moves, and friction, rad (infinity: no slip).
    `reach`: a node counts as touched up to so many cells outside."""

    def __init__(self, surface: Union[Shape, MeshSurface, Callable[[Any], Any]], motion: Recipe, friction: float,
                 contact: Union[Contact, Type[Contact]] = RigidVelocity, reach: float = 0.5, name: str = "") -> None:
        self.surface, self.motion, self.friction, self.reach, self.name = surface, motion, friction, reach, name
        self.contact = contact() if isinstance(contact, type) else contact

    def cpp(self) -> str:
        surface = "MeshSurface" if isinstance(self.surface, MeshSurface) else "DistanceSurface<>"
        contact = "" if isinstance(self.contact, RigidVelocity) else f", {self.contact.cpp()}"
        return f"Rigid<{surface}, {self.motion.cpp()}{contact}>"

    def value(self) -> Any:
        if isinstance(self.surface, MeshSurface):
            surface = self.surface.value()
        else:
            surface = {"distance": distance_value(self.surface), "reach": self.reach}
        return {"surface": surface, "motion": plain(self.motion), "friction": self.friction}

    def __repr__(self) -> str:
        return f"Rigid({self.surface!r}, {self.motion!r}, friction={self.friction!r}, contact={self.contact!r})"


@dataclass(frozen=True)
class RigidPair(Recipe):
    """Two rigid bodies, by their numbers, with a friction of their own, rad; None: they do not touch."""

    first: int
    second: int
    friction: Optional[float] = None

    def value(self) -> Any:
        return {"first": str(self.first), "second": str(self.second), "friction": self.friction}


@dataclass(frozen=True)
class RigidContact(Recipe):
    """All rigid bodies of the scene touch one another, with friction, rad, but for pairs with one of their own."""

    friction: float
    pairs: Sequence[RigidPair] = ()


@dataclass(frozen=True)
class MovingMesh(Recipe):
    """The mesh moves along an axis with rigid body number `leader`; heights in m."""

    fixed_below: float
    moving_from: float
    moving_to: float = float("inf")
    fixed_above: float = float("inf")
    axis: int = 1
    least: float = 0.05
    leader: int = 0

    def cpp(self) -> str:
        return f"MovingMesh<LedByRigid<{self.leader}>>" if self.leader else "MovingMesh<>"

    def value(self) -> Any:
        value = Recipe.value(self)
        del value["leader"]
        return value


__all__ = ["Anchor", "CentreOfMass", "Free", "Guided", "MeshSurface", "MovingMesh", "PointContact", "Prescribed",
           "PrescribedPose", "Rigid", "RigidContact", "RigidPair", "RigidVelocity"]
