"""Reads with meshio the VTU files that the C++ test wrote and compares them, number by number, with what it meant.

usage: check_vtu.py FOLDER

FOLDER holds NAME.vtu and NAME.txt (the reference, see vtu.cpp) and series.pvd. Exit code 1 and a sentence on a difference.
"""

import pathlib
import sys
import xml.etree.ElementTree

import meshio
import numpy as np

TYPES = {"double": np.float64, "float": np.float32, "int": None, "int32": np.int32, "int64": np.int64, "uint32": np.uint32}


def read_reference(path):
    """[(where, type, name, array [items x components])]"""
    arrays, lines = [], path.read_text().splitlines()
    at = 0
    while at < len(lines):
        word, where, kind, items, components, name = lines[at].split(" ", 5)
        assert word == "array", lines[at]
        items, components = int(items), int(components)
        numbers = lines[at + 1 : at + 1 + items * components]
        at += 1 + items * components
        convert = float.fromhex if kind in ("double", "float") else int
        arrays.append((where, kind, name, np.array([convert(n) for n in numbers]).reshape(items, components)))
    return arrays


def same(found, expected, kind, what):
    found = np.asarray(found)
    if TYPES[kind] is not None:
        assert found.dtype == TYPES[kind], f"{what}: type {found.dtype}, not {TYPES[kind]}"
    found = found.reshape(len(found), -1)
    assert found.shape == expected.shape, f"{what}: shape {found.shape}, not {expected.shape}"
    wrong = np.argwhere(found != expected)
    assert len(wrong) == 0, f"{what}: {found[tuple(wrong[0])]} at {wrong[0]}, not {expected[tuple(wrong[0])]}"
    return found.size


def check(vtu):
    mesh = meshio.read(vtu)
    count = 0
    names = {"point": set(), "cell": set()}
    kinds = []
    for where, kind, name, expected in read_reference(vtu.with_suffix(".txt")):
        what = f"{vtu.name}, {where} {name}"
        if where == "points":
            count += same(mesh.points, expected, kind, what)
        elif where == "cells":
            kinds.append(name)
            block = mesh.cells[len(kinds) - 1]
            assert block.type == name, f"{what}: is {block.type}"
            count += same(block.data, expected, kind, what)
        elif where == "point":
            names["point"].add(name)
            count += same(mesh.point_data[name], expected, kind, what)
        else:
            names["cell"].add(name)
            count += same(np.concatenate(mesh.cell_data[name]), expected, kind, what)
    if not kinds:  # a cloud: a vertex on each point
        assert [b.type for b in mesh.cells] == ["vertex"], f"{vtu.name}: cells are {mesh.cells}"
        count += same(mesh.cells[0].data, np.arange(len(mesh.points)).reshape(-1, 1), "int", f"{vtu.name}, vertices")
    assert set(mesh.point_data or {}) == names["point"], f"{vtu.name}: point arrays {list(mesh.point_data)}"
    assert set(mesh.cell_data or {}) == names["cell"], f"{vtu.name}: cell arrays {list(mesh.cell_data)}"
    print(f"{vtu.name}: {count} numbers agree")


def check_series(pvd):
    steps = xml.etree.ElementTree.parse(pvd).getroot().findall("Collection/DataSet")
    assert [float(s.get("timestep")) for s in steps] == [0.1 * i for i in range(3)], f"{pvd.name}: times"
    for step in steps:
        mesh = meshio.read(pvd.parent / step.get("file"))
        assert mesh.points.tolist() == [[0, 0, 0], [1, 2, 3]], step.get("file")
    print(f"{pvd.name}: {len(steps)} steps are readable")


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check_vtu.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    try:
        for name in ("cloud", "cells", "worn", "numbered", "sand"):
            check(folder / f"{name}.vtu")
        check_series(folder / "series.pvd")
    except AssertionError as difference:
        sys.exit(f"check_vtu.py: {difference}")


if __name__ == "__main__":
    main()
