"""Material point method for soil, sand and snow that meets something that moves.

A scene is made of recipes with the words of the C++ library and stepped by compiled code; SI units, angles in radians,
tension positive."""

from . import (_core, boundary, check as _check, drive as _drive, ffp, fill as _fill, laws, long_run as _long_run, meshes, numerics, pictures, points,
               recommend as _recommend, rigid, scene as _scene, shapes, tiles as _tiles, views, watch as _watch)
from ._errors import Error, RunError, Warning
from ._plugins import set_threads
from ._sweep import Sweep, sweep
from .boundary import *  # noqa: F403
from .check import *  # noqa: F403
from .convert import to_meshio, to_pyvista
from .drive import *  # noqa: F403
from .fill import *  # noqa: F403
from .functions import Ramp, Scaled, Signal, Table, deg
from .laws import *  # noqa: F403
from .long_run import *  # noqa: F403
from .meshes import *  # noqa: F403
from .numerics import *  # noqa: F403
from .own import compile
from .pictures import *  # noqa: F403
from .points import *  # noqa: F403
from .recommend import *  # noqa: F403
from .rigid import *  # noqa: F403
from .scene import *  # noqa: F403
from .shapes import *  # noqa: F403
from .tiles import *  # noqa: F403
from .views import View
from .vtu import Vtu
from .watch import *  # noqa: F403

from ._arguments import guard as _guard

__version__: str = _core.version

__all__ = ["Error", "Ramp", "RunError", "Scaled", "Signal", "Sweep", "Table", "View", "Vtu", "Warning", "compile", "deg", "ffp", "set_threads", "sweep", "to_meshio", "to_pyvista",
           *boundary.__all__, *_check.__all__, *_drive.__all__, *_fill.__all__, *laws.__all__, *_long_run.__all__, *meshes.__all__, *numerics.__all__, *pictures.__all__, *points.__all__,
           *_recommend.__all__, *rigid.__all__, *_scene.__all__, *shapes.__all__, *_tiles.__all__, *_watch.__all__]

_guard([*(globals()[name] for name in __all__), *(getattr(ffp, name) for name in ffp.__all__), *(getattr(views, name) for name in views.__all__)])
