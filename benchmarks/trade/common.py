"""What the problems share: meshes of either kind, points with numbers, a clock for the steps, and beams that bend far."""

import functools
import itertools
import math
import time
from pathlib import Path

import numpy as np

import arenite as ar
from arenite import _compile

#: Names the points, whose places in memory change: `points_of`.
IDS = ar.OwnPart("arenite::PointIds", str(Path(_compile.include_folders()[0]) / "arenite" / "particles" / "point_ids.hpp"))


def mesh(composition, lower, upper, cell):
    """Squares or cubes of an edge, or two triangles in each square, whose diagonals take turns, or six tetrahedra in each cube."""
    if composition.on_grid():
        return ar.CartesianGrid(lower, upper, cell=cell, dtype=composition.dtype)
    n = [round((b - a) / cell) for a, b in zip(lower, upper)]
    stride = np.cumprod([1, *(k + 1 for k in n[:-1])])  # numbers of nodes, the first axis fastest
    every = np.meshgrid(*(np.arange(k + 1) for k in n), indexing="ij")
    at = np.stack([q.ravel(order="F") for q in every], 1)
    nodes = np.asarray(lower) + at * (np.asarray(upper) - lower) / n
    first = (at[(at < n).all(axis=1)] * stride).sum(axis=1)  # of each square or cube
    if len(n) == 2:
        a, b, c, d = first, first + 1, first + n[0] + 1, first + n[0] + 2
        even = (at[first].sum(axis=1) % 2 == 0)[:, None]
        cells = np.concatenate([np.where(even, np.stack([a, b, d], 1), np.stack([a, b, c], 1)),
                                np.where(even, np.stack([a, d, c], 1), np.stack([b, d, c], 1))])
    else:  # along the three axes in any order, an odd one with two nodes swapped
        paths = [(stride[list(p)], np.linalg.det(np.eye(3)[list(p)])) for p in itertools.permutations(range(3))]
        cells = np.concatenate([np.stack([first + k for k in np.array([0, *np.cumsum(s)])[[0, 1, 2, 3] if sign > 0 else [0, 2, 1, 3]]], 1)
                                for s, sign in paths])
    numbers = np.arange(len(nodes))
    sides = {name: numbers[at[:, k] == (0 if low else n[k])] for k, names in enumerate((("left", "right"), ("bottom", "top"), ("front", "back"))[:len(n)])
             for low, name in zip((True, False), names)}
    return ar.SimplexMesh(nodes, cells, node_sets=sides, dtype=composition.dtype)


def corner(lower):
    """A wall that holds the lowest node of a mesh alone, which no matter reaches: a scene without walls is another composition."""
    return ar.where(lambda x: np.abs(x - np.asarray(lower)).max(axis=1) < 1e-6, "fixed")


class Points:
    """Columns of a body by number of the point, copies."""

    def __init__(self, scene):
        body = next(iter(scene.bodies.values()))
        order = np.argsort(np.asarray(body.column("id")))
        self.position, self.velocity, self.mass, self.stress = (
            np.asarray(column)[order] for column in (body.position, body.velocity, body.mass, body.stress))


def begin_with(scene, velocity, cell):
    """Gives points that carry a velocity gradient that of a field: of positions [n, D]."""
    body = scene.bodies["body"]
    for path in [p for p in scene.state if p.startswith("bodies/0/points/velocity_gradient/")]:
        component, along = ("xyz".index(k) for k in path[-2:])
        x = np.asarray(body.position)
        d = 1e-6 * cell * (np.arange(x.shape[1]) == along)
        body.column(path.removeprefix("bodies/0/points/"))[:] = (velocity(x + d) - velocity(x - d))[:, component] / (2e-6 * cell)


def elastic_scene(composition, time, lower, upper, cell, per_cell, region, law, walls=None, gravity=(0, 0), velocity=None, damping=0.0,
                  parts=()):
    """A body in plane strain, of a composition that all elastic problems share but for more `parts`. `velocity`: of positions [n, 2];
    points that carry a velocity gradient begin with its."""
    scene = ar.Scene(ar.PlaneStrain(), mesh(composition, lower, upper, cell), composition.numerics(time), energy=False,
                     bodies=[ar.fill("body", region, law, per_cell=per_cell, velocity=velocity or (0.0, 0.0), exact_volume=False)],
                     walls=walls or [corner(lower)], gravity=gravity, parts=[*parts, ar.LocalDamping(factor=damping), IDS])
    if velocity:
        begin_with(scene, velocity, cell)
    return scene


class Failed(Exception):
    """A run whose result counts for nothing."""


class Clock:
    """Sums what steps cost: seconds of the processor, of several threads seconds on the clock; steps, and points times steps; and the bytes of a
    point."""

    def __init__(self, threads=1):
        self.seconds, self.steps, self.point_steps, self.bytes = 0.0, 0, 0, 0
        self.now = time.process_time if threads == 1 else time.perf_counter

    def run(self, scene, end, courant, **more):
        steps, points = scene.step_count, sum(len(b) for b in scene.bodies.values())
        columns = [scene.state[path] for path in scene.state if path.startswith("bodies/0/points/")]
        self.bytes = round(sum(c.nbytes for c in columns) / max(len(columns[0]), 1))
        start = self.now()
        ar.run(scene, end=end, courant=courant, watch=False, **more)
        self.seconds += self.now() - start
        self.steps += scene.step_count - steps
        self.point_steps += points * (scene.step_count - steps)
        if any(b.lost for b in scene.bodies.values()):
            raise Failed("points left the mesh")


def farthest_off(scene, clock, courant, end, position):
    """Runs a scene and looks at it twenty times: the greatest root mean square of the points' distances, m, from `position` (of where they
    began [n, 2], and the time)."""
    start, worst = Points(scene).position, 0.0
    for k in range(1, 21):
        clock.run(scene, k * end / 20, courant)
        off = Points(scene).position - position(start, scene.time)
        worst = max(worst, np.sqrt((off**2).sum(axis=1).mean()))
    return worst


@functools.lru_cache(maxsize=None)
def elastica(weight, load=0.0, shear=0.0, n=400):
    """Rows (s, x, y, angle) of a clamped beam of length 1 that bends far: weight = q L^3 / EI along it, load = P L^2 / EI at its tip, both
    down; shear = EI / (k G A L^2). Without shear Euler's elastica (Bisshopp and Drucker 1945), with it Reissner's beam that does not stretch.
    Shooting on the moment at the clamp, Runge-Kutta of order 4."""
    h = 1.0 / n

    def slopes(s, state):
        force = load + weight * (1 - s)
        cos, sin = math.cos(state[2]), math.sin(state[2])
        slip = -shear * force * cos
        x = cos - slip * sin
        return x, sin + slip * cos, -state[3], -force * x

    def line(moment):
        state, rows = (0.0, 0.0, 0.0, moment), []
        for k in range(n):
            rows.append((k * h, *state[:3]))
            a = slopes(k * h, state)
            b = slopes((k + 0.5) * h, [u + h / 2 * v for u, v in zip(state, a)])
            c = slopes((k + 0.5) * h, [u + h / 2 * v for u, v in zip(state, b)])
            d = slopes((k + 1) * h, [u + h * v for u, v in zip(state, c)])
            state = tuple(u + h / 6 * (p + 2 * q + 2 * r + t) for u, p, q, r, t in zip(state, a, b, c, d))
        return rows + [(1.0, *state[:3])], state[3]

    low, high = 0.0, load + weight  # of the moment at the clamp over EI / L
    a, b = line(low)[1], line(high)[1]
    while True:  # regula falsi; an end that stays counts half
        middle = low - a * (high - low) / (b - a)
        rows, rest = line(middle)
        if abs(rest) < 1e-11 * (load + weight):
            return np.array(rows)
        if rest < 0:
            low, a, b = middle, rest, b / 2
        else:
            high, b, a = middle, rest, a / 2


def come_to_rest(scene, clock, period, courant, periods=2):
    """Runs a scene for so many of its periods, s, and stops all points where the kinetic energy of the nodes has begun to fall (kinetic
    damping), once in an eighth of a period at most. (Local damping
    under the noise of points that cross cells acts like a thick fluid: far from rest after eight periods.)"""
    body, begin, highest, since = next(iter(scene.bodies.values())), scene.time, 0.0, 0
    parts = 32  # of a period
    for k in range(1, periods * parts + 1):
        clock.run(scene, begin + k * period / parts, courant)
        nodes = scene.nodes()
        now = float((nodes.mass * (nodes.velocity**2).sum(axis=1)).sum())  # without the noise of the points
        highest, since = max(now, highest), since + 1
        if now < 0.9 * highest and since > parts / 8:
            for path in scene.state:
                if path.startswith(("bodies/0/points/velocity/", "bodies/0/points/velocity_gradient/")):
                    body.column(path.removeprefix("bodies/0/points/"))[:] = 0
            highest, since = 0.0, 0


def soil_scene(composition, time, lower, upper, cell, per_cell, region, law, walls, gravity=(0, 0), driven=None, damping=0.0):
    """A body of soil in plane strain, of a composition that all problems of soil share. `driven`: a wall and its velocity."""
    wall, velocity = driven or (corner(upper), (0, 0, 0))
    return ar.Scene(ar.PlaneStrain(), mesh(composition, lower, upper, cell), composition.numerics(time), energy=False, reactions=True,
                    bodies=[ar.fill("body", region, law, per_cell=per_cell)], walls=walls, gravity=gravity,
                    parts=[ar.Driven(wall, ar.Scaled(velocity, ar.Ramp(over=time))), ar.LocalDamping(factor=damping)])


def fall_to_rest(composition, clock, cell, per_cell, courant, size, above, law, k0, shape, mass, speed, friction, until):
    """A rigid body without slip sideways falls into a full cylinder of sand of a radius and depth `size`, m, with `above` over it: depth, m, where
    it first comes to rest. Looked at `until` / 200, s."""
    scene = ar.Scene(ar.Axisymmetric(), mesh(composition, (0, -size), (size, above), cell), composition.numerics(until), energy=False,
                     bodies=[ar.fill("sand", ar.Box((0, -size), (size, 0)), law, per_cell=per_cell, stress=ar.Geostatic(surface=0, k0=k0))],
                     walls=[ar.bottom("fixed"), ar.left("roller"), ar.right("roller")], gravity=(0, -9.81),
                     rigids=[ar.Rigid(shape, ar.Guided(mass=mass, velocity=-speed), friction=friction, name="body")])
    body = scene.rigids["body"]
    for k in range(1, 201):
        clock.run(scene, k * until / 200, courant)
        if body.velocity[1] >= 0:
            return -body.displacement[1]
    raise Failed(f"it still falls after {until} s")
