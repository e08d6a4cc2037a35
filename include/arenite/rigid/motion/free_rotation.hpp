// Rotation of a rigid body on which no moment acts, through one step.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>

#include <arenite/core/error.hpp>
#include <arenite/rigid/body/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Turns a body of `inertia` (in its own frame, kg m2) and angular momentum (in space, kg m2/s) through dt,
/// s, by the midpoint rule of the body's frame (Simo and Wong 1991, doi:10.1002/nme.1620310103; Austin,
/// Krishnaprasad and Wang 1993, doi:10.1006/jcph.1993.1128): the mean spin W of the step solves
///
///     I W + dt/2 W x (I W) = R^T L,   R <- R cay(dt W)
///
/// The angular momentum in space is not touched, the energy kept to round-off, and the motion reversible.
template <int D>
requires(D == 3) void rotate_freely(Orientation<D>& orientation, const Mat<double, D>& inertia,
                                    const Vec<double, D>& angular_momentum, double dt, int halvings = 20) {
  const Vec<double, D> start = orientation.matrix().transpose() * angular_momentum;
  const auto matrix_of = [](const Vec<double, D>& a) {
    Mat<double, D> m;
    m << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
    return m;
  };
  Vec<double, D> spin = inertia.inverse() * start;
  for (int k = 0; k < 30; ++k) {
    const Vec<double, D> momentum = inertia * spin;
    const Vec<double, D> rest = momentum + dt / 2 * spin.cross(momentum) - start;
    const Mat<double, D> slope = inertia + dt / 2 * (matrix_of(spin) * inertia - matrix_of(momentum));
    const Vec<double, D> change = slope.inverse() * rest;
    spin -= change;
    if (!(change.norm() <= 1e-8 * spin.norm())) continue;  // what is left is its square
    orientation.turn_by_cayley(dt * spin);
    return;
  }
  if (halvings == 0) throw run_error("Free: a rigid body spins too fast for the time step");
  for (int half = 0; half < 2; ++half)
    rotate_freely(orientation, inertia, angular_momentum, dt / 2, halvings - 1);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
