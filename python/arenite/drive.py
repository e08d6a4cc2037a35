"""A law without a scene: one point along a path of strains and stresses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ._errors import Error, checks
from ._html import table
from ._recipe import Recipe
from .laws import Law


@dataclass(frozen=True)
class Stage(Recipe):
    """One stage: strains [6] over the stage, -, and where `stresses` is not None the stress at its end, Pa, in place
    of the strain (xx, yy, zz, xy, yz, zx); duration, s; spin over the stage [3], -.

    parameter  unit  range              default          meaning
    strains    -     6 numbers          (0.0,) * 6       over the stage
    stresses   Pa    6 numbers or None  (None,) * 6      at its end, in the strain's place
    duration   s     >= 0               1.0
    steps      -     >= 1               100
    spin       -     3 numbers          (0.0, 0.0, 0.0)  over the stage"""

    strains: Sequence[float] = (0.0,) * 6
    stresses: Sequence[Optional[float]] = (None,) * 6
    duration: float = 1.0
    steps: int = 100
    spin: Sequence[float] = (0.0, 0.0, 0.0)

    def value(self) -> Any:
        return {"components": [{"stress": s is not None, "value": e if s is None else s}
                               for e, s in zip(self.strains, self.stresses)],
                "duration": self.duration, "steps": self.steps, "spin": list(self.spin)}


@dataclass(frozen=True)
class Path:
    """States along a path, the first and one after each step. stress, strain [n, 6]; time, opening, dilation, work
    (J/m3) [n]; history [n, h]."""

    time: NDArray[np.float64]
    stress: NDArray[np.float64]
    strain: NDArray[np.float64]
    history: NDArray[np.float64]
    opening: NDArray[np.float64]
    dilation: NDArray[np.float64]
    work: NDArray[np.float64]

    def __repr__(self) -> str:
        return (f"<Path: {len(self.time)} states, t = {self.time[0]:g} to {self.time[-1]:g} s; at its end p = {self.p[-1]:.6g} Pa, "
                f"q = {self.q[-1]:.6g} Pa>")

    def _repr_html_(self) -> str:
        shown = np.unique(np.linspace(0, len(self.time) - 1, 11).astype(int))
        return table(f"Path: {len(shown)} of {len(self.time)} states", ("time [s]", "p [Pa]", "q [Pa]", "strain (xx, yy, zz, xy, yz, zx)"),
                     ((self.time[k], self.p[k], self.q[k], self.strain[k]) for k in shown))

    @property
    def p(self) -> NDArray[np.float64]:
        """Mean pressure, Pa, compression positive."""
        return np.asarray(-self.stress[:, :3].mean(axis=1))

    @property
    def q(self) -> NDArray[np.float64]:
        """sqrt(3 J2), Pa."""
        deviator = self.stress.copy()
        deviator[:, :3] += self.p[:, None]
        squares = deviator**2
        return np.asarray(np.sqrt(1.5 * (squares[:, :3].sum(axis=1) + 2 * squares[:, 3:].sum(axis=1))))


@dataclass(frozen=True)
class Test:
    """A path of stages from a stress, Pa."""

    stages: Sequence[Stage]
    stress: Sequence[float] = (0.0,) * 6


def triaxial(pressure: float, axial: float, steps: int = 100, duration: float = 1.0) -> Test:
    """Drained triaxial test: from an isotropic pressure, Pa, the axial strain (y) changes by `axial`, - (negative:
    compression), at constant pressure on the sides, in so many steps over a duration, s."""
    return Test([Stage((0, axial, 0, 0, 0, 0), (-pressure, None, -pressure, 0.0, 0.0, 0.0), duration, steps)],
                (-pressure, -pressure, -pressure, 0, 0, 0))


def oedometer(axial: float, pressure: float = 0.0, steps: int = 100, duration: float = 1.0) -> Test:
    """The axial strain (y) changes by `axial`, -, without strain of the sides, from an isotropic pressure, Pa, in so many steps over a duration, s."""
    return Test([Stage((0, axial, 0, 0, 0, 0), duration=duration, steps=steps)],
                (-pressure, -pressure, -pressure, 0, 0, 0))


def simple_shear(pressure: float, gamma: float, steps: int = 100, duration: float = 1.0) -> Test:
    """x moves along y by gamma, -, at constant stress along y, from an isotropic pressure, Pa, in so many steps over a duration, s."""
    return Test([Stage((0, 0, 0, gamma / 2, 0, 0), (None, -pressure, None, None, None, None), duration, steps,
                       (gamma / 2, 0, 0))], (-pressure, -pressure, -pressure, 0, 0, 0))


@checks("test")
def drive(law: Law, test: Union[Test, Stage, Sequence[Stage]], stress: Optional[Sequence[float]] = None,
          history: Sequence[float] = ()) -> Path:
    """Takes one point of a law along a path: test: a `Test`, a `Stage` or several; stress, Pa, and history that it begins with, by default those of the
    test, or none, and of a new point. Raises `RunError` where no strain gives the prescribed stress."""
    stages = [test] if isinstance(test, Stage) else test.stages if isinstance(test, Test) else test
    if not isinstance(stages, (list, tuple)) or not stages or not all(isinstance(stage, Stage) for stage in stages):
        raise Error(f"drive.test = {test!r}: must be a Test, or one or more Stages")
    begin = stress if stress is not None else test.stress if isinstance(test, Test) else (0.0,) * 6
    return Path(**law.native().drive(3, [s.value() for s in stages], list(begin), list(history)))


__all__ = ["Path", "Stage", "Test", "drive", "oedometer", "simple_shear", "triaxial"]
