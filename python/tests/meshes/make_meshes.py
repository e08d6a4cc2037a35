"""Writes the Gmsh files beside it, with Gmsh's own Python package (PyPI `gmsh`), which the tests do not need.

Models: plane (two surfaces, partly loose), solid (a box), each with groups that share a tag over dimensions, overlap, or have no name."""

import itertools
from pathlib import Path

import gmsh


def plane():
    geo = gmsh.model.geo
    corners = [geo.addPoint(x, y, 0.25, 2) for x, y in ((0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1))]
    lines = [geo.addLine(corners[i], corners[(i + 1) % 6]) for i in range(6)]
    middle = geo.addLine(corners[1], corners[4])
    left = geo.addPlaneSurface([geo.addCurveLoop([lines[0], middle, lines[4], lines[5]])])
    right = geo.addPlaneSurface([geo.addCurveLoop([lines[1], lines[2], lines[3], -middle])])
    geo.addPoint(5, 5, 0)  # no element uses its node
    geo.synchronize()
    return corners, lines, [left, right]


def solid():
    gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
    gmsh.model.occ.synchronize()
    of = [[tag for _, tag in gmsh.model.getEntities(d)] for d in range(4)]
    return of[0], of[1], of[2], of[3]


def groups(given):
    for dim, entities, tag, name in given:
        gmsh.model.addPhysicalGroup(dim, entities, tag, name)


def write(name, model, given, dim, version=4.1, binary=False, **options):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.MeshSizeMin", 0.7)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.7)
    parts = model()
    groups(given(*parts))
    for option, value in options.items():
        gmsh.option.setNumber("Mesh." + option, value)
    gmsh.option.setNumber("Mesh.MshFileVersion", version)
    gmsh.option.setNumber("Mesh.Binary", binary)
    gmsh.model.mesh.generate(dim)
    gmsh.write(str(Path(__file__).parent / f"{name}.msh"))
    gmsh.finalize()


def shared_tags(points, lines, surfaces):
    return [(2, surfaces[:1], 1, "soil"), (2, surfaces[1:], 2, "clay"), (1, lines[:2], 1, "bottom"), (0, points[:1], 1, "anchor"),
            (0, points[2:4], 2, "side nodes")]


def overlapping(points, lines, surfaces):
    return [(2, surfaces, 3, "soil"), (1, lines[:2], 1, "bottom"), (1, lines[:4], 2, "outside"), (1, lines[1:3], 3, "")]


def nameless(points, lines, surfaces):
    return [(2, surfaces[:1], 4, ""), (2, surfaces[1:], 9, ""), (1, lines[:2], 4, ""), (0, points[:2], 7, "")]


def one_name(points, lines, surfaces):
    return [(2, surfaces, 3, "soil"), (1, lines[:2], 1, "hold"), (0, points[3:4], 1, "hold")]


def cells_in_two(points, lines, surfaces):
    return [(2, surfaces, 3, "all"), (2, surfaces[:1], 4, "soil")]


def partly(points, lines, surfaces):
    return [(2, surfaces[:1], 1, "soil"), (1, lines[:1], 2, "bottom")]


def box(points, lines, surfaces, volumes):
    return [(3, volumes, 1, "soil"), (2, surfaces[:2], 1, "sides"), (2, surfaces[1:3], 2, "two"), (1, lines[:3], 1, "edges"),
            (0, points[:2], 1, "corners")]


def box_partly(points, lines, surfaces, volumes):
    return [(2, surfaces[:1], 3, "side")]


if __name__ == "__main__":
    for version, binary in itertools.product((2.2, 4.1), (False, True)):
        form = f"{str(version).replace('.', '')}_{'binary' if binary else 'text'}"
        write(f"plane_{form}", plane, shared_tags, 2, version, binary)
        write(f"box_{form}", solid, box, 3, version, binary)
    for version in (2.2, 4.1):
        form = str(version).replace(".", "")
        write(f"overlapping_{form}", plane, overlapping, 2, version)
        write(f"nameless_{form}", plane, nameless, 2, version)
        write(f"one_name_{form}", plane, one_name, 2, version)
        write(f"cells_in_two_{form}", plane, cells_in_two, 2, version)
        write(f"partly_{form}", plane, partly, 2, version, SaveAll=version == 2.2)
        write(f"quads_{form}", plane, shared_tags, 2, version, RecombineAll=1)
        write(f"second_order_{form}", plane, shared_tags, 2, version, ElementOrder=2)
        write(f"without_groups_{form}", plane, lambda *parts: [], 2, version)
    write("save_all_41", plane, partly, 2, 4.1, SaveAll=1)
    write("parametric_22", solid, box, 3, 2.2, SaveParametric=1)
    write("parametric_41", solid, box, 3, 4.1, SaveParametric=1)
    write("surface_41", solid, box_partly, 3, 4.1)
