"""Reads the VTU and PVD files that Arenite writes (raw appended data, 64-bit sizes) with numpy alone."""

import os
import xml.etree.ElementTree as ElementTree

import numpy

from regular_file import opened

KINDS = {"Float64": "f8", "Float32": "f4", "Int32": "i4", "Int64": "i8", "UInt32": "u4", "UInt8": "u1"}


def read_vtu(path):
    """Returns {"points": [n, 3], "cells": {"connectivity", "offsets", "types"}, "point_data": {name: array},
    "cell_data": {name: array}}. Raises ValueError if the file is of another make."""
    with opened(path, mode="rb") as file:
        content = file.read()
    start = content.find(b"<AppendedData")
    first = content.find(b"_", content.find(b">", start)) + 1
    if start < 0 or first == 0:
        raise ValueError(f"{path}: has no appended data; read_vtu reads the files that Arenite writes")
    root = ElementTree.fromstring(content[:start] + b"</VTKFile>")
    if root.get("header_type") != "UInt64" or root.get("compressor"):
        raise ValueError(f"{path}: must have 64-bit sizes and no compression")
    order = "<" if root.get("byte_order") == "LittleEndian" else ">"

    def arrays(element):
        found = {}
        for array in root.iterfind(f".//{element}/DataArray"):
            at = first + int(array.get("offset"))
            size = int(numpy.frombuffer(content, order + "u8", 1, at)[0])
            values = numpy.frombuffer(content[at + 8 : at + 8 + size], order + KINDS[array.get("type")])
            components = int(array.get("NumberOfComponents", "1"))
            found[array.get("Name")] = values.reshape(-1, components) if components > 1 else values
        return found

    return {
        "points": arrays("Points")["Points"],
        "cells": arrays("Cells"),
        "point_data": arrays("PointData"),
        "cell_data": arrays("CellData"),
    }


def read_pvd(path):
    """Returns [(time, path of file)] in the order of the list."""
    folder = os.path.dirname(path)
    with opened(path, mode="rb") as file:
        entries = ElementTree.parse(file).getroot().iter("DataSet")
    return [(float(e.get("timestep")), os.path.join(folder, e.get("file"))) for e in entries]
