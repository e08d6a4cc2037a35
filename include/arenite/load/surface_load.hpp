// Surface load: a traction or a normal pressure as a function of place and time.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <arenite/boundary/place_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Force on an area of a surface.
class SurfaceLoad {
 public:
  explicit SurfaceLoad(VectorFunction traction) : load_{std::move(traction)} {}
  explicit SurfaceLoad(ScalarFunction pressure) : load_{std::move(pressure)} {}

  bool is_pressure() const { return std::holds_alternative<ScalarFunction>(load_); }
  const char* name() const { return is_pressure() ? "pressure" : "traction"; }

  /// N, on an area vector [D], m2, along the outward normal, at a position, m, and a time, s. Throws
  /// `run_error` that names `where` if the load is not finite.
  template <class T, int D>
  Vec<T, D> force(const Vec<T, D>& position, const Vec<T, D>& area, double time,
                  std::string_view where) const {
    if (const auto* pressure = std::get_if<ScalarFunction>(&load_))
      return -value_at(*pressure, position, time, where) * area;
    return area.norm() * value_at(std::get<VectorFunction>(load_), position, time, where);
  }

 private:
  std::variant<VectorFunction, ScalarFunction> load_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
