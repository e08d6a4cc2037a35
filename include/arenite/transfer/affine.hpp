// Affine part of a point's velocity field: what APIC and TPIC hand to the nodes beside the point's own
// velocity.
#pragma once

#include <arenite/transfer/transfer.hpp>

namespace arenite {

/// Velocity gradient [D x D], 1/s, that a point hands to the nodes: B D^-1 for APIC, L for TPIC. On open
/// knots D is diagonal, its entries are sum w (x_i - x_p)_a^2 and vanish only for a point on a face, which
/// then hands over nothing along that axis: there B vanishes too.
template <class Transfer, class T, int D, class Weights, class Positions>
Mat<T, D> handed_gradient(const Mat<T, D>& motion, const Weights& w, const Positions& x_nodes,
                          const Vec<T, D>& x) {
  if constexpr (std::same_as<Transfer, Tpic>) {
    return motion;
  } else {
    Mat<T, D> c = motion;
    for (int a = 0; a < D; ++a) {
      T inertia = 0, reach = 0;
      for (int k = 0; k < w.size(); ++k) {
        inertia += w[k] * square(x_nodes(a, k) - x[a]);
        reach = std::max(reach, std::abs(x_nodes(a, k) - x[a]));
      }
      c.col(a) *= inertia > std::numeric_limits<T>::epsilon() * reach * reach ? 1 / inertia : T(0);
    }
    return c;
  }
}

}  // namespace arenite
