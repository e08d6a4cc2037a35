"""Writes Gmsh meshes with meshio, and beside each mesh what a reader must find in it.

usage: make_meshes.py FOLDER

For each mesh (plane: triangles, solid: tetrahedra): NAME_22_text.msh, NAME_22_binary.msh, NAME_41_text.msh,
NAME_41_binary.msh and NAME.txt, the reference: words and numbers separated by blanks, namely
    nodes N, then x y z of each; cells N, then nodes and region of each;
    regions N, then name and tag of each; sets N, then name, length and nodes of each.
Also surface_text.stl and surface_binary.stl, closed surfaces of triangles, and surface.txt: vertices N, then x y z of
each; triangles N, then corners of each. Meshio is the independent writer; the reference is made from the arrays, not from a file.
"""

import itertools
import pathlib
import sys

import meshio
import numpy as np


def grid(*counts):
    """Simplices of a distorted box of unit cells (Kuhn's subdivision) and its nodes, the first axis running first."""
    dim = len(counts)
    index = np.arange(np.prod([n + 1 for n in counts])).reshape([n + 1 for n in counts][::-1]).T
    nodes = np.array([np.array(np.where(index == i)).ravel() for i in range(index.size)], float)
    random = np.random.default_rng(7)
    nodes = 0.1 * (nodes + random.uniform(-0.1, 0.1, nodes.shape))  # odd digits: text must carry all 17
    cells = []
    for corner in itertools.product(*[range(n) for n in counts]):
        for order in itertools.permutations(range(dim)):
            at = np.array(corner)
            cell = [index[tuple(at)]]
            for axis in order:
                at[axis] += 1
                cell.append(index[tuple(at)])
            cells.append(cell)
    return nodes, np.array(cells), index


def plane():
    xy, triangles, index = grid(5, 4)
    nodes = np.column_stack([xy, np.full(len(xy), 0.25)])
    left, bottom = index[0, :], index[:, 0]
    right = len(triangles) // 2
    blocks = [  # kind, elements, physical tag, geometrical tag
        ("line", np.column_stack([left[:-1], left[1:]]), 11, 1),
        ("line", np.column_stack([bottom[:-1], bottom[1:]]), 12, 2),
        ("triangle", triangles[:right], 3, 1),
        ("triangle", triangles[right:], 7, 2),
    ]
    names = {"left wall": [11, 1], "bottom": [12, 1], "loose sand": [3, 2], "clay": [7, 2]}
    return nodes, blocks, names, 2


def solid():
    nodes, cells, index = grid(3, 3, 2)
    face = index[:, :, 0]
    triangles = []
    for i, j in itertools.product(range(3), range(3)):
        a, b, c, d = face[i, j], face[i + 1, j], face[i + 1, j + 1], face[i, j + 1]
        triangles += [[a, b, c], [a, c, d]]
    edge = index[0, 0, :]
    half = len(cells) // 2
    blocks = [
        ("line", np.column_stack([edge[:-1], edge[1:]]), 4, 1),
        ("triangle", np.array(triangles), 5, 1),
        ("tetra", cells[:half], 1, 1),
        ("tetra", cells[half:], 2, 2),
    ]
    names = {"axis": [4, 1], "base": [5, 2], "soil": [1, 3], "core": [2, 3]}
    return nodes, blocks, names, 3


DIMENSION = {"line": 1, "triangle": 2, "tetra": 3}


def write(folder, name, nodes, blocks, names, dim):
    # Format 4.1 groups nodes by model entity. Any will do, as long as each entity has a node: the file then holds the
    # nodes in an order other than ours, with tags that say which is which.
    entity = np.zeros((len(nodes), 2), int)
    entity[:] = (dim, 1)
    for i, (kind, elements, _, geometrical) in enumerate(blocks):
        taken = blocks[:i]
        free = np.setdiff1d(elements, np.concatenate([[-1]] + [t[1][:1].ravel() for t in taken]))
        entity[free[: 2 + i]] = (DIMENSION[kind], geometrical)
    # A node that no element uses, in the middle: the reader must drop it and close the gap.
    middle = len(nodes) // 2
    shift = lambda a: np.where(a >= middle, a + 1, a)
    all_nodes = np.insert(nodes, middle, [9.0, 9.0, 9.0], axis=0)
    all_entities = np.insert(entity, middle, (dim, 1), axis=0)
    mesh = meshio.Mesh(
        all_nodes,
        [(kind, shift(elements)) for kind, elements, _, _ in blocks],
        point_data={"gmsh:dim_tags": all_entities},
        cell_data={
            "gmsh:physical": [np.full(len(b[1]), b[2]) for b in blocks],
            "gmsh:geometrical": [np.full(len(b[1]), b[3]) for b in blocks],
        },
        field_data={key: np.array(value) for key, value in names.items()},
    )
    for version, binary in itertools.product(["2.2", "4.1"], [False, True]):
        file = f"{name}_{version.replace('.', '')}_{'binary' if binary else 'text'}.msh"
        meshio.gmsh.write(folder / file, mesh, fmt_version=version, binary=binary)

    with open(folder / f"{name}.txt", "w") as out:
        print("nodes", len(nodes), file=out)
        for x in nodes.tolist():
            print(*map(repr, x), file=out)
        cells = [(*c, b[2]) for b in blocks if DIMENSION[b[0]] == dim for c in b[1].tolist()]
        print("cells", len(cells), file=out)
        for cell in cells:
            print(*cell, file=out)
        word = lambda key: key.replace(" ", "_")
        regions = {key: tag for key, (tag, d) in names.items() if d == dim}
        print("regions", len(regions), file=out)
        for key, tag in regions.items():
            print(word(key), tag, file=out)
        sets = {key: b[1] for key, (tag, d) in names.items() for b in blocks if d < dim and (DIMENSION[b[0]], b[2]) == (d, tag)}
        print("sets", len(sets), file=out)
        for key, elements in sets.items():
            members = np.unique(elements).tolist()
            print(word(key), len(members), *members, file=out)


def surface(folder):
    """The hull of the solid as STL: meshio writes text with all digits and binary files with single precision."""
    nodes, cells, _ = grid(3, 3, 2)
    nodes = nodes.astype(np.float32).astype(float)
    faces = {}
    for a, b, c, d in cells.tolist():
        if np.linalg.det(nodes[[b, c, d]] - nodes[a]) < 0:
            b, c = c, b
        for face in ((a, c, b), (a, b, d), (b, c, d), (a, d, c)):
            if not faces.pop(tuple(sorted(face)), None):
                faces[tuple(sorted(face))] = face
    triangles = np.array(list(faces.values()))
    number = {}  # in the order in which corners come first
    for node in triangles.ravel().tolist():
        number.setdefault(node, len(number))
    mesh = meshio.Mesh(nodes, [("triangle", triangles)])
    meshio.stl.write(folder / "surface_text.stl", mesh, binary=False)
    meshio.stl.write(folder / "surface_binary.stl", mesh, binary=True)
    with open(folder / "surface.txt", "w") as out:
        print("vertices", len(number), file=out)
        for x in nodes[list(number)].tolist():
            print(*map(repr, x), file=out)
        print("triangles", len(triangles), file=out)
        for triangle in triangles.tolist():
            print(*[number[i] for i in triangle], file=out)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: make_meshes.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    write(folder, "plane", *plane())
    write(folder, "solid", *solid())
    surface(folder)


if __name__ == "__main__":
    main()
