"""The examples in Python, each with the number that it should give."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "python"


# What each program says, the number that a closed form or an experiment has, and how far off it may be; no source: as
# computed once.
EXPECTED = {
    "cantilever": [(r"period (\S+) s", 0.2953, 0.02 * 0.2953)],  # Euler and Bernoulli, without shear
    "discs": [(r"momentum (\S+) of", 0, 1e-12), (r"\[(\S+) ", -0.840, 0.002)],
    "column_collapse": [(r"x = (\S+) m", 0.264, 0.002)],
    "excavation": [(r"(\S+): stands\n.*fails", 3.773, 0.05 * 3.773), (r"(\S+): fails", 3.773, 0.11 * 3.773)],
    "dam_break": [(r"dam (\S+) of", 4 / 9, 0.08 * 4 / 9), (r"flow (\S+) h", 8 / 27, 0.08 * 8 / 27)],
    "block_and_ball": [(r"friction (\S+),", 0.36397, 0.0006), (r"ball m/s2 (\S+),", 3.27, 0.01 * 3.27)],
    "ball_into_sand": [(r"depth (\S+) mm", 38.15, 0.15 * 38.15)],  # Uehara et al. 2003
    "footing": [(r"pressure (\S+) c", 5.1416, 0.02 * 5.1416)],
    "cone": [(r"depth 0.0500 m  force +(\S+) N", 49.0, 1)],
    "tilted": [(r"went (\S+) mm", -36.4, 0.4), (r"gained by (\S+)", 0, 1e-9)],
    "own_law": [(r"sheared by 0.1: (\S+) MPa", 234.091974, 1e-6)],
    "co_simulation": [(r"lies (\S+) m", 0.0323, 0.0005), (r"at (\S+) m/s", 1.037, 0.02)],
    "element_test": [(r"100 kPa: q = +(\S+) kPa", 269.02, 0.01)],
}


def test_each_example_has_a_number():
    assert {p.stem for p in EXAMPLES.glob("*.py")} == set(EXPECTED)


@pytest.mark.parametrize("name", EXPECTED)
def test_example(ar, name):
    said = subprocess.run([sys.executable, str(EXAMPLES / f"{name}.py")], check=True, capture_output=True, text=True).stdout
    for pattern, number, bar in EXPECTED[name]:
        found = re.search(pattern, said)
        assert found, said
        assert abs(float(found.group(1)) - number) <= bar, said


def test_examples_write_by_the_rule_of_all_files():
    """`io/output_file.hpp` replaces a link at a name; a stream of the standard library would write to what the link points at."""
    sources = [p for folder in ("examples", "docs") for p in sorted((EXAMPLES.parents[1] / folder).rglob("*.[ch]pp"))]
    assert len(sources) > 50
    assert not [p.name for p in sources if re.search(r"\b(ofstream|fopen)\b", p.read_text())]
