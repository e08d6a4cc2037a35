// Wall reactions: force and impulse of each wall on the matter.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/boundary/walls.hpp>
#include <arenite/core/cold.hpp>
#include <arenite/parallel/communicator.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A part that records the reactions of all walls, by name (`Wall::name`): `reaction(scene, "bottom")`.
/// Walls of one name are read together; axisymmetry blocks as "axisymmetric", another part that constrains by
/// the number that it has among the parts, "part 2". Without it nothing is computed.
struct Reactions {
  struct ReactionsOfWalls;
  using OnlyOne = ReactionsOfWalls;
};

/// Of a wall on the matter.
template <class T, int D>
struct Reaction {
  Vec<T, D> force;    ///< mean of the last step, N
  Vec<T, D> impulse;  ///< since the start, N s
};

namespace detail {

/// Rows, as many as directions are blocked: the share of an impulse on a node along each of them, as the walls named them.
template <int D>
Mat<double, D> shares_along(const Blocked<D>& blocked);

/// Place of a name in a list; a new name is added.
std::size_t number_of_name(std::vector<std::string>& names, std::string_view name);
/// Place of a wall's name in the list of all. Throws `error` that names all walls if there is none of that
/// name.
std::size_t number_of_wall(const std::vector<std::string>& names, std::string_view wall);

}  // namespace detail

/// The impulse on a node is divided among the walls there: each gives along the directions that it blocks.
/// A direction that several block counts for the first of them; oblique walls each give along their normals.
template <class T, int D>
class BoundReactions {
 public:
  using OnlyOne = Reactions::ReactionsOfWalls;
  static constexpr std::string_view state_name = "reactions";
  static constexpr bool reads_start_state = false;
  using V = Vec<T, D>;

  /// Called when the scene is made, before `connect` of the parts, with the directions that they all block.
  template <class Scene>
  void connect_walls(const Scene& scene, const BoundaryNodes<D>& nodes) {
    std::vector<std::vector<std::size_t>> number;  // [parts][walls] of their names
    scene.for_each_part([&](const auto& part) {
      auto& of_part = number.emplace_back();
      if constexpr (requires { part.walls_here(); })
        for (const Wall& wall : part.walls_here()) of_part.push_back(number_of(wall.name()));
      else if constexpr (requires(typename Scene::Nodes & all) { part.constrain(all); })
        of_part.push_back(number_of(name_of(part, number.size() - 1)));
      if constexpr (requires { part.given_impulse(); }) givers_.push_back(number_of(part.wall_name()));
    });
    place_.assign(nodes.size(), none);
    for (Index i = 0; i < nodes.size(); ++i) {
      const auto& blocked = nodes.blocked(i);
      if (blocked.count == 0) continue;
      const Mat<double, D> along = detail::shares_along(blocked);
      Share share{static_cast<int>(blocked.count), {}, {}, {}};
      for (std::size_t k = 0; k < blocked.count; ++k) {
        share.wall[k] = number[blocked.part[k]][blocked.wall[k]];
        for (int d = 0, row = static_cast<int>(k); d < D; ++d) {
          share.normals(d, row) = static_cast<T>(blocked.normals[k][d]);
          share.along(row, d) = static_cast<T>(along(row, d));
        }
      }
      place_[i] = static_cast<Index>(shares_.size());
      shares_.push_back(share);
    }
    for (auto* sums : {&now_, &last_, &impulse_}) sums->assign(names_.size() * dim, 0);
  }

  void take_wall_impulse(Index node, const V& impulse) {
    const Share& share = shares_[place_[node]];
    for (int k = 0; k < share.count; ++k) {
      const V part = share.along.row(k).dot(impulse) * share.normals.col(k);
      double* const sum = now_.data() + share.wall[static_cast<std::size_t>(k)] * dim;
      for (std::size_t d = 0; d < dim; ++d) sum[d] += static_cast<double>(part[static_cast<int>(d)]);
    }
  }
  template <class Scene>
  void follow_motion(const Scene& scene, double) {
    std::size_t giver = 0;
    scene.for_each_part([&](const auto& part) {
      if constexpr (requires { part.given_impulse(); }) {
        const V given = part.given_impulse();
        double* const sum = now_.data() + givers_[giver++] * dim;
        for (std::size_t d = 0; d < dim; ++d) sum[d] += static_cast<double>(given[static_cast<int>(d)]);
      }
    });
    for (std::size_t k = 0; k < now_.size(); ++k) impulse_[k] += last_[k] = now_[k];
    std::fill(now_.begin(), now_.end(), 0);
  }
  template <class F>
  void visit_state(F&& f) {
    f("last", last_);
    f("impulse", impulse_);
  }

  /// Names of all walls, each once.
  const std::vector<std::string>& names() const { return names_; }
  /// Impulses of a wall in the last step and since the start, N s. Throws `error` that names all walls if
  /// there is none of that name.
  std::pair<V, V> impulses(std::string_view wall) const {
    const std::size_t at = detail::number_of_wall(names_, wall);
    std::pair<V, V> both;
    for (std::size_t d = 0; d < dim; ++d) {
      both.first[static_cast<int>(d)] = static_cast<T>(last_[at * dim + d]);
      both.second[static_cast<int>(d)] = static_cast<T>(impulse_[at * dim + d]);
    }
    return both;
  }

 private:
  static constexpr auto dim = static_cast<std::size_t>(D);
  struct Share {
    int count;
    Mat<T, D> normals;                  // columns: directions, as walls block them
    Mat<T, D> along;                    // rows: the share of an impulse along each
    std::array<std::size_t, dim> wall;  // that blocks each
  };

  std::size_t number_of(const std::string& name) { return detail::number_of_name(names_, name); }
  template <class Part>
  static std::string name_of(const Part& part, std::size_t number) {
    if constexpr (requires { std::string(part.name); })
      return part.name;
    else
      return joined_text({"part ", number});
  }

  std::vector<std::string> names_;
  std::vector<Index> place_;  // [nodes] in shares_, or none
  std::vector<Share> shares_;
  std::vector<std::size_t> givers_;           // numbers of the parts that give impulses themselves
  std::vector<double> now_, last_, impulse_;  // [walls x D] N s
};

template <class Traits>
BoundReactions<typename Traits::T, Traits::D> bind_part(const Reactions&, const Traits&) {
  return {};
}

/// Force and impulse of a wall on the matter. Needs a scene with `Reactions`. In a scene over a portion of a
/// mesh: the sums over all portions, through the scene's communicator.
template <class Scene>
auto reaction(const Scene& scene, std::string_view wall) {
  static_assert(Scene::template has_part<Reactions>, "reaction: name Reactions{} among the scene's parts");
  auto [last, impulse] = scene.template part<Reactions>().impulses(wall);
  sum_over(scene.communicator(), last, impulse);
  if (scene.time_step > 0) last /= static_cast<typename Scene::T>(scene.time_step);
  return Reaction<typename Scene::T, Scene::D>{last, impulse};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

template <int D>
ARENITE_COLD Mat<double, D> shares_along(const Blocked<D>& blocked) {
  // The normals are the directions times R, which is upper triangular: R by back substitution.
  Mat<double, D> along = zeros<Mat<double, D>>();
  for (std::size_t k = blocked.count; k-- > 0;) {
    const Vec<double, D>& direction = blocked.directions[k];
    const int row = static_cast<int>(k);
    for (int d = 0; d < D; ++d) {
      double left = direction[d];
      for (std::size_t j = k + 1; j < blocked.count; ++j)
        left -= dot(direction, blocked.normals[j]) * along(static_cast<int>(j), d);
      along(row, d) = left / dot(direction, blocked.normals[k]);
    }
  }
  return along;
}

ARENITE_COLD std::size_t number_of_name(std::vector<std::string>& names, std::string_view name) {
  std::size_t at = 0;
  while (at < names.size() && names[at] != name) ++at;
  if (at == names.size()) names.emplace_back(name);
  return at;
}

ARENITE_COLD std::size_t number_of_wall(const std::vector<std::string>& names, std::string_view wall) {
  std::string known;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == wall) return k;
    known += (k == 0 ? "" : ", ") + names[k];
  }
  refuse({"reaction: wall"}, wall, {"must be one of: ", known});
}

#define ARENITE_INSTANCES(D) template Mat<double, D> shares_along(const Blocked<D>&);
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail

#endif  // ARENITE_HAS_COLD
