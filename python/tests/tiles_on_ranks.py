"""A slope of triangles under a ball, cut into four tiles: mpirun -n N python -m mpi4py tiles_on_ranks.py WHAT FOLDER. Each rank prints."""

import hashlib
import sys
import warnings

import numpy as np
from mpi4py import MPI

import arenite as ar

COMM = MPI.COMM_WORLD


def mesh():
    columns, rows = 20, 10
    nodes = [(0.02 * i, 0.02 * j) for j in range(rows + 1) for i in range(columns + 1)]
    cells = []
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b, d = a + 1, a + columns + 1
            cells += [(a, b, d + 1), (a, d + 1, d)]
    return ar.SimplexMesh(nodes, cells)


def scene(young=1e6, gravity=(0, -9.81), body=None, **more):
    sand = ar.MohrCoulomb(density=1540, young=young, poisson=0.3, friction=0.6)
    ball = ar.Rigid(ar.Ball((0.2, 0.14), 0.04), ar.Free(mass=20, inertia=0.02, centre=(0.2, 0.14), velocity=(0, -1)), 0.3, name="ball")
    return ar.TiledScene(ar.PlaneStrain(), mesh(), ar.Numerics(ar.LinearSimplex, ar.Flip), reactions=True,
                         bodies=[ar.fill("sand", ar.Box((0, 0), (0.4, 0.1)), sand, per_cell=3, **(body or {}))], gravity=gravity, rigids=[ball],
                         walls=[ar.bottom("fixed"), ar.left("roller"), ar.right("roller")], parts=[ar.LocalDamping(0.7)],
                         **{"ranks": COMM, "tiles": 4, "rebalance_every": 20, **more})


def say(*words):
    sys.stdout.write(" ".join(str(w) for w in words) + "\n")  # whole lines
    sys.stdout.flush()


def told(of):
    """Bits of all points by their ids, where the ball is, and energies: the same words on all ranks."""
    sand = of.bodies["sand"]
    ids, numbers = (np.concatenate(COMM.allgather(x)) for x in (sand.column("id"), np.column_stack([sand.position, sand.velocity, sand.stress])))
    bits = hashlib.sha256(numbers[np.argsort(ids)].tobytes()).hexdigest()[:16]
    return f"{of.step_count} {bits} {of.rigids['ball'].displacement.tolist()} {tuple(of.energy)} {of.reaction('bottom').force}"


def bits(folder):
    of = scene()
    seen = []
    ar.run(of, end=0.02, every={0.005: lambda s: seen.append(s.energy.residual)})
    of.save(folder)
    ar.run(of, end=0.03, every={0.005: lambda s: seen.append(s.reaction("bottom").force[1])})
    say(told(of), seen, of.stable_step)


def restart(folder):
    of = scene()
    of.restore(folder)
    ar.run(of, end=0.03)
    say(told(of))


def stop(folder):
    of, last = scene(), COMM.size - 1

    def at(time):
        return lambda s: ar.STOP if COMM.rank == last and s.time >= time else None

    ar.run(of, end=0.03, after_step=at(0.01))
    say(of.step_count)
    ar.run(of, end=0.03, every={0.002: at(0.015)})
    say(of.step_count)


def fail(folder):
    def dig(s):
        if COMM.rank == COMM.size - 1 and s.time > 0.01:
            raise ValueError("the spade broke")

    try:
        ar.run(scene(), end=0.03, every={0.002: dig})
    except Exception as e:
        say(f"{type(e).__name__}: {str(e).splitlines()}")
        raise


def fail_between(folder):
    of = scene()
    of.sum(lambda tile: [1.0][COMM.rank])  # not there on the second


def points(folder):
    of = scene()
    corner = ar.Box((0.0, 0.05), (0.1, 0.1))
    away, back = ar.remove_points(of, "sand", corner), ar.fill_points(of, "sand", corner)
    whole = of.sum(lambda tile: float(np.sum(tile.bodies["sand"].mass)))
    say(away.points, away.mass, back.points, back.mass, whole, len(of.bodies["sand"]) == sum(len(t.bodies["sand"]) for t in of.tiles))
    more = ar.insert_points(of, "sand", [(0.02 * i, 0.16) for i in range(1, 20)], 1e-5)  # on faces and nodes of cells
    say(more.points, more.mass, of.sum(lambda tile: float(len(tile.bodies["sand"]))))
    say(*ar.probe(of, "sand", [(0.05, 0.03), (0.1, 0.05), (0.3, 0.15)]).stress.ravel())
    for ask in (lambda: of.copy(), lambda: next(of.steps()), lambda: of.cells):
        try:
            ask()
        except ar.Error as e:
            say(e)


def functions(folder):
    """Of positions: noise and a greatest height are those of all ranks."""
    of = scene(body={"velocity": lambda x: np.random.default_rng(1).normal(size=x.shape), "stress": lambda x: np.outer(x[:, 1].max() - x[:, 1], [-1e4] * 3 + [0] * 3)})
    ar.remove_points(of, "sand", lambda x: x[:, 0] < np.quantile(x[:, 0], 0.2))
    say(told(of))
    ar.run(of, end=0.002)
    say(told(of))


def refused(folder):
    of = scene()
    ar.run(of, end=0.005)
    for ask in (lambda: of.reaction("ceiling"), lambda: ar.section_force(of, "sand", (0.1, 0.05), (0, 1), 0), lambda: of.restore("nothing"),
                lambda: ar.insert_points(of, "sand", [(5, 5)], 1e-5)):
        try:
            ask()
        except ar.Error as e:
            say(e)
    ar.run(of, end=0.01)
    say(told(of))


def differ(folder):
    """The last rank is told something else: what each then says."""
    odd = COMM.rank == COMM.size - 1

    def refused(ask):
        try:
            ask(scene())
            say("nothing was refused")
        except ar.Error as e:
            say(str(e).removesuffix(": all ranks must ask for the same"))

    refused(lambda s: scene(young=1e7 if odd else 1e6))
    refused(lambda s: scene(gravity=(0, 9.81) if odd else (0, -9.81)))
    refused(lambda s: scene(tiles=2 if odd else 4))
    refused(lambda s: ar.run(s, end=0.01 if odd else 0.02))
    refused(lambda s: ar.run(s, end=0.01, courant=0.1 if odd else 0.5))
    refused(lambda s: ar.run(s, end=0.01, watch=ar.Watch(volume=0.1 if odd else 0.2)))
    refused(lambda s: ar.run(s, end=0.01, every={0.001 if odd else 0.002: lambda s: None}))
    refused(lambda s: ar.run(s, end=0.01, every={0.002: lambda s: s.energy if odd and s.time > 0.003 else None}))
    refused(lambda s: ar.run(s, end=0.01, every={0.002: ar.Vtu("out/a")} if odd else {0.002: lambda s: None}))
    refused(lambda s: s.energy if odd else s.stable_step)
    refused(lambda s: s.save(f"{folder}{COMM.rank}"))
    refused(lambda s: ar.probe(s, "sand", [(0.1 + 0.1 * odd, 0.05)]))
    refused(lambda s: s.sum(lambda tile: 1.0) if odd else s.least(lambda tile: 1.0))


def differing_functions(folder):
    """Of a function its code, and what it reads, is compared."""
    pull = 9.81 + COMM.rank

    def gravity(t):
        return (0.0, -pull)

    try:
        scene(gravity=gravity)
    except ar.Error as e:
        say(e)


def left_alone(folder):
    of = scene()
    if COMM.rank == 0:
        of.energy


def series(folder):
    of = scene()
    ar.run(of, end=0.002, every={0.001: ar.Vtu("series/a")})
    of.save(folder)


def series_on(folder):
    of = scene()
    of.restore(folder)
    ar.run(of, end=0.004, every={0.001: ar.Vtu("series/a")})


def settled(folder):
    of = scene()
    say(ar.settle(of, end=1.0, every={1: lambda s: ar.STOP if COMM.rank == COMM.size - 1 else None}), of.step_count)
    for wrong in (dict(end=0.002), dict(end=1.0, ratio=0)):
        try:
            ar.settle(of, **wrong)
        except ar.Error as e:
            say(e)
    say(ar.settle(of, end=1.0, ratio=1e-2), of.out_of_balance <= 1e-2)
    say(told(of), of.out_of_balance)


def warned(folder):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        of = scene(body=dict(stress=ar.Geostatic(surface=0.2, k0=0.5)))  # ground that ends at 0.1
        ar.run(of, end=0.002)
    say(COMM.rank, [str(w.message) for w in caught])


if __name__ == "__main__":
    globals()[sys.argv[1]](sys.argv[2])
