"""Many cases, some at a time: what the sweeps of any function and those of the penetrometer share."""

from __future__ import annotations

import itertools
import os
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, TypeVar

import numpy as np

from ._errors import Error

T = TypeVar("T")


def processors() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def checked_jobs(jobs: Any) -> int:
    if isinstance(jobs, bool) or not isinstance(jobs, (int, np.integer)) or jobs < 1:
        raise Error(f"jobs = {jobs}: must be a whole number of at least 1")
    return int(jobs)


def several(name: str, value: object) -> Optional[List[Any]]:
    """What is given as several values (a range, list, tuple, array ..), as a list; None of one value."""
    if isinstance(value, (str, bytes, os.PathLike, Mapping)) or not isinstance(value, Iterable) or getattr(value, "ndim", 1) == 0:
        return None
    values = [one.item() if isinstance(one, np.generic) else one for one in value]
    if not values:
        raise Error(f"{name} = {value!r}: needs at least one value")
    return values


def combinations(swept: Mapping[str, List[Any]]) -> List[Dict[str, Any]]:
    """Every combination of the values, by their names; the last one changes fastest."""
    return [dict(zip(swept, values)) for values in itertools.product(*swept.values())]


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
