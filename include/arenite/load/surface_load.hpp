// Surface load: a traction or a normal pressure as a function of place and time.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <string>
#include <string_view>
#include <utility>

#include <arenite/functions/place_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Force on an area of a surface.
class SurfaceLoad {
 public:
  explicit SurfaceLoad(VectorFunction traction) : traction_{std::move(traction)} {}
  explicit SurfaceLoad(ScalarFunction pressure) : pressure_{std::move(pressure)}, is_pressure_{true} {}

  bool is_pressure() const { return is_pressure_; }
  const char* name() const { return is_pressure() ? "pressure" : "traction"; }

  /// N, on an area vector [D], m2, along the outward normal, at a position, m, and a time, s. Throws
  /// `run_error` that names `where` if the load is not finite.
  template <class T, int D>
  Vec<T, D> force(const Vec<T, D>& position, const Vec<T, D>& area, double time,
                  std::string_view where) const {
    if (is_pressure_) return -value_at(pressure_, position, time, where) * area;
    return area.norm() * value_at(traction_, position, time, where);
  }

 private:
  VectorFunction traction_{Triple{}};
  ScalarFunction pressure_{0.0};
  bool is_pressure_ = false;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
