"""Many drops: every combination of the options that are given as several values."""

from __future__ import annotations

import hashlib
import itertools
import re
import sys
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional

from .._cases import Cases, checked_jobs, chosen_cases, combinations, processors, run_cases, several
from .._errors import Error, RunError
from .._folder import Folder, PathLike
from ._columns import Columns
from ._driver import Runs, program
from ._drop import Drop, run_drop
from ._table import Table
from ._text import keywords, quantity
from ._words import text_of

__all__ = ["sweep"]

RESULTS = ("final_penetration_m", "max_penetration_m", "max_penetration_time_s", "peak_deceleration_g", "peak_time_s",
           "peak_penetration_m", "second_peak_deceleration_g", "second_peak_time_s", "second_peak_penetration_m",
           "raw_peak_deceleration_g", "peak_reaction_N", "energy_transfer", "energy_walls", "energy_residual",
           "steps", "wall_s")
BARS = ("final_penetration_m", "peak_deceleration_g")
HOW = ("threads", "resume", "force", "checkpoint_every")  # options that change nothing in the result


def sweep(jobs: int = 1, out: Optional[PathLike] = None, *, quiet: bool = True, cases: Cases = None, **options: object) -> Table:
    """Runs a drop for every combination of the options that are given as several values (a range, list, tuple, array ..): `sweep(delta=
    range(20, 41, 4), tip=["cone", "blunt"])` runs twelve. Units, limits and meaning of each option are those of `drop`.

    jobs     drops that run at once, each on the processors' share of threads unless `threads` is given
    out      folder that gets a folder a drop, named by its options. Drops that are finished there are read, not run again, so that the same
             call goes on with an interrupted sweep. Without, temporary folders that go with the result
    quiet    False: a line a drop as it ends, on standard error
    cases    which drops to run here, by the number of their row, as in `arenite.sweep`; the others are read where they are done, else "waiting"
    options  of `arenite.ffp.help("drop")`; `fields_every` is 0, no files for ParaView, unless given

    Returns a `Table`, a row a drop: the swept options, "status" ("done", "failed" .., or "refused" if its options cannot be used),
    "failure", results (NaN unless "done"), number of "warnings", "folder". `table.to_pandas()` is the DataFrame, `table.drops` are the
    drops. A drop that fails or is refused does not end the others; raises `Error` if all are refused. Ctrl-C ends all.
    """
    jobs = checked_jobs(jobs)
    given = {"threads": max(1, processors() // jobs), "fields_every": 0, **options}
    swept = {name: values for name, value in options.items() for values in [several(name, value)] if values is not None}
    planned = combinations(swept)
    chosen = chosen_cases(cases, len(planned), out is not None)
    names = folder_names([{**options, **case} for case in planned])
    runs = Runs()

    def run(k: int) -> Drop:
        case, name = planned[k], names[k]
        folder, told = Folder(None if out is None else Path(out) / name), {**options, **case}
        if not chosen[k]:
            try:
                done = Drop(folder, told)
                if done.status == "done":
                    return done
            except Error:
                pass  # not begun
            return UnfinishedDrop(folder, told, "waiting", "")
        try:
            drop = run_drop(runs, folder, {**given, **case}, quiet=True, keeps=out is not None)
        except RunError as problem:
            return UnfinishedDrop(folder, told, "failed", str(problem))
        except Error as problem:
            return UnfinishedDrop(folder, told, "refused", str(problem))
        drop.options = told
        return drop

    program()  # said once, not by every drop
    drops = run_cases(run, len(planned), jobs, runs.stop, runs.kill,
                      lambda ended, k, drop: None if quiet or not chosen[k] else _tell(ended, planned[k], len(planned), drop))
    return table_of(planned, drops)


class UnfinishedDrop(Drop):
    """A drop of a sweep that has no result: what it wrote before it failed, or nothing."""

    def __init__(self, folder: Folder, options: Mapping[str, object], status: str, failure: str) -> None:
        found: Dict[str, Any] = {}
        if status != "refused":
            try:
                super().__init__(folder, options)
                found = self.summary
            except Error:
                pass  # it was killed before it wrote anything
        self._folder, self.options, self._was_told = folder, dict(options), True
        self.history = Columns(folder, "history.csv")
        if found.get("status") in (None, "running", "done"):
            found = {**found, "status": status, "failure": failure}
        self.summary = found


def folder_names(cases: List[Dict[str, Any]]) -> List[str]:
    """A folder's name for each drop, from the options that decide its result; no two are the same."""
    names: List[str] = []
    for case in cases:
        name = ",".join(f"{option}={text_of(value)}" for option, value in sorted(case.items()) if option not in HOW and value is not None)
        name = re.sub(r"[^A-Za-z0-9.,=_+-]", "-", name) or "default"
        if len(name) > 150:
            name = name[:120] + "-" + hashlib.sha256(name.encode()).hexdigest()[:16]
        like = name
        for number in itertools.count(2):
            if name not in names:
                break
            name = f"{like}-{number}"
        names.append(name)
    return names


def table_of(cases: List[Dict[str, Any]], drops: List[Drop]) -> Table:
    """Raises `Error` if all drops were refused."""
    if all(drop.status == "refused" for drop in drops):
        raise Error(drops[0].failure)
    bars = [f"u_{name}" for name in BARS] if any(drop.uncertainty for drop in drops) else []
    rows = []
    for case, drop in zip(cases, drops):
        row: Dict[str, Any] = {**case, "status": drop.status, "failure": drop.failure}
        found = drop.summary if drop.status == "done" else {}
        row.update((name, found.get(name)) for name in RESULTS)
        row.update((bar, (drop.uncertainty or {}).get(bar[2:], {}).get("u")) for bar in bars)
        row.update({"warnings": len(drop.summary.get("warnings", [])), "folder": str(drop.folder)})
        rows.append(row)
    return Table(rows, drops, list(cases[0] if cases else ()), BARS, bars)


def _tell(count: int, case: Dict[str, Any], cases: int, drop: Drop) -> None:
    result = drop.failure if drop.status != "done" else (f"{quantity(drop.summary['final_penetration_m'], 'm')}, "
                                                         f"{quantity(drop.summary['peak_deceleration_g'], 'g')}")
    print(f"{count} of {cases}: {keywords(case) or 'drop'}: {drop.status}, {result}", file=sys.stderr, flush=True)
