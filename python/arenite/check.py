"""Which parts and values of a scene lie outside of what random scenes have tried (docs/envelope.md)."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Tuple

import numpy as np

from ._html import table
from ._recipe import arguments_of
from .scene import Scene


@dataclass(frozen=True)
class Outside:
    """A part that no random scene has, or a value beyond those tried: `what` it is, its value, and what was tried."""

    what: str
    value: Any
    tried: str

    def __str__(self) -> str:
        value = f"{self.value:.6g}" if isinstance(self.value, float) else self.value
        return f"{self.what} = {value}: tried {self.tried}"


#: What the endings of random scenes mean (docs/envelope.md).
ENDINGS = {"sound": "ran to their end, with momentum and energy kept (sound)",
           "damped": "the same, and the transfer took more than a tenth of the energy (damped)",
           "left": "the same, and points left the mesh (left)",
           "stopped": "were stopped by the watch or an error that names time and cause (stopped)",
           "refused": "were refused as they were made (refused)",
           "fault": "went wrong without an error (fault)"}


@dataclass(frozen=True)
class Checked:
    """`outside`: what was not tried. `scenes`: random scenes with the same kinematics, mesh, shape functions, transfer, stress update and
    average, and in `endings` how many of them, %, ended sound, damped, left, stopped or refused (docs/envelope.md says what that means)."""

    outside: List[Outside]
    scenes: int
    endings: Dict[str, float]

    def __str__(self) -> str:
        said = ["outside of what random scenes have tried; not wrong, but compare it with a solution that you know:", *map(str, self.outside)] \
            if self.outside else ["all parts and values lie within what random scenes have tried"]
        if self.scenes:
            said.append(f"{self.scenes} random scenes had these numerics, with values drawn from ranges so wide that many tear matter apart on purpose, to see "
                        "whether anything goes wrong unnoticed. The shares tell of these extremes, not of your scene:")
            said += [f"  {self.endings[e]:5.1f} % {meaning}" for e, meaning in ENDINGS.items() if self.endings[e] or e == "fault"]
        return "\n".join(said)

    def _repr_html_(self) -> str:
        return table("Outside of what random scenes have tried" if self.outside else "All lies within what random scenes have tried",
                     ("what", "value", "tried"), [(o.what, o.value, o.tried) for o in self.outside])


@lru_cache(maxsize=None)
def _tried() -> Dict[str, Any]:
    data: Dict[str, Any] = json.loads((Path(__file__).parent / "_envelope.json").read_text(encoding="utf-8"))
    return data


def _extents(scene: Scene) -> Tuple[float, float]:
    """Least and greatest edge of a cell, m."""
    value = scene._recipes["mesh"].value()
    if "cell" in value:
        return float(value["cell"]), float(value["cell"])
    if "nodes" in value:
        corners = np.asarray(value["nodes"])[np.asarray(value["cells"], int)]
        n = corners.shape[1]
        edges = np.concatenate([np.linalg.norm(corners[:, i] - corners[:, j], axis=1) for i in range(n) for j in range(i)])
        return float(edges.min()), float(edges.max())
    gaps = np.concatenate([np.diff(np.asarray(value[axis], float)) for axis in "xyz" if len(value.get(axis) or ())])
    return float(gaps.min()), float(gaps.max())


def _values(scene: Scene, courant: float) -> Iterator[Tuple[str, str, float]]:
    """(what, quantity, value) of a scene as it is now."""
    recipes = scene._recipes
    sizes = _extents(scene)
    for size in dict.fromkeys(sizes):
        yield "mesh, edge of a cell, m", "cell", size
    gravity = recipes["gravity"]
    if callable(gravity) and arguments_of(gravity) == 1:
        gravity = gravity(scene.time)
    g = float(np.linalg.norm(gravity)) if gravity is not None and not callable(gravity) and not hasattr(gravity, "cpp") else None
    if g is not None:
        yield "gravity, m/s2", "gravity", g
    moduli = {}
    matter = 0.0
    for fill in recipes["bodies"]:
        body, law = scene.bodies[fill.name], fill.law.value()
        velocity = np.asarray(body.velocity)
        matter += float(np.sum(body.mass))
        speed = float(np.max(np.linalg.norm(velocity, axis=1), initial=0))
        yield f"{fill.name}: speed, m/s", "speed", speed
        if len(body):
            most = max(float(np.max(np.unique(np.asarray(of.column("cell")), return_counts=True)[1], initial=0)) for of in scene._parts_of(fill.name))
            yield f"{fill.name}: points in a cell", "per_cell", most
        for name in "young", "poisson", "density", "friction", "cohesion", "dilatancy":
            if isinstance(law.get(name), (int, float)):
                yield f"{fill.name}: {name}", name, float(np.degrees(law[name])) if name in ("friction", "dilatancy") else float(law[name])
        if all(isinstance(law.get(name), (int, float)) for name in ("young", "poisson", "density")):
            nu = law["poisson"]
            modulus = law["young"] * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
            moduli[fill.name] = law["young"]
            yield f"{fill.name}: speed over that of pressure waves", "mach", speed / float(np.sqrt(modulus / law["density"]))
            if g is not None:
                yield f"{fill.name}: weight of ten cells over the stiffness", "weight", law["density"] * g * 10 * sizes[1] / modulus
    if recipes["contact"] is not None and len(moduli) > 1:
        ratio = max(moduli.values()) / min(moduli.values())
        yield "stiffest body over the softest", "stiffness_ratio", ratio
    for named, rigid in zip(scene.rigids, recipes["rigids"]):
        mass = getattr(rigid.motion, "mass", None)
        if mass is not None:
            yield f"rigid {named}: mass over that of all matter", "mass_ratio", float(mass) / matter
        if np.isfinite(rigid.friction):
            yield f"rigid {named}: friction, deg", "contact_friction", float(np.degrees(rigid.friction))
    yield "Courant number", "courant", courant


def _apart(bound: float, value: float) -> str:
    """A bound in so many digits that it shows on which side of it a value lies."""
    texts = (f"{bound:.{digits}g}" for digits in range(3, 18))
    return next(text for text in texts if (float(text) < value) == (bound < value) and (float(text) > value) == (bound > value))


def _own_classes(scene: Scene) -> List[str]:
    """Names of the classes in a scene's type that a user chooses."""
    not_chosen = {"Scene", "Numerics", "Bodies", "BodyList", "Fill", "Rigid", "TrackEnergy", "Reactions", "AnyFriction", "ConstantFriction", "ConstantStiffness",
                  "ForgetsOpening", "NoAntiLocking"}
    policies = [fill.law.value().get("friction_law", {}).get("policy") for fill in scene._recipes["bodies"]]
    words = [*re.findall(r"[A-Za-z]\w*", scene.composition), *scene._recipes["numerics"].kinds(), *(p for p in policies if p)]
    return [w for w in dict.fromkeys(words) if w not in not_chosen and not w.startswith(("Any", "Constant"))]


def check(scene: Scene, courant: float = 0.5) -> Checked:
    """Compares a scene, as it is now, and the Courant number `courant` that it shall run with, with what tens of thousands of random scenes have tried: each part, the numerics as a
    whole, and each value (moduli, angles, density, cells, speed, weight, points a cell, masses; of gravity as a function of time that of now; values that are other functions are not looked at). `print(arenite.check(scene))` tells in words. What lies
    outside is not wrong: nobody has tried it, so compare it with a solution that you know."""
    scene._refuse_ranks("check", "check the same scene without ranks")
    tried = _tried()
    outside: List[Outside] = []
    words = _own_classes(scene)
    parts: Mapping[str, Any] = tried["parts"]
    for word in words:
        if word not in parts:
            outside.append(Outside("part", word, "in no random scene"))
    numerics = sorted(w for w in words if w in tried["numerics"])
    same = [found for found in tried["together"] if found["classes"] == numerics]
    if not same and all(w in parts for w in numerics):
        outside.append(Outside("numerics", ", ".join(numerics), "each of them, but never together"))
    for what, quantity, value in _values(scene, courant):
        known = tried["quantities"][quantity]
        low, high = (0.0 if quantity in ("speed", "mach", "weight", "gravity") else known["from"]), known["to"]
        if not low - 1e-9 * abs(low) <= value <= high + 1e-9 * abs(high):
            outside.append(Outside(what, value, f"{_apart(low, value)} to {_apart(high, value)}"))
    return Checked(outside, same[0]["scenes"] if same else 0, dict(same[0]["endings"]) if same else {})


__all__ = ["Checked", "Outside", "check"]
