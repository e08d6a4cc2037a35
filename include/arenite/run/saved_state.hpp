// The state of a scene in a file: a run that was stopped for any reason resumes from the last saved state
// with the same bits.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/hash.hpp>
#include <arenite/core/type_words.hpp>
#include <arenite/io/state_file.hpp>
#include <arenite/mesh/motion.hpp>
#include <arenite/scene/state.hpp>
#include <arenite/version.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where a state is saved, and optionally a line on what made the scene (its inputs, their hash): a state is
/// restored only with the same line.
struct SavedState {
  std::filesystem::path path;
  std::string recipe{};

  template <class Path>
  requires std::convertible_to<Path, std::filesystem::path> SavedState(Path&& file, std::string made_by = {})
      : path(std::forward<Path>(file)), recipe(std::move(made_by)) {}
};

namespace detail {

/// Cells with their nodes, and places of the nodes along the axes on which they stay.
template <class Scene>
std::string mesh_words(const Scene& scene) {
  using Shape = typename Scene::Shape;
  int moved_axis = -1;
  scene.for_each_part([&](const auto& part) {
    if constexpr (requires {
                    requires std::same_as<typename std::remove_cvref_t<decltype(part)>::OnlyOne, MeshMotion>;
                  })
      moved_axis = part.axis();
  });
  Hash hash;
  const auto add = [&](const auto& number) { hash.add(&number, sizeof(number)); };
  for (Index i = 0; i < Shape::node_count(scene.mesh); ++i) {
    const auto x = Shape::node_position(scene.mesh, i);
    for (int k = 0; k < Scene::D; ++k)
      if (k != moved_axis) add(x[k]);
  }
  for (Index c = 0; c < scene.mesh.cell_count(); ++c)
    for (const Index i : typename Shape::template Cell<typename Scene::Mesh>(scene.mesh, c).nodes) add(i);
  return joined_text(
      {Shape::node_count(scene.mesh), " nodes, ", scene.mesh.cell_count(), " cells, ", hash.digits()});
}

/// The head: `types` of kinematics, mesh, shape, transfer, order and averages; of each body its name and its law.
std::vector<StateTerm> state_terms(const std::array<std::string, 6>& types, const std::string& mesh,
                                   const std::vector<StateTerm>& bodies, const std::string& recipe);
template <class Scene>
std::vector<StateTerm> state_terms(const Scene& scene, const std::string& recipe) {
  using N = typename Scene::NumericsType;
  std::vector<StateTerm> bodies;
  scene.for_each_body([&](const auto& body, const auto&) {
    bodies.emplace_back(Scene::body_name(bodies.size()),
                        type_words<std::remove_cvref_t<decltype(body.law)>>());
  });
  return state_terms({type_words<typename Scene::Kinematics>(), type_words<typename Scene::Mesh>(),
                      type_words<typename N::Shape>(), type_words<typename N::Transfer>(),
                      type_words<typename N::StressUpdate>(), type_words<typename N::AntiLocking>()},
                     mesh_words(scene), bodies, recipe);
}

/// Restores a run: first checks all names, types and counts, then writes all values and calls `follow`.
/// Errors that show only then (counts that do not fit each other, cells with other points, ..) are refused
/// too: the previous values are restored and `renew` is called.
void restore_run(StateSource& file, const std::vector<StateTerm>& terms,
                 const std::function<std::vector<StateSlot>()>& slots, const std::function<void()>& follow,
                 const std::function<void()>& renew);

/// Restores from an open file, or from a copy in memory, with the head `terms`.
template <class Scene, class... Observers>
void restore_from(StateSource&& file, Scene& scene, const std::vector<StateTerm>& terms,
                  Observers&... observers) {
  const auto follow = [&] {
    try {
      follow_state(scene);
    } catch (const error& e) {
      file.refuse(joined_text({"does not fit: ", e.what()}));
    }
    [[maybe_unused]] const auto follow_observer = [&](auto& observer) {
      if constexpr (requires { observer.follow_state(std::as_const(scene)); })
        observer.follow_state(std::as_const(scene));
    };
    (follow_observer(observers), ...);
  };
  restore_run(
      file, terms, [&] { return state_slots(scene, observers...); }, follow,
      [&] { renew_from_state(scene); });
}

}  // namespace detail

/// Saves the state of a scene, and of observers that have a `visit_state` (`Every`, `Watch`, ..), between two
/// steps: in the run's loop, or as an observer, which then must be the last one. At any time the file is the
/// old or the new one as a whole. Throws `output_error` if it cannot be written.
template <class Scene, class... Observers>
void save_state(const Scene& scene, const SavedState& to, const Observers&... observers) {
  write_state_file(to.path, detail::state_terms(scene, to.recipe),
                   state_slots(state_owner(scene), state_owner(observers)...));
}

/// Puts a saved state into a scene of the same recipe, and into the same observers in the same order (one with
/// a `follow_state(scene)` then renews what follows from it); the run then continues with the same bits, on
/// any number of threads. Parameters (of laws, gravity, contact) are those of the scene, not of the file.
/// Throws `error` that names file and reason, with the values of scene and observers as they were, if the
/// file is foreign, truncated or damaged, of another composition, mesh, recipe or set of observers, or has
/// values that do not fit each other.
template <class Scene, class... Observers>
void restore_state(Scene& scene, const SavedState& from, Observers&... observers) {
  detail::restore_from(StateFile(from.path), scene, detail::state_terms(scene, from.recipe), observers...);
}

/// The same from a copy in memory, which must be of a scene of the same recipe: it has no head to check that.
template <class Scene, class... Observers>
void restore_state(Scene& scene, StateCopy&& from, Observers&... observers) {
  detail::restore_from(std::move(from), scene, {}, observers...);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <algorithm>

#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

ARENITE_COLD std::vector<StateTerm> state_terms(const std::array<std::string, 6>& types,
                                                const std::string& mesh, const std::vector<StateTerm>& bodies,
                                                const std::string& recipe) {
  std::vector<StateTerm> terms{
      {"version", std::string(library_version)},
      {"kinematics", types[0]},
      {"mesh", joined_text({types[1], ", ", mesh})},
      {"numerics", joined_text({types[2], ", ", types[3], ", ", types[4], ", ", types[5]})}};
  for (const auto& [name, law] : bodies) terms.emplace_back(joined_text({"body ", name}), law);
  if (!recipe.empty()) terms.emplace_back("recipe", recipe);
  return terms;
}

/// Throws the refusal of a state file of another run: its head, or its values, are not those of this one.
ARENITE_COLD void refuse_other_run(const StateSource& file, const std::vector<StateTerm>& wanted,
                                   const std::vector<StateSlot>& slots) {
  for (std::size_t k = 0; k < std::max(wanted.size(), file.terms().size()); ++k) {
    const StateTerm none_there{"nothing", "more"},
        &here = k < wanted.size() ? wanted[k] : none_there,
        &there = k < file.terms().size() ? file.terms()[k] : none_there;
    if (here != there)
      file.refuse(joined_text({"is of another run: ", there.first, ": ", there.second, "; this one has ",
                               here.first, ": ", here.second}));
  }
  for (const StateSlot& here : slots) {
    const StateSlot* there = file.find(here.name);
    if (there == nullptr) file.refuse(joined_text({"has no ", here.name, ", which this run has"}));
    if (there->type() != here.type())
      file.refuse(joined_text({here.name, " is ", there->type(), "; in this run it is ", here.type()}));
    if (here.resize == nullptr && there->count != here.count)
      file.refuse(
          joined_text({here.name, " has ", there->count, " numbers; in this run it has ", here.count}));
  }
  if (slots.size() != file.entries().size())
    file.refuse(joined_text({"holds ", file.entries().size(), " values; this run has ", slots.size()}));
}

ARENITE_COLD void write_values(StateSource& from, const std::vector<StateSlot>& slots) {
  for (const StateSlot& slot : slots) {
    const StateSlot& entry = *from.find(slot.name);
    from.read(entry, slot.resize ? slot.resize(slot.array, entry.count) : slot.data);
  }
}

ARENITE_COLD void restore_run(StateSource& file, const std::vector<StateTerm>& terms,
                              const std::function<std::vector<StateSlot>()>& slots,
                              const std::function<void()>& follow, const std::function<void()>& renew) {
  const std::vector<StateSlot> there = slots();
  refuse_other_run(file, terms, there);
  StateCopy before(there);
  try {
    write_values(file, there);
    follow();
  } catch (...) {
    write_values(before, slots());  // what follows from a state may have moved
    renew();
    throw;
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail

#endif  // ARENITE_HAS_COLD
