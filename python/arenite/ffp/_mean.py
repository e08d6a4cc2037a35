"""The centred mean that peaks of the deceleration are read from."""

from __future__ import annotations

import numpy
from numpy.typing import NDArray

__all__ = ["WINDOW", "moving_mean"]

WINDOW = 2e-3  #: s; that of a summary's peaks


def moving_mean(time: NDArray[numpy.float64], value: NDArray[numpy.float64], window: float = WINDOW) -> NDArray[numpy.float64]:
    """Mean [n] over `window` s around each time [n] s, ascending, of a history whose value [n] holds since the row before; exact for
    uneven steps. At both ends over the part of the window that there is."""
    if len(time) < 2:
        return numpy.array(value)
    integral = numpy.concatenate([[0.0], numpy.cumsum(value[1:] * numpy.diff(time))])
    begin = numpy.maximum(time - window / 2, time[0])
    end = numpy.minimum(time + window / 2, time[-1])
    mean: NDArray[numpy.float64] = (numpy.interp(end, time, integral) - numpy.interp(begin, time, integral)) / (end - begin)
    return mean
