"""Views of points under the address sanitizer: none of them reads memory that is no longer the scene's."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent


def test_views(ar, tmp_path):
    library = subprocess.run(["g++", "-print-file-name=libasan.so"], capture_output=True, text=True).stdout.strip()
    if not os.path.isabs(library):
        pytest.skip("g++ has no address sanitizer here")
    # The compiler is not one that is looked at.
    environment = {**os.environ, "ARENITE_CACHE": str(tmp_path), "CXX": "env LD_PRELOAD= g++ -fsanitize=address -O0 --param asan-instrumentation-with-call-threshold=0",
                   "LD_PRELOAD": library, "ASAN_OPTIONS": "detect_leaks=0"}
    done = subprocess.run([sys.executable, str(HERE / "views_under_asan.py")], env=environment, capture_output=True, text=True)
    assert done.returncode == 0 and "done" in done.stdout, done.stderr[-4000:]
    assert "AddressSanitizer" not in done.stderr
