"""Reads with h5py the HDF5 files that the C++ test wrote.

usage: check_hdf_files.py FOLDER

FOLDER holds series/run_NAME.vtkhdf beside series/run_NAME_0000.vtu, ..: each number must be the same. Exit code 1 and a sentence on a difference.
"""

import pathlib
import sys

import h5py
import meshio
import numpy as np


def check_series(path, count):
    """Each step as the specification of VTKHDF 2.0 has it to be read: offsets of the step, counts of its part."""
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        steps = root["Steps"]
        assert root.attrs["Version"].tolist() == [2, 0], f"{path.name}: version"
        assert root.attrs["Type"] == b"UnstructuredGrid", f"{path.name}: type"
        assert steps.attrs["NSteps"] == len(steps["Values"]) == count, f"{path.name}: {steps.attrs['NSteps']} steps"
        numbers = 0
        for k in range(count):
            vtu = meshio.read(path.parent / f"{path.stem}_{k:04}.vtu")
            part = steps["PartOffsets"][k]
            assert steps["NumberOfParts"][k] == 1, f"{path.name}: parts of step {k}"
            points, cells, corners = (root[f"NumberOf{n}"][part] for n in ("Points", "Cells", "ConnectivityIds"))
            start = steps["CellOffsets"][k]

            def rows(name, begin, length):
                assert begin + length <= len(root[name]), f"{path.name}, step {k}: {name} is too short"
                return root[name][begin : begin + length]

            read = [("points", rows("Points", steps["PointOffsets"][k], points), vtu.points)]
            for where, length, data in (("Point", points, vtu.point_data), ("Cell", cells, vtu.cell_data)):
                names = set(root[f"{where}Data"]) if f"{where}Data" in root else set()
                assert names == set(data), f"{path.name}: {where} data {names}, not {set(data)}"
                for name in names:
                    expected = data[name] if where == "Point" else np.concatenate(data[name])
                    begin = steps[f"{where}DataOffsets/{name}"][k]
                    read.append((name, rows(f"{where}Data/{name}", begin, length), expected))
            corner = rows("Connectivity", steps["ConnectivityIdOffsets"][k], corners)
            read.append(("cells", corner, np.concatenate([b.data.ravel() for b in vtu.cells])))
            sizes = np.diff(rows("Offsets", start + part, cells + 1))
            read.append(("sizes", sizes, np.concatenate([[b.data.shape[1]] * len(b.data) for b in vtu.cells])))
            kinds = {1: 1, 2: 3, 3: 5, 4: 10}
            read.append(("types", rows("Types", start, cells), [kinds[n] for n in sizes]))
            for name, found, expected in read:
                what = f"{path.name}, step {k}: {name}"
                assert found.shape == np.shape(expected), f"{what}: shape {found.shape}, not {np.shape(expected)}"
                assert (found == expected).all(), f"{what}: other numbers"
                numbers += found.size
    print(f"{path.name}: {numbers} numbers of {count} steps agree")


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check_hdf_files.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    try:
        for name in ("sand", "mesh"):
            check_series(folder / "series" / f"run_{name}.vtkhdf", 4)
    except AssertionError as difference:
        sys.exit(f"check_hdf_files.py: {difference}")


if __name__ == "__main__":
    main()
