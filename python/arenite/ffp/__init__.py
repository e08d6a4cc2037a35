"""Penetrometers dropped into dry sand or pushed into the ground: drops, sweeps of drops, pushes, and records as practitioners read them.

Everything here runs the program `arenite-ffp`. A keyword is an option of the program: `delta=20` is `--delta 20`,
`cell_at_cone=0.004` is `--cell-at-cone 0.004`; `help("drop")` lists them with units and limits.

    from arenite import ffp
    drop = ffp.drop(delta=20)
    drop.summary["final_penetration_m"]
    drop.plot()
"""

from ._columns import Columns
from ._device import Device
from ._drop import Drop, drop
from ._help import help
from ._push import Push, push
from ._record import Record, record
from ._reduction import Reduction, reduce
from ._sweep import sweep
from ._table import Table

__all__ = ["Columns", "Device", "Drop", "Push", "Record", "Reduction", "Table", "drop", "help", "push", "record", "reduce", "sweep"]
