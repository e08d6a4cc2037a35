"""Points of a scene for other programs: meshio and PyVista."""

from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np

from .scene import Scene


def _fields(scene: Scene, body: str) -> Dict[str, Any]:
    of = scene.bodies[body]
    fields = {"velocity": _in_space(of.velocity.copy()), "mass": of.mass.copy(), "volume": of.volume.copy(),
              "stress": of.stress.copy()}
    fields.update({name: column.copy() for name, column in of.history.items()})
    return fields


def _in_space(x: Any) -> Any:
    return x if x.shape[1] == 3 else np.column_stack([x, np.zeros(len(x))])


def to_meshio(scene: Scene, body: Optional[str] = None) -> Any:
    """The points of a body (by default the first) as a meshio mesh of vertices with their fields."""
    import meshio  # type: ignore[import-untyped,import-not-found,unused-ignore]

    name = body or next(iter(scene.bodies))
    x = _in_space(scene.bodies[name].position.copy())
    return meshio.Mesh(x, [("vertex", np.arange(len(x))[:, None])], point_data=_fields(scene, name))


def to_pyvista(scene: Scene, body: Optional[str] = None) -> Any:
    """The points of a body (by default the first) as PyVista's PolyData with their fields."""
    import pyvista  # type: ignore[import-untyped,import-not-found,unused-ignore]

    name = body or next(iter(scene.bodies))
    cloud = pyvista.PolyData(_in_space(scene.bodies[name].position.copy()))
    for field, values in _fields(scene, name).items():
        cloud.point_data[field] = values
    return cloud


__all__ = ["to_meshio", "to_pyvista"]
