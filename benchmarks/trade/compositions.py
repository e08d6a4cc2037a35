"""Compositions that are compared: shape function x transfer x order of the stress update x average, and some of them in float and on two
threads. What does not go together is asked of the library, which refuses it with a sentence; nothing here lists it. The names alone do not
need the library, so that pages are written without it."""

import itertools
from dataclasses import asdict, dataclass, replace

SHAPES = {"linear": "LinearGrid", "uGIMP": "UGimp", "quadratic": "QuadraticBSpline", "cubic": "CubicBSpline", "MLS": "MlsGradient",
          "triangles": "LinearSimplex"}
#: Each a function of the library and of a time of the problem, s.
TRANSFERS = {"PIC": lambda ar, time: ar.Flip(fraction=0), "FLIP": lambda ar, time: ar.Flip(), "FLIP, time": lambda ar, time: ar.Flip(time=time),
             "APIC": lambda ar, time: ar.Apic(), "AFLIP": lambda ar, time: ar.Aflip(), "TPIC": lambda ar, time: ar.Tpic(),
             "XPIC(2)": lambda ar, time: ar.Xpic(order=2), "XPIC(2), time": lambda ar, time: ar.Xpic(order=2, time=time),
             "FMPM(4)": lambda ar, time: ar.Fmpm(order=4), "FMPM(4), time": lambda ar, time: ar.Fmpm(order=4, time=time)}
ORDERS = {"MUSL": "Musl", "USL": "Usl", "USF": "Usf"}
AVERAGES = {"none": "NoAntiLocking", "nodal": "NodalAveraging", "element": "ElementAverage", "nodal and element": "NodalAndElementAverage"}


@dataclass(frozen=True)
class Composition:
    """By the names above."""

    shape: str
    transfer: str
    order: str
    average: str = "none"
    number: str = "double"
    threads: int = 1

    @property
    def name(self):
        more = [f"{self.average} average"] * (self.average != "none") + [self.number] * (self.number != "double")
        return "; ".join([self.shape, self.transfer, self.order, *more, *[f"{self.threads} threads"] * (self.threads > 1)])

    @classmethod
    def of(cls, row):
        """That of a row of the table."""
        return cls(**{f: row[f] for f in ("shape", "transfer", "order", "average", "number")}, threads=int(row["threads"]))

    def columns(self):
        return asdict(self)

    @property
    def dtype(self):
        return {"double": "float64", "float": "float32"}[self.number]

    def numerics(self, time=1.0):
        """Of a time that the transfer may take, s. Raises `arenite.Error` where the library refuses it."""
        import arenite as ar

        shape, order, average = (getattr(ar, name) for name in (SHAPES[self.shape], ORDERS[self.order], AVERAGES[self.average]))
        return ar.Numerics(shape, TRANSFERS[self.transfer](ar, time), order, average)

    def on_grid(self):
        return self.shape != "triangles"

    def points(self, dimension=2):
        """Points a cell: the usual ones, and others. uGIMP is of the usual ones alone: their number is part of its type."""
        if not self.on_grid():
            return {2: (3, (1, 6)), 3: (4, (10,))}[dimension]
        return 2**dimension, () if self.shape == "uGIMP" else (1, 3**dimension)


#: In full, and `MORE` on two sizes of cells. Those that share a body's law and parts compile once for all problems; numbers of a transfer
#: (PIC's, a time) need no compiler of their own.
BASE = [Composition(*words) for words in (
    ("linear", "FLIP", "MUSL"), ("linear", "APIC", "USL"), ("uGIMP", "FLIP", "MUSL"),
    ("quadratic", "FLIP", "MUSL"), ("quadratic", "FLIP", "USL"), ("quadratic", "FLIP", "USF"), ("quadratic", "FLIP, time", "MUSL"),
    ("quadratic", "APIC", "USL"), ("quadratic", "APIC", "MUSL"), ("quadratic", "AFLIP", "USL"), ("quadratic", "XPIC(2)", "USL"),
    ("quadratic", "FMPM(4)", "USL"), ("cubic", "FLIP", "MUSL"), ("cubic", "APIC", "USL"), ("MLS", "APIC", "USL"),
    ("triangles", "FLIP", "MUSL"), ("triangles", "TPIC", "USL"), ("triangles", "FLIP", "MUSL", "nodal"),
    ("triangles", "FLIP", "MUSL", "nodal and element"))]
MORE = [Composition(*words) for words in (
    ("linear", "PIC", "MUSL"), ("linear", "FLIP, time", "MUSL"), ("linear", "FLIP", "USL"), ("uGIMP", "FLIP, time", "MUSL"),
    ("uGIMP", "FLIP", "USL"), ("uGIMP", "APIC", "USL"), ("quadratic", "PIC", "MUSL"), ("quadratic", "PIC", "USL"),
    ("quadratic", "FLIP, time", "USL"), ("quadratic", "FLIP, time", "USF"), ("quadratic", "AFLIP", "MUSL"), ("quadratic", "XPIC(2)", "MUSL"),
    ("quadratic", "XPIC(2), time", "USL"), ("quadratic", "FMPM(4), time", "USL"), ("cubic", "PIC", "MUSL"), ("cubic", "FLIP, time", "MUSL"),
    ("cubic", "FLIP", "USL"), ("cubic", "AFLIP", "USL"), ("MLS", "FLIP", "MUSL"), ("triangles", "PIC", "MUSL"), ("triangles", "FLIP, time", "MUSL"),
    ("triangles", "FLIP", "USL"), ("triangles", "FLIP, time", "MUSL", "nodal"), ("triangles", "FLIP, time", "MUSL", "nodal and element"))]


#: All sizes of cells at the usual points and steps, and, on two threads, the finest.
FLOAT = [replace(c, number="float") for c in BASE if c.name in (
    "linear; FLIP; MUSL", "quadratic; FLIP; MUSL", "quadratic; APIC; USL", "MLS; APIC; USL", "triangles; FLIP; MUSL",
    "triangles; FLIP; MUSL; nodal and element average")]
THREADS = [replace(c, threads=2) for f in FLOAT for c in (replace(f, number="double"), f)]


def every():
    """All products of the names above."""
    return [Composition(*words) for words in itertools.product(SHAPES, TRANSFERS, ORDERS, AVERAGES)]
