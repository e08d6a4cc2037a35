// Steps with observers, and files as bytes: what the tests of saved states share.
#pragma once

#include <arenite/run/saved_state.hpp>
#include <arenite/scene/stable_step.hpp>
#include <arenite/scene/step.hpp>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "catch.hpp"
#include "state_buffer.hpp"

namespace arenite::test {

template <class Scene, class... Observers>
void steps(Scene& scene, int count, Observers&... observers) {
  for (int k = 0; k < count; ++k) {
    step(scene, 0.4 * stable_step(scene));
    (observers(std::as_const(scene)), ...);
  }
}

inline std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
inline void write(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

/// Whole files, with a hash that fits, of states that do not: `save(entries)` writes one, `restore(scene)`
/// must refuse it and leave the scene as it was. Each value in turn is shorter, longer, of another type,
/// missing and doubled; then come numbers that no point or list may have.
template <class Make, class Save, class Restore>
void check_crafted(Make&& make, Save&& save, Restore&& restore) {
  auto source = make(), scene = make(), untouched = make();
  steps(source, 3);
  const StateBuffer before(scene);
  const auto good = state_slots(source);
  std::vector<char> numbers(1 << 20, 1);
  const auto refused = [&](const std::vector<StateSlot>& entries, const std::string& reason) {
    save(entries);
    REQUIRE_THROWS_WITH(restore(scene),
                        Catch::Matchers::Contains("state file = ") && Catch::Matchers::Contains(reason));
    REQUIRE(StateBuffer::first_difference(StateBuffer(scene), before) == "");
  };
  for (std::size_t k = 0; k < good.size(); ++k) {
    CAPTURE(good[k].name);
    REQUIRE((good[k].count + 1) * good[k].bytes < numbers.size());
    const std::string of_count = good[k].name.ends_with("points/mass") ? "as many as points have a mass"
                                 : good[k].name.ends_with("/unsorted") ? "state: cells"
                                 : good[k].name.find("/gaps/") != std::string::npos
                                     ? "state: gaps of a rigid body"
                                     : good[k].name;
    const auto with = [&](auto&& change) {
      auto entries = good;
      change(entries[k]);
      entries[k].data = numbers.data();
      return entries;
    };
    for (const std::size_t count : {std::size_t{0}, good[k].count - 1, good[k].count + 1})
      if (count != good[k].count && count <= good[k].count + 1)
        refused(with([&](auto& e) { e.count = count; }), of_count);
    refused(with([](auto& e) { e.kind = e.kind == 'f' ? 'i' : 'f', e.bytes = 8; }), good[k].name);
    auto entries = good;
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(k));
    refused(entries, "has no " + good[k].name);
    entries.push_back(good[k == 0 ? 1 : 0]);
    refused(entries, "has no " + good[k].name);
    entries.push_back(good[k]);
    refused(entries, "values; this run has");
  }
  std::vector<std::vector<char>> kept;
  const auto with = [&]<class Number>(const std::string& end, std::size_t at, Number value) {
    auto entries = good;
    for (auto& e : entries) {
      if (!e.name.ends_with(end) || at >= e.count) continue;
      REQUIRE(sizeof(Number) == e.bytes);
      const auto* bytes = static_cast<const char*>(e.data);
      auto& copy = kept.emplace_back(bytes, bytes + e.size());
      std::memcpy(copy.data() + at * e.bytes, &value, e.bytes);
      e.data = copy.data();
      return entries;
    }
    FAIL("no value ends with " << end);
    return entries;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), huge = std::numeric_limits<double>::max();
  refused(with("points/mass", 3, nan), "points/mass[3] = nan: must be positive");
  refused(with("points/mass", 3, 0.), "points/mass[3] = 0: must be positive");
  refused(with("points/volume", 0, nan), "points/volume[0] = nan: must be finite");
  refused(with("points/position/x", 1, 2 * huge), "points/position[1]");
  const Index cells = scene.mesh.cell_count();
  for (const Index cell : {cells, cells + 1, none, Index{0}}) {
    refused(with("points/cell", 40, cell), "runs and unsorted must list each point once");
    refused(with("cells/runs", cells, cell), "runs and unsorted must list each point once");
  }
  refused(with("cells/runs", 0, Index{1}), "runs and unsorted must list each point once");
  refused(with("/on", 0, char{2}), "is neither true nor false");
  steps(scene, 2);
  steps(untouched, 2);
  CHECK(StateBuffer::first_difference(StateBuffer(scene), StateBuffer(untouched)) == "");
}

}  // namespace arenite::test
