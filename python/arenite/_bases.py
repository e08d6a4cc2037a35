"""What recipes have in common by their kind: of laws, policies, numerics, parts and contacts."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import frictions
from ._recipe import NOT_GIVEN, Recipe, check_together


__all__ = ["Cone", "Contact", "Frictional", "Kind", "Law", "NOT_GIVEN", "Part", "Policy", "Updated"]


class Policy(Recipe):
    """A policy of the frictional laws."""


class Kind(Recipe):
    """A kind of numerics."""


class Part(Recipe):
    """What a scene may name beside bodies and walls."""


class Contact(Recipe):
    """A kind of contact of a rigid body."""


class Law(Recipe):
    """A law; `update` takes arrays of states through a step, for finite elements and the like."""

    def header(self) -> Optional[str]:
        """The C++ header of a law of one's own."""
        return None

    def hidden_history(self) -> Tuple[str, ...]:
        """Numbers which the points of its C++ class remember for other policies."""
        return ()

    def native(self) -> Any:
        from . import _plugins

        return _plugins.law(self)

    @property
    def history_names(self) -> Tuple[str, ...]:
        """Names of the numbers that a point remembers."""
        return tuple(self.native().history_names())

    @property
    def wave_modulus(self) -> float:
        """Density times the square of the fastest wave's speed, Pa."""
        return float(self.native().wave_modulus())

    def update(self, stress: ArrayLike, strain: ArrayLike, spin: Optional[ArrayLike] = None, dt: float = 0.0,
               history: Optional[ArrayLike] = None) -> "Updated":
        """Takes n states through one step.

        stress [n, 6] (xx, yy, zz, xy, yz, zx), Pa, or in the plane [n, 4]; strain of the step of the same shape, -
        (shear: half of gamma); spin of the step [n, 3] (xy, yz, zx), in the plane [n, 1], -; dt in s; history
        [n, len(history_names)], by default that of a new point. Returns new arrays."""
        return Updated(*self.native().update(stress, strain, spin, dt, history))

    def elastic_energy(self, stress: ArrayLike, history: Optional[ArrayLike] = None) -> NDArray[np.float64]:
        """Recoverable energy of the unit volume [n], J/m3."""
        energy: NDArray[np.float64] = self.native().elastic_energy(stress, history)
        return energy


@dataclass(frozen=True)
class Updated:
    """States after a step: stress [n, 6 or 4], Pa; history [n, h]; opening and dilation [n], -."""

    stress: NDArray[np.float64]
    history: NDArray[np.float64]
    opening: NDArray[np.float64]
    dilation: NDArray[np.float64]


class Cone(enum.IntEnum):
    """Where the cone of Drucker-Prager meets the pyramid of Mohr-Coulomb."""

    compression = 0  #: at the edges of triaxial compression
    extension = 1  #: at the edges of triaxial extension
    plane_strain = 2  #: in plastic flow in plane strain, for the given dilatancy


class Frictional(Law):
    """A law of three policies, of which the friction is chosen at run time."""

    memory: Policy
    friction_law: Policy
    stiffness_law: Policy

    def __post_init__(self) -> None:
        super().__post_init__()
        check_together(type(self.stiffness_law).__name__, type(self.friction_law).__name__)

    def cpp(self) -> str:
        stiffness = self.stiffness_law.cpp()
        return self.rules() if stiffness == "ConstantStiffness" else f"{self.rules()[:-1]}, {stiffness}>"

    def rules(self) -> str:
        return f"{type(self).__name__}<{self.memory.cpp()}, AnyFriction>"

    def value(self) -> Any:
        return {**super().value(), "friction_law": {"policy": type(self.friction_law).__name__, "values": self.friction_law.value()}}

    def hidden_history(self) -> Tuple[str, ...]:
        kept = dict(frictions())
        return tuple(name for name in kept["AnyFriction"] if name not in kept[type(self.friction_law).__name__])
