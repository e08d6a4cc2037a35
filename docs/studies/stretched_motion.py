"""How fast evenly stretched matter on quadratic B-splines loses its balance, by the order of the stress update and by what moves its points.
Prints the rows of docs/decisions.md ("Kernels"): python3 stretched_motion.py; needs NumPy.

A row of points (neo-Hookean, nu = 0.3, FLIP, periodic, 12 cells), evenly spaced, is stretched and at rest. The step is linearised about that state by
differences; with the largest eigenvalue r of a step dt a disturbance grows as exp(g t), g = ln(r) / dt."""

import numpy as np

SHEAR, LAME, CELLS = 1 / 2.6, 0.3 / (1.3 * 0.4), 12  # Young's modulus, density and cell are 1
ORDERS = "USL", "MUSL, points with v", "MUSL, points with u"


def functions(x):
    """Nodes, weights and slopes of the functions at x [n, 3]."""
    cell = np.floor(x).astype(int)
    r = x - cell
    nodes = (cell[:, None] + [-1, 0, 1]) % CELLS
    return nodes, np.stack([(1 - r) ** 2 / 2, 0.5 + r * (1 - r), r**2 / 2], 1), np.stack([r - 1, 1 - 2 * r, r], 1)


def step(state, mass, dt, order):
    """One step of position, velocity and logarithm of the stretch of each point, one after the other in `state` [3 n]."""
    x, v, log = state.reshape(3, -1)
    nodes, weight, slope = functions(x)

    def collect(rows):
        return np.bincount(nodes.ravel(), rows.ravel(), CELLS)

    node_mass = collect(weight * mass)
    tau = SHEAR * (np.exp(2 * log) - 1) + LAME * log
    old = collect(weight * (mass * v)[:, None]) / node_mass
    new = old - dt * collect(slope * (mass * tau)[:, None]) / node_mass  # initial volume = mass
    v = v + (weight * (new - old)[nodes]).sum(1)
    straining = new if order == "USL" else collect(weight * (mass * v)[:, None]) / node_mass
    moving = straining if order.endswith("u") else new
    x = x + dt * (weight * moving[nodes]).sum(1)
    return np.concatenate([x, v, log + np.log1p(dt * (slope * straining[nodes]).sum(1))])


def growth(per_cell, stretch, courant, order):
    """Stretch, to whole points, and rate of growth, in units of sqrt(E / density) / cell."""
    n = round(CELLS * per_cell / stretch)
    stretch = CELLS * per_cell / n
    dt = courant / np.sqrt(2 * SHEAR * stretch**2 + LAME)  # the wave's speed where it is
    state = np.concatenate([(np.arange(n) + 0.5) * CELLS / n, np.zeros(n), np.full(n, np.log(stretch))])
    columns = [(step(state + d, 1 / per_cell, dt, order) - step(state - d, 1 / per_cell, dt, order)) / 2e-6 for d in 1e-6 * np.eye(3 * n)]
    return stretch, np.log(np.abs(np.linalg.eigvals(np.array(columns).T)).max()) / dt


if __name__ == "__main__":
    print("| points a cell, stretch, Courant number |", " | ".join(ORDERS), "|\n|---|---|---|---|")
    for per_cell in (2, 3, 4):
        for stretch, courant in ((1.2, 0.4), (1.6, 0.4), (1.6, 0.1)):
            found = [growth(per_cell, stretch, courant, order) for order in ORDERS]
            print(f"| {per_cell}, {found[0][0]:.2f}, {courant} |", " | ".join(f"{g:.4f}" for _, g in found), "|")
