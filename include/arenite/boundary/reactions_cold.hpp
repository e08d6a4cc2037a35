// Cold functions of reactions.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/QR>

#include <arenite/boundary/reactions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

template <int D>
ARENITE_COLD Mat<double, D> shares_along(const Blocked<D>& blocked) {
  Eigen::Matrix<double, D, Eigen::Dynamic, 0, D, D> normals(D, static_cast<Eigen::Index>(blocked.count));
  for (std::size_t k = 0; k < blocked.count; ++k)
    normals.col(static_cast<Eigen::Index>(k)) = blocked.normals[k];
  Mat<double, D> along = zeros<Mat<double, D>>();
  along.topRows(normals.cols()) = normals.colPivHouseholderQr().solve(Mat<double, D>::Identity());
  return along;
}

ARENITE_COLD std::size_t number_of_name(std::vector<std::string>& names, std::string_view name) {
  std::size_t at = 0;
  while (at < names.size() && names[at] != name) ++at;
  if (at == names.size()) names.emplace_back(name);
  return at;
}

ARENITE_COLD std::size_t number_of_wall(const std::vector<std::string>& names, std::string_view wall) {
  std::string known;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == wall) return k;
    known += (k == 0 ? "" : ", ") + names[k];
  }
  refuse({"reaction: wall"}, wall, {"must be one of: ", known});
}

#define ARENITE_INSTANCES(D) template Mat<double, D> shares_along(const Blocked<D>&);
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
