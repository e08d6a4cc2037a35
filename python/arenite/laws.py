"""Constitutive laws. SI units, angles in radians, tension positive; what is not given must be."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, Optional, Tuple

from . import _bases, _recipes
from ._bases import Cone, Law, Updated
from ._errors import Error
from ._recipes import (ConstantFriction, ConstantStiffness, ForgetsOpening, InertialFriction, LinearElastic, LinearRateFriction,
                       LogarithmicFriction, MohrCoulomb, PressureStiffness, RateSofteningFriction, RateStiffness, RemembersOpening,
                       SofteningFriction)


class DruckerPrager(_recipes.DruckerPrager):
    def __post_init__(self) -> None:
        if not isinstance(self.cone, Cone):
            raise Error(f"DruckerPrager.cone = {self.cone!r}: must be one of {', '.join(f'Cone.{c.name}' for c in Cone)}")
        super().__post_init__()


@dataclass(frozen=True)
class WithDeviatoricStrain(Law):
    """A law whose points remember the deviator of their strain too, turned with the matter: `deviatoric_strain`.
    dimension: 2 for plane and axisymmetric scenes alone.

    parameter  unit  range  default  meaning
    law        -     a law  needed
    dimension  -     2, 3   3        2: for plane and axisymmetric scenes alone"""

    law: Law
    dimension: int = 3

    def cpp(self) -> str:
        return f"WithDeviatoricStrain<{self.law.cpp()}, {self.dimension}>"

    def header(self) -> Optional[str]:
        return self.law.header()

    def hidden_history(self) -> Tuple[str, ...]:
        return self.law.hidden_history()

    def value(self) -> Any:
        return self.law.value()


@dataclass(frozen=True)
class ByPoint(Law):
    """A law whose constants vary by point: factors in the history, by `fill(.., history={"stiffness": f, ..})` with numbers or
    functions of positions, 1 where none are given. `stiffness`: of Young's modulus; `strength`: of cohesion and tension;
    `friction`, of a frictional law: of tan(friction). The law is elastic, or perfectly plastic with constant friction.

    parameter  unit  range    default  meaning
    law        -     a law    needed"""

    law: Law

    def __post_init__(self) -> None:
        policies = [type(p) for p in (self.law.memory, self.law.friction_law, self.law.stiffness_law)] \
            if isinstance(self.law, _bases.Frictional) else []
        if not isinstance(self.law, LinearElastic) and policies != [ForgetsOpening, ConstantFriction, ConstantStiffness]:
            raise Error(f"ByPoint.law = {self.law!r}: must be elastic or perfectly plastic: LinearElastic, or MohrCoulomb or DruckerPrager "
                        "with constant friction and stiffness, without a memory of opening")
        super().__post_init__()

    def cpp(self) -> str:
        return f"ByPoint<{self.law.cpp().replace('AnyFriction', 'PointFriction')}>"

    def value(self) -> Any:
        value = dict(self.law.value())
        value.pop("friction_law", None)
        return value


@dataclass(frozen=True)
class OwnLaw(Law):
    """A law out of a C++ header, made by `compile`.

    parameter   unit  range           default  meaning
    name        -     a name          needed   the class in C++
    path        -     a file          needed   its header
    parameters  -     values by name  {}"""

    name: str
    path: str
    parameters: Dict[str, Any] = field(default_factory=dict)

    def cpp(self) -> str:
        return "::" + self.name

    def header(self) -> Optional[str]:
        return self.path

    def rules(self) -> str:
        return ""  # its own: they are known when it is compiled

    def value(self) -> Any:
        return dict(self.parameters)


__all__ = ["ByPoint", "Cone", "ConstantFriction", "ConstantStiffness", "DruckerPrager", "ForgetsOpening", "InertialFriction", "Law",
           "LinearElastic", "LinearRateFriction", "LogarithmicFriction", "MohrCoulomb", "OwnLaw", "PressureStiffness",
           "RateSofteningFriction", "RateStiffness", "RemembersOpening", "SofteningFriction", "Updated",
           "WithDeviatoricStrain"]
