// Material point: all that one point carries, as a value. Bodies store points as columns; values are for
// those that join a body or leave it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstdint>
#include <limits>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// No id: where a scene has none, and before a point gets one.
inline constexpr std::uint64_t no_id = std::numeric_limits<std::uint64_t>::max();

/// One point over scalar T in D dimensions, with a law's history and `Kept` numbers that parts keep with it.
template <real_scalar T, int D, class History, std::size_t Kept = 0>
struct MaterialPoint {
  Vec<T, D> position = filled<Vec<T, D>>(std::numeric_limits<T>::quiet_NaN());  ///< m
  Vec<T, D> velocity = zeros<Vec<T, D>>();                                      ///< m/s
  T volume = std::numeric_limits<T>::quiet_NaN();  ///< m3, of a metre of thickness or of the full circle
  T mass = std::numeric_limits<T>::quiet_NaN();    ///< kg; NaN: the law's density times the volume
  Sym<T, D> stress{};                              ///< Pa, tension positive
  History history{};
  Mat<T, D> velocity_gradient =
      zeros<Mat<T, D>>();              ///< velocity gradient of APIC or TPIC, 1/s; else without meaning
  T dilation = 0;                      ///< plastic volumetric strain of the last step, -
  std::array<T, Kept> part_columns{};  ///< see `point_columns`
  std::uint64_t id = no_id;            ///< where the scene has `PointIds`
};

/// Sums over points.
template <int D>
struct PointTotals {
  std::size_t count = 0;
  double mass = 0;                                    ///< kg
  Vec<double, D> momentum = zeros<Vec<double, D>>();  ///< kg m/s
  double kinetic_energy = 0;                          ///< J
  double strain_energy = 0;                           ///< J, recoverable
  PointTotals& operator+=(const PointTotals& o) {
    count += o.count;
    mass += o.mass;
    momentum += o.momentum;
    kinetic_energy += o.kinetic_energy;
    strain_energy += o.strain_energy;
    return *this;
  }
  template <class F>
  void visit_state(F&& f) {
    f("count", count);
    f("mass", mass);
    f("momentum", momentum);
    f("kinetic_energy", kinetic_energy);
    f("strain_energy", strain_energy);
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
