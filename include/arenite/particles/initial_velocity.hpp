// Initial velocity of a body: one vector, or any function of the position.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>

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
  InitialVelocity(std::initializer_list<double> v) {
    require(v.size() <= 3, "FillOptions.velocity, components", v.size(), "must be at most 3");
    std::ranges::copy(v, uniform_.begin());
  }
  template <class F>
  requires std::is_invocable_r_v<Three, const F&, const Three&> InitialVelocity(F f) : at_{std::move(f)} {}

  bool is_uniform() const { return !at_; }

  /// Velocity [D] at a position, m/s. Throws `error` unless it is finite and zero along axes that the scene
  /// does not have.
  template <class T, int D>
  Vec<T, D> at(const Vec<T, D>& x) const {
    if (is_uniform()) return vector_argument<T, D>("FillOptions.velocity", uniform_);
    const Three v = at_(in_space(x));
    const auto is_bad = [](double c) { return !std::isfinite(c); };
    if (std::ranges::any_of(v, is_bad) || (D == 2 && v[2] != 0))
      return vector_argument<T, D>(joined_text({"FillOptions.velocity at ", vector_text(x), " m"}), v);
    return in_scene<D>(v).template cast<T>();
  }

  /// Its gradient [D x D] at a position, 1/s: row i, column k is that of component i along axis k. `length`:
  /// over which the function varies, m; a millionth of it is the distance of the differences.
  template <class T, int D>
  Mat<T, D> gradient(const Vec<T, D>& x, double length) const {
    Mat<double, D> g = Mat<double, D>::Zero();
    if (is_uniform()) return g.template cast<T>();
    const double h = 1e-6 * length;
    for (int k = 0; k < D; ++k) {
      Vec<double, D> before = x.template cast<double>(), behind = before;
      before[k] -= h;
      behind[k] += h;
      g.col(k) = (at<double, D>(behind) - at<double, D>(before)) / (behind[k] - before[k]);
    }
    return g.template cast<T>();
  }

 private:
  Three uniform_{};
  std::function<Three(const Three&)> at_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
