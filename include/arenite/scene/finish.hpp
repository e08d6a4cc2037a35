// End of a step: the clock, the check that nothing has become NaN, and parts that renew points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/part/roles.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Whether all numbers of a point are finite.
template <class Points>
bool is_finite(const Points& points, std::size_t p) {
  bool finite = true;
  points.for_each_column([&](const auto& column) {
    if constexpr (std::is_floating_point_v<typename std::remove_cvref_t<decltype(column)>::value_type>)
      finite = finite && std::isfinite(column[p]);
  });
  return finite;
}

/// Lets parts insert, remove and split points.
template <class Scene>
void renew_points(Scene& scene) {
  scene.for_each_part([&](auto& part) {
    if constexpr (renews_points<std::remove_cvref_t<decltype(part)>, Scene>) part.renew_points(scene);
  });
}

namespace detail {

/// A point that is not finite.
struct BadPoint {
  std::size_t number;
  std::string body;
  std::array<double, 3> place, velocity;  // m, m/s
  double pressure, volume;                // Pa, m3
};
[[noreturn]] void refuse_point(double time, std::size_t step, const BadPoint& point, std::size_t dimensions);
/// Of bodies whose sums are not finite.
[[noreturn]] void refuse_sums(double time, std::size_t step, const std::string& bodies);

}  // namespace detail

/// Advances the clock. Throws `run_error` that names the first point that is not finite. dt: s.
template <class Scene>
void finish(Scene& scene, double dt) {
  using T = typename Scene::T;
  constexpr int D = Scene::D;
  scene.time += dt;
  scene.time_step = dt;
  ++scene.steps;
  if (scene.finite) return renew_points(scene);
  std::size_t number = 0;
  std::string bodies;  // whose sums are not finite
  scene.for_each_body([&](const auto& body, const auto&) {
    const auto& points = body.points;
    std::size_t first_bad = 0;
    while (first_bad < points.size() && is_finite(points, first_bad)) ++first_bad;
    if (first_bad < points.size())
      detail::refuse_point(scene.time, scene.steps,
                           {first_bad, Scene::body_name(number), in_space<T, D>(points.position[first_bad]),
                            in_space<T, D>(points.velocity[first_bad]),
                            static_cast<double>(-trace(points.stress[first_bad]) / 3),
                            static_cast<double>(points.volume[first_bad])},
                           D);
    if (!body.finite) bodies += joined_text({bodies.empty() ? "" : ", ", Scene::body_name(number)});
    ++number;
  });
  detail::refuse_sums(scene.time, scene.steps, bodies);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <span>

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

#endif  // ARENITE_HAS_COLD
