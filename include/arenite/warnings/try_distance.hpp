// Trial of a signed distance when a scene is made: at a bounded number of places, to find users' errors.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/geometry/signed_distance.hpp>
#include <arenite/parallel/communicator.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Number k of a sequence that fills [0, 1) evenly (Weyl's).
inline double spread(std::size_t k, double step = 0.6180339887498949) {
  const double x = static_cast<double>(k) * step;
  return x - std::floor(x);
}

/// Numbers below `size`, spread over them: all, or `most`.
std::vector<Index> spread_numbers(std::size_t size, std::size_t most);

/// The distances at some places, m. Throws `error` that names one where it is NaN.
std::vector<double> tried_distances(const AnyDistance& distance,
                                    const std::vector<AnyDistance::Position>& places);

/// `AnyDistance::differences` in space. Throws `error` that names x where one is NaN.
AnyDistance::Position tried_differences(const AnyDistance& distance, const AnyDistance::Position& x,
                                        double h);

/// The median of the magnitudes of the gradient at the places that are nearest to the surface, -, by central
/// differences; 1 if none of them is finite. The nearest are those of the least distance, in
/// whatever unit that is. Differences are over 1e-4 of `sizes`, m, one a place.
double median_gradient(const AnyDistance& distance, const std::vector<AnyDistance::Position>& places,
                       const std::vector<double>& sizes, const std::vector<double>& at_places);

/// Places near nodes of a mesh.
struct MeshPlaces {
  using Position = AnyDistance::Position;
  std::vector<Position> places{};  ///< off the nodes by up to half a cell, within the box around the mesh, m
  std::vector<double> sizes{};     ///< of the cells there, m
  Position lower{}, upper{};       ///< of the box, m

  bool covers(const Position& x) const {
    for (std::size_t k = 0; k < x.size(); ++k)
      if (x[k] < lower[k] || x[k] > upper[k]) return false;
    return true;
  }
};

/// At most `most` of them, spread over the nodes for which `is_meant(position, size)`. Off the nodes: faces
/// and planes of symmetry of a body, where the distance has a kink, pass through nodes. Scenes over the
/// portions of one mesh find the same places, those of the whole mesh.
template <class Scene, class IsMeant>
MeshPlaces mesh_places(const Scene& scene, std::size_t most, IsMeant&& is_meant) {
  constexpr std::array<double, 3> stride{0.7548776662466927, 0.5698402909980532, 0.8191725133961645};
  typename Scene::Nodes nodes(scene.mesh);
  if constexpr (Scene::is_portion) nodes.set_whole(scene.portion().lower, scene.portion().upper);
  MeshPlaces found{.lower = in_space(nodes.lower()), .upper = in_space(nodes.upper())};
  const auto owns = scene.node_owner();
  std::vector<Index> meant;
  for (Index i = 0; i < nodes.size(); ++i)
    if (owns(i) && nodes.is_used(i) &&
        is_meant(in_space(nodes.position(i)), static_cast<double>(scene.mesh.node_size(i))))
      meant.push_back(i);
  constexpr std::size_t row = 5;
  std::vector<double> close;  // of each node its number, position and size
  for (const Index n : spread_numbers(meant.size(), most)) {
    const Index i = meant[n];
    const auto x = in_space(nodes.position(i));
    double number = i;
    if constexpr (Scene::is_portion) number = static_cast<double>(scene.portion().whole_node[i]);
    close.insert(close.end(), {number, x[0], x[1], x[2], static_cast<double>(scene.mesh.node_size(i))});
  }
  if constexpr (Scene::is_portion) close = scene.communicator().gather(close);
  std::vector<std::size_t> order(close.size() / row);
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = row * k;
  if constexpr (Scene::is_portion) std::ranges::sort(order, {}, [&](std::size_t k) { return close[k]; });
  for (const Index n : spread_numbers(order.size(), most)) {
    const double* const node = &close[order[n]];
    MeshPlaces::Position x{node[1], node[2], node[3]};
    const double size = node[4];
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = std::clamp(x[k] + (spread(found.places.size() + 1, stride[k]) - 0.5) * size, found.lower[k],
                        found.upper[k]);
    found.places.push_back(x);
    found.sizes.push_back(size);
  }
  return found;
}

/// Throws `error` where a distance is NaN at one of the places. Warns where its gradient is not 1, as that of
/// a distance in another unit.
void try_distance_at(const AnyDistance& distance, const MeshPlaces& close, const std::string& body);

/// Tries the distance of a rigid body, called `body`, near the nodes of the mesh: less than 2,000 places.
/// Throws and warns as `try_distance_at`.
template <class Scene>
void try_distance(const Scene& scene, const AnyDistance& distance, const std::string& body) {
  const auto places = mesh_places(scene, 1024, [](const auto&, double) { return true; });
  if (is_reporter(scene)) try_distance_at(distance, places, body);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

ARENITE_COLD std::vector<Index> spread_numbers(std::size_t size, std::size_t most) {
  std::vector<Index> all(std::min(size, most));
  for (std::size_t k = 0; k < all.size(); ++k)
    all[k] = static_cast<Index>(size <= most ? k : static_cast<std::size_t>(spread(k) * double(size)));
  return all;
}

ARENITE_COLD std::vector<double> tried_distances(const AnyDistance& distance,
                                                 const std::vector<AnyDistance::Position>& places) {
  std::vector<double> d(places.size());
  distance.at(places, d.data());
  for (std::size_t k = 0; k < d.size(); ++k)
    if (std::isnan(d[k])) throw error(refused_distance(places[k], d[k]));
  return d;
}

ARENITE_COLD AnyDistance::Position tried_differences(const AnyDistance& distance,
                                                     const AnyDistance::Position& x, double h) {
  const auto g = distance.differences<3>(x, h);
  for (const double component : g)
    if (std::isnan(component)) throw error(refused_distance(x, component));
  return g;
}

ARENITE_COLD double median_gradient(const AnyDistance& distance,
                                    const std::vector<AnyDistance::Position>& places,
                                    const std::vector<double>& sizes, const std::vector<double>& at_places) {
  constexpr std::size_t most = 64;
  std::vector<std::size_t> nearest;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (std::isfinite(at_places[k])) nearest.push_back(k);
  std::sort(nearest.begin(), nearest.end(),
            [&](std::size_t a, std::size_t b) { return std::abs(at_places[a]) < std::abs(at_places[b]); });
  nearest.resize(std::min(nearest.size(), most));
  std::vector<double> gradients;
  for (const std::size_t k : nearest) {
    const auto g = tried_differences(distance, places[k], 1e-4 * sizes[k]);
    const double gradient = std::hypot(g[0], g[1], g[2]) / (2e-4 * sizes[k]);
    if (std::isfinite(gradient)) gradients.push_back(gradient);
  }
  if (gradients.empty()) return 1;
  std::sort(gradients.begin(), gradients.end());
  const double median = gradients[gradients.size() / 2];
  const double unit = std::pow(10, std::floor(std::log10(median)) - 3);  // differences have round-off
  return median > 0 ? unit * std::round(median / unit) : 0;
}

ARENITE_COLD void try_distance_at(const AnyDistance& distance, const MeshPlaces& close,
                                  const std::string& body) {
  const auto d = tried_distances(distance, close.places);
  const double gradient = median_gradient(distance, close.places, close.sizes, d);
  if (!(gradient > 0.8 && gradient < 1.25))
    warn(joined_text(
        {"rigid body ", body, ": the gradient of its distance is ", gradient,
         " near its surface (a median), not 1: the distance must be in m, as the position is, and "
         "that to the nearest place of the surface"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#endif  // ARENITE_HAS_COLD
