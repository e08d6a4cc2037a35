"""Reads with h5py the HDF5 files that the C++ test wrote.

usage: check_hdf_files.py FOLDER

FOLDER holds a.h5 and a.state, one state in both containers: head and each number must be the same. Exit code 1 and a sentence on a
difference.
"""

import pathlib
import sys

import h5py
import numpy as np


def read_state(path):
    """Head {key: value} and values {name: array} of a binary state file (io/state_file.hpp)."""
    content = path.read_bytes()
    end = content.index(b"\n\n") + 2
    head, values = {}, {}
    lines = content[:end].decode().splitlines()
    at = end
    first = next(i for i, line in enumerate(lines) if line.startswith("values: "))
    for line in lines[1:first]:
        key, value = line.split(": ", 1)
        head[key] = value
    for line in lines[first + 1 : -1]:
        kind, count, name = line.split(" ", 2)
        kind = "?" if kind == "b1" else kind
        values[name] = np.frombuffer(content, kind, int(count), at)
        at += values[name].nbytes
    assert at + 8 == len(content), f"{path.name}: {at} bytes are named, {len(content)} there"
    return head, values


def check_state(h5, state):
    head, values = read_state(state)
    with h5py.File(h5) as file:
        assert file.userblock_size == 512, f"{h5.name}: user block of {file.userblock_size} bytes"
        for key, value in head.items():
            found = file.attrs[key].decode()
            assert found == value, f"{h5.name}: {key} is {found}, not {value}"
        names = []
        file.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
        assert sorted(names) == sorted(values), f"{h5.name}: names {set(names) ^ set(values)}"
        for name, expected in values.items():
            found = file[name][...]
            assert found.dtype == expected.dtype, f"{h5.name}, {name}: type {found.dtype}, not {expected.dtype}"
            assert found.tobytes() == expected.tobytes(), f"{h5.name}, {name}: other numbers"
    print(f"{h5.name}: {sum(v.size for v in values.values())} numbers of {len(values)} names agree")


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check_hdf_files.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    try:
        check_state(folder / "a.h5", folder / "a.state")
    except AssertionError as difference:
        sys.exit(f"check_hdf_files.py: {difference}")


if __name__ == "__main__":
    main()
