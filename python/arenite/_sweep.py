"""A function of many values, in processes of their own, whose results stay on disk."""

from __future__ import annotations

import dataclasses
import enum
import functools
import hashlib
import inspect
import io
import json
import multiprocessing
import os
import pickle
import re
import signal
import sys
import threading
import traceback
import zipfile
from contextlib import suppress
from pathlib import Path
from typing import Any, Callable, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._cases import Cases, alone, checked_jobs, chosen_cases, combinations, processors, run_cases, several
from ._errors import Error
from ._files import MOST_TABLE, read_bytes, read_json, replaced
from ._folder import Folder, PathLike
from ._pickle import refuse_unpicklable
from ._rows import Rows


class Sweep(Rows):
    """What `sweep` returns: a row a value, with "status" ("done", "failed", or "waiting" and "running" of cases that this call was not to
    run, or that another process runs) and "failure". `sweep["depth"]` is a column as an array
    [rows], NaN where a number is missing; `to_pandas()` gives the pandas.DataFrame, `plot()` a picture over what was swept."""

    KIND = "value"

    def __init__(self, folder: Folder, rows: Sequence[Dict[str, Any]], swept: Sequence[str], results: Sequence[str],
                 returned: Sequence[Any]) -> None:
        super().__init__(rows, swept, results)
        self._folder = folder
        self.results: Tuple[Any, ...] = tuple(returned)  #: what the function returned, in the order of the rows; None if it failed

    @property
    def folder(self) -> Path:
        """Where the results lie; a temporary folder goes with this object."""
        return self._folder.path


#: Of a case without a result, in the place of a failure: not to be run here; run by another process.
WAITING, RUNNING = OPEN = "waiting", "running"


class Case(NamedTuple):
    name: str  #: of its file
    key: str  #: what decides its result, as text
    given: bytes  #: arguments and keywords, pickled


def sweep(function: Callable[..., Any], values: Union[Iterable[Any], Mapping[str, Iterable[Any]]], jobs: int = 1,
          out: Optional[PathLike] = None, *, quiet: bool = True, cases: Cases = None) -> Sweep:
    """Calls a function with each of many values, `jobs` at a time, each in a process of its own: `sweep(depth, [20, 25, 30])` calls
    `depth(20)` and so on, `sweep(depth, {"friction": [20, 30], "cell": [0.01, 0.02]})` every combination, `depth(friction=20, cell=0.01)`.

    function  of a module or a script, made by `def` at its top level; returns a number, a text, an array, or lists and mappings of
              them. Numbers and texts of a mapping become columns; all that it returned is in `results`
    values    one or more values each, or values by the names of parameters, {"friction, cell": [(0.5, 0.01), ..]} for such that go together;
              anything that pickle takes
    jobs      calls at once; scenes in each have the processors' share of threads
    out       folder that gets a file a value as soon as it is done. The same call goes on with a sweep that was interrupted or killed:
              what is done there is read. A folder of another function, or of one whose code has changed since, is refused; what it
              calls is not looked at. Without, a temporary folder that goes with the result
    quiet     False: a line a value as it ends, on standard error
    cases     which of the values to run here, by the number of their row: "0-9", "3,7", 3, range(10); "none" only collects. None: what the
              environment's ARENITE_CASES says, or all. Jobs of a cluster share a folder `out` so; a value that one of them runs is left to it

    Returns a `Sweep`, a row a value. One that raises, or whose process ends, has the status "failed" and says why under "failure", with
    the traceback in its file NAME.failed.txt; the others go on, and the same call tries it again. Raises `Error` if all fail. Ctrl-C
    ends all. A script calls it under `if __name__ == "__main__":`, as its processes import the script."""
    jobs = checked_jobs(jobs)
    refuse_unpicklable(function, "sweep.function")
    swept = list(values) if isinstance(values, Mapping) else ["value"]
    if isinstance(values, Mapping):
        told = combinations({name: _listed(f"sweep.values.{name}", given) for name, given in values.items()})
        planned = [_case(row, (), row) for row in told]
        swept = list(told[0])
    else:
        told = [{"value": one} for one in _listed("sweep.values", values)]
        planned = [_case(row, tuple(row.values()), {}) for row in told]
    chosen = chosen_cases(cases, len(planned), out is not None)
    folder = Folder(out)
    _claim(folder.path, function)
    workers = Workers(function, max(1, processors() // jobs), folder.path)

    def run(k: int) -> Tuple[str, Any]:
        case = planned[k]
        if not (folder.path / f"{case.name}.npz").exists() or _stored(folder.path, case) is None:
            if not chosen[k]:
                return WAITING, None
            with alone(folder.path / f"{case.name}.lock") as here:
                if not here:
                    return RUNNING, None
                failure = workers.run(case)
            if failure:
                return failure, None
        found = _stored(folder.path, case)
        return ("", found[0]) if found else (f"{folder.path / case.name}.npz: was changed meanwhile", None)

    def tell(ended: int, k: int, result: Tuple[str, Any]) -> None:
        if not quiet and chosen[k]:
            print(f"{ended} of {len(planned)}: {_words(told[k])}: {result[0] or 'done'}", file=sys.stderr, flush=True)

    try:
        ended = run_cases(run, len(planned), jobs, workers.stop, workers.kill, tell)
    finally:
        workers.close()
    failed = [(row, failure) for row, (failure, _), here in zip(told, ended, chosen) if here and failure and failure not in OPEN]
    if failed and len(failed) == sum(chosen):
        raise Error(f"sweep: each of {len(failed)} values failed; {_words(failed[0][0])}: {failed[0][1]}")
    rows = []
    for row, (failure, result) in zip(told, ended):
        columns = result if isinstance(result, dict) else {"result": result}
        rows.append({**{name: one if _is_plain(one) else _short(one) for name, one in row.items()}, "status": failure if failure in OPEN else "failed" if failure else "done",
                     "failure": "" if failure in OPEN else failure, **{name: one for name, one in columns.items() if _is_plain(one) and one is not None}})
    names = dict.fromkeys(name for row in rows for name in row if name not in (*swept, "status", "failure"))
    return Sweep(folder, rows, swept, list(names), [result for _, result in ended])


# --- values, and what is known of them

def _listed(name: str, given: Any) -> List[Any]:
    values = several(name, list(given) if hasattr(given, "__next__") else given)
    if values is None:
        raise Error(f"{name} = {given!r}: must be several values: a list, a range, an array")
    return values


def _is_plain(value: Any) -> bool:
    return value is None or isinstance(value, (bool, int, float, str))


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _words(row: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {_short(value)}" for name, value in row.items())


def _text(value: Any) -> str:
    """A value in words that tell it from others, the same in each process."""
    if isinstance(value, np.generic):
        value = value.item()
    if _is_plain(value) or isinstance(value, (bytes, complex, enum.Enum, range)):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return f"{type(value).__name__}({', '.join(map(_text, value))})"
    if isinstance(value, dict):
        return f"dict({', '.join(f'{_text(key)}: {_text(one)}' for key, one in value.items())})"
    if isinstance(value, np.ndarray) and value.dtype != object:
        return f"array({value.dtype}, {value.shape}, {hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest()})"
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return f"{_name_of(type(value))}({', '.join(f'{f.name}={_text(getattr(value, f.name))}' for f in dataclasses.fields(value))})"
    if callable(value) and hasattr(value, "__qualname__"):
        return _name_of(value)
    return f"{_name_of(type(value))}({hashlib.sha256(pickle.dumps(value, 4)).hexdigest()})"


def _name_of(function: Any) -> str:
    return f"{function.__module__}.{function.__qualname__}"


def _case(row: Mapping[str, Any], arguments: Tuple[Any, ...], keywords: Mapping[str, Any]) -> Case:
    for name, value in row.items():
        refuse_unpicklable(value, f"sweep.values.{name}")
    key = ", ".join(f"{name}={_text(value)}" for name, value in row.items())
    readable = ",".join(f"{name}={_short(value)}" for name, value in row.items())
    name = re.sub(r"[^A-Za-z0-9.,=_+-]", "-", readable)[:80] + "-" + hashlib.sha256(key.encode()).hexdigest()[:12]
    return Case(name, key, pickle.dumps((arguments, dict(keywords))))


def _code_of(function: Any) -> Dict[str, str]:
    """A function's name and the hash of its source, empty where there is none."""
    if isinstance(function, functools.partial):
        inner = _code_of(function.func)
        return {**inner, "function": inner["function"] + _text([list(function.args), function.keywords])}
    if not hasattr(function, "__qualname__"):
        function = type(function)
    try:
        source = inspect.getsource(function)
    except (OSError, TypeError):
        source = ""
    module = "__main__" if function.__module__ == "__mp_main__" else function.__module__
    return {"function": f"{module}.{function.__qualname__}", "source": hashlib.sha256(source.encode()).hexdigest() if source else ""}


def _claim(folder: Path, function: Any) -> None:
    """Makes the folder that of a function. Raises `Error` if it is another one's."""
    path, code = folder / "sweep.json", _code_of(function)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if path.exists():
            found = read_json(path)
            if found != code:
                same = isinstance(found, dict) and found.get("function") == code["function"]
                raise Error(f"sweep.out = {folder}: holds results of {'this function as its code was then' if same else 'another function'}; "
                            "name another folder, or remove it")
            return
        with replaced(path) as file:
            json.dump(code, file)
    except (OSError, ValueError) as problem:
        if isinstance(problem, Error):
            raise
        raise Error(f"sweep.out = {folder}: cannot be used: {problem}") from None


# --- results on disk: JSON, and arrays beside it; never a pickle, which would run what it holds

def _plain(value: Any, arrays: Dict[str, Any], at: str) -> Any:
    if isinstance(value, np.generic) and not isinstance(value, (np.complexfloating, np.void)):
        value = value.item()
    if _is_plain(value):
        return value
    if isinstance(value, dict) and all(isinstance(key, str) for key in value):
        return {"dict": {key: _plain(one, arrays, f"{at}.{key}") for key, one in value.items()}}
    if isinstance(value, (list, tuple)):
        return {"list": [_plain(one, arrays, f"{at}[{k}]") for k, one in enumerate(value)]}
    if hasattr(value, "__array__"):
        array = np.asarray(value)
        if array.dtype.kind in "biufcSU":
            arrays[f"array{len(arrays)}"] = array
            return {"array": f"array{len(arrays) - 1}"}
    raise Error(f"{at} = {_short(value)}: must be a number, a text, an array, or lists and mappings of them")


def _whole(value: Any, arrays: Mapping[str, Any]) -> Any:
    if not isinstance(value, dict):
        return value
    (kind, inner), = value.items()
    if kind == "dict":
        return {key: _whole(one, arrays) for key, one in inner.items()}
    return [_whole(one, arrays) for one in inner] if kind == "list" else arrays[inner]


def _store(folder: Path, name: str, key: str, result: Any) -> None:
    arrays: Dict[str, Any] = {}
    told = json.dumps({"key": key, "result": _plain(result, arrays, "result")})
    with replaced(folder / f"{name}.npz", binary=True) as file:
        np.savez(file, told=np.array(told), **arrays)


def _stored(folder: Path, case: Case) -> Optional[Tuple[Any]]:
    """The result of a case, in a tuple; None if there is none that is whole."""
    try:
        content = read_bytes(folder / f"{case.name}.npz", MOST_TABLE)
        with np.load(io.BytesIO(content), allow_pickle=False) as found:
            told = json.loads(str(found["told"]))
            return (_whole(told["result"], found),) if told["key"] == case.key else None
    except (OSError, EOFError, KeyError, TypeError, zipfile.BadZipFile) as problem:
        if isinstance(problem, PermissionError):
            raise Error(f"sweep.out: {problem}") from None
        return None
    except ValueError as problem:
        if isinstance(problem, Error):
            raise
        return None


# --- processes

class Workers:
    """A process for each thread that asks for one: it calls the function, and stores what that returns."""

    def __init__(self, function: Any, threads: int, folder: Path) -> None:
        self._function, self._threads, self._folder = pickle.dumps(function), threads, folder
        self._lock, self._own = threading.Lock(), threading.local()
        self._all: List[Any] = []
        self._stopped = False

    def run(self, case: Case) -> str:
        """What went wrong; empty if the result is stored."""
        process, line = getattr(self._own, "worker", None) or self._started()
        failed = self._folder / f"{case.name}.failed.txt"
        try:
            line.send((case.name, case.key, case.given))
            failure, trace = line.recv()
        except (EOFError, OSError):
            self._own.worker = None
            process.join()
            if self._stopped:
                raise KeyboardInterrupt from None
            failure = trace = f"its process ended {_ending(process.exitcode)}"
        with suppress(FileNotFoundError):
            failed.unlink()
        if failure:
            with replaced(failed) as file:
                file.write(trace)
        return str(failure)

    def _started(self) -> Tuple[Any, Any]:
        context = multiprocessing.get_context("spawn")  # a fork would share the threads of this process, which are not there
        line, other = context.Pipe()
        process = context.Process(target=_work, args=(other, self._function, self._threads, os.fspath(self._folder)))
        with self._lock:
            if self._stopped:
                raise KeyboardInterrupt
            process.start()
            self._all.append((process, line))
        other.close()
        try:
            problem = line.recv()
        except (EOFError, OSError):
            process.join()
            if self._stopped:
                raise KeyboardInterrupt from None
            raise Error(f"sweep: a process ended {_ending(process.exitcode)} before its first value; a script must call sweep under "
                        "`if __name__ == \"__main__\":`") from None
        if problem:
            raise Error(f"sweep.function: cannot be used in another process: {problem}; make it by `def` at the top level of a module")
        self._own.worker = process, line
        return process, line

    def stop(self) -> None:
        """Ends all, and lets no other begin."""
        self._end(lambda process: process.terminate())

    def kill(self) -> None:
        self._end(lambda process: process.kill())

    def _end(self, how: Callable[[Any], None]) -> None:
        with self._lock:
            self._stopped = True
            for process, _ in self._all:
                how(process)

    def close(self) -> None:
        """Lets all end, which wait for a value."""
        for process, line in self._all:
            line.close()
        for process, _ in self._all:
            process.join()


def _ending(code: Optional[int]) -> str:
    if code is not None and code < 0:
        with suppress(ValueError):
            return f"by signal {-code} ({signal.Signals(-code).name})"
    return f"with exit code {code}"


def _work(line: Any, pickled: bytes, threads: int, folder: str) -> None:
    """In a process: takes values until there are no more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # of the terminal; the first process says when to end
    from ._plugins import set_threads

    set_threads(threads)
    try:
        function = pickle.loads(pickled)
    except Exception as problem:
        line.send(f"{type(problem).__name__}: {problem}")
        return
    line.send("")
    while True:
        try:
            name, key, given = line.recv()
        except EOFError:
            return
        try:
            arguments, keywords = pickle.loads(given)
            _store(Path(folder), name, key, function(*arguments, **keywords))
            ended = ("", "")
        except BaseException as problem:
            said = str(problem)
            ended = (said if isinstance(problem, Error) else f"{type(problem).__name__}{': ' if said else ''}{said}", traceback.format_exc())
        try:
            line.send(ended)
        except OSError:  # the first process has been killed
            return


__all__ = ["Sweep", "sweep"]
