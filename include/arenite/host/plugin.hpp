// Plugin: the compositions and laws that a shared object offers to the program that opens it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/once.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/host/hosted_law.hpp>
#include <arenite/host/hosted_scene.hpp>
#include <arenite/host/members.hpp>
#include <arenite/parallel/parallel.hpp>
#include <arenite/version.hpp>

namespace arenite::program {

/// Hidden: each shared object has its own.
[[gnu::visibility("hidden")]] inline constinit Place plugin{nullptr};

}  // namespace arenite::program

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// What a composition's parameters are called, in order, and how they begin (not a number: no default).
using PluginMembers = std::vector<std::pair<std::string, double>>;

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
  struct Recipe {
    std::string type;
    PluginMembers (*members)();
  };
  std::vector<SceneMaker> scenes{};
  std::vector<LawMaker> laws{};
  std::vector<Recipe> recipes{};  ///< of which the host may ask for the parameters
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
  explicit Registration(Plugin::Recipe recipe) { this_plugin().recipes.push_back(std::move(recipe)); }
};

}  // namespace shared_detail

/// The members of an aggregate of parameters.
template <class Parameters>
PluginMembers members_of() {
  return [&]<std::size_t... K>(std::index_sequence<K...>) {
    [[maybe_unused]] const Parameters begin{};
    [[maybe_unused]] const auto number = [](const auto& value) -> double {
      if constexpr (std::is_convertible_v<decltype(value), double>)
        return static_cast<double>(value);
      else if constexpr (requires { static_cast<double>(value({}, 0.0)); })  // a load in time
        if (value.is_constant()) return value({}, 0.0);
      return std::numeric_limits<double>::quiet_NaN();
    };
    return PluginMembers{{std::string(member_names<Parameters>[K]), number(member<K>(begin))}...};
  }
  (std::make_index_sequence<member_count<Parameters>>{});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

/// In one unit of the shared object: what its program looks for.
#define ARENITE_PLUGIN \
  extern "C" const arenite::Plugin* arenite_plugin() { return &arenite::shared_detail::this_plugin(); }
