"""Compositions that stand for others: what is neither prebuilt nor in the cache runs in a prebuilt composition that has more, if one
does, with the same bits. `PARTS` is the whole rule; what costs more than 5 % of a step is not in it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterable, List, NamedTuple, Optional, Tuple

from . import _core

Values = Dict[str, Any]


def _walls_along_axes(values: Values) -> bool:
    """Whether no wall blocks a direction between the axes, along which to hold a velocity twice moves its round-off."""
    walls = values.get("Walls", {"list": []})["list"]
    return all(sum(x != 0 for x in wall["condition"]["direction"]) <= 1 for wall in walls)


@dataclass(frozen=True)
class PartStandIn:
    """A part of a prebuilt composition for one of the scene, or, neutral, for none."""

    part: str
    of: Optional[str]
    value: Callable[[Any, int], Any]  #: of the values of `of` and the scene's dimension
    hidden: str = ""  #: paths of the state that begin so are those of a part that the scene does not have; {}: its number
    fits: Callable[[Values], bool] = lambda _: True  #: of the values of the scene's parts, by type


#: Which part stands for which, with its values.
PARTS = (
    PartStandIn("GravityInTime", "Gravity", lambda value, dimension: value),
    PartStandIn("GravityInTime", None, lambda _, dimension: {"g": [0.0] * dimension}),
    PartStandIn("Walls", None, lambda *_: {"list": []}),
    PartStandIn("LocalDamping", None, lambda *_: {"factor": 0.0}, "parts/{}/", _walls_along_axes),  # and switched off
    PartStandIn("Reactions", None, lambda *_: {}, "reactions/"),
)

class StandIn(NamedTuple):
    type: str
    parts: List[Any]  #: values of its parts, that of the bodies first
    hidden: Tuple[str, ...]  #: beginnings of paths of its state that the scene does not have
    neutral: Tuple[str, ...]  #: types of parts that the scene does not have


def arguments(type_name: str) -> Tuple[str, Tuple[str, ...]]:
    """`A<B<C>, D>` as A and B<C>, D."""
    head, _, rest = type_name.partition("<")
    found, depth = [""], 0
    for letter in rest[:-1]:
        depth += {"<": 1, ">": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            found.append("")
        else:
            found[-1] += letter
    return head, tuple(a.strip() for a in found if a.strip())


def _parts(parts: Tuple[str, ...], of: Tuple[str, ...], values: List[Any],
           dimension: int) -> Optional[Tuple[List[Any], List[str], List[str]]]:
    made: List[Any] = []
    hidden: List[str] = []
    neutral: List[str] = []
    left = list(zip(of, values))
    by_type = dict(left)
    for number, part in enumerate(parts):
        if left and part == left[0][0]:
            made.append(left.pop(0)[1])
            continue
        rows = [row for row in PARTS if row.part == part and (row.of is None or left and row.of == left[0][0]) and row.fits(by_type)]
        if not rows:
            return None
        made.append(rows[0].value(left.pop(0)[1] if rows[0].of else None, dimension))
        if rows[0].of is None:
            neutral.append(part)
            hidden += [rows[0].hidden.format(number)] if rows[0].hidden else []
    return None if left else (made, hidden, neutral)


def find(type_name: str, values: List[Any], dimension: int, prebuilt: Iterable[str]) -> Optional[StandIn]:
    """The prebuilt composition that stands for a scene's, the one with the fewest other parts; None if there is none.
    `values`: of the scene's parts."""
    of = arguments(type_name)[1]
    found: List[Tuple[int, str, StandIn]] = []
    for name in prebuilt:
        given = arguments(name)[1]
        if given[:4] != of[:4]:
            continue
        parts = _parts(given[4:], of[4:], values[1:], dimension)
        if parts is not None:
            made = StandIn(name, [values[0], *parts[0]], tuple(parts[1]), tuple(parts[2]))
            found.append((len(set(given[4:]) - set(of[4:])), name, made))
    return min(found)[2] if found else None


__all__ = ["PARTS", "PartStandIn", "StandIn", "find"]
