// Warnings about a new scene: what is allowed but hardly meant.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/warning.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/scene/parts.hpp>
#include <arenite/scene/roles.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// Warns if a region with bounds (members `lower` and `upper`, m) reaches beyond the box around the mesh by
/// more than a hundredth of a cell: no points are made there. An infinite bound means all that there is.
/// Other regions have no bounds to compare.
template <class M>
void warn_bounds(const M& mesh, const AnyRegion& region, const std::string& name) {
  if (region.has_bounds) {
    constexpr int D = M::dimension;
    Vec<double, D> lower, upper;
    if constexpr (is_simplex_mesh<M>) {
      lower = upper = mesh.origin(0).template cast<double>();
      for (Index c = 0; c < mesh.cell_count(); ++c)
        for (const Index i : mesh.nodes(c)) {
          const Vec<double, D> x = mesh.position(i).template cast<double>();
          lower = lower.cwiseMin(x);
          upper = upper.cwiseMax(x);
        }
    } else {
      for (int k = 0; k < D; ++k) {
        lower[k] = static_cast<double>(mesh.lower()[k]);
        upper[k] = static_cast<double>(mesh.upper(k));
      }
    }
    double least = std::numeric_limits<double>::infinity();
    for (Index c = 0; c < mesh.cell_count(); ++c) least = std::min(least, static_cast<double>(mesh.size(c)));
    double within = 1;
    bool beyond = false;
    for (int k = 0; k < D; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const double from = std::isinf(region.lower[axis]) ? lower[k] : region.lower[axis];
      const double to = std::isinf(region.upper[axis]) ? upper[k] : region.upper[axis];
      beyond = beyond || std::max(lower[k] - from, to - upper[k]) > 0.01 * least;
      within *= (std::min(to, upper[k]) - std::max(from, lower[k])) / (to - from);
    }
    if (beyond)
      warn(joined_text({"body ", name, ": ", std::round(1000 * (1 - within)) / 10,
                       " % of its region lies outside of the mesh, which reaches from ", vector_text(lower),
                       " to ", vector_text(upper), " m, and is not filled"}));
  }
}

/// Warns of points that stand for another volume than that of the region in the mesh.
template <class B>
void warn_volume(const B& body, const std::string& name) {
  const double filled = body.initial_volume, region = body.region_volume, density = body.law.density();
  if (std::abs(filled - region) <= 0.02 * region || body.points.size() == 0) return;
  warn(joined_text({
      "body ", name, ": its points have ", density * filled, " kg, its region ", density * region,
      " kg: a point stands for all of its sub-cell, if the middle of that lies in the region; let "
      "the region end on sub-cells, or say FillOptions.exact_volume"}));
}

/// Points of a body that lie in the region of another.
template <class M, class B>
std::size_t points_within(const M& mesh, const B& body, const AnyRegion& region) {
  std::size_t count = 0;
  if (region.test) {
    for (const auto& x : body.points.position) count += region.contains(x);
  } else if constexpr (is_simplex_mesh<M>) {
    const auto numbers = region_numbers(mesh, region);
    for (const Index c : body.points.cell) count += std::ranges::count(numbers, mesh.region(c)) > 0;
  }
  return count;
}

/// Warns of bodies that were filled into one place: one has points in the region of the other.
template <class M, class B, class C, class FillB, class FillC>
void warn_overlap(const M& mesh, const std::string& name, const B& body, const FillB& fill,
                  const std::string& other_name, const C& other, const FillC& other_fill) {
  const std::size_t in_other = points_within(mesh, body, other_fill.region),
                    in_this = points_within(mesh, other, fill.region);
  if (in_other + in_this == 0) return;
  warn(joined_text({"bodies ", name, " and ", other_name, " lie in one place: ", in_other, " of the ",
                   body.points.size(), " points of body ", name, " are in the region of body ", other_name,
                   ", and ", in_this, " of ", other.points.size(), " the other way"}));
}

/// Warns of a body with fewer points than span a volume: it cannot strain as a body does.
template <class L, class T, int D, ExtraColumns E>
void warn_few_points(const Body<L, T, D, E>& body, const std::string& name) {
  const std::size_t count = body.points.size();
  if (count == 0 || count > D) return;
  warn(joined_text({
      "body ", name, " has ", count, count == 1 ? " point" : " points", ": fewer than ", D + 1,
      " cannot strain as a body; is its region, or the mesh's cell, of the size that was meant?"}));
}

/// Warns if gravity pulls and nothing can hold: no constraint blocks a part of it, and no part holds but
/// those that fall themselves.
template <class Scene>
void warn_no_support(const Scene& scene) {
  const auto g = scene.acceleration();
  const auto magnitude = g.norm();
  if (!(magnitude > 0)) return;
  for (const auto& c : scene.constraints)
    if ((g - c.projector * g).norm() > 1e-6 * magnitude) return;
  bool held = false;
  scene.for_each_part([&](const auto& part) {
    using P = std::remove_cvref_t<decltype(part)>;
    if constexpr (holds_against<P, Scene>)
      held = held || part.holds_against(g);
    else
      held = held || adds_force<P, Scene> || (exchanges_impulses<P, Scene> && exchange_rank<P> > 0);
  });
  if (!held)
    warn(joined_text({"gravity ", vector_text(g),
                     " m/s2 acts, but no wall and no rigid body holds along it: everything falls"}));
}

/// All warnings about a new scene and the recipes of its bodies.
template <class Scene, class... Fills>
void warn_about_new_scene(const Scene& scene, const Bodies<Fills...>& recipe) {
  const auto& fills = recipe.fills;
  constexpr std::size_t count = sizeof...(Fills);
  const auto each = [&]<std::size_t... I>(std::index_sequence<I...>, [[maybe_unused]] auto&& f) {
    (f(std::integral_constant<std::size_t, I>{}), ...);
  };
  each(std::make_index_sequence<count>{}, [&](auto b) {
    warn_bounds(scene.mesh, std::get<b>(fills).region, Scene::body_name(b));
    each(std::make_index_sequence<b>{}, [&](auto a) {
      warn_overlap(scene.mesh, Scene::body_name(a), scene.template body<std::size_t(a)>(), std::get<a>(fills),
                   Scene::body_name(b), scene.template body<std::size_t(b)>(), std::get<b>(fills));
    });
  });
  scene.for_each_body([&, number = std::size_t{0}](const auto& body, const auto&) mutable {
    warn_volume(body, Scene::body_name(number));
    warn_few_points(body, Scene::body_name(number++));
  });
  warn_no_support(scene);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
