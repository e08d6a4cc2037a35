"""Numerics: shape functions, transfer, order of the stress update, anti-locking."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Type, Union

from . import _recipes
from ._bases import Kind as _Kind
from ._errors import Error
from ._recipe import Recipe, check_together
from ._recipes import (Aflip, Apic, CubicBSpline, ElementAverage, Flip, Fmpm, LinearGrid, LinearSimplex, Musl, NoAntiLocking,
                       NodalAndElementAverage, NodalAveraging, QuadraticBSpline, Tpic, Usf, Usl, Xpic)


class UGimp(_recipes.UGimp):
    def cpp(self) -> str:
        return f"UGimp<{self.points}>"


_Given = Union[_Kind, Type[_Kind]]


def _made(given: _Given) -> _Kind:
    return given() if isinstance(given, type) else given


@dataclass(frozen=True)
class MlsGradient(_Kind):
    """The values of a spline with gradients of moving least squares, as in MLS-MPM (Hu et al. 2018): cheapest with Apic and Usl.

    parameter  unit  range                             default
    spline     -     QuadraticBSpline or CubicBSpline  QuadraticBSpline"""

    spline: _Given = QuadraticBSpline

    def __post_init__(self) -> None:
        if not isinstance(_made(self.spline), (QuadraticBSpline, CubicBSpline)):
            raise Error(f"MlsGradient.spline = {self.spline}: must be QuadraticBSpline or CubicBSpline")
        super().__post_init__()

    def cpp(self) -> str:
        return f"MlsGradient<{_made(self.spline).cpp()}>"


@dataclass(frozen=True)
class MidpointStrain(_Kind):
    """An order of the stress update with the strain at the middle of the step's motion: a body that turns does not swell with each step.

    parameter  unit  range            default
    order      -     Musl, Usl, Usf   Usl"""

    order: _Given = Usl

    def __post_init__(self) -> None:
        if not isinstance(_made(self.order), (Musl, Usl, Usf)):
            raise Error(f"MidpointStrain.order = {self.order}: must be Musl, Usl or Usf")
        super().__post_init__()

    def cpp(self) -> str:
        return f"MidpointStrain<{_made(self.order).cpp()}>"


class Numerics(Recipe):
    """`Numerics(QuadraticBSpline, Apic)`: kinds as classes, or as values with parameters, `Flip(0.99)`.

    parameter     unit  range                                default        meaning
    shape         -     a shape function                     needed
    transfer      -     a transfer                           Flip
    order         -     Musl, Usl, Usf, or `MidpointStrain`  Musl           of the stress update
    anti_locking  -     an average                           NoAntiLocking"""

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
        order = _made(self.order.order) if isinstance(self.order, MidpointStrain) else self.order
        return [type(k).__name__ for k in (self.shape, self.transfer, order, self.anti_locking)]

    def cpp(self) -> str:
        kinds = [k.cpp() for k in (self.shape, self.transfer, self.order, self.anti_locking)]
        usual = ["", "Flip", "Musl", "NoAntiLocking"]
        while kinds[-1] == usual[len(kinds) - 1]:
            kinds.pop()
        return f"Numerics<{', '.join(kinds)}>"

    def value(self) -> Any:
        return {"transfer": self.transfer.value(), "anti_locking": self.anti_locking.value()}


__all__ = ["Aflip", "Apic", "CubicBSpline", "ElementAverage", "Flip", "Fmpm", "LinearGrid", "LinearSimplex", "MidpointStrain",
           "MlsGradient", "Musl", "NoAntiLocking", "NodalAndElementAverage", "NodalAveraging", "Numerics", "QuadraticBSpline", "Tpic", "UGimp", "Usf",
           "Usl", "Xpic"]
