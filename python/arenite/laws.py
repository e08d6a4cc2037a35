"""Constitutive laws. SI units, angles in radians, tension positive; what is not given must be."""

from __future__ import annotations

import dataclasses
import enum
import warnings
from dataclasses import dataclass, field
from typing import Any, Dict, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import frictions
from ._errors import Error
from ._recipe import Recipe, check_together

NOT_GIVEN = float("nan")


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


@dataclass(frozen=True)
class LinearElastic(Law):
    """Hooke's law with the Jaumann rate, for small elastic strains and any rotation.

    parameter  unit   range      default  meaning
    density    kg/m3  > 0        needed
    young      Pa     > 0        needed   Young's modulus
    poisson    -      (-1, 0.5)  needed   Poisson's ratio"""

    density: float = NOT_GIVEN
    young: float = NOT_GIVEN
    poisson: float = NOT_GIVEN


# --- policies of the frictional laws


class Policy(Recipe):
    pass


@dataclass(frozen=True)
class ForgetsOpening(Policy):
    """Separated matter bears stress as soon as it is compressed again."""


@dataclass(frozen=True)
class RemembersOpening(Policy):
    """Separated matter bears no stress until what it had opened is closed.

    parameter  unit  range  default  meaning
    limit      -     > 0    1.0      greatest opening that is remembered, a volumetric strain"""

    limit: float = 1.0


@dataclass(frozen=True)
class ConstantFriction(Policy):
    """The angle of the law's parameters."""


@dataclass(frozen=True)
class LinearRateFriction(Policy):
    """tan(phi) + time x shear rate: a regulariser, no property of sand.

    parameter  unit  range  default  meaning
    time       s     >= 0   0.001    slope of tan(phi) over the shear rate
    smoothing  s     >= 0   0.0      time over which the rate is smoothed"""

    time: float = 1e-3
    smoothing: float = 0.0


@dataclass(frozen=True)
class InertialFriction(Policy):
    """mu(I) rheology (Jop, Forterre and Pouliquen 2006).

    parameter          unit   range  default  meaning
    rise               -      >= 0   0.261    mu_2 - mu_s
    reference_inertia  -      > 0    0.279    I_0
    grain_size         m      > 0    0.00053
    grain_density      kg/m3  > 0    2450.0
    smoothing          s      >= 0   0.0      time over which the rate is smoothed"""

    rise: float = 0.261
    reference_inertia: float = 0.279
    grain_size: float = 0.53e-3
    grain_density: float = 2450.0
    smoothing: float = 0.0


@dataclass(frozen=True)
class LogarithmicFriction(Policy):
    """phi (1 + a log10(rate / reference)) (Zambrano-Cruzatty and Yerro 2020).

    parameter       unit  range  default  meaning
    per_decade      -     >= 0   0.027    a
    reference_rate  1/s   > 0    2.1e-05
    smoothing       s     >= 0   0.0      time over which the rate is smoothed"""

    per_decade: float = 0.027
    reference_rate: float = 2.1e-5
    smoothing: float = 0.0


@dataclass(frozen=True)
class SofteningFriction(Policy):
    """Friction and dilatancy fall from the law's to residual ones with the plastic strain, as exp(-decay eps_p).

    parameter           unit  range                   default  meaning
    residual_friction   rad   (0, 1.55]               needed   at most the law's friction
    residual_dilatancy  rad   [0, residual_friction]  0.0      at most the law's dilatancy
    decay               -     >= 0                    needed   per unit of plastic strain
    cell_size           m     >= 0                    0.0      with reference_size it scales the decay
    reference_size      m     >= 0                    0.0"""

    residual_friction: float = NOT_GIVEN
    residual_dilatancy: float = 0.0
    decay: float = NOT_GIVEN
    cell_size: float = 0.0
    reference_size: float = 0.0


@dataclass(frozen=True)
class RateSofteningFriction(Policy):
    """Softening between peak and residual angles, of which the peak ones grow with the shear rate (Zambrano-Cruzatty
    and Yerro 2020).

    parameter             unit  range                default  meaning
    softening             -     `SofteningFriction`  needed
    friction_per_decade   -     >= 0                 0.027    a of phi
    dilatancy_per_decade  -     >= 0                 0.27     a of psi
    reference_rate        1/s   > 0                  2.1e-05
    smoothing             s     >= 0                 0.0      time over which the rate is smoothed"""

    softening: SofteningFriction = field(default_factory=SofteningFriction)
    friction_per_decade: float = 0.027
    dilatancy_per_decade: float = 0.27
    reference_rate: float = 2.1e-5
    smoothing: float = 0.0


def AnyFriction(policy: Policy) -> Policy:
    """Deprecated: any friction is chosen at run time. Give the law the friction itself."""
    warnings.warn("AnyFriction(policy) is policy: each friction is chosen at run time", DeprecationWarning, stacklevel=2)
    return policy


@dataclass(frozen=True)
class ConstantStiffness(Policy):
    """The moduli of the law's parameters."""


@dataclass(frozen=True)
class PressureStiffness(Policy):
    """E = E_ref (p / p_ref)^n of the mean pressure (Ohde 1939, Janbu 1963).

    parameter           unit  range   default   meaning
    exponent            -     [0, 1]  0.5       n
    reference_pressure  Pa    > 0     100000.0  p_ref
    lowest_pressure     Pa    > 0     1000.0    below it the modulus is that of it"""

    exponent: float = 0.5
    reference_pressure: float = 100e3
    lowest_pressure: float = 1e3


@dataclass(frozen=True)
class RateStiffness(Policy):
    """The shear modulus grows with the shear rate and falls with the plastic strain, of which `RateSofteningFriction`
    keeps account (Zambrano-Cruzatty and Yerro 2020).

    parameter       unit  range                default               meaning
    per_decade      -     >= 0                 0.102                 growth of G
    reference_rate  1/s   > 0                  2.1e-05
    residual        -     (0, 1]               1.0                   G_r / G_p
    decay           -     >= 0                 0.0                   per unit of plastic strain
    pressure        -     `PressureStiffness`  PressureStiffness(0)  of which it is a factor"""

    per_decade: float = 0.102
    reference_rate: float = 2.1e-5
    residual: float = 1.0
    decay: float = 0.0
    pressure: PressureStiffness = field(default_factory=lambda: PressureStiffness(exponent=0.0))


class Cone(enum.IntEnum):
    """Where the cone of Drucker-Prager meets the pyramid of Mohr-Coulomb."""

    compression = 0  #: at the edges of triaxial compression
    extension = 1  #: at the edges of triaxial extension
    plane_strain = 2  #: in plastic flow in plane strain, for the given dilatancy


@dataclass(frozen=True)
class _Frictional(Law):
    density: float = NOT_GIVEN
    young: float = NOT_GIVEN
    poisson: float = NOT_GIVEN
    friction: float = NOT_GIVEN
    cohesion: float = 0.0
    dilatancy: float = 0.0
    greatest_volume_ratio: float = 1.5
    tension: float = float("inf")
    memory: Policy = field(default_factory=ForgetsOpening)
    friction_law: Policy = field(default_factory=ConstantFriction)
    stiffness_law: Policy = field(default_factory=ConstantStiffness)

    def cpp(self) -> str:
        stiffness = self.stiffness_law.cpp()
        return self.rules() if stiffness == "ConstantStiffness" else f"{self.rules()[:-1]}, {stiffness}>"

    def value(self) -> Any:
        return {**super().value(), "friction_law": {"policy": type(self.friction_law).__name__, "values": self.friction_law.value()}}

    def hidden_history(self) -> Tuple[str, ...]:
        kept = dict(frictions())
        return tuple(name for name in kept["AnyFriction"] if name not in kept[type(self.friction_law).__name__])

    def __post_init__(self) -> None:
        super().__post_init__()
        check_together(type(self.stiffness_law).__name__, type(self.friction_law).__name__)

    def rules(self) -> str:
        return f"{type(self).__name__}<{self.memory.cpp()}, AnyFriction>"


@dataclass(frozen=True)
class MohrCoulomb(_Frictional):
    """Mohr-Coulomb plasticity, perfectly plastic, with dilatancy and a cut-off of the greatest principal stress.

    parameter              unit   range                default            meaning
    density                kg/m3  > 0                  needed
    young                  Pa     > 0                  needed             Young's modulus
    poisson                -      (-1, 0.5)            needed             Poisson's ratio
    friction               rad    [0, 1.55]            needed             angle of friction; 0: Tresca
    cohesion               Pa     >= 0                 0.0                positive where friction is 0
    dilatancy              rad    [0, friction]        0.0                angle of dilatancy
    greatest_volume_ratio  -      >= 1                 1.5                V / V0 beyond which it dilates no further
    tension                Pa     >= 0                 inf                cut-off of the tension; infinity: at the apex
    memory                 -      a memory of opening  ForgetsOpening
    friction_law           -      a friction           ConstantFriction   by point
    stiffness_law          -      a stiffness          ConstantStiffness  by point"""


@dataclass(frozen=True)
class DruckerPrager(_Frictional):
    """Drucker-Prager plasticity, matched to Mohr-Coulomb as `cone` says, with a cut-off of the mean stress.

    parameter              unit   range                default            meaning
    density                kg/m3  > 0                  needed
    young                  Pa     > 0                  needed             Young's modulus
    poisson                -      (-1, 0.5)            needed             Poisson's ratio
    friction               rad    [0, 1.55]            needed             angle of friction; 0: Tresca
    cohesion               Pa     >= 0                 0.0                positive where friction is 0
    dilatancy              rad    [0, friction]        0.0                angle of dilatancy
    greatest_volume_ratio  -      >= 1                 1.5                V / V0 beyond which it dilates no further
    tension                Pa     >= 0                 inf                cut-off of the tension; infinity: at the apex
    memory                 -      a memory of opening  ForgetsOpening
    friction_law           -      a friction           ConstantFriction   by point
    stiffness_law          -      a stiffness          ConstantStiffness  by point
    cone                   -      a `Cone`             Cone.compression"""

    cone: Cone = Cone.compression

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

    def __repr__(self) -> str:
        return f"{self.name}({', '.join(f'{k}={v!r}' for k, v in self.parameters.items())})"


__all__ = ["AnyFriction", "Cone", "ConstantFriction", "ConstantStiffness", "DruckerPrager", "ForgetsOpening", "InertialFriction", "Law",
           "LinearElastic", "LinearRateFriction", "LogarithmicFriction", "MohrCoulomb", "OwnLaw", "PressureStiffness",
           "RateSofteningFriction", "RateStiffness", "RemembersOpening", "SofteningFriction", "Updated",
           "WithDeviatoricStrain"]
