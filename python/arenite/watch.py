"""What looks at a run: a watch that stops one that goes wrong, and how far it is."""

from __future__ import annotations

import math
import sys
import time
from typing import Any, NamedTuple, Optional, TextIO, Tuple

from ._recipes import Watch


class Watched(NamedTuple):
    """What a watch saw of a quantity (`meaning`): its `limit`, its greatest value (`worst`) and at which `time`, s, in which body (-1: the whole scene) and at which `place`, m;
    `warned`: whether it was told."""

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
