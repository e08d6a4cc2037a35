"""Pictures of a scene: its points, coloured by a quantity, once or through a run. Needs matplotlib."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._errors import Error, did_you_mean
from ._folder import PathLike
from ._optional import need
from .meshes import Axisymmetric
from .scene import Scene, run
from .vtu import point_fields

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Quantity = Union[str, Callable[[Any], Any]]

UNITS = {"pressure": "Pa", "shear_stress": "Pa", "stress": "Pa", "speed": "m/s", "velocity": "m/s", "mass": "kg", "volume": "m3"}


def quantities(scene: Scene, body: str) -> Dict[str, Any]:
    """Numbers of a body's points, [n] by name: "pressure" (compression positive) and "shear_stress" (sqrt(3 J2)), Pa, "speed", m/s,
    "velocity_x" .., "stress_xx" .., "mass", "volume", and those of the law's history."""
    found: Dict[str, Any] = {}
    for name, values in point_fields(scene, body).items():
        if values.ndim == 1:
            found[name] = values
        else:
            found.update((f"{name}_{axes}", values[:, k]) for k, axes in enumerate(("x", "y", "z") if values.shape[1] == 3 else
                                                                                 ("xx", "yy", "zz", "xy", "yz", "zx")))
            if name == "velocity":
                found["speed"] = np.linalg.norm(values, axis=1)
            else:
                deviator = values.copy()
                deviator[:, :3] -= values[:, :3].mean(axis=1, keepdims=True)
                found["shear_stress"] = np.sqrt(1.5 * ((deviator[:, :3]**2).sum(axis=1) + 2 * (deviator[:, 3:]**2).sum(axis=1)))
    return found


class Frame(NamedTuple):
    """What a picture shows: time, s; places in its plane [n, 2], m; widths [n], m; values [n]."""

    time: float
    place: Any
    width: Any
    value: Any


def _is_axisymmetric(scene: Scene) -> bool:
    return isinstance(scene._recipes["kinematics"], Axisymmetric)


def _axes_of(scene: Scene, plane: Optional[str]) -> Tuple[int, int]:
    dimension = next(iter(scene.bodies.values())).position.shape[1]
    given = ("xy" if plane is None else plane)
    known = "xyz"[:dimension]
    if len(given) != 2 or given[0] == given[1] or any(axis not in known for axis in given):
        raise Error(f"plot.plane = {plane!r}: must be two of {', '.join(known)}, such as 'xy'")
    return known.index(given[0]), known.index(given[1])


def _frame(scene: Scene, quantity: Quantity, bodies: Sequence[str], axes: Tuple[int, int]) -> Frame:
    places, widths, values = [], [], []
    dimension = 2
    for name in bodies:
        body = scene.bodies[name]
        x, volume = np.asarray(body.position), np.asarray(body.volume)
        dimension = x.shape[1]
        if callable(quantity):
            value = np.asarray(quantity(body), dtype=float)
            if value.shape != (len(x),):
                raise Error(f"plot.quantity: of body {name!r}: returned an array {list(value.shape)}; must be [{len(x)}], one for each point")
        else:
            known = quantities(scene, name)
            if quantity not in known:
                raise Error(f"plot.quantity = {quantity}: body {name!r} has none; it has {', '.join(sorted(known))}")
            value = known[quantity]
        if _is_axisymmetric(scene):
            width = np.sqrt(volume / (2 * np.pi * np.maximum(x[:, 0], 1e-300)))
        else:
            width = volume**(1 / dimension)
        places.append(x)
        widths.append(width)
        values.append(value)
    x, width, value = np.concatenate(places), np.concatenate(widths), np.concatenate(values)
    if dimension == 3:  # seen from where the third axis points to; the nearest last
        order = np.argsort(x[:, 3 - sum(axes)] * (1 if (axes[0] - axes[1]) % 3 == 2 else -1), kind="stable")
        x, width, value = x[order], width[order], value[order]
    return Frame(scene.time, x[:, axes], width, value)


def _chosen(scene: Scene, body: Union[None, str, Sequence[str]]) -> List[str]:
    names = list(scene.bodies) if body is None else [body] if isinstance(body, str) else list(body)
    for name in names:
        scene.number_of(name)
    return names


def _add_points(frame: Frame, ax: Any, limits: Tuple[float, float], colours: str) -> Any:
    collections = need("matplotlib.collections", "plot()")
    points = collections.EllipseCollection(frame.width, frame.width, 0 * frame.width, units="x", offsets=frame.place, cmap=colours,
                                           offset_transform=ax.transData, linewidths=0)
    points.set_array(frame.value)
    points.set_clim(*limits)
    ax.add_collection(points)
    ax.set_title(f"t = {frame.time:.4g} s")
    return points


def _draw(frame: Frame, ax: Any, label: str, names: Tuple[str, str], limits: Tuple[float, float], colours: str,
          box: Tuple[Any, Any]) -> Any:
    points = _add_points(frame, ax, limits, colours)
    ax.set(xlabel=f"{names[0]} [m]", ylabel=f"{names[1]} [m]", aspect="equal", xlim=(box[0][0], box[1][0]), ylim=(box[0][1], box[1][1]))
    ax.figure.colorbar(points, ax=ax, label=label, shrink=0.8)
    return points


def _label(quantity: Quantity) -> str:
    if callable(quantity):
        return str(getattr(quantity, "__name__", "")).replace("<lambda>", "")
    unit = UNITS.get(quantity, UNITS.get(quantity.rsplit("_", 1)[0], ""))
    return quantity.replace("_", " ") + (f" [{unit}]" if unit else "")


def _names(scene: Scene, axes: Tuple[int, int]) -> Tuple[str, str]:
    known = "ry" if _is_axisymmetric(scene) else "xyz"
    return known[axes[0]], known[axes[1]]


def _range(values: Sequence[Any], limits: Optional[Tuple[float, float]]) -> Tuple[float, float]:
    if limits is not None:
        low, high = limits
        return low, high
    finite = [v[np.isfinite(v)] for v in values]
    sound = [v for v in finite if len(v)]
    return (min(float(v.min()) for v in sound), max(float(v.max()) for v in sound)) if sound else (0.0, 1.0)


def _box(scene: Scene, axes: Tuple[int, int]) -> Tuple[Any, Any]:
    """Corners of the mesh in the plane."""
    position = np.asarray(scene.nodes().position)[:, axes]
    return position.min(axis=0), position.max(axis=0)


def plot(scene: Scene, quantity: Quantity = "pressure", *, body: Union[None, str, Sequence[str]] = None, plane: Optional[str] = None,
         limits: Optional[Tuple[float, float]] = None, colours: str = "viridis", ax: Any = None) -> Axes:
    """Draws the points of a scene, as wide as their matter, coloured by a quantity; returns the axes. Needs matplotlib.

    quantity  "pressure", "shear_stress", "speed", "velocity_x", "stress_xy", "mass", "volume", or of the law's history by its name; or
              a function of a body that returns [n]
    body      one or more by name; all by default
    plane     two axes to look along the third: "xy" by default; in space also "xz", "zy" ..
    limits    of the colours; by default those of the values
    colours   a colour map of matplotlib
    ax        axes to draw into; without, a new figure"""
    scene._refuse_ranks("plot", "write files with Vtu")
    pyplot = need("matplotlib.pyplot", "plot()")
    axes = _axes_of(scene, plane)
    if colours not in pyplot.colormaps():
        raise Error(f"plot.colours = {colours}: must be a colour map of matplotlib{did_you_mean(colours, pyplot.colormaps())}")
    if ax is not None and not hasattr(ax, "add_collection"):
        raise Error(f"plot.ax = {ax!r}: must be axes of matplotlib")
    frame = _frame(scene, quantity, _chosen(scene, body), axes)
    if ax is None:
        _, ax = pyplot.subplots(constrained_layout=True)
    _draw(frame, ax, _label(quantity), _names(scene, axes), _range([frame.value], limits), colours, _box(scene, axes))
    drawn: Axes = ax
    return drawn


def animate(scene: Scene, path: PathLike, quantity: Quantity = "pressure", *, end: float, every: float,
            body: Union[None, str, Sequence[str]] = None, plane: Optional[str] = None, limits: Optional[Tuple[float, float]] = None,
            colours: str = "viridis", per_second: float = 20, **options: Any) -> Path:
    """Runs a scene to `end`, s, and writes what `plot` shows each `every` s as a film, FILE.gif or FILE.mp4; returns its path. A run
    that raises is drawn as far as it came. Needs matplotlib, and for MP4 the program ffmpeg.

    per_second  frames of the film
    options     of `run`: `courant`, `after_step`, `watch` ..

    `quantity`, `body`, `plane`, `limits` and `colours` are those of `plot`."""
    scene._refuse_ranks("animate", "write files with Vtu")
    pyplot, films = need("matplotlib.pyplot", "animate()"), need("matplotlib.animation", "animate()")
    target, axes, names = Path(path), _axes_of(scene, plane), _chosen(scene, body)
    kinds = {".gif": "pillow", ".mp4": "ffmpeg"}
    if target.suffix.lower() not in kinds:
        raise Error(f"animate.path = {target}: must end with .gif or .mp4")
    if not films.writers.is_available(kinds[target.suffix.lower()]):
        raise Error("animate: an MP4 needs the program ffmpeg: apt install ffmpeg; or name a .gif")
    if target.exists() and not target.is_file():
        raise Error(f"animate.path = {target}: must be a regular file, a link, or nothing")
    frames: List[Frame] = []
    try:
        run(scene, end, every={every: lambda s: frames.append(_frame(s, quantity, names, axes))}, **options)
    finally:
        if frames:
            figure, ax = pyplot.subplots(constrained_layout=True)
            shades = _range([f.value for f in frames], limits)
            points = _draw(frames[0], ax, _label(quantity), _names(scene, axes), shades, colours, _box(scene, axes))
            figure.canvas.draw()
            figure.set_layout_engine("none")  # all frames as the first one
            part = target.with_name(f"{target.stem}.part{target.suffix}")
            part.unlink(missing_ok=True)
            writer = films.writers[kinds[target.suffix.lower()]](fps=per_second)
            try:
                with writer.saving(figure, os.fspath(part), figure.dpi):
                    for frame in frames:
                        points.remove()
                        points = _add_points(frame, ax, shades, colours)
                        writer.grab_frame()
                os.replace(part, target)
            finally:
                part.unlink(missing_ok=True)
                pyplot.close(figure)
    return target


__all__ = ["animate", "plot"]
