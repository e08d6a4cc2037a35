"""Numerics: shape functions, transfer, order of the stress update, anti-locking."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Type, Union

from ._recipe import Recipe, check_together


class _Kind(Recipe):
    pass


@dataclass(frozen=True)
class QuadraticBSpline(_Kind):
    """Quadratic B-splines on a grid."""


@dataclass(frozen=True)
class CubicBSpline(_Kind):
    """Cubic B-splines on a grid."""


@dataclass(frozen=True)
class LinearGrid(_Kind):
    """Linear functions on a grid."""


@dataclass(frozen=True)
class UGimp(_Kind):
    """Uniform GIMP (Bardenhagen and Kober 2004), of bodies with so many points along each axis of a cell at first.

    parameter  unit  range  default  meaning
    points     -     >= 1   2        along each axis of a cell at first"""

    points: int = 2

    def cpp(self) -> str:
        return f"UGimp<{self.points}>"


@dataclass(frozen=True)
class LinearSimplex(_Kind):
    """Linear functions on triangles or tetrahedra."""


@dataclass(frozen=True)
class Flip(_Kind):
    """PIC and FLIP in any blend; with a time the fraction of a step dt is fraction exp(-dt / time).

    parameter  unit  range   default  meaning
    fraction   -     [0, 1]  1.0      0: PIC, 1: FLIP
    time       s     > 0     inf      time constant of the share; infinity: none"""

    fraction: float = 1.0
    time: float = float("inf")


@dataclass(frozen=True)
class Apic(_Kind):
    """Affine particle-in-cell (Jiang et al. 2015); for B-splines."""


@dataclass(frozen=True)
class Tpic(_Kind):
    """Taylor particle-in-cell; for linear simplices."""


@dataclass(frozen=True)
class Aflip(_Kind):
    """APIC's affine motion with FLIP's share (Fei et al. 2021); for B-splines.

    parameter  unit  range   default  meaning
    fraction   -     [0, 1]  1.0      FLIP share"""

    fraction: float = 1.0


@dataclass(frozen=True)
class Fmpm(_Kind):
    """FMPM of an order: the inverse of the mass matrix in so many terms (Nairn and Hammerquist 2021).

    parameter  unit  range     default  meaning
    order      -     [1, 1e6]  2.0      a whole number
    time       s     >= 0      0.0      time constant; 0: all of it in each step"""

    order: float = 2.0
    time: float = 0.0


@dataclass(frozen=True)
class Xpic(_Kind):
    """XPIC of an order (Hammerquist and Nairn 2017).

    parameter  unit  range     default  meaning
    order      -     [1, 1e6]  2.0      a whole number
    time       s     >= 0      0.0      time constant; 0: all of it in each step"""

    order: float = 2.0
    time: float = 0.0


@dataclass(frozen=True)
class Musl(_Kind):
    """Stresses last, of velocities that the points map back to the nodes."""


@dataclass(frozen=True)
class Usl(_Kind):
    """Stresses last, of the velocities at the nodes."""


@dataclass(frozen=True)
class Usf(_Kind):
    """Stresses first, ahead of the forces."""


@dataclass(frozen=True)
class NoAntiLocking(_Kind):
    """The strain of each point as the shape functions give it."""


@dataclass(frozen=True)
class NodalAveraging(_Kind):
    """Volumetric strains averaged over nodes; for linear simplices."""


@dataclass(frozen=True)
class ElementAverage(_Kind):
    """Mean stress in filled cells; for linear simplices.

    parameter  unit  range  default  meaning
    fill       -     > 0    0.5      a cell counts as filled from this share of its volume on"""

    fill: float = 0.5


@dataclass(frozen=True)
class NodalAndElementAverage(_Kind):
    """Both: volumetric strains averaged over nodes, stresses over filled cells; for linear simplices.

    parameter  unit  range  default  meaning
    fill       -     > 0    0.5      a cell counts as filled from this share of its volume on"""

    fill: float = 0.5


_Given = Union[_Kind, Type[_Kind]]


def _made(given: _Given) -> _Kind:
    return given() if isinstance(given, type) else given


class Numerics(Recipe):
    """`Numerics(QuadraticBSpline, Apic)`: kinds as classes, or as values with parameters, `Flip(0.99)`.

    parameter     unit  range             default        meaning
    shape         -     a shape function  needed
    transfer      -     a transfer        Flip
    order         -     Musl, Usl, Usf    Musl           of the stress update
    anti_locking  -     an average        NoAntiLocking"""

    def __init__(self, shape: _Given, transfer: _Given = Flip, order: _Given = Musl,
                 anti_locking: _Given = NoAntiLocking) -> None:
        self.shape, self.transfer = _made(shape), _made(transfer)
        self.order, self.anti_locking = _made(order), _made(anti_locking)
        kinds = self.kinds()
        check_together(*kinds[:2])
        check_together(*kinds[:3])
        check_together(kinds[0], kinds[3])

    def kinds(self) -> List[str]:
        """Names of shape function, transfer, order and anti-locking."""
        return [type(k).__name__ for k in (self.shape, self.transfer, self.order, self.anti_locking)]

    def cpp(self) -> str:
        kinds = [k.cpp() for k in (self.shape, self.transfer, self.order, self.anti_locking)]
        usual = ["", "Flip", "Musl", "NoAntiLocking"]
        while kinds[-1] == usual[len(kinds) - 1]:
            kinds.pop()
        return f"Numerics<{', '.join(kinds)}>"

    def value(self) -> Any:
        return {"transfer": self.transfer.value(), "anti_locking": self.anti_locking.value()}

    def __repr__(self) -> str:
        return f"Numerics({self.shape!r}, {self.transfer!r}, {self.order!r}, {self.anti_locking!r})"


__all__ = ["Aflip", "Apic", "CubicBSpline", "ElementAverage", "Flip", "Fmpm", "LinearGrid", "LinearSimplex", "Musl",
           "NoAntiLocking", "NodalAndElementAverage", "NodalAveraging", "Numerics", "QuadraticBSpline", "Tpic", "UGimp", "Usf",
           "Usl", "Xpic"]
