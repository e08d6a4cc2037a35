"""Meshes in: the C++ reader of Gmsh files and `from_meshio` take the same mesh out of the same file, or both refuse it. The files of
folder meshes are Gmsh's own (make_meshes.py there); others are written here by meshio."""

import itertools
from pathlib import Path

import numpy as np
import pytest

ar = pytest.importorskip("arenite")
meshio = pytest.importorskip("meshio")

FILES = sorted((Path(__file__).parent / "meshes").glob("*.msh"))
# meshio gives what it has read of these up, with errors of its own: physical tags of some entities alone
MESHIO_CANNOT = {"save_all_41", "without_groups_41"}
# and of these it says less than the file: of groups of one name the last, of an element's second group its name alone
MESHIO_FORGETS = {"overlapping_41": {"1:3"}, "one_name_22": {"hold", "0:1", "1:1"}, "one_name_41": {"hold", "0:1", "1:1"}}


def dimension_of(path):
    return 3 if path.stem.startswith(("box", "parametric", "surface")) else 2


def read(make):
    try:
        return make()
    except ar.Error as e:
        return str(e)


def regions(mesh):
    """Cells, by the places of their nodes, under the name of their region, or its number."""
    name = {tag: name for name, tag in mesh.region_names.items()}
    of = np.zeros(len(mesh.cells), int) if mesh.region is None else np.asarray(mesh.region)
    return sorted((str(name.get(r, r)), *sorted(map(tuple, np.asarray(mesh.nodes)[cell]))) for r, cell in zip(of.tolist(), np.asarray(mesh.cells)))


def sets(mesh):
    return {name: sorted(map(tuple, np.asarray(mesh.nodes)[nodes].tolist())) for name, nodes in mesh.node_sets.items()}


def nodes(mesh):
    return sorted(map(tuple, np.asarray(mesh.nodes).tolist()))


def check_same(a, b, without=()):
    if isinstance(a, str) or isinstance(b, str):
        assert isinstance(a, str) and isinstance(b, str), (a, b)
        return
    assert nodes(a) == nodes(b) and regions(a) == regions(b)
    assert {n: s for n, s in sets(a).items() if n not in without} == {n: s for n, s in sets(b).items() if n not in without}


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.stem)
def test_both_readers_take_the_same_out_of_a_file_of_gmsh(path):
    d = dimension_of(path)
    own = read(lambda: ar.SimplexMesh.from_gmsh(path, dimension=d))
    refused = path.stem.startswith(("quads", "second", "parametric", "surface"))
    assert isinstance(own, str) == refused, own
    try:
        given = meshio.read(path)
    except (Exception, SystemExit):
        assert path.stem in MESHIO_CANNOT or path.stem.startswith("parametric")
        return
    if path.stem.startswith("parametric"):
        return  # meshio takes parameters for nodes, or what it likes
    check_same(own, read(lambda: ar.SimplexMesh.from_meshio(given, d)), MESHIO_FORGETS.get(path.stem, ()))


def test_groups_of_gmsh_files_are_those_of_the_models():
    """Against the model, not the other reader."""
    def of(name, d=2):
        return ar.SimplexMesh.from_gmsh(Path(__file__).parent / "meshes" / f"{name}.msh", d)

    def box(name, d=2):
        x = np.array(sets(of(name, d))[box.group])
        return x.min(axis=0).tolist(), x.max(axis=0).tolist()

    for name in ("plane_22_text", "plane_41_binary"):
        plane = of(name)
        assert plane.region_names == {"soil": 1, "clay": 2}
        assert {k: s for k, s in sets(plane).items() if k != "bottom"} == {"anchor": [(0, 0)], "side nodes": [(2, 0), (2, 1)]}
        assert {y for _, y in sets(plane)["bottom"]} == {0.0}
        assert nodes(plane)[-1][0] == 2  # the loose point at (5, 5) is no node
    assert set(sets(of("overlapping_41"))) == set(sets(of("overlapping_22"))) == {"bottom", "outside", "1:3"}
    for name in ("cells_in_two_22", "cells_in_two_41"):
        assert set(of(name).region_names) == {"all", "soil"} and set(of(name).shared_regions) == {"all", "soil"}
    assert set(sets(of("nameless_41"))) == {"1:4", "0:7"} and set(np.asarray(of("nameless_41").region)) == {4, 9}
    assert (1.0, 1.0) not in sets(of("one_name_41"))["hold"] and (2.0, 1.0) in sets(of("one_name_41"))["hold"]
    assert set(np.asarray(of("save_all_41").region)) == {0, 1}
    box.group = "sides"
    assert box("box_41_text", 3) == ([0, 0, 0], [1, 1, 1])


@pytest.mark.parametrize("version,binary", itertools.product(("2.2", "4.1"), (False, True)))
def test_both_readers_take_the_same_out_of_a_file_of_meshio(tmp_path, version, binary):
    points = [(0, 0, 0), (1, 0, 0), (9, 9, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0)]
    mesh = meshio.Mesh(points, [("line", [[0, 1], [1, 5]]), ("triangle", [[0, 1, 3], [0, 3, 4], [1, 5, 3]]), ("line", [[4, 0]])],
                       point_data={"gmsh:dim_tags": np.array([(1, 1), (1, 2), (2, 1), (2, 1), (2, 1), (2, 1)])},
                       cell_data={"gmsh:physical": [np.array([1, 1]), np.array([1, 1, 1]), np.array([2])],
                                  "gmsh:geometrical": [np.array([1, 1]), np.array([1, 1, 1]), np.array([2])]},
                       field_data={"soil": np.array([1, 2]), "base": np.array([1, 1])})
    meshio.gmsh.write(tmp_path / "mesh.msh", mesh, fmt_version=version, binary=binary)
    own = ar.SimplexMesh.from_gmsh(tmp_path / "mesh.msh", 2)
    check_same(own, ar.SimplexMesh.from_meshio(mesh))
    check_same(own, ar.SimplexMesh.from_meshio(meshio.read(tmp_path / "mesh.msh")))
    assert sets(own) == {"base": [(0, 0), (1, 0), (2, 0)], "1:2": [(0, 0), (0, 1)]} and len(nodes(own)) == 5


SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (2.0, 0.0), (2.0, 1.0)]


def test_what_the_reader_of_gmsh_refuses_is_refused_of_a_meshio_mesh():
    def refusal(cells, d=None, points=SQUARE, **more):
        with pytest.raises(ar.Error) as told:
            ar.SimplexMesh.from_meshio(meshio.Mesh(points, cells, **more), d)
        return str(told.value)

    assert refusal([("quad", [[0, 1, 2, 3]]), ("triangle", [[1, 4, 2]])]) == \
        "SimplexMesh.from_meshio: type of element = 3 (quadrangle): the cells must be triangles"
    solid = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
    assert "5-node" not in refusal([("tetra", [[0, 1, 2, 3]])], 2, solid) and "3 dimensions" in refusal([("tetra", [[0, 1, 2, 3]])], 2, solid)
    assert "7 (pyramid): the cells must be tetrahedra" in refusal([("pyramid", [[0, 1, 2, 3, 4]])], None, solid)
    assert "9 (6-node triangle): must be of first order" in refusal([("triangle6", [[0, 1, 2, 3, 4, 5]])])
    assert "8 (3-node line): must be of first order" in refusal([("triangle", [[0, 1, 2]]), ("line3", [[0, 1, 4]])])
    assert "polygon: is no known type" in refusal([("triangle", [[0, 1, 2]]), ("polygon", [[0, 1, 2, 3]])])
    assert "z of node 3 = 1" in refusal([("triangle", [[0, 1, 4]]), ("triangle", [[0, 1, 2]])], 2, [(0, 0, 0), (1, 0, 0), (0, 1, 1), (0, 0, 0), (0, 1, 0)])
    assert "cells = 0" in refusal([("line", [[0, 1]])])
    assert "nodes of a cell = 1 2 3: the cell is given twice" in refusal([("triangle", [[0, 1, 2], [1, 2, 0]])])


def test_sets_of_other_formats_are_groups(tmp_path):
    """Abaqus: sets of cells, of faces and of nodes; Medit: references; VTK and XDMF: data by cell, made into sets."""
    mesh = meshio.Mesh([(*x, 0) for x in SQUARE], [("triangle", [[0, 1, 2], [0, 2, 3], [1, 4, 2], [4, 5, 2]]), ("line", [[0, 1], [1, 4]])],
                       point_sets={"anchor": np.array([3]), "base": np.array([4])},
                       cell_sets={"soil": [np.array([0, 1]), None], "clay": [np.array([2, 3]), np.array([], int)],
                                  "base": [None, np.array([0])]})
    made = ar.SimplexMesh.from_meshio(mesh)
    assert sorted(made.region_names) == ["clay", "soil"] and sets(made) == {"anchor": [(0, 1)], "base": [(0, 0), (1, 0), (2, 0)]}
    assert [name for name, *_ in regions(made)] == ["clay", "clay", "soil", "soil"]

    (tmp_path / "mesh.inp").write_text(
        "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n*ELEMENT, TYPE=S3, ELSET=soil\n1, 1, 2, 3\n"
        "*ELEMENT, TYPE=S3, ELSET=clay\n2, 1, 3, 4\n*NSET, NSET=base\n1, 2\n")
    abaqus = ar.SimplexMesh.from_meshio(meshio.read(tmp_path / "mesh.inp"))
    assert sets(abaqus) == {"base": [(0, 0), (1, 0)]} and [name for name, *_ in regions(abaqus)] == ["clay", "soil"]

    triangles = meshio.Mesh([(*x, 0) for x in SQUARE], [("triangle", [[0, 1, 2], [0, 2, 3]]), ("line", [[0, 1]])],
                            cell_data={"medit:ref": [np.array([3, 4]), np.array([5])]})
    triangles.write(tmp_path / "mesh.mesh")
    medit = ar.SimplexMesh.from_meshio(meshio.read(tmp_path / "mesh.mesh"))
    assert list(medit.region) == [3, 4] and sets(medit) == {"1:5": [(0, 0), (1, 0)]}

    try:
        import h5py  # which meshio needs for XDMF  # noqa: F401
        endings = ["vtu", "xdmf"]
    except ModuleNotFoundError:
        endings = ["vtu"]
    for ending in endings:
        named = meshio.Mesh(triangles.points, triangles.cells, cell_data={"soil": [np.array([0, 1]), np.array([5])]})
        named.write(tmp_path / f"mesh.{ending}", **({"data_format": "XML"} if ending == "xdmf" else {}))
        back = meshio.read(tmp_path / f"mesh.{ending}")
        assert not ar.SimplexMesh.from_meshio(back).region_names  # data by cell is a field as well
        back.cell_data_to_sets("soil")
        assert len(ar.SimplexMesh.from_meshio(back).region_names) == 2


def test_a_cell_that_is_there_once_for_each_of_its_groups(tmp_path):
    """As format 2.2 has it. Twice in one group, or in none, it is a mistake."""
    def given(again, tags, **more):
        triangles = [[0, 1, 2], [0, 2, 3], [1, 4, 2], [4, 5, 2], *again]
        mesh = meshio.Mesh([(*x, 0) for x in SQUARE], [("triangle", triangles), ("line", [[0, 1], [1, 0]])],
                           cell_data={key: [np.array([1, 1, 1, 1, *tags]), np.array([4, 5])] for key in ("gmsh:physical", "gmsh:geometrical")},
                           field_data={"all": np.array([1, 2]), "soil": np.array([2, 2]), "wet": np.array([3, 2]), "base": np.array([4, 1])}, **more)
        return mesh

    mesh = given([[0, 2, 3], [4, 5, 2], [5, 2, 4]], [2, 2, 3])  # in another order of its nodes, too
    meshio.gmsh.write(tmp_path / "mesh.msh", mesh, fmt_version="2.2", binary=False)
    own = ar.SimplexMesh.from_gmsh(tmp_path / "mesh.msh", 2)
    for made in own, ar.SimplexMesh.from_meshio(mesh), ar.SimplexMesh.from_meshio(meshio.read(tmp_path / "mesh.msh")):
        assert np.asarray(made.cells).tolist() == [[0, 1, 2], [0, 2, 3], [1, 4, 2], [4, 5, 2]] and np.asarray(made.region).tolist() == [1, -1, 1, -2]
        assert {name: sorted(np.asarray(r).tolist()) for name, r in made.shared_regions.items()} == {"all": [-2, -1], "soil": [-2, -1], "wet": [-2]}
        check_same(own, made)
    # of sets of cells each may have some that another has, too
    in_sets = ar.SimplexMesh.from_meshio(given([[0, 2, 3]], [2], cell_sets={"left": [np.array([0, 1, 4]), np.array([])]}))
    assert len(in_sets.cells) == 4 and in_sets.region[1] in in_sets.shared_regions["left"] and in_sets.region[1] in in_sets.shared_regions["soil"]
    for again, tags in (([[0, 2, 3]], [1]), ([[0, 2, 3]], [0]), ([[0, 2, 3], [0, 2, 3]], [2, 1])):
        with pytest.raises(ar.Error, match="SimplexMesh.from_meshio: nodes of a cell = 1 3 4: the cell is given twice"):
            ar.SimplexMesh.from_meshio(given(again, tags))
    with pytest.raises(ar.Error, match="the cell is given twice"):  # in one, and in that and another
        ar.SimplexMesh.from_meshio(given([[0, 2, 3]], [1], cell_sets={"left": [np.array([4]), np.array([])]}))


def test_a_cell_in_several_groups_belongs_to_the_region_of_each():
    """`Cells` of a name fill all of its cells, and two fills of one cell are told by the names of both bodies. Area of "soil": 1/2, of "all": 2."""
    triangles = [[0, 1, 2], [0, 2, 3], [1, 4, 2], [4, 5, 2]]
    given = meshio.Mesh(SQUARE, [("triangle", triangles)], cell_sets={"all": [np.arange(4)], "soil": [np.array([1])], "clay": [np.array([2, 3])]})
    mesh = ar.SimplexMesh.from_meshio(given)
    assert sorted(mesh.region_names) == ["all", "clay", "soil"] and sorted(mesh.shared_regions) == ["all", "clay", "soil"]
    rubber = ar.LinearElastic(density=1000, young=1e6, poisson=0.3)

    def scene(*names):
        return ar.Scene(ar.PlaneStrain(), mesh, ar.Numerics(ar.LinearSimplex), walls=[ar.bottom()], gravity=(0, -9.81),
                        bodies=[ar.fill(name, ar.Cells(name), rubber) for name in names])

    for name, area in (("soil", 0.5), ("clay", 1.0), ("all", 2.0)):
        assert np.isclose(scene(name).bodies[name].mass.sum(), 1000 * area, rtol=1e-12), name
    beside = scene("soil", "clay")  # in their order, without a warning
    assert [np.isclose(b.mass.sum(), 1000 * area) for b, area in zip(beside.bodies.values(), (0.5, 1.0))] == [True, True]
    with pytest.warns(ar.Warning, match="body soil and body all lie in one place: 4 of the 4 points of body soil are in the region of body all, and 4 of 16"):
        scene("soil", "all")
