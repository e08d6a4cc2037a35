// The state of a scene in a file: a run that is stopped, by whatever, goes on from the last one that was
// saved with the same bits.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/hash.hpp>
#include <arenite/core/type_words.hpp>
#include <arenite/io/state_file.hpp>
#include <arenite/mesh/motion.hpp>
#include <arenite/scene/state.hpp>
#include <arenite/version.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where a state is saved, and, if you like, a line on what made the scene (its inputs, their hash): a state
/// is restored only by who gives the same line.
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

template <class Scene>
std::vector<StateTerm> state_terms(const Scene& scene, const std::string& recipe) {
  using N = typename Scene::NumericsType;
  std::vector<StateTerm> terms{
      {"version", std::string(library_version)},
      {"kinematics", type_words<typename Scene::Kinematics>()},
      {"mesh", joined_text({type_words<typename Scene::Mesh>(), ", ", mesh_words(scene)})},
      {"numerics",
       joined_text({type_words<typename N::Shape>(), ", ", type_words<typename N::Transfer>(), ", ",
                    type_words<typename N::Order>(), ", ", type_words<typename N::AntiLocking>()})}};
  std::size_t number = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    terms.emplace_back(joined_text({"body ", Scene::body_name(number++)}),
                       type_words<std::remove_cvref_t<decltype(body.law)>>());
  });
  if (!recipe.empty()) terms.emplace_back("recipe", recipe);
  return terms;
}

/// Calls `f(name, value)` for the state of a scene and of observers, "observers/0", ..
template <class Scene, class F, class... Observers>
void visit_run(Scene& scene, F&& f, Observers&... observers) {
  for_each_state(scene, f);
  std::size_t number = 0;
  (visit_state_of(observers, joined_text({"observers/", number++}), f), ...);
}

/// A value of a state as an entry of a file.
template <class Value>
StateEntry entry_of(std::string_view name, Value& value) {
  const auto entry = [&]<class Number>(const Number* data, std::size_t count) {
    return StateEntry{std::string(name), number_kind<Number>, sizeof(Number), count, data};
  };
  if constexpr (state_number<Value>)
    return entry(&value, 1);
  else
    return entry(value.data(), static_cast<std::size_t>(value.size()));
}

/// All values, where they are.
template <class Scene, class... Observers>
std::vector<StateEntry> state_entries(const Scene& scene, const Observers&... observers) {
  std::vector<StateEntry> entries;
  visit_run(
      scene, [&](std::string_view name, const auto& value) { entries.push_back(entry_of(name, value)); },
      observers...);
  return entries;
}

/// Throws the refusal of a state file of another run: its head, or its values, are not those of this one.
template <class Scene, class... Observers>
void refuse_other_run(const StateSource& file, Scene& scene, const std::string& recipe,
                      Observers&... observers) {
  const auto wanted = state_terms(scene, recipe);
  for (std::size_t k = 0; k < std::max(wanted.size(), file.terms().size()); ++k) {
    const StateTerm none_there{"nothing", "more"},
        &here = k < wanted.size() ? wanted[k] : none_there,
        &there = k < file.terms().size() ? file.terms()[k] : none_there;
    if (here != there)
      file.refuse(joined_text({"is of another run: ", there.first, ": ", there.second, "; this one has ",
                               here.first, ": ", here.second}));
  }
  std::size_t known = 0;
  visit_run(
      scene,
      [&](std::string_view name, auto& value) {
        const StateEntry here = entry_of(name, value);
        const StateEntry* there = file.find(name);
        if (there == nullptr) file.refuse(joined_text({"has no ", name, ", which this run has"}));
        if (there->type() != here.type())
          file.refuse(joined_text({name, " is ", there->type(), "; in this run it is ", here.type()}));
        if (!resizable_state_array<std::remove_reference_t<decltype(value)>> && there->count != here.count)
          file.refuse(
              joined_text({name, " has ", there->count, " numbers; in this run it has ", here.count}));
        ++known;
      },
      observers...);
  if (known != file.entries().size())
    file.refuse(joined_text({"holds ", file.entries().size(), " values; this run has ", known}));
}

/// Writes all values.
template <class Scene, class... Observers>
void write_values(StateSource& from, Scene& scene, Observers&... observers) {
  visit_run(
      scene,
      [&](std::string_view name, auto& value) {
        const StateEntry& entry = *from.find(name);
        if constexpr (state_number<decltype(value)>) {
          from.read(entry, &value);
        } else {
          if constexpr (resizable_state_array<std::remove_reference_t<decltype(value)>>)
            value.resize(entry.count);
          from.read(entry, value.data());
        }
      },
      observers...);
}

/// Restores from a file that is open: first looks at all names, types and counts, then writes all values.
/// What shows then alone (counts that do not fit each other, cells that hold other points, ..) is refused
/// too, and the values that were there are put back.
template <class Scene, class... Observers>
void restore_from(StateSource&& file, Scene& scene, const std::string& recipe, Observers&... observers) {
  refuse_other_run(file, scene, recipe, observers...);
  StateCopy before(state_entries(std::as_const(scene), std::as_const(observers)...));
  try {
    write_values(file, scene, observers...);
    try {
      follow_state(scene);
    } catch (const error& e) {
      file.refuse(joined_text({"does not fit: ", e.what()}));
    }
    [[maybe_unused]] const auto follow = [&](auto& observer) {
      if constexpr (requires { observer.follow_state(std::as_const(scene)); })
        observer.follow_state(std::as_const(scene));
    };
    (follow(observers), ...);
  } catch (...) {
    write_values(before, scene, observers...);
    renew_from_state(scene);
    throw;
  }
}

}  // namespace detail

/// Saves the state of a scene, and of observers that have a `visit_state` (`Every`, `Watch`, ..), between two
/// steps: in the run's loop, or as an observer, which then must be the last one. At any time the file is the
/// old or the new one as a whole. Throws `output_error` if it cannot be written.
template <class Scene, class... Observers>
void save_state(const Scene& scene, const SavedState& to, const Observers&... observers) {
  write_state_file(to.path, detail::state_terms(scene, to.recipe),
                   detail::state_entries(scene, observers...));
}

/// Puts a saved state into a scene of the same recipe, and into the same observers in the same order (who has
/// a `follow_state(scene)` is then asked to renew what follows from it); the run
/// then goes on with the same bits, on any number of threads. Parameters (of laws, gravity, contact) are
/// those of the scene, not of the file. Throws `error` that names file and reason, with the values of scene
/// and observers as they were, if the file is foreign, truncated or damaged, of another composition, mesh,
/// recipe or set of observers, or holds values that do not fit each other.
template <class Scene, class... Observers>
void restore_state(Scene& scene, const SavedState& from, Observers&... observers) {
  detail::restore_from(StateFile(from.path), scene, from.recipe, observers...);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
