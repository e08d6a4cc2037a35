"""Rigid bodies: a surface, a motion, friction and the kind of contact."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Callable, Optional, Sequence, Tuple, Type, Union

from . import _recipes
from ._bases import Contact
from ._recipe import Recipe, check_together, function_value, plain
from ._recipes import Anchor, CentreOfMass, Guided, NodalGap, PointContact, PrescribedPose, RigidVelocity
from .shapes import Shape, distance_value


@dataclass(frozen=True)
class Prescribed(Recipe):
    """A velocity, m/s: a vector, a `Signal`, or a function of time.

    parameter  unit  range                                               default
    velocity   m/s   up to 3 numbers, a `Signal`, or a function of time  needed"""

    velocity: Any

    def value(self) -> Any:
        return function_value(self.velocity)


class Free(_recipes.Free):
    def value(self) -> Any:
        value = super().value()
        if self.inertia is None:
            del value["inertia"]
        return value


@dataclass(frozen=True)
class MeshSurface(Recipe):
    """The surface of a region of a simplex mesh that moves with the body.

    parameter       unit  range   default  meaning
    region          -     a name  needed   of a region of the mesh
    shear_strength  Pa    >= 0    inf      greatest shear stress that it gives: the adhesion of clay, with friction infinity"""

    region: str
    shear_strength: float = math.inf


class Rigid(Recipe):
    """A rigid body: a shape (or a signed distance), how it moves, and friction, rad (infinity: no slip).
    `reach`: a node counts as touched up to so many cells outside.

    parameter  unit  range                                           default        meaning
    surface    -     a shape, a signed distance, or a `MeshSurface`  needed
    motion     -     a motion                                        needed
    friction   rad   [0, pi/2)                                       needed         angle; infinity: no slip
    contact    -     a contact                                       NodalGap
    reach      -     >= 0                                            0.5            a node counts as touched up to so many cells outside
    name       -     a name                                          ''"""

    def __init__(self, surface: Union[Shape, MeshSurface, Callable[[Any], Any]], motion: Recipe, friction: float,
                 contact: Union[Contact, Type[Contact]] = NodalGap, reach: float = 0.5, name: str = "") -> None:
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
        contact = "" if isinstance(self.contact, NodalGap) else f", {self.contact.cpp()}"
        return f"Rigid<{surface}, {self.motion.cpp()}{contact}>"

    def value(self) -> Any:
        if isinstance(self.surface, MeshSurface):
            surface = self.surface.value()
        else:
            surface = {"distance": distance_value(self.surface), "reach": self.reach}
        return {"surface": surface, "motion": plain(self.motion), "friction": self.friction}


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

    Walls that hold are those at a side of the box around the mesh that holds the matter all over, as planes without an end that stay where
    they were at the start. A smooth one does not hold a body that crosses it at the start, as at a plane of symmetry. Without `walls` a run
    warns of a body that passes one.

    parameter  unit  range             default  meaning
    friction   rad   [0, pi/2)         needed   angle; infinity: no slip
    pairs      -     `RigidPair` each  ()       with a friction of their own
    walls      rad   [0, pi/2)         None     of the walls, which then hold bodies with a mass, too; None: they hold the matter alone"""

    friction: float
    pairs: Sequence[RigidPair] = ()
    walls: Optional[float] = None


class MovingMesh(_recipes.MovingMesh):
    def cpp(self) -> str:
        return f"MovingMesh<LedByRigid<{self.leader}>>" if self.leader else "MovingMesh<>"

    def value(self) -> Any:
        value = super().value()
        del value["leader"]
        return value


__all__ = ["Anchor", "CentreOfMass", "Free", "Guided", "MeshSurface", "MovingMesh", "NodalGap", "PointContact", "Prescribed",
           "PrescribedPose", "Rigid", "RigidContact", "RigidPair", "RigidVelocity"]
