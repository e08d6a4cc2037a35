"""Compositions, and programs, compiled on first use by the system's compiler, and cached.

The name of an object is a hash of all that decides it: the unit's text, compiler and flags, and the content of every
file that the compiler read (a law's header and what it includes, the library, Eigen, the system's headers), as the
compiler listed them when it last compiled the unit. One process at a time compiles one unit.

How recipes are read, and other cold code, does not depend on a scene's type: it is compiled once, into an object that the others are linked with.
The package has one, which serves the compiler that made it; for another one it is made in the cache."""

from __future__ import annotations

import functools
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Callable, Container, List, Optional, Sequence, Tuple

from . import _cache, _core
from ._cases import processors
from ._errors import Error

PACKAGE = Path(__file__).parent


def include_folders() -> List[Path]:
    """Where headers are looked up: the folders of ARENITE_INCLUDE (several, with colons), then those of the package."""
    given = os.environ.get("ARENITE_INCLUDE", "")
    return [*(Path(p) for p in given.split(":") if given), PACKAGE / "include", PACKAGE / "include" / "eigen3"]


def compiler(what: str = "This composition") -> List[str]:
    given = os.environ.get("CXX", "")
    try:
        words = shlex.split(given) or ["g++"]
    except ValueError as e:
        raise Error(f"CXX = {given}: must be words as a shell takes them ({e})") from e
    if shutil.which(words[0]) is None:
        raise Error(f"compiler = {words[0]}: not found. {what} is not prebuilt and must be compiled: install "
                    "g++ 12 or clang++ 14 (or newer), or name one in the environment's CXX")
    return words


def _called(command: Sequence[str]) -> "subprocess.CompletedProcess[str]":
    try:
        return subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
    except OSError as e:
        raise Error(f"compiler = {command[0]}: cannot be run ({e.strerror}); name one in the environment's CXX") from e


@functools.lru_cache(maxsize=None)
def _compiler_version(words: Tuple[str, ...], path: str) -> str:
    return path + "\n" + _called([*words, "--version"]).stdout


#: C++ of the object that scenes and laws are linked with: python/native/host.cpp and src/cold/cold.cpp.
HOST = "#define ARENITE_COLD_LIBRARY\n#define ARENITE_HOST_HERE\n#include <arenite/cold.hpp>\n#include <arenite_host/readers.hpp>\n"
ELSEWHERE = "#define ARENITE_COLD_LIBRARY\n#define ARENITE_HOST_ELSEWHERE\n"
#: How a unit of a scene is told that its step is a unit of its own: which of the two it is.
STEP, HERE = "ARENITE_EXTERN_STEP", "ARENITE_STEP_HERE"


def source(what: str, type_name: str, headers: Sequence[str]) -> str:
    """C++ of a shared object that offers one composition or law. Its words are looked up in the library; names of
    one's own begin with `::`, so that they may be any."""
    host = {"scene": ("scene_host", "SceneMaker", "make_hosted"), "law": ("law_host", "LawMaker", "make_hosted_law"),
            "tiles": ("tiles_host", "TilesMaker", "make_hosted_tiles")}
    file, maker, make = host[what]
    own = "".join(f'#include "{Path(h).resolve()}"\n' for h in headers)
    begin = (f"{ELSEWHERE}#include <arenite_host/plugin.hpp>\n#include <arenite_host/{file}.hpp>\n{own}"
             "namespace arenite::compiled_on_first_use {\n"
             f"using Type = {type_name};\n"
             "}\n")
    offer = ("namespace arenite::compiled_on_first_use {\n"
             f'static const shared_detail::Registration offer{{Plugin::{maker}{{"{type_name}", &{make}<Type>}}}};\n'
             "}\n"
             "ARENITE_PLUGIN\n")
    if what != "scene":
        return begin + offer
    return (f"{begin}#ifdef {STEP}\nnamespace arenite {{\nARENITE_STEP({STEP}, compiled_on_first_use::Type);\n}}\n#endif\n"
            f"#ifndef {HERE}\n{offer}#endif\n")


def _cause(output: str) -> str:
    """The sentence of a refusal, or the compiler's first error."""
    for pattern in (r"static assertion failed: (.*)", r"static_assert failed[^\"]*\"(.*)\"", r"error: static assertion failed[^:]*: (.*)"):
        found = re.search(pattern, output)
        if found:
            return found.group(1).strip()
    found = re.search(r"error: (.*)", output)
    return found.group(1).strip() if found else output.strip()[-2000:]


def _files_read(rule: str, unit: Path) -> List[str]:
    """Files of a dependency rule as make reads it, but the unit itself."""
    words = re.findall(r"(?:\\.|[^\s\\])+", rule.split(":", 1)[1].replace("\\\n", " "))
    paths = {os.path.abspath(re.sub(r"\\(.)", r"\1", w).replace("$$", "$")) for w in words}
    return sorted(paths - {os.path.abspath(unit)})


def _ending(command: Sequence[str]) -> str:
    """Of what a command makes; a program has none."""
    return ".o" if "-c" in command else ".so" if "-shared" in command else ""


def _compiled(command: Sequence[str], text: str, told: str, folder: Path, log: Path, host: Optional[Path]) -> List[str]:
    """Compiles `folder/unit` with its ending, linked with `host` if there is one; returns the files that it was made of."""
    unit = folder / "unit.cpp"
    out = folder / f"unit{_ending(command)}"
    unit.write_text(text)
    linked = [str(host)] if host else []

    def compiled(*ways: Tuple[Sequence[str], Path]) -> List[str]:
        """The unit in each of these ways, by a command and to a file, at once."""
        rules = [made.with_suffix(".d") for _, made in ways]
        with ThreadPoolExecutor() as pool:
            ended = list(pool.map(_called, [[*words, "-MD", "-MF", str(rule), str(unit), *(linked if made == out else []), "-o", str(made)]
                                            for (words, made), rule in zip(ways, rules)]))
        for done in ended:
            if done.returncode != 0:
                log.write_text(done.stderr)
                raise Error(f"{_cause(done.stderr)}\n  (compiling {told}; the compiler's words: {log})")
        if not all(made.is_file() and rule.is_file() for (_, made), rule in zip(ways, rules)):
            raise Error(f"compiler = {' '.join(command[:1])}: ended without an error, but made no object; "
                        "name g++ or clang++ in the environment's CXX")
        return sorted({file for rule in rules for file in _files_read(rule.read_text(errors="surrogateescape"), unit)}) + linked

    if STEP in text and processors() > 1:
        # What runs every step, and all else with less of the optimiser: at once, in 0.6 of the time and 0.75 of the memory.
        objects = [folder / "hosted.o", folder / "step.o"]
        words = [word for word in command if word != "-shared"]
        level = words.index("-O3")
        hosted = [*words[:level], "-O1", *words[level + 1:]]
        files = compiled(([*hosted, f"-D{STEP}=extern", "-c"], objects[0]), ([*words, f"-D{STEP}=", f"-D{HERE}", "-c"], objects[1]))
        if _called([*command, "-Wl,-z,defs", *map(str, objects), *linked, "-o", str(out)]).returncode == 0:
            return files
        # A header of the user's own is for one unit alone: functions that are not inline, names without linkage.
    return compiled((command, out))


def _made(command: Sequence[str], text: str, told: str, key: str, place: Path, host: Optional[Path]) -> Path:
    """Compiles and stores an object and the list of the files that it was made of."""
    folder = place / f"{key}.tmp"
    ending = _ending(command)
    rounds = 3
    for _ in range(rounds):
        shutil.rmtree(folder, ignore_errors=True)  # that of a process that was killed
        folder.mkdir(mode=0o700)
        try:
            begin = time.time_ns()
            files = _compiled(command, text, told, folder, place / f"{key}.log", host)
            name = _cache.hash_of_files(key, files)
            # What was saved meanwhile may have been read before or after.
            if name is None or any(os.stat(f).st_ctime_ns >= begin for f in files):
                continue
            made = place / f"{name}{ending}"
            _cache.store(folder / f"unit{ending}", made, 0o600 if ending else 0o700)
            listed = folder / "files"
            listed.write_bytes("\n".join(files).encode(errors="surrogateescape"))
            _cache.store(listed, place / f"{key}.files")
            return made
        finally:
            shutil.rmtree(folder, ignore_errors=True)
    raise Error(f"compiling {told}: its headers changed while they were compiled, {rounds} times; try again")


def _found(key: str, place: Path, ending: str) -> Path:
    """The object that the files as they are now lead to; it may not be there."""
    files = _cache.read_list(place / f"{key}.files")
    name = _cache.hash_of_files(key, files) if files else None
    return place / f"{name or key}{ending}"


def _object(text: str, told: str, command: Sequence[str], version: str, place: Path, loaded: Container[str] = (),
            check: Callable[[], None] = lambda: None, host: Callable[[], Optional[Path]] = lambda: None, takes: str = "") -> Path:
    """An object of the cache, compiled if it is not there; `host`: what it is linked with, made before; `takes`: how long."""
    paths_of_compiler = [os.environ.get(name, "") for name in ("CPATH", "CPLUS_INCLUDE_PATH", "COMPILER_PATH", "LIBRARY_PATH")]
    key = hashlib.sha256("\0".join([text, _core.version, version, *command, *paths_of_compiler])
                         .encode(errors="surrogateescape")).hexdigest()[:32]
    ending = _ending(command)
    made = _found(key, place, ending)
    if str(made) in loaded or _cache.whole(made):
        return made
    check()
    with _cache.locked(place / f"{key}.lock"):
        made = _found(key, place, ending)
        if _cache.whole(made):
            return made
        with_host = host()
        print(f"arenite: compiling {told} (once{takes and f', {takes}'}; {place}) ..", file=sys.stderr, flush=True)
        start = time.monotonic()
        made = _made(command, text, told, key, place, with_host)
        print(f"arenite: compiled in {time.monotonic() - start:.0f} s", file=sys.stderr, flush=True)
        return made


def built(what: str, type_name: str, headers: Sequence[str], flags: Sequence[str], loaded: Container[str] = (),
          check: Callable[[], None] = lambda: None, host: Optional[Path] = None) -> Path:
    """The shared object of a composition, compiled if it is not in the cache. `loaded`: those that need not be looked
    at again; `check`: called before it is compiled, which takes long; `host`: what the package has for it to be linked with,
    with these flags."""
    for h in headers:
        if not Path(h).is_file():
            raise Error(f"header = {h}: there is no such file")
        if re.search(r'["\\\n]', str(Path(h).resolve())):
            raise Error(f"header = {h}: its path must hold no quote, backslash or line break")
    folders = tuple(include_folders())
    if not (folders[0] / "arenite" / "arenite.hpp").is_file():
        raise Error(f"include = {folders[0]}: the library's headers are not there; set ARENITE_INCLUDE")
    text = source(what, type_name, headers)
    words, version = _compiler()
    command = [*_command(words, folders, flags), "-fPIC"]
    place = _cache.opened()

    def with_host() -> Optional[Path]:
        if not text.startswith(ELSEWHERE):
            return None
        if host and folders[0] == PACKAGE / "include" and len(words) == 1 and _is_of(host, version):
            return host
        return _object(HOST, "what all compositions read their recipes with", [*command, "-c"], version, place)

    try:
        return _object(text, type_name, [*command, "-shared"], version, place, loaded, check, with_host)
    except OSError as e:
        _cache.refuse(place, e)


def program(text: str, told: str, flags: Sequence[str], host: Callable[[], Path], takes: str) -> Path:
    """A program of one unit, compiled if it is not in the cache, with the headers of the package; `host`: what of the package it is
    linked with, asked for before it is compiled; `takes`: how long that takes, to say so."""
    words, version = _compiler(told)
    place = _cache.opened()
    command = [*_command(words, (PACKAGE / "include", PACKAGE / "include" / "eigen3"), flags), "-pthread"]
    try:
        return _object(text, told, command, version, place, host=host, takes=takes)
    except OSError as e:
        _cache.refuse(place, e)


#: C++ of the object that makes ranks of a communicator, by its address.
RANKS = """#include <arenite/tiles/mpi_world.hpp>
#include <cstdint>
extern "C" arenite::Ranks* arenite_ranks(std::uintptr_t communicator) {
  return new arenite::mpi::World(*reinterpret_cast<MPI_Comm*>(communicator));
}
extern "C" void arenite_end_ranks(arenite::Ranks* ranks) { delete ranks; }
extern "C" const char* arenite_mpi_version() {
  static char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  return text;
}
"""


def ranks() -> Path:
    """The shared object that links to the machine's MPI, compiled if it is not in the cache."""
    words = shlex.split(os.environ.get("MPICXX", "")) or ["mpicxx"]
    if shutil.which(words[0]) is None:
        raise Error(f"compiler = {words[0]}: not found; it makes the link to MPI: install it (Debian: libopenmpi-dev), or name one in the "
                    "environment's MPICXX")
    version = _compiler_version(tuple(words), os.path.realpath(shutil.which(words[0]) or ""))
    place = _cache.opened()
    try:
        return _object(RANKS, "the link to MPI", [*_command(words, include_folders(), []), "-fPIC", "-shared"], version, place)
    except OSError as e:
        _cache.refuse(place, e)


def _compiler(what: str = "This composition") -> Tuple[List[str], str]:
    words = compiler(what)
    return words, _compiler_version(tuple(words), os.path.realpath(shutil.which(words[0]) or ""))


def _command(words: Sequence[str], folders: Sequence[Path], flags: Sequence[str]) -> List[str]:
    own = next((k for k, word in enumerate(words) if word.startswith("-")), len(words))  # options of the environment's have the last word
    return [*words[:own], "-std=c++20", "-O3", "-DNDEBUG", *flags, *words[own:], *(f"-isystem{f}" for f in folders)]


def _is_of(host: Path, version: str) -> bool:
    """Whether the package's object is there and of this compiler: what it calls itself, whatever it was called by."""
    try:
        made_by = (host.parent / "compiler.txt").read_text()
    except OSError:
        return False
    return host.is_file() and made_by.split()[1:] == version.split("\n", 1)[1].split()[1:]


def _code(header: Path) -> str:
    """A law's header without comments."""
    try:
        return re.sub(r"//.*|(?s:/\*.*?\*/)", "", header.read_bytes().decode(errors="replace"))
    except OSError as e:
        raise Error(f"compile: law = {header}: cannot be read ({e.strerror})") from e


def check_law(header: Path, name: str) -> None:
    """Refuses a class that cannot be made of parameters by name, where the header shows it: the compiler needs half a minute
    to say so."""
    word = re.split("<", name)[0].rpartition("::")[2]
    text = _code(header)
    begin = re.search(rf"(\btemplate\s*<[^;{{]*>\s*)?\b(?:class|struct)\s+{word}\s*(?:final\s*)?(?::[^;{{]*)?\{{", text)
    if begin is None:
        return  # it is included
    if begin.group(1) and "<" not in name:
        raise Error(f"compile: law = {header}: {name} is a template: name what it is made for, as in name=\"{name}<2>\"")
    depth, body = 1, ""
    for piece in re.split(r"([{}])", text[begin.end():]):
        depth += {"{": 1, "}": -1}.get(piece, 0)
        if depth == 0:
            break
        body += piece
    if re.search(rf"(?<![~\w]){word}\s*\(", body) and not re.search(r"\bParameters\b", body):
        raise Error(f"compile: law = {header}: {name} has a constructor and no struct Parameters, so that Python cannot make it of values by "
                    f"name: give it `struct Parameters {{ double density = 0, ..; }};` and `explicit {word}(const Parameters& p)`, as "
                    "examples/own_law.hpp has them")


def law_name(header: Path) -> str:
    """The class in a header that has an `update`, with its namespaces: the last one before it."""
    text = _code(header)
    at = re.search(r"\bupdate\s*\(", text)
    begin = text[: at.start()] if at else text
    found = [m for m in re.finditer(r"\b(?:class|struct)\s+(\w+)\s*(?:final\s*)?(?::[^;{]*)?\{", begin)
             if m.group(1) not in ("History", "Parameters")]
    if not found:
        raise Error(f"compile: law = {header}: holds no class with update(..); name it: compile(law=.., name=..)")
    within: List[str] = []
    for brace in re.finditer(r"(?:\bnamespace\s+([\w:]*)\s*)?(\{|\})", begin[: found[-1].start()]):
        if brace.group(2) == "{":
            within.append(brace.group(1) or "")
        elif within:
            within.pop()
    return "::".join([*(w for w in within if w), found[-1].group(1)])
