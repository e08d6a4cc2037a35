"""Reads the JSON of Google Benchmark: the repetitions of each benchmark, under its plain name."""

import json
import re
import statistics
from pathlib import Path


def plain(name):
    """The name as registered, without what Google Benchmark appends (iterations, repeats, kinds of time)."""
    return re.sub(r"/(iterations:\d+|repeats:\d+|min_time:[\d.]+|real_time|manual_time)(?=/|$)", "", name)


class Series:
    """All repetitions of one benchmark."""

    scale = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}

    def __init__(self, name):
        self.name = name
        self.ns = []  # one iteration each, ns
        self.counters = {}

    def add(self, entry):
        self.ns.append(entry["real_time"] * self.scale[entry["time_unit"]])
        for key, value in entry.items():
            if isinstance(value, (int, float)):
                self.counters.setdefault(key, []).append(value)

    def counter(self, key):
        return statistics.median(self.counters[key])

    def has(self, key):
        return key in self.counters

    def per_point(self, value=None):
        """ns a point of the median repetition, or of a given time."""
        return (statistics.median(self.ns) if value is None else value) / self.counter("points")


def read(paths):
    """{plain name: Series} of JSON files; ValueError names a file that cannot be used."""
    found = {}
    for path in paths:
        try:
            entries = json.loads(Path(path).read_text())["benchmarks"]
        except (OSError, KeyError, json.JSONDecodeError) as e:
            raise ValueError(f"{path}: not a result of Google Benchmark ({e})") from e
        for entry in entries:
            if entry.get("run_type", "iteration") == "iteration" and "real_time" in entry:
                name = plain(entry.get("run_name", entry["name"]))
                found.setdefault(name, Series(name)).add(entry)
    return found
