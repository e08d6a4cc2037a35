"""Walls, driven walls, contact of bodies, loads and damping."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Optional, Sequence, Tuple, Union

from ._bases import Part
from ._errors import Error, did_you_mean
from ._recipe import Recipe, function_value, plain
from ._recipes import LocalDamping, ViscousDamping
from .shapes import Region, region_value


@dataclass(frozen=True)
class Condition(Recipe):
    """What a wall blocks: `fixed`, `roller`, `symmetry(normal)` or `free_along(axis)`.

    parameter  unit  range      default          meaning
    kind       -     0 to 3     needed           fixed, roller, symmetry, free along
    direction  -     3 numbers  (0.0, 0.0, 0.0)  the normal, or the free axis"""

    kind: int
    direction: Tuple[float, float, float] = (0.0, 0.0, 0.0)


fixed = Condition(0)  #: no motion
roller = Condition(1)  #: no motion across the face


def symmetry(normal: Sequence[float]) -> Condition:
    """No motion across a plane with this normal."""
    x, y, z = (list(normal) + [0.0, 0.0])[:3]
    return Condition(2, (x, y, z))


def free_along(axis: int) -> Condition:
    """Motion along this axis alone, 0 for x."""
    return Condition(3, (float(axis == 0), float(axis == 1), float(axis == 2)))


def _condition(condition: Union[str, Condition]) -> Condition:
    if isinstance(condition, Condition):
        return condition
    known = {"fixed": fixed, "roller": roller}
    if condition not in known:
        raise Error(f"Wall.condition = {condition}: must be fixed or roller, symmetry(normal) or free_along(axis){did_you_mean(condition, known)}")
    return known[condition]


@dataclass(frozen=True)
class Wall(Recipe):
    """Nodes that may not move. Made by `left`, `right`, `bottom`, `top`, `front`, `back`, `on` and `where`.

    parameter   unit  range                    default  meaning
    axis        -     -1 to 2                  -1       a face's normal; -1: no face
    upper       -     True, False              False    at the upper end of the mesh
    set         -     a name                   ''       of a node set
    test        -     a function of positions  None
    condition   -     a condition              fixed    what is blocked
    given_name  -     a name                   ''       by which its reaction is read"""

    axis: int = -1
    upper: bool = False
    set: str = ""
    test: Optional[Callable[[Any], Any]] = None
    condition: Union[str, Condition] = fixed
    given_name: str = ""

    def value(self) -> Any:
        return {**super().value(), "condition": _condition(self.condition).value()}

    def named(self, name: str) -> "Wall":
        """The wall under a name of its own, by which its reaction is read."""
        return Wall(self.axis, self.upper, self.set, self.test, self.condition, name)


def left(condition: Union[str, Condition] = fixed) -> Wall:
    """The mesh's face at the lower end of x; condition: what is blocked, `fixed`, `roller`, `symmetry(normal)` or `free_along(axis)`."""
    return Wall(0, False, condition=condition)


def right(condition: Union[str, Condition] = fixed) -> Wall:
    """The mesh's face at the upper end of x; condition: what is blocked, `fixed`, `roller`, `symmetry(normal)` or `free_along(axis)`."""
    return Wall(0, True, condition=condition)


def bottom(condition: Union[str, Condition] = fixed) -> Wall:
    """The mesh's face at the lower end of y; condition: what is blocked, `fixed`, `roller`, `symmetry(normal)` or `free_along(axis)`."""
    return Wall(1, False, condition=condition)


def top(condition: Union[str, Condition] = fixed) -> Wall:
    """The mesh's face at the upper end of y; condition: what is blocked, `fixed`, `roller`, `symmetry(normal)` or `free_along(axis)`."""
    return Wall(1, True, condition=condition)


def front(condition: Union[str, Condition] = fixed) -> Wall:
    """The mesh's face at the lower end of z; condition: what is blocked, `fixed`, `roller`, `symmetry(normal)` or `free_along(axis)`."""
    return Wall(2, False, condition=condition)


def back(condition: Union[str, Condition] = fixed) -> Wall:
    """The mesh's face at the upper end of z; condition: what is blocked, `fixed`, `roller`, `symmetry(normal)` or `free_along(axis)`."""
    return Wall(2, True, condition=condition)


def on(set: str, condition: Union[str, Condition] = fixed) -> Wall:
    """The nodes of a named set of a simplex mesh; condition as of `left`."""
    return Wall(set=set, condition=condition)


def where(test: Callable[[Any], Any], condition: Union[str, Condition] = fixed) -> Wall:
    """The nodes whose positions pass a test: positions [n, 2 or 3], m, in, [n] booleans out, called once; condition as
    of `left`."""
    return Wall(test=test, condition=condition)


@dataclass(frozen=True)
class Driven(Part):
    """A wall whose nodes move: velocity, m/s, a vector, a `Signal`, or a function of time, or of place and time.

    parameter  unit  range                                                                     default
    wall       -     a wall                                                                    needed
    velocity   m/s   up to 3 numbers, a `Signal`, or a function of time, or of place and time  needed"""

    wall: Wall
    velocity: Any

    def value(self) -> Any:
        return {"wall": self.wall.value(), "velocity": function_value(self.velocity)}


@dataclass(frozen=True)
class Coulomb(Part):
    """Friction between deformable bodies, rad; infinity: no slip.

    parameter       unit  range      default  meaning
    friction        rad   [0, pi/2)  needed   angle; infinity: no slip
    velocity_limit  -     >= 0       0.75     share of cell / dt that contact may give; 0: no limit"""

    friction: float
    velocity_limit: float = 0.75

    def cpp(self) -> str:
        return "Coulomb<>"

    def value(self) -> Any:
        return {"friction": self.friction, "normals": {}, "velocity_limit": self.velocity_limit}


@dataclass(frozen=True)
class BodyForce(Part):
    """Acceleration of all matter, m/s2: a vector, or a function of time, or of place and time.

    parameter  unit  range                                                         default
    force      m/s2  up to 3 numbers, or a function of time, or of place and time  needed"""

    force: Any

    def value(self) -> Any:
        return {"value": function_value(self.force)}


def _faces(wall: Wall) -> Any:
    return {"axis": wall.axis, "upper": wall.upper, "set": wall.set, "test": wall.test}


@dataclass(frozen=True)
class Surface(Recipe):
    """The points of a body in a layer under its surface, which carry its area; made by `surface`.

    parameter  unit  range                                                default  meaning
    body       -     a body's name or number                              needed
    region     -     a shape, `Cells`, or a function of positions         needed   where its points are in the layer
    normal     -     up to 3 numbers, or a function of place and time     needed   outward, of any length
    thickness  m     > 0                                                  needed   of the layer"""

    body: Union[str, int]
    region: Region
    normal: Any
    thickness: float

    def cpp(self) -> str:
        return "PointLayer<>"

    def rules(self) -> str:
        return "SurfaceOptions"

    def checked(self) -> Any:
        return {"normal": function_value(self.normal), "thickness": self.thickness}

    def value(self) -> Any:
        return {"body": self.body, "region": region_value(self.region), "options": self.checked()}


def surface(body: Union[str, int], region: Region, normal: Any, thickness: float) -> Surface:
    """The surface of a body, for `Traction` and `Pressure`: the load goes with its points. Those of the body that lie in
    the region when the scene is made stand for an area of volume / thickness each. With a thickness of its own, a row of
    points or of cells, the region's area is the surface's; normal: out of the body."""
    return Surface(body, region, normal, thickness)


def _loaded(where: Union[Wall, Surface]) -> Any:
    return where.value() if isinstance(where, Surface) else _faces(where)


@dataclass(frozen=True)
class Traction(Part):
    """Traction, Pa, on faces of the mesh, `Traction(top(), (0, -1e3))`, or on a body's `surface`.

    parameter  unit  range                                                         default
    where      -     a wall's faces, or a `surface`                                needed
    traction   Pa    up to 3 numbers, or a function of time, or of place and time  needed"""

    where: Union[Wall, Surface]
    traction: Any

    def cpp(self) -> str:
        return "PointTraction<>" if isinstance(self.where, Surface) else "FaceTraction"

    def value(self) -> Any:
        return {"where": _loaded(self.where), "load": {"traction": function_value(self.traction)}}


@dataclass(frozen=True)
class Pressure(Part):
    """Pressure, Pa, against the outward normal of faces of the mesh, or of a body's `surface`.

    parameter  unit  range                                                  default
    where      -     a wall's faces, or a `surface`                         needed
    pressure   Pa    a number, or a function of time, or of place and time  needed"""

    where: Union[Wall, Surface]
    pressure: Any

    def cpp(self) -> str:
        return "PointTraction<>" if isinstance(self.where, Surface) else "FaceTraction"

    def value(self) -> Any:
        return {"where": _loaded(self.where), "load": {"pressure": function_value(self.pressure)}}


@dataclass(frozen=True)
class PointLoad(Part):
    """A force, N, on the point of a body that is nearest to a place, m.

    parameter  unit  range                                   default
    place      m     2 or 3 numbers                          needed
    force      N     up to 3 numbers, or a function of time  needed
    body       -     a body's name or number                 0"""

    place: Sequence[float]
    force: Any
    body: Union[str, int] = 0

    def value(self) -> Any:
        return {"body": self.body, "place": list(self.place), "force": function_value(self.force)}


@dataclass(frozen=True)
class FrictionalWall(Part):
    """Faces at rest with Coulomb friction, rad.

    parameter  unit  range           default  meaning
    where      -     a wall's faces  needed
    friction   rad   [0, pi/2)       needed   angle; infinity: no slip
    separates  -     True, False     True     whether matter may part from it"""

    where: Wall
    friction: float
    separates: bool = True

    def value(self) -> Any:
        return {"where": _faces(self.where), "friction": self.friction, "options": {"separates": self.separates}}


@dataclass(frozen=True)
class Absorbing(Part):
    """Dashpots along faces of the mesh (Lysmer and Kuhlemeyer 1969).

    parameter       unit   range           default    meaning
    where           -      a wall's faces  needed
    density         kg/m3  >= 0            the law's
    pressure_wave   m/s    >= 0            the law's  speed of pressure waves
    shear_wave      m/s    >= 0            the law's  speed of shear waves
    first_reaction  -      True, False     False      whether the forces of the first step hold it"""

    where: Wall
    density: float = float("nan")
    pressure_wave: float = float("nan")
    shear_wave: float = float("nan")
    first_reaction: bool = False

    def cpp(self) -> str:
        return "AbsorbingFaces"

    def value(self) -> Any:
        return {"where": _faces(self.where),
                "options": {"density": self.density, "pressure_wave": self.pressure_wave,
                            "shear_wave": self.shear_wave, "support": int(self.first_reaction)}}


@dataclass(frozen=True)
class OwnPart(Part):
    """A part of one's own, of a C++ header: an aggregate with these members.

    parameter  unit  range           default  meaning
    type       -     a name          needed   the class in C++, with its namespaces
    path       -     a file          needed   its header
    members    -     values by name  {}"""

    type: str
    path: str
    members: Any = field(default_factory=dict)

    def cpp(self) -> str:
        return "::" + self.type

    def rules(self) -> str:
        return ""

    def header(self) -> str:
        return self.path

    def value(self) -> Any:
        return plain(self.members)


__all__ = ["Absorbing", "BodyForce", "Condition", "Coulomb", "Driven", "FrictionalWall", "LocalDamping", "OwnPart",
           "PointLoad", "Pressure", "Surface", "Traction", "ViscousDamping", "Wall", "back", "bottom", "fixed", "free_along",
           "front", "left", "on", "right", "roller", "surface", "symmetry", "top",
           "where"]
