"""Rigid bodies: a surface, a motion, friction and the kind of contact."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Optional, Sequence, Tuple, Type, Union

from ._recipe import Recipe, check_together, function_value, plain
from .shapes import Shape, distance_value


@dataclass(frozen=True)
class Guided(Recipe):
    """A mass that slides along one axis under gravity, a load and contact.

    parameter  unit  range                            default          meaning
    mass       kg    > 0                              needed           of what the scene models: a metre, the full circle
    axis       -     any                              (0.0, 1.0, 0.0)  direction of the guide
    velocity   m/s   any                              0.0              along the axis, at the start
    load       N     a number, or a function of time  0.0              force along the axis; each step takes that of its begin"""

    mass: float = float("nan")
    axis: Sequence[float] = (0.0, 1.0, 0.0)
    velocity: float = 0.0
    load: Any = 0.0

    def value(self) -> Any:
        return {**Recipe.value(self), "load": function_value(self.load)}


@dataclass(frozen=True)
class Prescribed(Recipe):
    """A velocity, m/s: a vector, a `Signal`, or a function of time.

    parameter  unit  range                                               default
    velocity   m/s   up to 3 numbers, a `Signal`, or a function of time  needed"""

    velocity: Any

    def value(self) -> Any:
        return function_value(self.velocity)


@dataclass(frozen=True)
class PrescribedPose(Recipe):
    """Velocity of one point, m/s, and the spin about it, rad/s.

    parameter  unit   range                                               default          meaning
    centre     m      any                                                 (0.0, 0.0, 0.0)  the point, at the start
    velocity   m/s    up to 3 numbers, a `Signal`, or a function of time  (0.0, 0.0, 0.0)  of the point
    spin       rad/s  up to 3 numbers, a `Signal`, or a function of time  (0.0, 0.0, 0.0)  in the plane (0, 0, z)"""

    centre: Sequence[float] = (0.0, 0.0, 0.0)
    velocity: Any = (0.0, 0.0, 0.0)
    spin: Any = (0.0, 0.0, 0.0)

    def value(self) -> Any:
        return {"centre": list(self.centre), "velocity": function_value(self.velocity),
                "spin": function_value(self.spin)}


@dataclass(frozen=True)
class Anchor(Recipe):
    """Springs, N/m and N m/rad, and dashpots, N s/m and N m s/rad, to the place at the start.

    parameter             unit       range  default          meaning
    stiffness             N/m        >= 0   (0.0, 0.0, 0.0)  along each axis
    damping               N s/m      >= 0   (0.0, 0.0, 0.0)  along each axis
    rotational_stiffness  N m/rad    >= 0   (0.0, 0.0, 0.0)  about each axis
    rotational_damping    N m s/rad  >= 0   (0.0, 0.0, 0.0)  about each axis"""

    stiffness: Sequence[float] = (0.0, 0.0, 0.0)
    damping: Sequence[float] = (0.0, 0.0, 0.0)
    rotational_stiffness: Sequence[float] = (0.0, 0.0, 0.0)
    rotational_damping: Sequence[float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Free(Recipe):
    """A mass that moves and turns freely; force, N, and moment, N m, may be vectors, signals or functions.

    parameter  unit   range                                               default          meaning
    mass       kg     > 0                                                 needed           of what the scene models: a metre, the full circle
    inertia    kg m2  > 0                                                 None             about the centre: one number, three or six; none in axisymmetry
    centre     m      any                                                 needed           of mass, at the start
    velocity   m/s    any                                                 (0.0, 0.0, 0.0)  at the start
    spin       rad/s  any                                                 (0.0, 0.0, 0.0)  at the start; in the plane (0, 0, z)
    anchor     -      an `Anchor`                                         Anchor           springs and dashpots to the world
    force      N      up to 3 numbers, a `Signal`, or a function of time  (0.0, 0.0, 0.0)
    moment     N m    up to 3 numbers, a `Signal`, or a function of time  (0.0, 0.0, 0.0)"""

    mass: float = float("nan")
    inertia: Union[float, Sequence[float], None] = None
    centre: Sequence[float] = (float("nan"), float("nan"), 0.0)
    velocity: Sequence[float] = (0.0, 0.0, 0.0)
    spin: Sequence[float] = (0.0, 0.0, 0.0)
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
    """The surface of a region of a simplex mesh that moves with the body.

    parameter  unit  range   default  meaning
    region     -     a name  needed   of a region of the mesh"""

    region: str


class Rigid(Recipe):
    """A rigid body: a shape (or a signed distance), how it moves, and friction, rad (infinity: no slip).
    `reach`: a node counts as touched up to so many cells outside.

    parameter  unit  range                                           default        meaning
    surface    -     a shape, a signed distance, or a `MeshSurface`  needed
    motion     -     a motion                                        needed
    friction   rad   [0, pi/2)                                       needed         angle; infinity: no slip
    contact    -     a contact                                       RigidVelocity
    reach      -     >= 0                                            0.5            a node counts as touched up to so many cells outside
    name       -     a name                                          ''"""

    def __init__(self, surface: Union[Shape, MeshSurface, Callable[[Any], Any]], motion: Recipe, friction: float,
                 contact: Union[Contact, Type[Contact]] = RigidVelocity, reach: float = 0.5, name: str = "") -> None:
        self.surface, self.motion, self.friction, self.reach, self.name = surface, motion, friction, reach, name
        self.contact = contact() if isinstance(contact, type) else contact
        self.__post_init__()
        surface_, motion_, contact_ = self.kinds()
        check_together(contact_, surface_)
        check_together(contact_, motion_)
        check_together(motion_, surface_)

    def kinds(self) -> Tuple[str, str, str]:
        """Names of surface, motion and contact."""
        surface = "MeshSurface" if isinstance(self.surface, MeshSurface) else "DistanceSurface"
        return surface, type(self.motion).__name__, type(self.contact).__name__

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
    """Two rigid bodies, by their numbers, with a friction of their own, rad; None: they do not touch.

    parameter  unit  range            default  meaning
    first      -     a body's number  needed
    second     -     another one's    needed
    friction   rad   [0, pi/2)        None     None: they do not touch"""

    first: int
    second: int
    friction: Optional[float] = None

    def value(self) -> Any:
        return {"first": str(self.first), "second": str(self.second), "friction": self.friction}


@dataclass(frozen=True)
class RigidContact(Recipe):
    """All rigid bodies of the scene touch one another, with friction, rad, but for pairs with one of their own.

    parameter  unit  range             default  meaning
    friction   rad   [0, pi/2)         needed   angle; infinity: no slip
    pairs      -     `RigidPair` each  ()       with a friction of their own"""

    friction: float
    pairs: Sequence[RigidPair] = ()


@dataclass(frozen=True)
class MovingMesh(Recipe):
    """The mesh moves along an axis with rigid body number `leader`; heights in m.

    parameter    unit  range           default  meaning
    fixed_below  m     any             needed   nodes below it rest
    moving_from  m     > fixed_below   needed   nodes from here on move
    moving_to    m     >= moving_from  inf      up to here
    fixed_above  m     > moving_to     inf      nodes above it rest
    axis         -     0 to 2          1
    least        -     (0, 1)          0.05     share of its height that a zone keeps, or the run stops
    leader       -     >= 0            0        number of the rigid body"""

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
