"""At which stretch points part from a face: the least eigenvalue of evenly stretched matter on B-splines. Prints the rows of docs/limits.md
("Stretched bodies"): python3 stretched_points.py; needs NumPy and SciPy.

A neo-Hookean square (nu = 0.3) between rollers is stretched by the same ratio along both axes and in balance but for the sums of the points. Where
its nodes move by u the points follow them, so that along an axis their force changes by -K u,

    K_ij = sum_p V0 (c N_i' N_j' + tau N_i'' N_j),  c = d tau / d ln(stretch)

with the Kirchhoff stress tau. The second term is the change of N_i' as a point moves; it is not there where sums are integrals, and with few points it outweighs the
first for the function of the node beside a face. A negative eigenvalue of K / M grows at any step."""

import numpy as np
from scipy.interpolate import BSpline

SHEAR, LAME = 1 / 2.6, 0.3 / (1.3 * 0.4)  # over Young's modulus


def least_eigenvalue(degree, per_axis, stretch, length=20):
    """In units of c^2 / h^2, c^2 = E / density and h the cell; `length`: at the start, cells."""
    cells = round(length * stretch)
    points = (np.arange(length * per_axis) + 0.5) * stretch / per_axis
    knots = np.r_[[0] * degree, np.arange(cells + 1), [cells] * degree]
    functions = BSpline(knots, np.eye(cells + degree), degree)
    value, slope, curve = (np.asarray(f(points)).T[1:-1] for f in (functions, functions.derivative(1), functions.derivative(2)))
    tau, rate = SHEAR * (stretch**2 - 1) + LAME * 2 * np.log(stretch), 2 * SHEAR * stretch**2 + LAME
    stiffness = rate * slope @ slope.T + tau * curve @ value.T
    return np.linalg.eigvals(stiffness / value.sum(axis=1)[:, None]).real.min()


if __name__ == "__main__":
    for name, degree in (("QuadraticBSpline", 2), ("CubicBSpline", 3)):
        for per_axis in (2, 3, 4, 5):
            stretches = 1 + 0.05 * np.arange(1, 41)  # whole numbers of cells
            first = next((s for s in stretches if least_eigenvalue(degree, per_axis, s) < -1e-6), None)
            print(f"| `{name}` | {per_axis**2} | {'above 3' if first is None else format(first, '.2f')} |")
