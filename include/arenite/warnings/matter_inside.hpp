// Matter inside of a rigid body when a scene is made: points there take part in no contact that means
// anything.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <arenite/core/by_body.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/warnings/try_distance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Warns of `inside` of the `all` points of body `matter`, which lie inside of rigid body `rigid`.
inline void warn_matter_inside(const std::string& rigid, const std::string& matter, double inside, double all,
                               const char* cure) {
  warn(joined_text({"rigid body ", rigid, ": ", static_cast<std::size_t>(inside), " of the ",
                    static_cast<std::size_t>(all), " points of body ", matter, inside == 1 ? " lies" : " lie",
                    " inside of it: fill what it leaves of the region, ", cure}));
}

/// Warns of bodies with points inside of a rigid one, called `rigid`: deeper than half of a point's size, by
/// which matter may stand over its points' places. If most of the matter lies there, the distance may have
/// the wrong sign.
template <class Scene>
void warn_points_inside(const Scene& scene, const AnyDistance& distance, const std::string& rigid) {
  // Of each body: points inside, all, those that lie deep.
  auto found = by_body<std::array<double, 3>, Scene::body_count>(scene.number_of_bodies());
  std::size_t number = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    std::vector<AnyDistance::Position> places;
    std::vector<double> sizes;
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const typename Scene::V x = body.points.position[p];
      const auto at = in_space(x);
      if (distance.is_beyond(at)) continue;
      places.push_back(at);
      sizes.push_back(std::pow(static_cast<double>(body.points.volume[p] / Scene::Kinematics::thickness(x)),
                               1.0 / Scene::D));
    }
    const auto d = tried_distances(distance, places);
    auto& [inside, all, deep] = found[number++];
    all = static_cast<double>(body.points.size());
    for (std::size_t k = 0; k < d.size(); ++k) {
      inside += d[k] < -1e-6 * sizes[k];
      deep += d[k] < -0.499 * sizes[k];
    }
  });
  double inside_all = 0, all = 0;
  for (auto& of_body : found) {
    sum_over(scene.communicator(), of_body);
    inside_all += of_body[0];
    all += of_body[1];
  }
  if (!is_reporter(scene)) return;
  if (2 * inside_all > all)
    warn(joined_text({"rigid body ", rigid, ": ", std::floor(100 * inside_all / all),
                      " % of the matter lies inside of it: its distance must be negative inside and positive "
                      "outside"}));
  else
    for (std::size_t k = 0; k < found.size(); ++k)
      if (found[k][2] > 0)
        warn_matter_inside(rigid, Scene::body_name(k), found[k][0], found[k][1], "fill(region - shape, ..)");
}

/// Warns of material points in the region of the mesh whose boundary is the surface of a rigid body.
template <class Scene>
void warn_points_in_region(const Scene& scene, const std::string& region, const std::string& rigid) {
  const auto own = scene.mesh.region_numbers(region);
  std::size_t number = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    auto inside = static_cast<double>(
        std::ranges::count_if(body.points.cell, [&](Index c) { return scene.mesh.is_in(c, own); }));
    auto all = static_cast<double>(body.points.size());
    sum_over(scene.communicator(), inside, all);
    if (inside > 0 && is_reporter(scene))
      warn_matter_inside(rigid, Scene::body_name(number), inside, all,
                         "fill(Cells(..), ..) of the mesh's other regions");
    ++number;
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
