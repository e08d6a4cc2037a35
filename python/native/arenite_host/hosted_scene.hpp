// Hosted scene: any scene through one interface, for a program that learns its type at run time. Calls are
// virtual around a step, never within one. Bodies are identified by number.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/core/state_value.hpp>
#include <arenite_host/value.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Nodes of the mesh [n] with their velocity field.
struct HostedNodes {
  std::vector<double> position{};  ///< [n x D], m
  std::vector<double> mass{};      ///< [n], kg, from the last step
  std::vector<double> velocity{};  ///< [n x D], m/s, from the last step
};

/// The cells: nodes of each [m x corners], only of simplex meshes.
struct HostedCells {
  std::vector<std::size_t> nodes{};
  std::size_t corners = 0;
};

/// Energies, J, as `Energies` has them.
struct HostedEnergies {
  double kinetic, strain, stored, plastic, contact, external, inserted, transfer, walls, residual;
};

/// Totals of added or removed points, as in `PointTotals`.
struct HostedTotals {
  std::size_t count = 0;
  double mass = 0;                 ///< kg
  std::vector<double> momentum{};  ///< [D], kg m/s
  double kinetic_energy = 0;       ///< J
  double strain_energy = 0;        ///< J
};

/// Results of probes, one row each; NaN where there is no matter.
struct HostedProbes {
  std::vector<double> velocity{};  ///< [n x D], m/s
  std::vector<double> stress{};    ///< [n x 4 or 6], Pa
};

/// A quantity checked by a `Watch`, as in `Watched`.
struct HostedWatched {
  std::string name;
  std::string meaning;
  double limit = 0;
  double worst = 0;  ///< NaN: not checked
  double time = 0;   ///< of the worst value, s
  int body = -1;     ///< of the worst value; -1: the whole scene
  std::array<double, 3> place{};
  bool warned = false;
};

/// Settings of a run.
struct HostedRun {
  double end;                      ///< s, on the scene's clock
  double courant = 0.5;            ///< share of the stable step, -
  double max_step = 1e300;         ///< s
  std::optional<double> settle{};  ///< ends when settled to this ratio (`SettleOptions`), -
  bool watch = true;               ///< whether the run is watched
  std::optional<Value> limits{};   ///< of the watch, `WatchLimits` by name; none: those of `run`
  std::vector<double> periods{};   ///< s; each has a callback
  bool resumed = false;            ///< continues a restored run: calls due at its start were made
  /// called with the number of a period that is due; returns whether the run stops there
  std::function<bool(std::size_t)> due{};
  bool each_step = false;              ///< whether `after_step` must be called after each one
  std::function<bool()> after_step{};  ///< called after steps; returns whether the run stops there
};

class HostedScene {
 public:
  virtual ~HostedScene() = default;

  virtual int dimension() const = 0;
  virtual double time() const = 0;
  virtual double time_step() const = 0;
  virtual std::size_t steps() const = 0;
  /// Changes whenever points may have changed places in their columns, or columns in memory.
  virtual std::size_t generation() const = 0;

  virtual double stable_step() const = 0;
  virtual void step(double dt) = 0;
  /// Whether it came to its end, or settled; false where a call stopped it before.
  virtual bool run(const HostedRun&) = 0;
  /// The loop of `run` for a host that steps by itself, without callbacks; `end` may be infinite. The
  /// returned function computes the next step and returns its length, s; 0 at the end. Its argument: whether
  /// the host wrote numbers of points before that step. It must not outlive the scene.
  virtual std::function<double(bool)> steps(const HostedRun&) = 0;
  /// Quantities checked by the watch of the last run; empty if it had none.
  virtual std::vector<HostedWatched> watched() const = 0;

  /// As `out_of_balance` has it; of a scene in which a part damps.
  virtual double out_of_balance() const = 0;
  /// Ends damping by all parts that damp.
  virtual void switch_off_damping() = 0;

  /// `state_slots` of the scene.
  virtual std::vector<StateSlot> state() = 0;
  virtual HostedNodes nodes(std::size_t body) const = 0;
  virtual HostedCells cells() const = 0;
  virtual HostedEnergies energies() const = 0;
  /// Force, N, and impulse, N s, of a wall: two rows of D numbers.
  virtual std::array<std::vector<double>, 2> reaction(const std::string& wall) const = 0;

  /// Fills a region with points of a body, as a fill of these values does in a new scene.
  virtual HostedTotals fill(std::size_t body, const Value& fill) = 0;
  /// Adds points: rows by name, "position" [n, D] and "volume" [n], perhaps "velocity" [n, D], "mass" [n],
  /// "stress" [n, 4 or 6], and "history", rows [n] by name.
  virtual HostedTotals insert(std::size_t body, const Value& points) = 0;
  /// Removes points: those in a region, or those whose number in an array [n] is not 0.
  virtual HostedTotals remove(std::size_t body, const Value& where) = 0;
  /// Velocity and stress of a body at places [n x D].
  virtual HostedProbes probe(std::size_t body, const std::vector<double>& places) const = 0;
  /// Force [D] across a `Section`, N; `of_nodes`: as the motion of nodes sees it.
  virtual std::vector<double> section_force(std::size_t body, const Value& section, bool of_nodes) const = 0;

  virtual void save(const std::string& path, const std::string& recipe) const = 0;
  virtual void restore(const std::string& path, const std::string& recipe) = 0;
  /// Renews what follows from the state, after it was written.
  virtual void follow() = 0;
  virtual std::unique_ptr<HostedScene> copy() const = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
