"""Numbers with their units and error bars, as the program words them."""

from __future__ import annotations

import math
from typing import Mapping, Optional

from ._words import text_of

__all__ = ["keywords", "quantity"]


def quantity(value: Optional[float], unit: str, bar: Optional[float] = None) -> str:
    """"0.1864 m"; with an error bar its two digits and the value as far: "0.186 +- 0.033 m". "none" without a value."""
    if value is None or math.isnan(value):
        return "none"
    if bar:
        decimals = min(max(1 - math.floor(math.log10(bar)), 0), 9)
        return f"{value:.{decimals}f} +- {bar:.{decimals}f} {unit}"
    return f"{value:.4g} {unit}"


def keywords(options: Mapping[str, object]) -> str:
    """"delta=20, tip='blunt'": as they were given, numbers without what NumPy adds."""
    return ", ".join(f"{name}={value!r}" if isinstance(value, (str, bool)) else f"{name}={text_of(value)}"
                     for name, value in options.items())
