"""A penetrometer, described once: for drops, reductions and sweeps."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, fields
from typing import Any, Dict, Mapping, Optional, Sequence

from .._errors import Error

__all__ = ["Device", "with_device"]


@dataclass(frozen=True)
class Device:
    """A penetrometer, given to `drop`, `sweep` and `reduce` as `penetrometer=Device(..)`.

    Either a named one and what differs from it, each as the option of the same name in `arenite.ffp.help("drop")`:
    `Device("cone-10cm2", mass=1.2)`, `Device(diameter=0.05, length=0.4, cone_angle=90, mass=2)`. Or any other by its outline:
    `Device(name="probe", profile=[(0, 0), (0.03, 0.05), {"to": (0.035, 0.06), "arc": 0.02}, (0.035, 0.4)], mass=5.2)`,
    points (radius, height) in m from the tip upward, each at the end of a line or of an arc (negative: hollow). mass in kg; centre_of_mass above the tip and gyration across the axis in m.
    """

    penetrometer: Optional[str] = None
    tip: Optional[str] = None
    diameter: Optional[float] = None
    length: Optional[float] = None
    cone_angle: Optional[float] = None
    flat: Optional[float] = None
    shoulder: Optional[str] = None
    fillet: Optional[float] = None
    mass: Optional[float] = None
    name: Optional[str] = field(default=None, metadata={"of_profile": True})
    source: Optional[str] = field(default=None, metadata={"of_profile": True})
    profile: Optional[Sequence[Any]] = field(default=None, metadata={"of_profile": True})
    centre_of_mass: Optional[float] = field(default=None, metadata={"of_profile": True})
    gyration: Optional[float] = field(default=None, metadata={"of_profile": True})

    def __post_init__(self) -> None:
        if self.profile is None:
            for one in fields(self):
                if one.metadata and getattr(self, one.name) is not None:
                    raise Error(f"Device.{one.name} = {getattr(self, one.name)!r}: goes with a profile")
            return
        object.__setattr__(self, "profile", tuple(self.profile))
        for one in fields(self):
            if not one.metadata and one.name != "mass" and getattr(self, one.name) is not None:
                raise Error(f"Device.{one.name} = {getattr(self, one.name)!r}: goes without a profile, which tells the whole outline")

    @property
    def options(self) -> Dict[str, object]:
        """What the program is told of it: options as keywords."""
        if self.profile is None:
            return {one.name: getattr(self, one.name) for one in fields(self) if getattr(self, one.name) is not None}
        try:
            points = [{"to": [float(x) for x in p["to"]], "arc": float(p["arc"])} if isinstance(p, Mapping) else [float(x) for x in p]
                      for p in self.profile]
        except (KeyError, TypeError, ValueError) as problem:
            raise Error(f"Device.profile: must be points (radius, height) in m, or {{'to': (radius, height), 'arc': radius}} "
                        f"({problem!r})") from None
        told: Dict[str, object] = {"name": self.name or "a profile", "profile": points}
        for key, value in (("source", self.source), ("mass_kg", self.mass), ("centre_of_mass_m", self.centre_of_mass),
                           ("gyration_m", self.gyration)):
            if value is not None:
                told[key] = value
        return {"device_file": json.dumps(told)}

    def __str__(self) -> str:
        return self.name or " ".join(str(value) for value in self.options.values()) or "bluedrop"


def with_device(options: Mapping[str, object]) -> Dict[str, object]:
    """Options with those of a `Device` in the place of `penetrometer`. Raises `Error` if an option is given twice."""
    told = dict(options)
    device = told.get("penetrometer")
    if not isinstance(device, Device):
        return told
    del told["penetrometer"]
    for name, value in device.options.items():
        if told.get(name) is not None:
            raise Error(f"{name} = {told[name]!r}: is given beside the penetrometer, which has its own")
        told[name] = value
    return told
