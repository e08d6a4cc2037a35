"""The cache of compiled objects: where it is, that nobody else can write there, and that an object is whole before it
is loaded, for what is loaded runs."""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import os
import stat
from pathlib import Path
from typing import Dict, Iterator, List, NoReturn, Optional, Sequence, Tuple

from ._errors import Error

CURE = "name another folder in the environment's ARENITE_CACHE"
_DIGEST = hashlib.sha256().digest_size


def folder() -> Path:
    """ARENITE_CACHE, else `arenite` in the user's cache folder: XDG_CACHE_HOME if it is absolute, else ~/.cache."""
    given = os.environ.get("ARENITE_CACHE", "")
    if given:
        if not os.path.isabs(given):
            raise Error(f"ARENITE_CACHE = {given}: must be an absolute path")
        return Path(given)
    # https://specifications.freedesktop.org/basedir-spec: empty is unset, and relative paths are ignored
    root = os.environ.get("XDG_CACHE_HOME", "")
    if not os.path.isabs(root):
        home = os.path.expanduser("~")
        if not os.path.isabs(home):
            raise Error(f"HOME = {os.environ.get('HOME', '')}: names no folder to keep compiled objects in; {CURE}")
        root = os.path.join(home, ".cache")
    return Path(root) / "arenite"


def refuse(path: Path, e: OSError) -> NoReturn:
    raise Error(f"cache = {path}: {e.strerror or e}: {e.filename or path}; {CURE}") from e


def _check(path: Path, is_kind: bool, kind: str, found: os.stat_result) -> None:
    if not is_kind:
        raise Error(f"cache = {path}: must be a {kind}; remove it, or {CURE}")
    if found.st_uid not in (os.geteuid(), 0):
        raise Error(f"cache = {path}: belongs to user {found.st_uid}: must belong to you, for what is in it runs; {CURE}")
    if found.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        raise Error(f"cache = {path}: others may write there (mode {stat.S_IMODE(found.st_mode):o}), and what is in it runs: "
                    f"look at what it holds, then remove it or `chmod go-w`, or {CURE}")


def opened() -> Path:
    """The cache's folder; made, for its user alone, if it is not there."""
    place = folder()
    try:
        place.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        with contextlib.suppress(FileExistsError):
            place.mkdir(mode=0o700)
        found = place.stat()
    except OSError as e:
        refuse(place, e)
    _check(place, stat.S_ISDIR(found.st_mode), "folder", found)
    return place


def whole(path: Path) -> bool:
    """Whether an object is there and is what was stored: it ends with a hash of what is before it. Raises `Error` if
    others could have written it."""
    try:
        file = os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NOFOLLOW | os.O_NONBLOCK)
    except FileNotFoundError:
        return False
    except OSError as e:
        refuse(path, e)
    try:
        found = os.fstat(file)
        _check(path, stat.S_ISREG(found.st_mode), "file", found)
        with open(file, "rb", closefd=False) as opened_file:
            content = opened_file.read()
    finally:
        os.close(file)
    return len(content) > _DIGEST and hashlib.sha256(content[:-_DIGEST]).digest() == content[-_DIGEST:]


def store(made: Path, path: Path, mode: int = 0o600) -> None:
    """Puts a file that is complete under its name, with a hash behind it: on the disk as a whole, or not at all."""
    with open(made, "r+b") as file:
        file.write(hashlib.sha256(file.read()).digest())
        file.flush()
        os.fchmod(file.fileno(), mode)
        os.fsync(file.fileno())
    os.replace(made, path)
    at = os.open(path.parent, os.O_RDONLY | os.O_CLOEXEC)
    try:
        os.fsync(at)
    finally:
        os.close(at)


@contextlib.contextmanager
def locked(path: Path) -> Iterator[None]:
    """Waits for other processes; the system frees the lock of one that dies."""
    file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
    try:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield
    finally:
        os.close(file)


_hashes: Dict[str, Tuple[Tuple[int, ...], bytes]] = {}


def _hash_of(path: str) -> Optional[bytes]:
    """Of a file's content; none if it cannot be read. Within a process it is read again once it changed."""
    try:
        found = os.stat(path)
        seen = (found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns, found.st_ctime_ns)
        known = _hashes.get(path)
        if known is None or known[0] != seen:
            with open(path, "rb") as file:
                known = _hashes[path] = (seen, hashlib.sha256(file.read()).digest())
        return known[1]
    except OSError:
        return None


def hash_of_files(key: str, paths: Sequence[str]) -> Optional[str]:
    """Of a key and of what the files hold; none if one cannot be read."""
    all_of_them = hashlib.sha256(key.encode())
    for path in paths:
        content = _hash_of(path)
        if content is None:
            return None
        all_of_them.update(path.encode() + b"\0" + content)
    return all_of_them.hexdigest()[:32]


def read_list(path: Path) -> List[str]:
    """Lines that `store` stored; none if they are not there or damaged."""
    return path.read_bytes()[:-_DIGEST].decode(errors="surrogateescape").splitlines() if whole(path) else []
