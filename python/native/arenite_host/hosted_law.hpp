// Hosted law: any law through one interface, over arrays of states.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <string>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite_host/value.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Arrays of `n` states in D dimensions, row by row: stresses and strains with S components (D = 2: xx, yy,
/// zz, xy; D = 3: also yz, zx), spins with one or three, histories with as many as the law has names.
struct HostedUpdate {
  int dimension;
  std::size_t n;
  double dt;             ///< s
  double* stress;        ///< [n x S], Pa; in place
  const double* strain;  ///< [n x S], of the step, -
  const double* spin;    ///< [n x 1 or 3], of the step, -; null: none
  double* history;       ///< [n x H]; in place
  double* opening;       ///< [n], -; out
  double* dilation;      ///< [n], -; out
};

/// States along a path, row by row.
struct HostedPath {
  std::size_t rows = 0;
  std::vector<double> time{}, stress{}, strain{}, history{};  ///< [rows], [rows x S] twice, [rows x H]
  std::vector<double> opening{}, dilation{}, work{};          ///< [rows]
};

class HostedLaw {
 public:
  virtual ~HostedLaw() = default;
  virtual double density() const = 0;       ///< kg/m3
  virtual double wave_modulus() const = 0;  ///< Pa
  /// Names of the history's members; empty where one has none.
  virtual std::vector<std::string> history_names() const = 0;
  /// Initial history of a point.
  virtual std::vector<double> history_start() const = 0;
  virtual void update(const HostedUpdate&) const = 0;
  /// J/m3 of the unit volume [n].
  virtual void elastic_energy(int dimension, std::size_t n, const double* stress, const double* history,
                              double* energy) const = 0;
  /// Takes one point through stages (a list of `DriveStage`) from a stress and a history.
  virtual HostedPath drive(int dimension, const Value& stages, const std::vector<double>& stress,
                           const std::vector<double>& history) const = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
