// Cold functions of vector_argument.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void check_vector_argument(std::string_view name, const std::array<double, 3>& given,
                                        int dimensions) {
  for (int k = 0; k < 3; ++k) {
    const double component = given[static_cast<std::size_t>(k)];
    require(std::isfinite(component), name, component, "must be finite");
    require(k < dimensions || component == 0, name, component,
            "must be zero along an axis that the scene does not have");
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
