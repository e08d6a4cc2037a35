"""The examples in Python, each with the number that it should give."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "python"


@pytest.mark.parametrize("name, expected", [
    ("column_collapse", [(r"x = (\S+) m", 0.241, 0.002)]),
    ("discs", [(r"momentum (\S+) of", 0, 1e-12), (r"\[(\S+) ", -0.858, 0.002)]),
    ("cone", [(r"depth 0.0500 m  force +(\S+) N", 50.2, 1)]),
    ("co_simulation", [(r"lies (\S+) m", 0.0323, 0.0005), (r"at (\S+) m/s", 1.037, 0.02)]),
    ("element_test", [(r"100 kPa: q = +(\S+) kPa", 269.02, 0.01)]),
    ("tilted", [(r"went (\S+) mm", -18.0, 0.2)]),
])
def test_example(ar, name, expected):
    assert {p.stem for p in EXAMPLES.glob("*.py")} == {"column_collapse", "discs", "cone", "co_simulation", "element_test", "tilted"}
    said = subprocess.run([sys.executable, str(EXAMPLES / f"{name}.py")], check=True, capture_output=True, text=True).stdout
    for pattern, number, bar in expected:
        found = re.search(pattern, said)
        assert found, said
        assert abs(float(found.group(1)) - number) <= bar, said
