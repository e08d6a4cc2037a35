// Cold functions of reactions.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/boundary/reactions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

template <int D>
ARENITE_COLD Mat<double, D> shares_along(const Blocked<D>& blocked) {
  // The normals are the directions times R, which is upper triangular: R by back substitution.
  Mat<double, D> along = zeros<Mat<double, D>>();
  for (std::size_t k = blocked.count; k-- > 0;) {
    const Vec<double, D>& direction = blocked.directions[k];
    const int row = static_cast<int>(k);
    for (int d = 0; d < D; ++d) {
      double left = direction[d];
      for (std::size_t j = k + 1; j < blocked.count; ++j)
        left -= dot(direction, blocked.normals[j]) * along(static_cast<int>(j), d);
      along(row, d) = left / dot(direction, blocked.normals[k]);
    }
  }
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
