"""Compares the runs of two builds that compare.sh made in turns: compare.py FOLDER FACTOR. Exit code 1 if any is slower,
2 if the runs cannot be used."""

import statistics
import sys
from pathlib import Path

import results


def main(folder, factor):
    rounds = len(list(Path(folder).glob("a.*.json")))
    pairs = [[results.read([Path(folder) / f"{which}.{k}.json"]) for which in "ab"] for k in range(rounds)]
    names = [name for name in pairs[0][0] if all(name in run for pair in pairs for run in pair)]
    if not names:
        raise ValueError("the builds have no benchmark in common")
    width = max(len(name) for name in names)
    print(f"{'':{width}}   before      after       after/before   of each round")
    slower = []
    for name in names:
        a, b = ([statistics.median(pair[which][name].ns) / 1e6 for pair in pairs] for which in (0, 1))
        ratio = statistics.median(b) / statistics.median(a)
        each = sorted(y / x for x, y in zip(a, b))
        mark = "  SLOWER" if ratio > factor else ""
        print(
            f"{name:{width}} {statistics.median(a):9.4f} ms {statistics.median(b):9.4f} ms"
            f" {ratio:9.3f}      {each[0]:6.3f} .. {each[-1]:.3f}{mark}"
        )
        if ratio > factor:
            slower.append(name)
    if slower:
        print(f"\n{len(slower)} of {len(names)} slower than {factor:g} times", file=sys.stderr)
        return 1
    print(f"\nnone of {len(names)} slower than {factor:g} times")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1], float(sys.argv[2])))
    except ValueError as e:
        print(f"benchmarks/compare.py: {e}", file=sys.stderr)
        sys.exit(2)
