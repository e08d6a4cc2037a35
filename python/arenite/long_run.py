"""A long run in a folder of its own: locked, with its status in a file, saved from time to time, resumed with the same bits."""

from __future__ import annotations

import os
import signal
import threading
import time
from typing import Any, Dict, List, Optional, Union

from . import _core
from ._errors import Error, checks
from ._folder import PathLike
from .scene import STOP, Every, Observer, Scene, check_observer, number, observers_of, run
from .watch import Progress, Watch

__all__ = ["run_in_folder"]


class _Stop:
    """SIGINT and SIGTERM, noted while it is entered; a second one of its kind ends the program as ever. In the main thread only."""

    def __init__(self) -> None:
        self.came = False
        self._before: Dict[int, Any] = {}

    def __enter__(self) -> "_Stop":
        if threading.current_thread() is threading.main_thread():
            for number in (signal.SIGINT, signal.SIGTERM):
                if signal.getsignal(number) not in (signal.SIG_IGN, None):
                    self._before[number] = signal.signal(number, self._note)
        return self

    def _note(self, number: int, frame: Any) -> None:
        self.came = True
        signal.signal(number, self._before[number])

    def __exit__(self, *_: Any) -> None:
        for number, before in self._before.items():
            signal.signal(number, before)


class _Status:
    """Writes status.json of a run, at most ten seconds late."""

    def __init__(self, scene: Scene, folder: str, end: float) -> None:
        self._scene, self._end = scene, end
        self._file = os.path.join(folder, "status.json")
        self._started, self._begin, self._written = _core.utc_now(), time.monotonic(), 0.0
        self.resumed_at: List[float] = []

    def write(self, status: str = "running", failure: str = "") -> None:
        self._written = time.monotonic()
        bodies = self._scene.bodies.values()
        _core.write_run_status(self._file, status, failure, self._started, (self._scene.time, self._end, self._written - self._begin),
                               self._scene.step_count, sum(len(b) for b in bodies), sum(b.lost for b in bodies), self.resumed_at)

    def refresh(self) -> None:
        if time.monotonic() - self._written > 10:
            self.write()


@checks("checkpoint_every", "end", "courant", "max_step", "every", "after_step", "watch", "progress")
def run_in_folder(scene: Scene, end: float, folder: PathLike, *, checkpoint_every: float = float("inf"), resume: bool = False,
                  recipe: str = "", courant: float = 0.5, max_step: float = float("inf"),
                  every: Optional[Every] = None, after_step: Optional[Observer] = None,
                  watch: Union[bool, Watch] = True, progress: Union[bool, Progress] = False) -> str:
    """`run` in a folder that no other run may use meanwhile. Saves the scene there (`checkpoint.state`) each `checkpoint_every`,
    s, at the end, and when Ctrl-C or SIGTERM ends the run after a step (in the main thread); with `resume` the same program goes on
    from there with the same bits. It also goes on to a later `end`: with the bits of a run to that from the start unless the last two steps
    before the former `end` were taken, which are shortened to hit it. Without it state and status of an earlier run are removed. `status.json`
    tells how the run stands, at most ten seconds late. `courant`, `max_step`, `every`, `after_step`, `watch` and `progress` are those of `run`. `recipe`: a line on what made the scene; a state is resumed only with the
    same one. Returns "finished", "stopped" (by an observer) or "interrupted". Raises `Error` that names the folder if it cannot be
    used, or the state if it is of another run, which leaves the folder as it was; else what `run` raises, once the status tells it. A `TiledScene` must have all its tiles in one process."""
    scene._refuse_ranks("run_in_folder", "give `run` every={period: lambda scene: scene.save(folder)}")
    end, checkpoint_every = number("run_in_folder.end", end, "s"), number("run_in_folder.checkpoint_every", checkpoint_every, "s")
    observers = observers_of("run_in_folder.every", every)
    after_each = None if after_step is None else check_observer("run_in_folder.after_step", after_step)
    if not checkpoint_every > 0:
        raise Error(f"checkpoint_every = {checkpoint_every:g}: must be positive (s)")
    if not end >= scene.time:
        raise Error(f"end = {end:g}: must not lie before the scene's time {scene.time:g}")
    path = os.fspath(folder)
    if len(scene._pieces()) > 1:
        raise Error(f"run_in_folder: folder = {path}: is held by one process, and this scene is on {len(scene._pieces())} ranks: give `run` a "
                    "function that calls scene.save(..) in `every`, and go on with scene.restore(..)")
    held = _core.RunFolder(path, resume)
    try:
        state = os.path.join(path, "checkpoint.state")
        if not resume:
            scene._remove_saved(state)
        status = _Status(scene, path, end)
        if resume and os.path.exists(state):
            scene.restore(state, recipe)
            status.resumed_at.append(scene.time)

        def save(_: Any = None) -> None:
            scene.save(state, recipe)
            status.write()

        def after(s: Scene) -> Any:
            told = after_each(s) if after_each else None
            status.refresh()
            return STOP if stop.came else told

        if checkpoint_every < float("inf"):
            begin = scene.step_count
            observers.append((checkpoint_every, lambda s: save() if s.step_count > begin else None))  # behind those that it saves after
        with _Stop() as stop:
            try:
                status.write()
                run(scene, end, courant, max_step, observers, after, watch=watch, progress=progress)
                how = "finished" if scene.time >= end else "interrupted" if stop.came else "stopped"
                scene.save(state, recipe)
                status.write(how)
                return how
            except BaseException as e:
                held.free_reserve()
                try:
                    status.write("failed", str(e) or type(e).__name__)
                except Exception:  # what failed first is raised
                    pass
                raise
    finally:
        held.close()
