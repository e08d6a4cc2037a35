"""Numerics: shape functions, transfer, order of the stress update, anti-locking."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Type, Union

from ._recipe import Recipe


class _Kind(Recipe):
    pass


@dataclass(frozen=True)
class QuadraticBSpline(_Kind):
    pass


@dataclass(frozen=True)
class CubicBSpline(_Kind):
    pass


@dataclass(frozen=True)
class LinearGrid(_Kind):
    pass


@dataclass(frozen=True)
class UGimp(_Kind):
    """Uniform GIMP (Bardenhagen and Kober 2004), of bodies with so many points along each axis of a cell at first."""

    points: int = 2

    def cpp(self) -> str:
        return f"UGimp<{self.points}>"


@dataclass(frozen=True)
class LinearSimplex(_Kind):
    pass


@dataclass(frozen=True)
class Flip(_Kind):
    """PIC and FLIP in any blend; with a time the fraction of a step dt is fraction exp(-dt / time)."""

    fraction: float = 1.0  #: 0 (PIC) to 1 (FLIP)
    time: float = float("inf")  #: s


@dataclass(frozen=True)
class Apic(_Kind):
    """Affine particle-in-cell (Jiang et al. 2015); for B-splines."""


@dataclass(frozen=True)
class Tpic(_Kind):
    """Taylor particle-in-cell; for linear simplices."""


@dataclass(frozen=True)
class Aflip(_Kind):
    fraction: float = 1.0


@dataclass(frozen=True)
class Fmpm(_Kind):
    order: float = 2.0
    time: float = 0.0  #: s


@dataclass(frozen=True)
class Xpic(_Kind):
    order: float = 2.0
    time: float = 0.0  #: s


@dataclass(frozen=True)
class Musl(_Kind):
    pass


@dataclass(frozen=True)
class Usl(_Kind):
    pass


@dataclass(frozen=True)
class Usf(_Kind):
    pass


@dataclass(frozen=True)
class NoAntiLocking(_Kind):
    pass


@dataclass(frozen=True)
class NodalAveraging(_Kind):
    """Volumetric strains averaged over nodes; for linear simplices."""


@dataclass(frozen=True)
class ElementAverage(_Kind):
    """Mean stress in filled cells; for linear simplices."""

    fill: float = 0.5


@dataclass(frozen=True)
class NodalAndElementAverage(_Kind):
    fill: float = 0.5


_Given = Union[_Kind, Type[_Kind]]


def _made(given: _Given) -> _Kind:
    return given() if isinstance(given, type) else given


class Numerics(Recipe):
    """`Numerics(QuadraticBSpline, Apic)`: kinds as classes, or as values with parameters, `Flip(0.99)`."""

    def __init__(self, shape: _Given, transfer: _Given = Flip, order: _Given = Musl,
                 anti_locking: _Given = NoAntiLocking) -> None:
        self.shape, self.transfer = _made(shape), _made(transfer)
        self.order, self.anti_locking = _made(order), _made(anti_locking)

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
