// Rigid bodies as a watch sees them: whether one has passed a wall (they stop only matter) or left the mesh.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <arenite/boundary/wall_sides.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/state_value.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

struct MeshMotion;

namespace detail {

/// Whether a watch checks a rigid body: it has a mass, and a surface that moves with it.
template <class B>
concept watched_rigid = requires(const B& body) {
  requires B::is_free;
  body.surface.distance();
  body.pose();
};

class WatchedRigids {
 public:
  /// After each step. `looks`: whether to inspect a moving mesh again. Calls `tell(text)`.
  template <class Scene, class Tell>
  void look([[maybe_unused]] const Scene& scene, [[maybe_unused]] bool looks, [[maybe_unused]] Tell&& tell) {
    constexpr int D = Scene::D;
    std::size_t number = 0;
    scene.for_each_rigid([&](const auto& body) {
      if constexpr (watched_rigid<std::remove_cvref_t<decltype(body)>>) {
        if (number == 0 && (cell_ == 0 || (looks && moves_mesh(scene)))) look_at_mesh(scene);
        MeshSides<D> mesh{{}, cell_};
        std::copy_n(sides_.begin(), mesh.sides.size(), mesh.sides.begin());
        if (seen_.size() == number) seen_.push_back(body.first_look(mesh));
        const std::string text = body.look_at_walls(seen_[number++], mesh);
        if (!text.empty())
          tell(joined_text({"t = ", scene.time, " s: rigid body ", body.called_in(scene), text}));
      }
    });
  }

  /// The mesh as last inspected: tiles do that together, and one that moves to another rank keeps the result.
  template <class F>
  void visit_state(F&& f) {
    f("mesh/cell", cell_);
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      const StateUnder side(f, joined_text({"mesh/side ", s}));
      side("at", sides_[s].at);
      side("holds", sides_[s].holds);
      side("is_smooth", sides_[s].is_smooth);
    }
  }

 private:
  template <class Scene>
  static bool moves_mesh(const Scene& scene) {
    bool moves = false;
    scene.for_each_part([&](const auto& part) {
      using P = std::remove_cvref_t<decltype(part)>;
      moves = moves || requires { requires std::same_as<typename P::OnlyOne, MeshMotion>; };
    });
    return moves;
  }
  template <class Scene>
  void look_at_mesh(const Scene& scene) {
    std::ranges::copy(wall_sides(scene), sides_.begin());
    cell_ = std::numeric_limits<double>::infinity();
    for (Index c = 0; c < scene.mesh.cell_count(); ++c)
      cell_ = std::min(cell_, static_cast<double>(scene.mesh.size(c)));
    cell_ = scene.communicator().least(cell_);
  }

  std::array<WallSide, 6> sides_{};
  double cell_ = 0;  // m
  std::vector<WatchedRigid> seen_{};
};

}  // namespace detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
