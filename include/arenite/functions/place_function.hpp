// Type-erased functions of place and time, in which loads and prescribed motions are given.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/functions/time_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// (x, y, z), z = 0 in two dimensions: a position, m, or a vector of any unit.
using Triple = std::array<double, 3>;

/// A value, a function of time, `f(t)`, or one of place and time, `f(x, t)`, x a `Triple`, m, t in s. A
/// function of place is called on several threads at once.
template <class Value>
class PlaceFunction {
 public:
  template <class F>
  static constexpr bool of_time = std::is_invocable_r_v<Value, const F&, double>;
  template <class F>
  static constexpr bool of_place = std::is_invocable_r_v<Value, const F&, const Triple&, double>;

  PlaceFunction(const Value& value)
      : f_{[value](const Triple&, double) { return value; }}, is_constant_{true} {}
  template <class F>
  requires(!std::convertible_to<F, Value> && !std::derived_from<F, PlaceFunction>) PlaceFunction(F f) {
    static_assert(of_time<F> || of_place<F>,
                  "a load or motion must be a value, or callable as f(double time) const or f(const "
                  "std::array<double, 3>& position, double time) const, and return a number where a number "
                  "is meant, else std::array<double, 3>");
    if constexpr (requires { f.check(); }) f.check();
    if constexpr (of_place<F>) {
      is_uniform_ = false;
      f_ = std::move(f);
    } else if constexpr (of_time<F>) {
      f_ = [g = std::move(f)](const Triple&, double time) -> Value { return g(time); };
    }
  }

  /// Whether it is the same everywhere.
  bool is_uniform() const { return is_uniform_; }
  /// Whether it is a value.
  bool is_constant() const { return is_constant_; }
  Value operator()(const Triple& position, double time) const { return f_(position, time); }

 private:
  std::function<Value(const Triple&, double)> f_;
  bool is_uniform_ = true, is_constant_ = false;
};

using ScalarFunction = PlaceFunction<double>;

/// `{0, -9.81}` (as many components as the scene has dimensions, or fewer), or a function that returns
/// (x, y, z); `VectorFunction({0, -1}, Ramp{..})` is a direction times a function of time.
class VectorFunction : public PlaceFunction<Triple> {
 public:
  using PlaceFunction<Triple>::PlaceFunction;
  VectorFunction(std::initializer_list<double> v) : PlaceFunction<Triple>(filled(v)) {}
  VectorFunction(const Triple& v, const ScalarFunction& factor) : PlaceFunction<Triple>(scaled(v, factor)) {}

 private:
  static Triple filled(std::initializer_list<double> v) {
    require(v.size() <= 3, "components", v.size(), "must be at most 3");
    Triple a{};
    std::size_t k = 0;
    for (const double x : v) {
      require(std::isfinite(x), {"component ", k}, x, "must be finite");
      a[k++] = x;
    }
    return a;
  }
  static PlaceFunction<Triple> scaled(const Triple& v, const ScalarFunction& factor) {
    filled({v[0], v[1], v[2]});  // or throws
    const auto product = [v](double s) { return Triple{s * v[0], s * v[1], s * v[2]}; };
    if (factor.is_uniform())
      return [=](double time) { return product(factor({}, time)); };
    else
      return [=](const Triple& x, double time) { return product(factor(x, time)); };
  }
};

namespace detail {

/// Throws `run_error`: what is given by a function has no sensible value.
[[noreturn]] inline void refuse_value(std::string_view name, const std::string& place, double time,
                                      const std::string& value, std::string_view rule) {
  throw run_error(joined_text({"t = ", time, " s: ", name, place.empty() ? "" : " at ", place,
                               place.empty() ? "" : " m", " = ", value, ": ", rule}));
}

}  // namespace detail

/// The value at a position, m, and time, s. Throws `run_error` that names what is given so, unless it is
/// finite and has no component along an axis that the scene does not have.
template <class T, int D>
Vec<T, D> value_at(const VectorFunction& f, const Vec<T, D>& position, double time, std::string_view name) {
  const Triple v = f(in_space(position), time);
  Vec<double, D> out;
  bool finite = true;
  for (std::size_t k = 0; k < D; ++k) {
    out[static_cast<int>(k)] = v[k];
    finite = finite && std::isfinite(v[k]);
  }
  if (!finite)
    detail::refuse_value(name, f.is_uniform() ? "" : vector_text(position), time, vector_text(out),
                         "must be finite");
  if (D == 2 && v[2] != 0)
    detail::refuse_value(name, f.is_uniform() ? "" : vector_text(position), time,
                         joined_text({"(", v[0], ", ", v[1], ", ", v[2], ")"}),
                         "must be zero along an axis that the scene does not have");
  return out.template cast<T>();
}
template <class T, int D>
T value_at(const ScalarFunction& f, const Vec<T, D>& position, double time, std::string_view name) {
  const double value = f(in_space(position), time);
  if (!std::isfinite(value))
    detail::refuse_value(name, f.is_uniform() ? "" : vector_text(position), time, joined_text({value}),
                         "must be finite");
  return static_cast<T>(value);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
