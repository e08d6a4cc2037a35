"""What decides the result of a function, as text that is the same in each process: its code and that of what it calls, and the values that both
read. Functions and classes of installed packages count by the package's version."""

from __future__ import annotations

import builtins
import copyreg
import dataclasses
import dis
import enum
import functools
import hashlib
import importlib.metadata
import importlib.util
import inspect
import sys
import sysconfig
import types
from pathlib import Path
from typing import AbstractSet, Any, Dict, Iterable, Iterator, List, Mapping, Optional, Set, Tuple

import numpy as np

from . import _core
from ._errors import Error
from ._recipe import Recipe

__all__ = ["STATE", "Decides", "code_name", "first_difference", "short", "what_decides"]

STATE = "object or arguments"  #: the name of what a function carries along: a method's object, a partial's arguments
PLAIN = (type(None), type(...), bool, int, float, complex, str, bytes, range)


def what_decides(function: Any) -> Dict[str, str]:
    """Hashes by name, such as "helpers.STIFFNESS". Raises `Error` that names a value that is none to tell from others."""
    found = Decides()
    try:
        state = found.text(function, "sweep.function")
    except Exception as problem:
        if isinstance(problem, Error):
            raise
        raise Error(f"sweep.function = {short(function)}: what decides its results cannot be told ({type(problem).__name__}: {problem}); sweep without `out`") from None
    return {"arenite": str(_core.version), STATE: digest(state), **found.parts}


def first_difference(one: Mapping[str, str], other: Mapping[str, str]) -> Optional[str]:
    """The name of what two have not alike; None if there is none."""
    return next((name for name in [*one, *other] if one.get(name) != other.get(name)), None)


def code_name(value: Any) -> str:
    """The name of a function or class, or that of the function in a partial one, or of an object's class."""
    while isinstance(value, functools.partial):
        value = value.func
    if not hasattr(value, "__qualname__"):
        value = type(value)
    return f"{_module_name(getattr(value, '__module__', None))}.{value.__qualname__}"


def short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def digest(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


class Decides:
    """Texts of values; `parts` holds the hashes of the code and of the names that were met on the way."""

    def __init__(self) -> None:
        self.parts: Dict[str, str] = {}
        self._names: Dict[int, str] = {}  # of functions and classes, by identity
        self._kept: List[Any] = []  # holds what `_names` knows
        self._modules: Set[Tuple[str, AbstractSet[str]]] = set()  # and the attributes that were looked for
        self._within: List[int] = []  # what is being written

    def text(self, value: Any, at: str) -> str:
        """`at`: how messages call it."""
        if isinstance(value, np.generic):
            value = value.item()
        if type(value) in PLAIN:
            return repr(value)
        if isinstance(value, types.ModuleType):
            return self._module(value, ())
        if isinstance(value, types.FunctionType):
            return self._function(value)
        if isinstance(value, type):
            return self._class(value)
        if id(value) in self._within:
            return f"^{self._within.index(id(value))}"
        self._within.append(id(value))
        try:
            return self._compound(value, at)
        finally:
            self._within.pop()

    def _compound(self, value: Any, at: str) -> str:
        def all_of(values: Iterable[Any]) -> List[str]:
            return [self.text(one, at) for one in values]

        if isinstance(value, types.MethodType):
            return f"method({', '.join(all_of([value.__self__, value.__func__]))})"
        if isinstance(value, (types.BuiltinFunctionType, types.MethodWrapperType)) and not isinstance(value.__self__, (types.ModuleType, type(None))):
            return f"method({self.text(value.__self__, at)}, {value.__name__})"
        if isinstance(value, enum.Enum):
            return f"{self._class(type(value))}.{value.name}"
        if type(value) in (list, tuple):
            return f"{type(value).__name__}({', '.join(all_of(value))})"
        if type(value) in (set, frozenset):
            return f"{type(value).__name__}({', '.join(sorted(all_of(value)))})"
        if type(value) is dict:
            return f"dict({', '.join(f'{self.text(key, at)}: {self.text(one, at)}' for key, one in value.items())})"
        if type(value) is np.ndarray and not value.dtype.hasobject:
            return f"array({value.dtype}, {value.shape}, {hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest()})"
        try:
            reduce = copyreg.dispatch_table.get(type(value))
            made = reduce(value) if reduce else value.__reduce_ex__(4)
            header = value.header() if isinstance(value, Recipe) and hasattr(value, "header") else None
            content = Path(header).read_bytes() if header else b""
        except Exception as problem:
            raise Error(f"{at}: {short(value)} decides the result, but cannot be told from others ({problem}): give what it holds as a parameter "
                        "or as numbers, texts and arrays, or sweep without `out`, which keeps nothing") from None
        if isinstance(made, str):  # by its name; what a cache wraps counts by its code
            wrapped = getattr(value, "__wrapped__", None)
            self._installed(str(getattr(value, "__module__", None) or type(value).__module__))
            return f"{code_name(value)}:{made}" + (f"({self.text(wrapped, at)})" if wrapped is not None else "")
        # A function that makes it, its arguments, state, elements and items: what pickle takes.
        words = all_of([*made[:3], *map(list, (part for part in made[3:5] if part is not None))])
        return f"object({', '.join(words)}{hashlib.sha256(content).hexdigest() if content else ''})"

    # --- code

    def _function(self, f: types.FunctionType) -> str:
        module = str(f.__globals__.get("__name__"))
        name, is_new = self._named(f, f"{_module_name(module)}.{f.__qualname__}")
        if not is_new:
            return name
        for variable, cell in zip(f.__code__.co_freevars, f.__closure__ or ()):
            at = f"{variable!r} of {name}"
            try:
                self.parts[at] = digest(self.text(cell.cell_contents, at))
            except ValueError as problem:  # a name that is not bound yet
                if isinstance(problem, Error):
                    raise
        if self._installed(module):
            return name
        self.parts[name] = digest(_source(f.__code__))
        for what, given in (("defaults", [f.__defaults__, f.__kwdefaults__]), ("attributes", vars(f))):
            if given and given != [None, None]:
                self.parts[f"{what} of {name}"] = digest(self.text(given, f"{what} of {name}"))
        read, attributes, imports = _names_read(f.__code__)
        for one in sorted(read):
            if one in f.__globals__ or not hasattr(builtins, one):
                self._read(module, one, f.__globals__, attributes)
        for level, imported, names in sorted(imports):
            try:
                full = importlib.util.resolve_name("." * level + imported, f.__globals__.get("__package__") or "") if level else imported
                if not self._installed(full):
                    self._module(__import__(full, fromlist=names or ("",)), attributes | set(names))
            except ImportError:  # the function may know what to do without
                self.parts[f"module {imported}"] = "cannot be imported"
        return name

    def _class(self, c: type) -> str:
        name, is_new = self._named(c, code_name(c))
        if not is_new or self._installed(c.__module__):
            return name
        words = [self.text(base, name) for base in (*c.__bases__, type(c))]
        fields = [(f.default, f.default_factory) for f in dataclasses.fields(c)] if dataclasses.is_dataclass(c) else []
        words += [self.text(given, f"a default of {name}") for given in fields]
        is_enum = issubclass(c, enum.Enum)
        words += [f"{key}={self.text(one.value, name)}" for key, one in getattr(c, "__members__", {}).items() if is_enum]
        for key, member in vars(c).items():
            for of in _functions_of(member):
                if of.__code__.co_filename != "<string>":  # what a data class is given, of its fields
                    words.append(f"{key}={self._function(of)}")
            if not (is_enum or key.startswith(("__", "_abc_")) or any(_functions_of(member)) or hasattr(member, "__set__")):
                words.append(f"{key}={self.text(member, f'{name}.{key}')}")
        self.parts[name] = digest("\n".join(words))
        return name

    def _module(self, module: types.ModuleType, attributes: Iterable[str]) -> str:
        """`attributes`: those that are read of it, and names of others."""
        looked = (module.__name__, frozenset(attributes))
        if not self._installed(module.__name__) and looked not in self._modules:
            self._modules.add(looked)
            for name in sorted(looked[1] & set(vars(module))):
                self._read(module.__name__, name, vars(module), looked[1])
        return f"module {_module_name(module.__name__)}"

    def _read(self, module: str, name: str, names: Mapping[str, Any], attributes: AbstractSet[str]) -> None:
        """Notes what a name of a module stands for."""
        if name.startswith("__"):  # __name__, __file__
            return
        key = f"{_module_name(module)}.{name}"
        value = names.get(name)
        if isinstance(value, types.ModuleType):
            self._module(value, attributes)
        elif key not in self.parts:
            self.parts[key] = ""  # it may lead back here
            text = self.text(value, key) if name in names else "not there"
            if text != key:
                self.parts[key] = digest(text)

    def _named(self, value: Any, name: str) -> Tuple[str, bool]:
        """The name of a function or class, which no other one has, and whether it is met for the first time."""
        if id(value) in self._names:
            return self._names[id(value)], False
        known = set(self._names.values())
        unique = next(one for one in (name, *(f"{name} {k}" for k in range(2, len(known) + 3))) if one not in known)
        self._names[id(value)] = unique
        self._kept.append(value)
        return unique, True

    def _installed(self, module: str) -> bool:
        """Whether a module is no code of the user's; notes the version of its package."""
        top = module.partition(".")[0]
        if not _is_installed(top):
            return False
        if top != "arenite" and _version(top):
            self.parts[top] = _version(top)
        return True


def _module_name(name: Any) -> str:
    return "__main__" if name == "__mp_main__" else str(name)  # a script, as another process imports it


def _functions_of(member: Any) -> Iterator[types.FunctionType]:
    """Functions of a member of a class."""
    if isinstance(member, (staticmethod, classmethod)):
        member = member.__func__
    elif isinstance(member, functools.cached_property):
        member = member.func
    parts = [member.fget, member.fset, member.fdel] if isinstance(member, property) else [member]
    return (one for one in parts if isinstance(one, types.FunctionType))


@functools.lru_cache(maxsize=None)
def _source(code: types.CodeType) -> str:
    """The text of a function; its instructions where there is none, or others may stand in the same line."""
    if code.co_name != "<lambda>":
        try:
            return inspect.getsource(code)
        except (OSError, TypeError, SyntaxError):
            pass
    constants = [_source(one) if isinstance(one, types.CodeType) else sorted(map(repr, one)) if isinstance(one, frozenset) else repr(one)
                 for one in code.co_consts]
    return repr((code.co_code, code.co_names, code.co_varnames, constants))


def _names_read(code: types.CodeType) -> Tuple[Set[str], Set[str], Set[Tuple[int, str, Tuple[str, ...]]]]:
    """Global names that code reads; attributes; and what it imports: levels up, module, names of it."""
    read: Set[str] = set()
    attributes: Set[str] = set()
    imports: Set[Tuple[int, str, Tuple[str, ...]]] = set()
    before: List[Any] = [None, None]  # values of the last two instructions
    for step in dis.get_instructions(code):
        if step.opname == "EXTENDED_ARG":
            continue
        if step.opname == "LOAD_NAME" or step.opname.startswith("LOAD_") and "GLOBAL" in step.opname:
            read.add(step.argval)
        elif step.opname in ("LOAD_ATTR", "LOAD_METHOD"):
            attributes.add(step.argval)
        elif step.opname == "IMPORT_NAME":
            imports.add((int(before[0] or 0), step.argval, tuple(before[1] or ())))
        before = [before[1], step.argval]
    for one in code.co_consts:
        if isinstance(one, types.CodeType):
            inner = _names_read(one)
            read |= inner[0]
            attributes |= inner[1]
            imports |= inner[2]
    return read, attributes, imports


@functools.lru_cache(maxsize=None)
def _is_installed(top: str) -> bool:
    """Whether a package or module is Python's own, or was put where packages are installed."""
    if top in ("__main__", "__mp_main__"):
        return False
    if top == "arenite" or top in sys.builtin_module_names:
        return True
    module = sys.modules.get(top)
    file = getattr(module, "__file__", None)
    if module is None:
        try:
            spec = importlib.util.find_spec(top)
        except (ImportError, ValueError):
            spec = None
        if spec is None:
            return True  # it cannot be imported: what tries it says so
        file = spec.origin
    if file in ("built-in", "frozen"):
        return True
    folder = Path(str(file or next(iter(getattr(module, "__path__", [])), "."))).resolve().parent
    if file and Path(file).name.startswith("__init__."):
        folder = folder.parent
    own = [Path(sysconfig.get_path(name)).resolve() for name in ("stdlib", "platstdlib")]
    return (bool({"site-packages", "dist-packages"} & set(folder.parts)) or any(path == folder or path in folder.parents for path in own)
            or any(folder.glob("*.dist-info")))


@functools.lru_cache(maxsize=None)
def _version(top: str) -> str:
    """Of an installed package that is called like its module; empty of others."""
    try:
        return importlib.metadata.version(top)
    except importlib.metadata.PackageNotFoundError:
        return ""
