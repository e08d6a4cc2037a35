"""Many cases, some at a time: what the sweeps of any function and those of the penetrometer share."""

from __future__ import annotations

import errno
import itertools
import os
import re
import warnings
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Callable, Dict, Iterable, Iterator, List, Mapping, Optional, Set, TypeVar, Union

import numpy as np

from ._errors import Error, Warning

T = TypeVar("T")


def processors() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def checked_jobs(jobs: Any) -> int:
    if isinstance(jobs, bool) or not isinstance(jobs, (int, np.integer)) or jobs < 1:
        raise Error(f"jobs = {jobs!r}: must be a whole number of at least 1")
    return int(jobs)


def several(name: str, value: object) -> Optional[List[Any]]:
    """What is given as several values (a range, list, tuple, array ..), as a list; None of one value."""
    if isinstance(value, (str, bytes, os.PathLike, Mapping)) or not isinstance(value, Iterable) or getattr(value, "ndim", 1) == 0:
        return None
    if isinstance(value, (set, frozenset)):
        raise Error(f"{name} = {value!r}: has no order by which cases can be numbered: give a list, sorted(..)")
    if hasattr(value, "itertuples"):
        raise Error(f"{name}: is a table, whose names would be lost: give the values of one column, or the table as all values of a sweep")
    values = [one.item() if isinstance(one, np.generic) else one for one in value]
    if not values:
        raise Error(f"{name} = {value!r}: needs at least one value")
    return values


def combinations(swept: Mapping[str, List[Any]]) -> List[Dict[str, Any]]:
    """Every combination of the values, by their names; the last one changes fastest. Names with a comma, "friction, cell", have values that go
    together, [(0.5, 0.01), ..]."""
    groups = []
    for names, values in swept.items():
        each = [name.strip() for name in names.split(",")]
        if len(each) == 1:
            groups.append([{names: value} for value in values])
            continue
        for value in values:
            if isinstance(value, (str, bytes)) or not isinstance(value, Iterable) or len(list(value)) != len(each):
                raise Error(f"{names} = {value!r}: must be {len(each)} values")
        groups.append([dict(zip(each, value)) for value in values])
    named = [name for group in groups for name in group[0]]
    if len(set(named)) < len(named):
        raise Error(f"{', '.join(named)}: each name must stand there once")
    return [{name: value for part in parts for name, value in part.items()} for parts in itertools.product(*groups)]


Cases = Union[None, str, int, Iterable[int]]


def chosen_cases(cases: Cases, count: int, keeps: bool) -> List[bool]:
    """Which of so many cases a sweep is to run, of its argument `cases`: "3", "0-9", "0-4,7", "none", "all", or whole numbers; None: the
    environment's ARENITE_CASES, or all. `keeps`: whether results stay on disk."""
    told = "cases"
    if cases is None:
        told, cases = "ARENITE_CASES", os.environ.get("ARENITE_CASES") or "all"
    rule = "must be none, all, or numbers of cases and ranges of them, such as 0-9,12"
    if cases == "all":
        return [True] * count
    numbers: List[int] = []
    if isinstance(cases, str):
        for word in [] if cases == "none" else cases.split(","):
            found = re.fullmatch(r" *(\d+)(?:-(\d+))? *", word)
            if not found:
                raise Error(f"{told} = {cases}: {rule}")
            begin, last = int(found[1]), int(found[2] or found[1])
            if last < begin:
                raise Error(f"{told} = {word.strip()}: must rise")
            numbers += range(begin, min(last, max(begin, count)) + 1)
    else:
        given: List[Any] = list(cases) if isinstance(cases, Iterable) and not isinstance(cases, bytes) else [cases]
        for k in given:
            if isinstance(k, bool) or not isinstance(k, (int, np.integer)):
                raise Error(f"{told} = {cases!r}: {rule}")
            numbers.append(int(k))
    for k in numbers:
        if not 0 <= k < count:
            raise Error(f"{told} = {k}: the sweep has the cases 0 to {count - 1}")
    if not keeps:
        raise Error(f"{told} = {cases}: needs a folder, `out`, where the other cases' results lie")
    return [k in set(numbers) for k in range(count)]


@contextmanager
def alone(path: Path, wait: bool = False) -> Iterator[bool]:
    """Holds the lock of a file; False if another process has it, for which it may wait. The system frees it when a process ends, however
    that is. Warns where a disk has no locks."""
    try:
        import fcntl
    except ImportError:  # a system without
        yield True
        return
    while True:
        with open(path, "w") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
            except OSError as problem:
                if problem.errno in (errno.EWOULDBLOCK, errno.EAGAIN, errno.EACCES):
                    yield False
                    return
                _warn_unlocked(path.parent, problem)
            if os.fstat(file.fileno()).st_nlink == 0:  # who held it has removed it meanwhile
                continue
            yield True
            with suppress(FileNotFoundError):
                path.unlink()
            return


_unlocked: Set[Path] = set()


def _warn_unlocked(folder: Path, problem: OSError) -> None:
    if folder not in _unlocked:
        _unlocked.add(folder)
        warnings.warn(Warning(f"{folder}: cannot be locked ({problem.strerror}); nothing else must write there meanwhile"), stacklevel=2)


def run_cases(run: Callable[[int], T], count: int, jobs: int, stop: Callable[[], None], kill: Callable[[], None],
              tell: Callable[[int, int, T], None]) -> List[T]:
    """Calls run(k) for k = 0 .. count - 1, `jobs` at a time in threads, and tell(ended so far, k, result) as each ends. What ends it
    early, such as Ctrl-C, calls stop(), which makes those that run end, and kill() if it comes once more meanwhile."""
    pool = ThreadPoolExecutor(jobs)
    results: Dict[int, T] = {}
    try:
        futures = {pool.submit(run, k): k for k in range(count)}
        for future in as_completed(futures):
            results[futures[future]] = future.result()
            tell(len(results), futures[future], future.result())
    except BaseException:
        stop()
        try:
            pool.shutdown(wait=True, cancel_futures=True)
        except BaseException:
            kill()
            raise
        raise
    pool.shutdown()
    return [results[k] for k in range(count)]
