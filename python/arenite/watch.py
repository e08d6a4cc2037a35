"""What looks at a run: a watch that stops one that goes wrong, and how far it is."""

from __future__ import annotations

import math
import sys
import time
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, TextIO, Tuple

from ._recipe import Recipe


@dataclass(frozen=True)
class Watch(Recipe):
    """Limits of what `run` watches: `Watch(volume=0.2, energy_gain=0.05)`. Past a limit the run stops with `RunError`, past a tenth of
    it comes one `Warning`; infinity switches a quantity off. `scene.watched` tells what was seen of each quantity. The watch that a
    run has of its own, `watch=True`, has an `energy_gain` of 1, a `volume` of 5 and `lost` 1.

    parameter    unit  range  default  meaning
    energy_gain  -     > 0    0.1      energy that nothing put in, over all that was put in
    transfer     -     > 0    1        energy that the transfer took, over all that was put in; needs the energy balance
    residual     -     > 0    0.5      what is left of the energy balance, over all that was put in
    volume       -     > 0    0.5      change of a body's mean volume, V/V0 - 1, voids included
    speed        -     > 0    10       greatest speed of a point over the wave speed of its body
    strength     -     > 0    0.1      how far a stress lies outside its law's yield surface
    lost         -     > 0    0.1      share of a body's points that left the mesh
    every        -     >= 1   100      steps from one look to the next"""

    energy_gain: float = 0.1
    transfer: float = 1
    residual: float = 0.5
    volume: float = 0.5
    speed: float = 10
    strength: float = 0.1
    lost: float = 0.1
    every: int = 100


class Watched(NamedTuple):
    """What a watch saw of a quantity: its greatest value and when, s, in which body (-1: the whole scene) and where, m."""

    meaning: str
    limit: float
    worst: float
    time: float
    body: int
    place: Tuple[float, float, float]
    warned: bool


class Progress:
    """How far a run is: `run(scene, end=1, progress=True)`. Rewrites a line about twice a second on a terminal; elsewhere, as in a
    notebook, writes a line each tenth of the run. stream: by default `sys.stderr`."""

    def __init__(self, stream: Optional[TextIO] = None) -> None:
        self._stream = stream
        self._tenth = 0

    def start(self, now: float, end: float) -> None:
        """At the start of a run from a time until another, s."""
        self._from, self._end, self._tenth = now, end, 0
        self._began = self._shown = time.monotonic()

    def __call__(self, scene: Any, done: bool = False) -> None:
        stream = self._stream or sys.stderr
        terminal, now = stream.isatty(), time.monotonic()
        share = (scene.time - self._from) / (self._end - self._from) if self._end > self._from else 1.0
        if terminal and not done and now - self._shown < 0.5:
            return
        tenth = 10 if share >= 1 else int(10 * share)
        if not terminal and tenth <= self._tenth:
            return
        self._shown, self._tenth = now, tenth
        left = (now - self._began) * (1 - share) / share if share > 0 else 0.0
        stream.write(f"{chr(13) if terminal else ''}{100 * share:5.1f} %  t = {scene.time:.5f} s  step {scene.step_count}  "
                     f"dt = {scene.time_step:.2e} s  {math.ceil(left):d} s left{'   ' if terminal else ''}"
                     f"{chr(10) if done or not terminal else ''}")
        stream.flush()


__all__ = ["Progress", "Watch", "Watched"]
