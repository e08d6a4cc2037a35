// End of a step: the clock, the check that nothing has become NaN, and parts that renew points.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include <arenite/scene/scene.hpp>

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

/// Advances the clock. Throws `run_error` that names the first point that is not finite. dt: s.
template <class Scene>
void finish(Scene& scene, double dt) {
  scene.time += dt;
  scene.time_step = dt;
  ++scene.steps;
  if (scene.finite) return renew_points(scene);
  std::size_t number = 0;
  std::string bodies;  // whose sums are not finite
  scene.for_each_body([&](const auto& body, const auto&) {
    const auto& points = body.points;
    const std::size_t first_bad = parallel_reduce(
        points.size(), points.size(),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t p = begin; p < end; ++p)
            if (!is_finite(points, p)) return p;
          return points.size();
        },
        [](std::size_t a, std::size_t b) { return std::min(a, b); });
    if (first_bad < points.size())
      throw run_error(joined_text({
          "t = ", scene.time, " s, step ", scene.steps, ": point ", first_bad, " of body ",
          Scene::body_name(number), " at ", vector_text(points.position[first_bad]), " m has velocity ",
          vector_text(points.velocity[first_bad]), " m/s, pressure ", -trace(points.stress[first_bad]) / 3,
          " Pa, volume ", points.volume[first_bad], " m3: no longer finite"}));
    if (!body.finite) bodies += joined_text({bodies.empty() ? "" : ", ", Scene::body_name(number)});
    ++number;
  });
  throw run_error(joined_text({"t = ", scene.time, " s, step ", scene.steps,
                              ": the sums of stress and volume over the points of body ", bodies,
                              " are not finite, though every number of every point is: they overflow"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
