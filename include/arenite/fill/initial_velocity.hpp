// Initial velocity of a body: one vector, or any function of the position.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>

#include <arenite/core/cold.hpp>
#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// `{3, 1, 0}`, or a function of the position (x, y, z = 0 in two dimensions), m, that returns (x, y, z),
/// m/s. Transfers that keep a velocity gradient at the points (APIC, TPIC) begin with that of the function,
/// by central differences.
class InitialVelocity {
 public:
  using Three = std::array<double, 3>;

  InitialVelocity() = default;
  InitialVelocity(const Three& v) : uniform_{v} {}
  InitialVelocity(std::initializer_list<double> v);
  template <class F>
  requires std::is_invocable_r_v<Three, const F&, const Three&> InitialVelocity(F f) : at_{std::move(f)} {}

  bool is_uniform() const { return !at_; }

  /// Velocity [D] at a position, m/s. Throws `error` unless it is finite and zero along axes that the scene
  /// does not have.
  template <class T, int D>
  Vec<T, D> at(const Vec<T, D>& x) const {
    return in_scene<D, T>(checked(in_space(x), D));
  }

  /// Its gradient [D x D] at a position, 1/s: row i, column k is that of component i along axis k. `length`:
  /// over which the function varies, m; a millionth of it is the distance of the differences.
  template <class T, int D>
  Mat<T, D> gradient(const Vec<T, D>& x, double length) const {
    Mat<T, D> g = zeros<Mat<T, D>>();
    if (is_uniform()) return g;
    const double h = 1e-6 * length;
    const Three middle = in_space(x);
    for (std::size_t k = 0; k < D; ++k) {
      Three before = middle, behind = middle;
      before[k] -= h;
      behind[k] += h;
      const Three v = checked(before, D), w = checked(behind, D);
      for (std::size_t i = 0; i < D; ++i)
        g(static_cast<int>(i), static_cast<int>(k)) = static_cast<T>((w[i] - v[i]) / (behind[k] - before[k]));
    }
    return g;
  }

 private:
  Three checked(const Three& x, int dimensions) const;

  Three uniform_{};
  std::function<Three(const Three&)> at_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <algorithm>
#include <cmath>
#include <span>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD InitialVelocity::InitialVelocity(std::initializer_list<double> v) {
  require(v.size() <= 3, "FillOptions.velocity, components", v.size(), "must be at most 3");
  std::copy(v.begin(), v.end(), uniform_.begin());
}

ARENITE_COLD InitialVelocity::Three InitialVelocity::checked(const Three& x, int dimensions) const {
  const Three v = is_uniform() ? uniform_ : at_(x);
  if (std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]) && (dimensions == 3 || v[2] == 0))
    return v;
  const std::string place = vector_text(std::span(x).first(static_cast<std::size_t>(dimensions)));
  check_vector_argument(
      is_uniform() ? "FillOptions.velocity" : joined_text({"FillOptions.velocity at ", place, " m"}), v,
      dimensions);
  return v;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
