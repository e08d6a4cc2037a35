// Plugin: the compositions and laws that a shared object offers to the program that opens it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/once.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/parallel/parallel.hpp>
#include <arenite/tiles/options.hpp>
#include <arenite/tiles/ranks.hpp>
#include <arenite/version.hpp>
#include <arenite_host/hosted_law.hpp>
#include <arenite_host/hosted_scene.hpp>

namespace arenite::program {

/// Hidden: each shared object has its own.
[[gnu::visibility("hidden")]] inline constinit Place plugin{nullptr};

}  // namespace arenite::program

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The functions of a shared object that its program calls; `type`: the composition as the host writes it.
struct Plugin {
  std::string version;
  struct SceneMaker {
    std::string type;
    std::unique_ptr<HostedScene> (*make)(const Value&);
  };
  struct LawMaker {
    std::string type;
    std::unique_ptr<HostedLaw> (*make)(const Value&);
  };
  struct TilesMaker {
    std::string type;
    std::unique_ptr<HostedScene> (*make)(const Value&, Ranks&, const TileOptions&, const RebalanceOptions&);
  };
  std::vector<SceneMaker> scenes{};
  std::vector<LawMaker> laws{};
  std::vector<TilesMaker> tiles{};
  void (*set_threads)(int) = nullptr;
  WarningHook (*on_warning)(WarningHook) = nullptr;
};

namespace shared_detail {

/// The plugin of this shared object; its units add to it before the program asks.
[[gnu::visibility("hidden")]] inline Plugin& this_plugin() {
  return once<Plugin>(program::plugin, []() -> Plugin& {
    static Plugin plugin{std::string(library_version), {}, {}, {}, &set_threads, &on_warning};
    return plugin;
  });
}

/// Adds to the plugin when the shared object is opened.
struct Registration {
  explicit Registration(Plugin::SceneMaker scene) { this_plugin().scenes.push_back(std::move(scene)); }
  explicit Registration(Plugin::LawMaker law) { this_plugin().laws.push_back(std::move(law)); }
  explicit Registration(Plugin::TilesMaker tiles) { this_plugin().tiles.push_back(std::move(tiles)); }
};

}  // namespace shared_detail

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

/// In one unit of the shared object: the symbol that its program loads.
#define ARENITE_PLUGIN \
  extern "C" const arenite::Plugin* arenite_plugin() { return &arenite::shared_detail::this_plugin(); }
