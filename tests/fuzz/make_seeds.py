"""Writes what the fuzz targets start from: a few small meshes that are right.

usage: make_seeds.py FOLDER

FOLDER/read_stl: a tetrahedron, text and binary. FOLDER/read_gmsh: a square and a tetrahedron in formats 2.2 and 4.1, text and binary, behind the byte that chooses
the dimension. FOLDER/simplex_mesh: arrays as simplex_mesh.cpp takes them.
"""

import pathlib
import struct
import sys

SQUARE = ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], 2, [(1, 2, 3), (1, 3, 4)])
TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], 4, [(1, 2, 3, 4)])
NAMES = '$PhysicalNames\n2\n1 7 "left"\n%d 5 "sand"\n$EndPhysicalNames\n'


def format_22(nodes, kind, cells, binary):
    dim = 2 if kind == 2 else 3
    head = f"$MeshFormat\n2.2 {int(binary)} 8\n".encode()
    if binary:
        head += struct.pack("<i", 1) + b"\n"
    head += b"$EndMeshFormat\n" + (NAMES % dim).encode()
    if binary:
        points = b"".join(struct.pack("<i3d", i, *x) for i, x in enumerate(nodes, 1))
        elements = struct.pack("<3i", 1, 1, 2) + struct.pack("<5i", 1, 7, 1, 1, 4)
        elements += struct.pack("<3i", kind, len(cells), 2)
        elements += b"".join(struct.pack(f"<{3 + len(c)}i", 2 + i, 5, 1, *c) for i, c in enumerate(cells))
    else:
        points = "".join(f"{i} {x} {y} {z}\n" for i, (x, y, z) in enumerate(nodes, 1)).encode()
        elements = b"1 1 2 7 1 1 4\n"
        elements += "".join(f"{2 + i} {kind} 2 5 1 {' '.join(map(str, c))}\n" for i, c in enumerate(cells)).encode()
    return (head + f"$Nodes\n{len(nodes)}\n".encode() + points + b"\n$EndNodes\n" +
            f"$Elements\n{1 + len(cells)}\n".encode() + elements + b"\n$EndElements\n")


def format_41(nodes, kind, cells, binary):
    dim = 2 if kind == 2 else 3

    def ints(*values):
        return struct.pack(f"<{len(values)}i", *values) if binary else (" ".join(map(str, values)) + " ").encode()

    def sizes(*values):
        return struct.pack(f"<{len(values)}Q", *values) if binary else (" ".join(map(str, values)) + " ").encode()

    def reals(*values):
        return struct.pack(f"<{len(values)}d", *values) if binary else (" ".join(map(str, values)) + " ").encode()

    row = b"" if binary else b"\n"
    head = f"$MeshFormat\n4.1 {int(binary)} 8\n".encode()
    if binary:
        head += struct.pack("<i", 1) + b"\n"
    head += b"$EndMeshFormat\n" + (NAMES % dim).encode()
    counts = [0, 1, 0, 0]
    counts[dim] += 1
    entities = sizes(*counts) + row
    for group in (7, 5):
        entities += ints(1) + reals(0, 0, 0, 1, 1, 1) + sizes(1) + ints(group) + sizes(0) + row
    points = sizes(1, len(nodes), 1, len(nodes)) + row + ints(dim, 1, 0) + sizes(len(nodes)) + row
    points += b"".join(sizes(i) + row for i in range(1, len(nodes) + 1))
    points += b"".join(reals(*x) + row for x in nodes)
    elements = sizes(2, 1 + len(cells), 1, 1 + len(cells)) + row
    elements += ints(1, 1, 1) + sizes(1) + row + sizes(1, 1, 4) + row
    elements += ints(dim, 1, kind) + sizes(len(cells)) + row
    elements += b"".join(sizes(2 + i, *c) + row for i, c in enumerate(cells))
    return (head + b"$Entities\n" + entities + b"\n$EndEntities\n$Nodes\n" + points + b"\n$EndNodes\n$Elements\n" +
            elements + b"\n$EndElements\n")


def arrays(kind, small, nodes, cells):
    """The bytes that simplex_mesh.cpp turns into these arrays: `kind` 0 to 3 is plane or solid, double or float."""
    number = (lambda x: struct.pack("<b", int(2 * x))) if small else (lambda x: struct.pack("<d", x))
    return (bytes([kind + 4 * small, len(nodes), 1]) + b"".join(number(x) for node in nodes for x in node) +
            bytes([0, 1]) + bytes(i for cell in cells for i in cell))


folder = pathlib.Path(sys.argv[1])
for target in ("read_gmsh", "read_stl", "simplex_mesh"):
    (folder / target).mkdir(parents=True, exist_ok=True)
for name, mesh in (("square", SQUARE), ("tetrahedron", TETRAHEDRON)):
    for binary in (False, True):
        for version, write in (("22", format_22), ("41", format_41)):
            file = folder / "read_gmsh" / f"{name}_{version}_{'binary' if binary else 'text'}"
            file.write_bytes(bytes([mesh is TETRAHEDRON]) + write(*mesh, binary))
TRIANGLES = [[TETRAHEDRON[0][i] for i in t] for t in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))]
stl = b" " * 80 + struct.pack("<I", 4)
for corners in TRIANGLES:
    stl += struct.pack("<12fH", 0, 0, 0, *(x for corner in corners for x in corner), 0)
(folder / "read_stl" / "binary").write_bytes(stl)
loops = (" ".join(f"vertex {x} {y} {z}\n" for x, y, z in corners) for corners in TRIANGLES)
facets = "".join(f"facet normal 0 0 0\nouter loop\n{loop}endloop\nendfacet\n" for loop in loops)
(folder / "read_stl" / "text").write_text(f"solid s\n{facets}endsolid s\n")
for kind in range(4):
    nodes, _, cells = TETRAHEDRON if kind % 2 else SQUARE
    plane = [node[:3 if kind % 2 else 2] for node in nodes]
    for small in (0, 1):
        file = folder / "simplex_mesh" / f"{kind}_{'small' if small else 'any'}"
        file.write_bytes(arrays(kind, small, plane, [[i - 1 for i in cell] for cell in cells]))
