"""What a drop and a measured record have in common for a picture."""

from __future__ import annotations

from typing import NamedTuple

import numpy
from numpy.typing import NDArray

__all__ = ["Curve"]


class Curve(NamedTuple):
    """Motion of a penetrometer since the impact; arrays [n], deceleration net and positive when it slows the penetrometer."""

    name: str
    time: NDArray[numpy.float64]  #: s
    depth: NDArray[numpy.float64]  #: m
    deceleration: NDArray[numpy.float64]  #: g
    mean: NDArray[numpy.float64]  #: g, over 2 ms or the window of a reduction
