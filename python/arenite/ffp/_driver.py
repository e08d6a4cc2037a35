"""The program `arenite-ffp`: where it is, and how its commands are run, told apart and stopped."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
from contextlib import suppress
from itertools import takewhile
from pathlib import Path
from typing import List, Mapping, NamedTuple, Set

from .._errors import Error, RunError
from ._units import program_with

__all__ = ["Ending", "Runs", "program", "run"]

NAME = "arenite-ffp"


def program() -> Path:
    """Path of the program: of the environment's ARENITE_FFP, else in the package's folder `bin`, else on PATH. Raises `Error`
    if there is none."""
    given = os.environ.get("ARENITE_FFP")
    if given:
        if not _is_program(Path(given)):
            raise Error(f"ARENITE_FFP = {given}: must be the path of the program {NAME}")
        return Path(given)
    own = _own()
    if _is_program(own):
        return own
    found = shutil.which(NAME)
    if found is None:
        raise Error(f"{NAME}: there is no such program in {own.parent} or on PATH; install the package with pip "
                    f"(nlohmann-json is needed then), which brings it along; or build the program (cmake --build DIR --target {NAME}) and set ARENITE_FFP to its path")
    return Path(found)


def _own() -> Path:
    return Path(__file__).resolve().parent.parent / "bin" / NAME


def _is_program(path: Path) -> bool:
    return path.is_file() and os.access(path, os.X_OK)


class Ending(NamedTuple):
    """How a command ended."""

    code: int  #: its exit code; minus the signal's number if a signal ended it
    said: List[str]  #: lines that it wrote on both of its streams

    @property
    def missing(self) -> List[str]:
        """Units that the program was built without and that this command needs; nothing was run then."""
        found = re.match(r"drops = ([a-z, -]+):", self.sentence) if self.code == 3 else None
        return found.group(1).split(", ") if found else []

    @property
    def sentence(self) -> str:
        """What it said is wrong, without its name in front, with the list below it, if there is one."""
        for at in reversed(range(len(self.said))):
            line = self.said[at]
            if line.startswith(f"{NAME}: ") and not line.startswith(f"{NAME}: warning: "):
                # Who gave keywords has no command line to ask.
                sentence = re.sub(r": no such option of (\w+)$", r"\g<0>; arenite.ffp.help('\1') lists them", line[len(NAME) + 2:])
                return "\n".join([sentence, *takewhile(lambda below: below.startswith("  "), self.said[at + 1:])])
        how = f"by signal {-self.code}" if self.code < 0 else f"with exit code {self.code}"
        return f"{NAME} ended {how} and did not say why"

    def check(self) -> None:
        """Raises `Error` if an option or a file could not be used, and `RunError` if the run came to another end."""
        if self.code in (2, 3):
            raise Error(self.sentence)
        if self.code != 0:
            raise RunError(self.sentence)


class Runs:
    """Commands of the program, run by any number of threads, that are stopped together."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running: Set[subprocess.Popen[str]] = set()
        self._stopped = False

    def run(self, command: Mapping[str, object], quiet: bool = True) -> Ending:
        """Runs a command given as values ({"command": "drop", "options": {"delta": "40"}}) and waits for its end. What it says goes to standard error, too, unless `quiet`. On Ctrl-C it
        is told to stop: a drop finishes its step and its files."""
        started = program()
        ending = self._run(started, command, quiet)
        if ending.missing and started == _own():
            whole = program_with(ending.missing, self._go_on)
            if whole is not None:
                ending = self._run(whole, command, quiet)
        return ending

    def _go_on(self) -> None:
        if self._stopped:
            raise KeyboardInterrupt

    def _run(self, program: Path, command: Mapping[str, object], quiet: bool) -> Ending:
        words = [os.fspath(program), "values"]
        with self._lock:
            self._go_on()
            try:
                # In a session of its own, so that Ctrl-C on the terminal reaches it once, from here.
                process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                           encoding="utf-8", errors="replace", start_new_session=True)
            except OSError as problem:
                raise Error(f"{words[0]}: cannot be run: {problem.strerror}") from None
            self._running.add(process)
        said: List[str] = []
        assert process.stdin is not None and process.stdout is not None
        try:
            with suppress(BrokenPipeError), process.stdin:  # it has ended already: then it says why
                process.stdin.write(json.dumps(command))
            for line in process.stdout:
                said.append(line.rstrip("\n"))
                if not quiet and not line.startswith(f"{NAME}: drops = "):  # who is asked for `missing` says it
                    print(line, end="", file=sys.stderr, flush=True)
            return Ending(process.wait(), said)
        except BaseException:
            _stop(process)
            raise
        finally:
            process.stdout.close()
            with self._lock:
                self._running.discard(process)

    def stop(self) -> None:
        """Tells all that run to stop, and lets no other begin."""
        self._signal(signal.SIGTERM)

    def kill(self) -> None:
        """Ends all at once."""
        self._signal(signal.SIGKILL)

    def _signal(self, number: signal.Signals) -> None:
        with self._lock:
            self._stopped = True
            for process in self._running:
                process.send_signal(number)


def _stop(process: subprocess.Popen[str]) -> None:
    """Tells it to stop and waits until it has; a second Ctrl-C meanwhile ends it at once."""
    process.stdin = None  # is closed, which `communicate` does not expect
    process.send_signal(signal.SIGTERM)  # it may have inherited that SIGINT is ignored
    try:
        process.communicate()  # reads on, so that it cannot wait for a reader
    except BaseException:
        process.kill()
        process.wait()
        raise


def run(command: Mapping[str, object], quiet: bool = True) -> Ending:
    """One command on its own: see `Runs.run`."""
    return Runs().run(command, quiet)
