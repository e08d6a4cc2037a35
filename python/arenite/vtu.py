"""VTU files of a scene, which ParaView opens as one series."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from . import _core
from ._errors import Error
from .laws import WithDeviatoricStrain
from .points import deviator_columns, deviatoric_strain
from .scene import Scene


def in_space(x: Any) -> Any:
    """Rows [n, 2 or 3] as [n, 3]."""
    x = np.asarray(x, dtype=float)
    return x if x.shape[1] == 3 else np.column_stack([x, np.zeros(len(x))])


def point_fields(scene: Scene, body: str) -> Dict[str, Any]:
    """Of the points of a body: velocity [n, 3], m/s, stress [n, 6] (xx, yy, zz, xy, yz, zx), Pa, mean pressure,
    compression positive, mass, volume, and the numbers of the law's history by name; of a `WithDeviatoricStrain` also
    sqrt(2/3 e : e), "deviatoric_strain"."""
    of = scene.bodies[body]
    stress = np.asarray(of.stress)
    fields = {"velocity": in_space(of.velocity),
              "stress": np.column_stack([stress, np.zeros((len(stress), 6 - stress.shape[1]))]),
              "pressure": -stress[:, :3].mean(axis=1), "mass": of.mass.copy(), "volume": of.volume.copy()}
    names: Dict[str, str] = {}
    law = scene.law(body)
    if isinstance(law, WithDeviatoricStrain):
        names = deviator_columns(law, of.history)
        fields["deviatoric_strain"] = deviatoric_strain(scene, body)
    fields.update({names.get(name, name): np.asarray(column, dtype=float) for name, column in of.history.items()})
    return fields


class Vtu:
    """Observer for `run`: writes the points of each body as PREFIX_BODY_0000.vtu (`prefix`: folder and beginning of the names), .., the cells
    of a simplex mesh if `mesh`, and PREFIX.pvd. Makes the folder. `ar.run(scene, end=1, every={0.1: ar.Vtu("out/column")})`

    `resumed`: goes on with the series that is there, behind its frames before the scene's time; by default where the scene was
    restored from a saved state, behind those up to the time of that. Else the series of an earlier run is replaced with a `Warning`; if the scene is past its first
    frame, it is kept, and `Error` raised."""

    def __init__(self, prefix: Union[str, "os.PathLike[str]"], mesh: bool = False, resumed: Optional[bool] = None) -> None:
        self._prefix, self._mesh, self._resumed = os.fspath(prefix), mesh, resumed
        self._series = os.path.realpath(self._prefix)
        self._begun = False
        self._files: List[Tuple[float, str, int]] = []  # of the frames so far: time, file, part
        self._frames = 0
        self._at: Optional[float] = None  # time of the last frame that was written here
        folder = Path(self._prefix).parent
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as e:
            raise Error(f"Vtu: folder = {folder}: cannot be made: {e.strerror}") from e
        self._list = _core.PvdWriter(self._prefix + ".pvd", True)

    def __call__(self, scene: Scene) -> None:
        parts: List[Tuple[str, Any, Any, Dict[str, Any]]] = [
            (name, in_space(body.position), None, point_fields(scene, name)) for name, body in scene.bodies.items()]
        if self._mesh:
            if scene.cells is None:
                raise Error("Vtu: mesh = True: goes with a mesh of simplices alone")
            parts.append(("mesh", in_space(scene.nodes().position), scene.cells, {}))
        scene._meet("files of Vtu", prefix=self._prefix, mesh=self._mesh)
        restored = scene._restored
        goes_back = restored is not None and self._series not in restored.series  # frames behind that state are of another future
        if goes_back or not self._begun:
            resumed = self._begun or (restored is not None if self._resumed is None else self._resumed)
            time = scene.time
            if restored is not None and goes_back and resumed:
                time = min(time, float(np.nextafter(restored.time, np.inf)))  # a frame at its time was written before it was saved
            self._files = self._list.kept(time, resumed, scene.rank == 0)  # written by other ranks, perhaps
            self._frames, self._at = len({time for time, _, _ in self._files}), None
            self._write_list(scene)
            self._begun = True
            if restored is not None:
                restored.series.add(self._series)
        again = self._at == scene.time  # at the start of a run that goes on
        frame = self._frames - again
        pieces = scene._pieces()
        for name, position, cells, fields in parts:
            _core.write_vtu(self._file(name + pieces[scene.rank], frame), position, cells, fields)
        scene._meet("files of Vtu", prefix=self._prefix, mesh=self._mesh)
        if not again:
            self._files += [(scene.time, self._file(part[0] + piece, frame), number * len(pieces) + k)
                            for number, part in enumerate(parts) for k, piece in enumerate(pieces)]
            self._frames, self._at = frame + 1, scene.time
            self._write_list(scene)

    def _write_list(self, scene: Scene) -> None:
        if scene.rank == 0:
            self._list.replace(self._files)

    def _file(self, part: str, frame: int) -> str:
        return f"{self._prefix}_{part}_{frame:04d}.vtu"


__all__ = ["Vtu"]
