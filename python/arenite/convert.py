"""Points of a scene for other programs: meshio and PyVista."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from .scene import Scene
from .vtu import in_space, point_fields


def to_meshio(scene: Scene, body: Optional[str] = None) -> Any:
    """The points of a body of a scene (by default the first) as a meshio mesh of vertices with their fields."""
    scene._refuse_ranks("to_meshio", "write files with Vtu")
    import meshio  # type: ignore[import-untyped,import-not-found,unused-ignore]

    name = body or next(iter(scene.bodies))
    x = in_space(scene.bodies[name].position)
    return meshio.Mesh(x, [("vertex", np.arange(len(x))[:, None])], point_data=point_fields(scene, name))


def to_pyvista(scene: Scene, body: Optional[str] = None) -> Any:
    """The points of a body of a scene (by default the first) as PyVista's PolyData with their fields."""
    scene._refuse_ranks("to_pyvista", "write files with Vtu")
    import pyvista  # type: ignore[import-untyped,import-not-found,unused-ignore]

    name = body or next(iter(scene.bodies))
    cloud = pyvista.PolyData(in_space(scene.bodies[name].position))
    for field, values in point_fields(scene, name).items():
        cloud.point_data[field] = values
    return cloud


__all__ = ["to_meshio", "to_pyvista"]
