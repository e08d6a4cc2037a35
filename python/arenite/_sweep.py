"""A function of many values, in processes of their own, whose results stay on disk."""

from __future__ import annotations

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
import warnings
import zipfile
from contextlib import suppress
from pathlib import Path
from typing import Any, Callable, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._cases import Cases, alone, checked_jobs, chosen_cases, combinations, processors, run_cases, several
from ._decides import Decides, code_name, digest, first_difference, short, what_decides
from ._errors import Error, Warning, checks
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
#: Columns of every sweep.
OUTCOME = "status", "failure"


class Case(NamedTuple):
    name: str  #: of its file
    key: str  #: what decides its result, as text
    given: bytes  #: arguments and keywords, pickled


@checks("values", "jobs", "cases", "out")
def sweep(function: Callable[..., Any], values: Union[Iterable[Any], Mapping[str, Iterable[Any]]], jobs: int = 1,
          out: Optional[PathLike] = None, *, quiet: bool = True, cases: Cases = None) -> Sweep:
    """Calls a function with each of many values, `jobs` at a time, each in a process of its own: `sweep(depth, [20, 25, 30])` calls
    `depth(20)` and so on, `sweep(depth, {"friction": [20, 30], "cell": [0.01, 0.02]})` every combination, `depth(friction=20, cell=0.01)`.

    function  of a module or a script, made by `def` at its top level; also a method, a functools.partial or an object of a class of one.
              Returns a number, a text, an array, or lists and mappings of them. Numbers and texts of a mapping become columns, which
              no parameter may have the name of; all that it returned is in `results`. Of pandas a Series or DataFrame is a mapping by its names
    values    one or more values each, or values by the names of parameters, {"friction, cell": [(0.5, 0.01), ..]} for such that go together;
              or a DataFrame: a row a value. Anything that pickle takes. The same value is run once
    jobs      calls at once; scenes in each have the processors' share of threads
    out       folder that gets a file a value as soon as it is done. The same call goes on with a sweep that was interrupted or killed:
              what is done there is read. A folder of another function is refused; so is one of the same with other code, defaults, captured
              values or state, or if functions and classes that it calls or globals that these read have changed since, or versions of installed packages.
              Files and the environment are not looked at. Without, a temporary folder that goes with the result
    quiet     False: a line a value as it ends, on standard error
    cases     which of the values to run here, by the number of their row: "0-9", "3,7", 3, range(10); "none" only collects. None: what the
              environment's ARENITE_CASES says, or all. Jobs of a cluster share a folder `out` so; a value that one of them runs is left to it

    Returns a `Sweep`, a row a value. One that raises, or whose process ends, has the status "failed" and says why under "failure", with
    the traceback in its file NAME.failed.txt; the others go on, and the same call tries it again. Raises `Error` if all fail. Ctrl-C
    ends all. A script calls it under `if __name__ == "__main__":`, as its processes import the script."""
    jobs = checked_jobs(jobs)
    refuse_unpicklable(function, "sweep.function")
    told, called_by_name = _planned(values)
    swept = list(told[0])
    planned = [_case(row, () if called_by_name else tuple(row.values()), row if called_by_name else {}, out is not None) for row in told]
    first: Dict[str, int] = {}  # number of the row by the case, which a value that is given twice shares
    for k, case in enumerate(planned):
        first.setdefault(case.name, k)
    numbers = list(first.values())
    to_run = {case.name for case, here in zip(planned, chosen_cases(cases, len(planned), out is not None)) if here}
    chosen = [case.name in to_run for case in planned]
    folder, decides = Folder(out), _decided(function, out is not None)
    if decides is not None:
        _claim(folder.path, function, decides)
        planned = [case._replace(key=f"{case.key} of {digest(json.dumps(decides))}") for case in planned]
    workers = Workers(function, max(1, processors() // jobs), folder.path, (*swept, *OUTCOME), decides, out is not None)

    def run(of: int) -> Tuple[str, Any]:
        case = planned[numbers[of]]
        found = _stored(folder.path, case)
        if not found and not chosen[numbers[of]]:
            return WAITING, None
        try:
            if not found:
                with alone(folder.path / f"{case.name}.lock") as here:
                    if not here:
                        return RUNNING, None
                    found = _stored(folder.path, case)  # by one that held the lock until now
                    failure = "" if found else workers.run(case)
                    if failure:
                        return failure, None
        except OSError as problem:
            return f"sweep.out = {folder.path}: cannot be used: {problem}", None
        found = found or _stored(folder.path, case)
        return ("", found[0]) if found else (f"{folder.path / case.name}.npz: was changed meanwhile", None)

    def tell(ended: int, of: int, result: Tuple[str, Any]) -> None:
        if not quiet and chosen[numbers[of]]:
            print(f"{ended} of {len(numbers)}: {_words(told[numbers[of]])}: {result[0] or 'done'}", file=sys.stderr, flush=True)

    try:
        each = run_cases(run, len(numbers), jobs, workers.stop, workers.kill, tell)
    finally:
        workers.close()
    ends = dict(zip(first, each))
    ended = [ends[case.name] for case in planned]
    failed = [(row, failure) for row, (failure, _), here in zip(told, ended, chosen) if here and failure and failure not in OPEN]
    if failed and len(failed) == sum(chosen):
        raise Error(f"sweep: each of {len(failed)} values failed; {_words(failed[0][0])}: {failed[0][1]}")
    rows = []
    for row, (failure, result) in zip(told, ended):
        columns = result if isinstance(result, dict) else {"result": result}
        rows.append({**{name: one if _is_plain(one) else short(one) for name, one in row.items()}, "status": failure if failure in OPEN else "failed" if failure else "done",
                     "failure": "" if failure in OPEN else failure, **{name: one for name, one in columns.items() if _is_plain(one) and one is not None}})
    names = dict.fromkeys(name for row in rows for name in row if name not in (*swept, *OUTCOME))
    return Sweep(folder, rows, swept, list(names), [result for _, result in ended])


# --- values, and what is known of them

def _planned(values: Any) -> Tuple[List[Dict[str, Any]], bool]:
    """Rows of values by name, and whether the function is called by these names."""
    by_name = isinstance(values, Mapping) or hasattr(values, "itertuples")
    for name in values if by_name else ():
        if not isinstance(name, str):
            raise Error(f"sweep.values: {name!r}: must be the name of a parameter, a text")
    if isinstance(values, Mapping):
        rows = combinations({name: _listed(f"sweep.values.{name}", given) for name, given in values.items()})
    elif by_name:  # a DataFrame: a row a value
        rows = [dict(zip(values, row)) for row in values.itertuples(index=False, name=None)]
    else:
        label = getattr(values, "name", None) if hasattr(values, "iloc") else None  # of a Series
        rows = [{"value" if label is None else str(label): one} for one in _listed("sweep.values", values)]
    if not rows or not rows[0] or by_name and len(rows[0]) < sum(len(name.split(",")) for name in values):
        raise Error(f"sweep.values = {values!r}: needs at least one value, and each name once")
    for name in set(OUTCOME) & set(rows[0]):
        raise Error(f"sweep.values.{name}: every sweep has a column of that name; name the parameter otherwise")
    return rows, by_name


def _listed(name: str, given: Any) -> List[Any]:
    values = several(name, list(given) if hasattr(given, "__next__") else given)
    if values is None:
        raise Error(f"{name} = {given!r}: must be several values: a list, a range, an array")
    return values


def _is_plain(value: Any) -> bool:
    return value is None or isinstance(value, (bool, int, float, str))


def _words(row: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {short(value)}" for name, value in row.items())


def _case(row: Mapping[str, Any], arguments: Tuple[Any, ...], keywords: Mapping[str, Any], keeps: bool = True) -> Case:
    found = Decides()
    words = []
    for name, value in row.items():
        refuse_unpicklable(value, f"sweep.values.{name}")
        try:
            words.append(f"{name}={found.text(value, f'sweep.values.{name}')}")
        except Error:
            if keeps:
                raise
            words.append(f"{name}={digest(repr(pickle.dumps(value)))}")
    key = ", ".join([*words, *(f"{name}: {part}" for name, part in found.parts.items())])
    readable = ",".join(f"{name}={short(value)}" for name, value in row.items())
    name = re.sub(r"[^A-Za-z0-9.,=_+-]", "-", readable)[:80] + "-" + digest(key)[:12]
    return Case(name, key, pickle.dumps((arguments, dict(keywords))))


def _decided(function: Any, keeps: bool) -> Optional[Dict[str, str]]:
    """What decides the results; None where nothing is kept and that cannot be told."""
    try:
        return what_decides(function)
    except Error:
        if keeps:
            raise
        return None


def _claim(folder: Path, function: Any, decides: Mapping[str, str]) -> None:
    """Makes the folder that of a function. Raises `Error` if it is another one's."""
    path, mine = folder / "sweep.json", {"function": code_name(function), "decides": dict(decides)}
    try:
        folder.mkdir(parents=True, exist_ok=True)
        found = read_json(path) if path.exists() else None
        if found != mine and not any(folder.glob("*.npz")):  # no results, that a claim would be there for
            with alone(folder / "sweep.lock", wait=True), replaced(path) as file:
                json.dump(mine, file)
            return
    except (OSError, ValueError) as problem:
        if isinstance(problem, Error):
            raise
        raise Error(f"sweep.out = {folder}: cannot be used: {problem}") from None
    if found != mine:
        of, then = (found.get("function"), found.get("decides")) if isinstance(found, dict) else (None, None)
        other = first_difference(then, decides) if of == mine["function"] and isinstance(then, dict) else None
        raise Error(f"sweep.out = {folder}: holds results of " + (
            "another function; name another folder, or remove it" if of != mine["function"] else
            "this function as its code was then; name another folder, or remove it" if other in (None, mine["function"]) else
            f"this function, but then with another {other}; name another folder, or remove it; what is to vary is best a parameter"))


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
    if hasattr(value, "iloc"):
        return _plain(_without_frame(value, at), arrays, at)
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise Error(f"{at} = {short(value)}: has masked values, which an array cannot have; return filled(..) of it")
    if hasattr(value, "__array__"):
        array = np.asarray(value)
        if array.dtype.kind in "biufcSU":
            arrays[f"array{len(arrays)}"] = array
            return {"array": f"array{len(arrays) - 1}"}
    raise Error(f"{at} = {short(value)}: must be a number, a text, an array, or lists and mappings of them")


def _without_frame(value: Any, at: str) -> Any:
    """A Series or DataFrame of pandas by its names: a mapping of numbers, texts, arrays and lists."""

    def values(column: Any) -> Any:
        array = column.to_numpy()
        return array.tolist() if array.dtype == object else array

    index = list(value.index)
    plain_index = value.index.name is None and index == list(range(len(index)))
    if hasattr(value, "columns"):
        if plain_index and value.columns.is_unique:
            return {name: values(value[name]) for name in value.columns}
    elif plain_index:
        return values(value) if value.name is None else {value.name: values(value)}
    elif value.index.is_unique and all(isinstance(name, str) for name in index):
        return dict(zip(index, values(value)))
    raise Error(f"{at} = {short(value)}: has an index that would be lost: return reset_index() of it, or its numbers as arrays")


def _whole(value: Any, arrays: Mapping[str, Any]) -> Any:
    if not isinstance(value, dict):
        return value
    (kind, inner), = value.items()
    if kind == "dict":
        return {key: _whole(one, arrays) for key, one in inner.items()}
    return [_whole(one, arrays) for one in inner] if kind == "list" else arrays[inner]


def _store(folder: Path, name: str, key: str, result: Any, taken: Sequence[str]) -> None:
    """`taken`: columns that are not those of results."""
    arrays: Dict[str, Any] = {}
    plain = _plain(result, arrays, "result")
    columns = plain["dict"] if isinstance(plain, dict) and "dict" in plain else {"result": plain}
    for column, one in columns.items():
        if column in taken and one is not None and _is_plain(one):
            raise Error(f"result.{column} = {short(one)}: a column of this sweep has that name; name the result otherwise")
    told = json.dumps({"key": key, "result": plain})
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

    def __init__(self, function: Any, threads: int, folder: Path, taken: Sequence[str], decides: Optional[Mapping[str, str]], keeps: bool) -> None:
        self._folder, self._keeps = folder, keeps
        self._given = pickle.dumps(function), threads, os.fspath(folder), tuple(taken), decides
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
            with suppress(OSError):  # a disk that is full: the row tells the failure
                with replaced(failed) as file:
                    file.write(trace)
        return str(failure)

    def _started(self) -> Tuple[Any, Any]:
        context = multiprocessing.get_context("spawn")  # a fork would share the threads of this process, which are not there
        line, other = context.Pipe()
        process = context.Process(target=_work, args=(other, *self._given))
        with self._lock:
            if self._stopped:
                raise KeyboardInterrupt
            process.start()
            self._all.append((process, line))
        other.close()
        try:
            problem, other_here = line.recv()
        except (EOFError, OSError):
            process.join()
            if self._stopped:
                raise KeyboardInterrupt from None
            raise Error(f"sweep: a process ended {_ending(process.exitcode)} before its first value; a script must call sweep under "
                        "`if __name__ == \"__main__\":`") from None
        if problem:
            raise Error(f"sweep.function: cannot be used in another process: {problem}; make it by `def` at the top level of a module")
        if other_here:
            said = (f"sweep.function: {other_here} is another one in the processes that a sweep starts, which import what they run anew: change it where "
                    "it is imported, or give it as a parameter; if a file was edited, begin Python anew")
            if self._keeps:
                raise Error(said)
            warnings.warn(Warning(said), stacklevel=2)
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


def _work(line: Any, pickled: bytes, threads: int, folder: str, taken: Sequence[str], decides: Optional[Mapping[str, str]]) -> None:
    """In a process: takes values until there are no more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # of the terminal; the first process says when to end
    from ._plugins import set_threads

    set_threads(threads)
    try:
        function = pickle.loads(pickled)
        other = first_difference(what_decides(function), decides) if decides is not None else None
    except Exception as problem:
        line.send((f"{type(problem).__name__}: {problem}", ""))
        return
    line.send(("", other))
    while True:
        try:
            name, key, given = line.recv()
        except EOFError:
            return
        try:
            arguments, keywords = pickle.loads(given)
            _store(Path(folder), name, key, function(*arguments, **keywords), taken)
            ended = ("", "")
        except BaseException as problem:
            said = str(problem)
            ended = (said if isinstance(problem, Error) else f"{type(problem).__name__}{': ' if said else ''}{said}", traceback.format_exc())
        try:
            line.send(ended)
        except OSError:  # the first process has been killed
            return


__all__ = ["Sweep", "sweep"]
