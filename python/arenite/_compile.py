"""Compositions compiled on first use by the system's compiler, and cached.

The cache (ARENITE_CACHE, else arenite in the user's cache folder) holds one shared object for each hash of source,
headers, compiler and flags. One process at a time compiles one of them; an object appears under its name when it is
complete, so that a killed compiler leaves nothing that counts."""

from __future__ import annotations

import contextlib
import fcntl
import functools
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Iterator, List, Sequence

from . import _core
from ._errors import Error

PACKAGE = Path(__file__).parent


def cache() -> Path:
    given = os.environ.get("ARENITE_CACHE")
    root = Path(given) if given else Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "arenite"
    return root


def include_folders() -> List[Path]:
    """Headers of the library and Eigen: those of the package, or of ARENITE_INCLUDE (several, with colons)."""
    given = os.environ.get("ARENITE_INCLUDE")
    return [Path(p) for p in given.split(":")] if given else [PACKAGE / "include", PACKAGE / "include" / "eigen3"]


def compiler() -> List[str]:
    words = shlex.split(os.environ.get("CXX", "")) or ["g++"]
    if shutil.which(words[0]) is None:
        raise Error(f"compiler = {words[0]}: not found. This composition is not prebuilt and must be compiled: install "
                    "g++ 12 or clang++ 14 (or newer), or name one in the environment's CXX")
    return words


@functools.lru_cache(maxsize=None)
def _compiler_version(words: Sequence[str]) -> str:
    return subprocess.run([*words, "--version"], capture_output=True, text=True, check=False).stdout


@functools.lru_cache(maxsize=None)
def _headers_hash(folders: Sequence[Path]) -> str:
    found = hashlib.sha256()
    for path in sorted((folders[0] / "arenite").rglob("*.hpp")):
        found.update(path.read_bytes())
    return found.hexdigest()


def source(what: str, type_name: str, headers: Sequence[str]) -> str:
    """C++ of a shared object that offers one composition or law."""
    host = {"scene": ("scene_host", "SceneMaker", "make_hosted"), "law": ("law_host", "LawMaker", "make_hosted_law")}
    file, maker, make = host[what]
    own = "".join(f'#include "{Path(h).resolve()}"\n' for h in headers)
    return (f"#include <arenite/host/plugin.hpp>\n#include <arenite/host/{file}.hpp>\n{own}"
            "using namespace arenite;\n"
            f"using Type = {type_name};\n"
            f'static const shared_detail::Offer offer{{Plugin::{maker}{{"{type_name}", &{make}<Type>}}}};\n'
            "ARENITE_PLUGIN\n")


@contextlib.contextmanager
def _locked(path: Path) -> Iterator[None]:
    """Waits for other processes; the system frees the lock of one that dies."""
    with open(path, "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _cause(output: str) -> str:
    """The sentence of a refusal, or the compiler's first error."""
    for pattern in (r"static assertion failed: (.*)", r"static_assert failed[^\"]*\"(.*)\"", r"error: static assertion failed[^:]*: (.*)"):
        found = re.search(pattern, output)
        if found:
            return found.group(1).strip()
    found = re.search(r"error: (.*)", output)
    return found.group(1).strip() if found else output.strip()[-2000:]


def built(what: str, type_name: str, headers: Sequence[str], flags: Sequence[str]) -> Path:
    """The shared object of a composition, compiled if it is not in the cache."""
    for h in headers:
        if not Path(h).is_file():
            raise Error(f"header = {h}: there is no such file")
    words, folders = compiler(), tuple(include_folders())
    if not (folders[0] / "arenite" / "arenite.hpp").is_file():
        raise Error(f"include = {folders[0]}: the library's headers are not there; set ARENITE_INCLUDE")
    text = source(what, type_name, headers)
    own = "".join(Path(h).read_text() for h in headers)
    key = hashlib.sha256("\0".join([text, own, _core.version, _compiler_version(tuple(words)), *flags,
                                    _headers_hash(folders)]).encode()).hexdigest()[:32]
    place = cache()
    place.mkdir(parents=True, exist_ok=True)
    made = place / f"{key}.so"
    if made.exists():
        return made
    with _locked(place / f"{key}.lock"):
        if made.exists():
            return made
        print(f"arenite: compiling {type_name} (once; {place}) ..", file=sys.stderr, flush=True)
        begin = time.monotonic()
        with tempfile.TemporaryDirectory(dir=place) as folder:
            unit, out = Path(folder) / "composition.cpp", Path(folder) / "composition.so"
            unit.write_text(text)
            command = [*words, "-std=c++20", "-O3", "-DNDEBUG", "-fPIC", "-shared", *flags,
                       *(f"-isystem{f}" for f in folders), str(unit), "-o", str(out)]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                log = place / f"{key}.log"
                log.write_text(done.stderr)
                raise Error(f"{_cause(done.stderr)}\n  (compiling {type_name}; the compiler's words: {log})")
            os.replace(out, made)
        print(f"arenite: compiled in {time.monotonic() - begin:.0f} s", file=sys.stderr, flush=True)
    return made


def law_name(header: Path) -> str:
    """The class in a header that has an `update`: the last one before it."""
    text = re.sub(r"//.*", "", header.read_text())
    at = re.search(r"\bupdate\s*\(", text)
    names = re.findall(r"\b(?:class|struct)\s+(\w+)\s*(?::[^;{]*)?\{", text[: at.start()] if at else text)
    outer = [n for n in names if n not in ("History", "Parameters")]
    if not outer:
        raise Error(f"compile: law = {header}: holds no class with update(..); name it: compile(law=.., name=..)")
    return str(outer[-1])
