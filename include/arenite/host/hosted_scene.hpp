// Hosted scene: any scene behind one interface, for a program that learns its type when it runs. Calls are
// virtual around a step, never within one.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>

namespace arenite {

/// A value of a scene's state (`for_each_state`), where it is: valid until the next step.
struct HostedState {
  std::string name;   ///< path, such as "bodies/0/points/position/x"
  char kind;          ///< 'f' floating point, 'i' signed, 'u' unsigned, 'b' bool
  std::size_t bytes;  ///< of a number
  std::size_t count;
  bool is_array;
  void* data;
};

/// Nodes of the mesh [n] with their velocity field.
struct HostedNodes {
  std::vector<double> position{};  ///< [n x D], m
  std::vector<double> mass{};      ///< [n], kg, from the last step
  std::vector<double> velocity{};  ///< [n x D], m/s, from the last step
};

/// The cells: nodes of each [m x corners], of simplices alone.
struct HostedCells {
  std::vector<std::size_t> nodes{};
  std::size_t corners = 0;
};

/// Energies, J, as `Energies` has them.
struct HostedEnergies {
  double kinetic, strain, stored, plastic, contact, external, inserted, residual;
};

/// What a run is asked for.
struct HostedRun {
  double end;                              ///< s, on the scene's clock
  double courant = 0.5;                    ///< share of the stable step, -
  double max_step = 1e300;                 ///< s
  std::vector<double> periods{};           ///< s; each has a callback
  std::function<void(std::size_t)> due{};  ///< called with the number of a period that is due
  std::function<bool()> after_step{};      ///< called after each step; returns whether the run stops there
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
  virtual void run(const HostedRun&) = 0;

  virtual std::vector<HostedState> state() = 0;
  virtual HostedNodes nodes(std::size_t body) const = 0;
  virtual HostedCells cells() const = 0;
  virtual HostedEnergies energies() const = 0;
  /// Force, N, and impulse, N s, of a wall: two rows of D numbers.
  virtual std::array<std::vector<double>, 2> reaction(const std::string& wall) const = 0;

  virtual void save(const std::string& path, const std::string& recipe) const = 0;
  virtual void restore(const std::string& path, const std::string& recipe) = 0;
  /// Renews what follows from the state, after it was written.
  virtual void follow() = 0;
  virtual std::unique_ptr<HostedScene> copy() const = 0;
};

}  // namespace arenite
