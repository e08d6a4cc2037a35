// Cold functions of reactions.hpp.
#pragma once

#include <Eigen/QR>

#include <arenite/boundary/reactions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

template <int D>
ARENITE_COLD Mat<double, D> shares_along(const Blocked<D>& blocked) {
  Eigen::Matrix<double, D, Eigen::Dynamic, 0, D, D> named(D, static_cast<Eigen::Index>(blocked.count));
  for (std::size_t k = 0; k < blocked.count; ++k) named.col(static_cast<Eigen::Index>(k)) = blocked.named[k];
  Mat<double, D> along = Mat<double, D>::Zero();
  along.topRows(named.cols()) = named.colPivHouseholderQr().solve(Mat<double, D>::Identity());
  return along;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
