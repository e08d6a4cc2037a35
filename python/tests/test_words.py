"""What users read: each wrong argument is refused by its name with value and rule, names that are not there with the nearest one, every
recipe can be pasted back from what it shows, every public name tells of its parameters, and notebooks get tables."""

import difflib
import inspect
import math
import re
import threading

import numpy as np
import pytest

from test_recipes import recipes, sound


class Quantity:
    """A number with a unit, as packages of units have it."""

    def __init__(self, number, unit):
        self.number, self.unit = number, unit

    def __float__(self):
        raise TypeError("only a quantity without a unit is a number")

    def __repr__(self):
        return f"<Quantity({self.number}, '{self.unit}')>"


WRONG = ["50 ms", Quantity(50, "ms"), object(), 3 + 4j, {"a": object()}, [object()], -1.5, [[1], [2, 3]], None, True, print]
MADE_BY_OTHERS = {"Sweep", "View", "BodyHere", "Tile", "Error", "RunError", "Warning", "Cone"}  # not by users


def functions_and_methods(ar, scene):
    """Public callables by name, methods as those of objects that there are."""
    found = {name: getattr(ar, name) for name in ar.__all__ if callable(getattr(ar, name)) and name not in MADE_BY_OTHERS}
    law, signal = scene.law(), ar.Signal(0, 1)
    for told, owner in {"Scene": scene, "Law": law, "Signal": signal, "Body": scene.bodies["sand"], "Watch": ar.Watch()}.items():
        found.update((f"{told}.{name}", getattr(owner, name)) for name, x in vars(type(owner)).items() if name[0] != "_" and inspect.isfunction(x))
    return found


def parameters_of(x):
    kinds = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
    return {name: p for name, p in inspect.signature(x).parameters.items() if p.kind in kinds}


def sound_arguments(ar, scene, name, x):
    """For the parameters that must be given."""
    law = scene.law()
    known = {"scene": scene, "end": scene.time, "law": law, "body": "sand", "region": ar.Box((0, 0), (1, 1)), "name": "sand", "path": "nowhere", "folder": "nowhere",
             "kinematics": ar.PlaneStrain(), "mesh": ar.CartesianGrid((0, 0), (0.4, 0.2), cell=0.01), "numerics": ar.Numerics(ar.QuadraticBSpline, ar.Apic),
             "bodies": [ar.fill("sand", ar.Box((0, 0), (0.1, 0.15)), law)]}
    return {**known, **sound(ar).get(name, {})}


def test_each_wrong_type_is_refused_in_words(ar, column, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    scene, tried, faults = column(), 0, []
    slow = {"compile", "animate", "plot", "sweep", "run", "settle", "run_in_folder", "Scene.steps", "Scene.step"}  # would run with what is no mistake
    for name, x in functions_and_methods(ar, scene).items():
        base = sound_arguments(ar, scene, name, x)
        parameters = parameters_of(x)
        needed = {n: base[n] for n, p in parameters.items() if p.default is p.empty and n in base}
        for parameter in parameters:
            for wrong in WRONG:
                if name in slow and (wrong is None or wrong is True or wrong is print or isinstance(wrong, dict)):
                    continue
                tried += 1
                try:
                    x(**{**needed, parameter: wrong})
                except ar.Error as e:
                    if "incompatible" in str(e) or "Invoked with" in str(e) or "object has no attribute" in str(e):
                        faults.append(f"{name}({parameter}={wrong!r}): {e}")
                except Exception as e:
                    faults.append(f"{name}({parameter}={wrong!r}): {type(e).__name__}: {e}")
    assert tried > 1000
    assert not faults, f"{len(faults)}\n" + "\n".join(faults)
