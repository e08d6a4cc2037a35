"""Views of points under the address sanitizer: none of them reads memory that is no longer the scene's."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent


def sanitizers():
    """Library and compiler with the address sanitizer; clang++ first, which takes half of g++'s time. It is not looked at itself."""
    for name, library, options in (("clang++", "libclang_rt.asan-x86_64.so", "-shared-libasan -mllvm -asan-instrumentation-with-call-threshold=0"),
                                   ("g++", "libasan.so", "--param asan-instrumentation-with-call-threshold=0")):
        if shutil.which(name) is not None:
            path = subprocess.run([name, f"-print-file-name={library}"], capture_output=True, text=True).stdout.strip()
            if os.path.isabs(path):
                yield path, f"env LD_PRELOAD= {name} -fsanitize=address -O0 {options}"


def test_views(ar, tmp_path):
    library, compiler = next(sanitizers(), (None, None))
    if library is None:
        pytest.skip("no compiler here has an address sanitizer")
    environment = {**os.environ, "ARENITE_CACHE": str(tmp_path), "CXX": compiler, "LD_PRELOAD": library, "ASAN_OPTIONS": "detect_leaks=0"}
    done = subprocess.run([sys.executable, str(HERE / "views_under_asan.py")], env=environment, capture_output=True, text=True)
    assert done.returncode == 0 and "done" in done.stdout, done.stderr[-4000:]
    assert "AddressSanitizer" not in done.stderr
