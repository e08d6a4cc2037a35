"""Points of a scene between two steps: inserted, removed, probed, cut."""

from __future__ import annotations

from typing import Any, Callable, Dict, Iterable, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import Error
from ._html import members
from ._recipe import Recipe
from .fill import Field, Geostatic, fill
from .laws import WithDeviatoricStrain
from .scene import Scene
from .shapes import Region
from .views import Body

Name = Union[int, str]


class Totals(NamedTuple):
    """What points brought or took: points, their number; mass, kg; momentum [D], kg m/s; kinetic_energy and strain_energy (recoverable), J."""

    points: int
    mass: float
    momentum: Sequence[float]
    kinetic_energy: float
    strain_energy: float

    def _repr_html_(self) -> str:
        return members(self, self._fields)


class Probed(NamedTuple):
    """At places: velocity [n, D], m/s, and stress [n, 4 or 6], Pa; NaN where there is no matter."""

    velocity: NDArray[np.float64]
    stress: NDArray[np.float64]


def _body(scene: Scene, name: Name) -> Body:
    return list(scene.bodies.values())[scene.number_of(name)]


def fill_points(scene: Scene, body: Name, region: Region, per_cell: Optional[int] = None, velocity: Field = (0.0, 0.0, 0.0),
                stress: Union[Geostatic, Callable[[Any], Any], None] = None,
                history: Optional[Mapping[str, Any]] = None, may_be_empty: bool = False,
                exact_volume: bool = False) -> Totals:
    """Fills a region with points of a body of a running scene, as `fill` does when a scene is made. The region should
    be empty: points that are there stay. `per_cell`, `velocity`, `stress`, `history`, `may_be_empty` and `exact_volume` are those of `fill`. Raises `Error`, with the scene as it was, where `fill` would."""
    number = scene.number_of(body)
    recipe = fill(str(body), region, scene.law(number), per_cell, velocity, stress, may_be_empty, dict(history or {}),
                  exact_volume=exact_volume)
    with scene._named():
        return Totals(*scene._core.fill(number, scene._fill_value(number, recipe)))


def insert_points(scene: Scene, body: Name, position: ArrayLike, volume: ArrayLike, velocity: Optional[ArrayLike] = None,
                  mass: Optional[ArrayLike] = None, stress: Optional[ArrayLike] = None,
                  history: Optional[Mapping[str, ArrayLike]] = None) -> Totals:
    """Adds points to a body: position [n, D], m; volume [n] or a number, m3 (of a metre of thickness, or of the full
    circle); velocity [n, D], m/s; mass [n], kg, by default the law's density times the volume; stress [n, 4 or 6],
    Pa; history, arrays [n] by name. Raises `Error`, with the scene as it was, for a point outside of the mesh or one
    that is not finite. The energy balance counts what they bring as put in."""
    place = np.asarray(position, dtype=float)
    rows = {"velocity": velocity, "mass": mass, "stress": stress}
    values: dict[str, Any] = {name: np.asarray(x, dtype=float) for name, x in rows.items() if x is not None}
    values["position"] = place
    values["volume"] = np.broadcast_to(np.asarray(volume, dtype=float), place.shape[:1])
    if history:
        scene._check_history(scene.number_of(body), history)
        values["history"] = {name: np.asarray(x, dtype=float) for name, x in history.items()}
    with scene._named():
        return Totals(*scene._core.insert(scene.number_of(body), values))


def remove_points(scene: Scene, body: Name, where: Union[Region, ArrayLike]) -> Totals:
    """Removes the points of a body of a scene, `where` they are in a region (a shape, `Cells`, or a test of positions [n, D] that returns [n]
    booleans), or those for which an array [n] of booleans is true. The energy balance counts what they take as taken
    out."""
    number = scene.number_of(body)
    if isinstance(where, Recipe):
        return Totals(*scene._core.remove(number, where.value()))
    if callable(where):
        where = scene._test(list(scene.bodies)[number], where)
    mask = np.asarray(where)
    if mask.dtype != bool:
        raise Error(f"where = an array of {mask.dtype}: must be of booleans, one for each point")
    return Totals(*scene._core.remove(number, mask.astype(float)))


def probe(scene: Scene, body: Name, places: ArrayLike) -> Probed:
    """Velocity and stress of a body of a scene at places [n, D], m, interpolated between its points. Constant fields come out as
    they are."""
    return Probed(*scene._core.probe(scene.number_of(body), np.asarray(places, dtype=float)))


def section_force(scene: Scene, body: Name, through: Sequence[float], normal: Sequence[float], thickness: float,
                  of_nodes: bool = False) -> NDArray[np.float64]:
    """Force [D], N, on the body of a scene behind a plane cut from the part in front of it, into which the normal points; in
    tension positive along the normal. thickness, m: two cells or more. `of_nodes`: of the internal forces of nodes,
    through a cut of the whole body; better on coarse simplices."""
    cut = {"through": list(through), "normal": list(normal), "thickness": thickness}
    return np.array(scene._core.section_force(scene.number_of(body), cut, of_nodes))


def deviator_columns(law: WithDeviatoricStrain, names: Iterable[str]) -> Dict[str, str]:
    """The columns of a history that hold the deviator, with the names of their components."""
    components = ("xx", "yy", "xy", "yz", "zx")[:3 if law.dimension == 2 else 5]
    last = sorted((name for name in names if name.isdigit()), key=int)[-len(components):]
    return {name: f"deviatoric_strain_{component}" for name, component in zip(last, components)}


def deviatoric_strain(scene: Scene, body: Name = 0) -> NDArray[np.float64]:
    """sqrt(2/3 e : e) of the points of a body of a scene [n], -, whose law is a `WithDeviatoricStrain`."""
    law = scene.law(body)
    if not isinstance(law, WithDeviatoricStrain):
        raise Error(f"deviatoric_strain: the law of body {body} is {law.cpp()}: must be a WithDeviatoricStrain")
    columns = _body(scene, body).history
    xx, yy, *shear = (np.asarray(columns[name]) for name in deviator_columns(law, columns))
    size: NDArray[np.float64] = np.sqrt(2 / 3 * (xx**2 + yy**2 + (xx + yy)**2 + 2 * sum(x**2 for x in shear)))
    return size


__all__ = ["Probed", "Totals", "deviatoric_strain", "fill_points", "insert_points", "probe", "remove_points", "section_force"]
