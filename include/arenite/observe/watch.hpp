// Watch: an observer that looks at a run for what cannot be right, warns, and stops it at limits that the user
// sets.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/core/warning.hpp>
#include <arenite/observe/energy.hpp>

namespace arenite {

/// Limits of a `Watch`. Past a limit the run stops, past a tenth of it comes one warning. Infinity switches a
/// quantity off: it is not computed.
struct WatchLimits {
  /// Energy that nothing put in, over all that was put in (initial energy, and the work of gravity, loads and
  /// prescribed motions), -. Without `TrackEnergy` what was dissipated is not known: then only a gain beyond
  /// it shows. Sound runs of this library stay below 0.01 to 0.04.
  double energy_gain = 0.1;
  /// Energy that transfers and time steps took, over all that was put in, -. More than all cannot be. Needs
  /// `TrackEnergy`. APIC and PIC take up to a half where bodies collide.
  double energy_loss = 1;
  /// Change of a body's mean volume, |V/V0 - 1|, voids that opened included, -. Dense sand dilates by 0.01 to
  /// 0.05 as a whole, sand that is thrown and lands by 0.4 to 1.2.
  double volume = 0.5;
  /// How far the stress of a point lies outside the yield surface, as `yield(stress)` of its law has it, -:
  /// for laws with that member. A law that returns to its surface stays within round-off.
  double strength = 0.1;
  /// Share of a body's points that left the mesh, -.
  double lost = 0.1;
  /// Steps from one look to the next: a look costs as much as a half to one step at most.
  std::size_t every = 64;
};

/// What a `Watch` saw of one quantity: its greatest value so far.
struct Watched {
  std::string_view name;     ///< the limit's name in `WatchLimits`
  std::string_view meaning;  ///< in words
  double limit = 0;
  double worst = std::numeric_limits<double>::quiet_NaN();  ///< -; NaN: not looked at
  double time = std::numeric_limits<double>::quiet_NaN();   ///< of the worst value, s
  int body = -1;                                            ///< of the worst value; -1: the whole scene
  /// Position of the point that shows it most, m; NaN below a tenth of the limit, and where no point does.
  std::array<double, 3> place = nowhere;
  bool warned = false;

  static constexpr std::array<double, 3> nowhere{std::numeric_limits<double>::quiet_NaN(),
                                                 std::numeric_limits<double>::quiet_NaN(),
                                                 std::numeric_limits<double>::quiet_NaN()};
};

/// Observer that looks at a scene at its first call, then at every `limits.every`th step and, if `run` calls
/// it itself, at the end. Past a limit it throws `run_error` with time, quantity, value, limit and place; past
/// a tenth it warns once (`on_warning`). What it saw can be read afterwards, from the object given to `run`.
/// Observers after it do not see the step at which it throws: name it last.
class Watch {
 public:
  /// Throws `error` unless all limits are positive.
  explicit Watch(const WatchLimits& limits = {});

  template <class Scene>
  void operator()(const Scene& scene) {
    if (scene.steps >= next_) look(scene);
  }
  /// Looks at the end of a run, which may lie between two looks.
  template <class Scene>
  void finish(const Scene& scene) {
    if (scene.steps != last_) look(scene);
  }
  /// Looks now.
  template <class Scene>
  void look(const Scene& scene);

  /// Each quantity with its greatest value so far, in the order of `WatchLimits`.
  const std::array<Watched, 5>& seen() const { return seen_; }
  /// The warnings given, in order: at most one a quantity.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::array<Watched, 5> seen_;
  std::vector<std::string> warnings_;
  std::size_t every_, next_ = 0, last_ = std::size_t(-1);
};

}  // namespace arenite
