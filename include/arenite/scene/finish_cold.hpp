// Cold functions of finish.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <span>

#include <arenite/scene/finish.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

ARENITE_COLD void refuse_point(double time, std::size_t step, const BadPoint& point, std::size_t dimensions) {
  const auto text = [&](const auto& vector) { return vector_text(std::span(vector).first(dimensions)); };
  throw run_error(
      joined_text({"t = ", time, " s, step ", step, ": point ", point.number, " of body ", point.body, " at ",
                   text(point.place), " m has velocity ", text(point.velocity), " m/s, pressure ",
                   point.pressure, " Pa, volume ", point.volume, " m3: no longer finite"}));
}

ARENITE_COLD void refuse_sums(double time, std::size_t step, const std::string& bodies) {
  throw run_error(joined_text({"t = ", time, " s, step ", step,
                               ": the sums of stress and volume over the points of body ", bodies,
                               " are not finite, though every number of every point is: they overflow"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
