// Limits of a `Watch`, and the values that it found of each quantity.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Limits of a `Watch`. Past a limit the run stops; past a tenth of it the watch warns once. Infinity
/// switches a quantity off: it is not computed. The watch that `run` adds itself has an `energy_gain` of 1, a
/// `volume` of 5 and `lost` 1.
struct WatchLimits {
  /// Energy gained from nothing over the energy put in, -, positive. Put in are the initial energy, that of
  /// inserted points, and the work of gravity, loads and prescribed motions. Gained are the residual of the
  /// balance and negative dissipation, above their lowest value at a check, so that energy lost in transfers
  /// hides no gain. Without `TrackEnergy` the dissipation is not known: then only a gain beyond it since the
  /// first check shows, and none at the end of a run between two checks. An elastic law stretched by 0.1,
  /// beyond the small strains that it is made for, shows 0.03.
  double energy_gain = 0.1;
  /// Energy lost in the transfer over the energy put in, -, positive; needs the energy balance
  /// (`TrackEnergy`). More than 1 is impossible; the warning comes at a tenth: APIC loses 0.17 for a column
  /// of sand that collapses in cells of a tenth of its width, and the heap stays short by a fifth.
  double transfer = 1;
  /// Residual of the energy balance over the energy put in, -, positive; needs `TrackEnergy`. Errors of time
  /// steps, contact and laws. It stays below 0.01 in a sound run; contact with MUSL leaves 0.02.
  double residual = 0.5;
  /// Change of a body's mean volume, |V/V0 - 1|, voids included, -, positive.
  double volume = 0.5;
  /// Greatest speed of a point over the wave speed of its body, -, positive. Above 1 matter cannot give way
  /// to an impact: strains become large at once, which laws of small strains are not made for.
  double speed = 10;
  /// How far a stress lies outside the yield surface of its law, -, positive. As `yield(stress)` of the law has
  /// it, for laws with that member. A law that returns to its surface stays within round-off (1e-13, in float
  /// 5e-5).
  double strength = 0.1;
  /// Share of a body's points that left the mesh, -, positive.
  double lost = 0.1;
  /// Steps from one check to the next, -, >= 1.
  std::size_t every = 100;

  /// Limits of the watch that `run` adds itself. It warns past a tenth of the energy put in gained from
  /// nothing or lost in the transfer, a twentieth of it unaccounted for, half of the volume, the wave speed
  /// and a tenth of the points lost. It stops a run whose energy doubles from nothing, or half of whose
  /// energy is unaccounted for, and no other.
  static WatchLimits of_runs() { return {.energy_gain = 1, .volume = 5, .lost = 1}; }
};

/// The greatest value of one quantity that a `Watch` has found so far.
struct Watched {
  static constexpr std::array<double, 3> nowhere{std::numeric_limits<double>::quiet_NaN(),
                                                 std::numeric_limits<double>::quiet_NaN(),
                                                 std::numeric_limits<double>::quiet_NaN()};

  std::string_view name;     ///< the limit's name in `WatchLimits`
  std::string_view meaning;  ///< in words
  double limit = 0;
  double worst = std::numeric_limits<double>::quiet_NaN();  ///< -; NaN: not checked
  double time = std::numeric_limits<double>::quiet_NaN();   ///< of the worst value, s
  int body = -1;                                            ///< of the worst value; -1: the whole scene
  /// Position of the point with the greatest value, m; NaN below a tenth of the limit, or if there is none.
  std::array<double, 3> place = nowhere;
  bool warned = false;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
