// Numerics: how a scene is discretised, as one value: shape function, transfer, order of the stress update,
// anti-locking.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstddef>

#include <arenite/core/refusals.hpp>
#include <arenite/law/law.hpp>
#include <arenite/particles/points.hpp>
#include <arenite/shape/shape.hpp>
#include <arenite/transfer/anti_locking.hpp>
#include <arenite/transfer/transfer.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Bytes of the widest register that this translation unit is compiled for. A constant of internal linkage,
/// used as a template argument: units compiled with other flags have other types and never share a function.
constexpr std::size_t native_register_bytes =
#if defined(__AVX512F__)
    64;
#elif defined(__AVX__)
    32;
#else
    16;
#endif

/// `RegisterBytes`: size of the packs in which points are computed; sizeof(T) for plain scalars.
template <class Shape_, class Transfer_ = Flip, class StressUpdate_ = Musl,
          class AntiLocking_ = NoAntiLocking, std::size_t RegisterBytes = native_register_bytes>
struct Numerics {
  static constexpr std::size_t register_bytes = RegisterBytes;
  /// Points computed at once in scalar T.
  template <class T>
  static constexpr int width = static_cast<int>(RegisterBytes / sizeof(T));
  using Shape = Shape_;
  static_assert(!names_hand<Transfer_> && !names_take<Transfer_>,
                "Numerics: hand and take of a transfer are now called particle_field and gather");
  static_assert(!names_sweeps<Transfer_>,
                "Numerics: sweeps and swept of a transfer are now called iterations and iterated");
  static_assert(
      transfer_type<Transfer_, Shape_>,
      "Numerics: the transfer lacks a member: affine, fits<Shape>, particle_field(point), gather(cell, "
      "nodes), of a class that is not final; see arenite/transfer/transfer.hpp");
  /// Flip in the place of one that the compiler has refused, as already reported.
  using Transfer = std::conditional_t<transfer_type<Transfer_, Shape_>, Transfer_, Flip>;
  using StressUpdate = StressUpdate_;
  using AntiLocking = AntiLocking_;
  template <class T>
  using StrainAverage = typename detail::StrainAverageOf<AntiLocking, T>::type;
  static constexpr bool averages_strain = !std::same_as<StrainAverage<double>, Nothing>;
  /// Whether strains are computed from velocities that were mapped back to the nodes.
  static constexpr bool maps_back = StressUpdate::maps_back && !returns_unchanged<Transfer, Shape>;
  /// Whether the points get their velocities where they are mapped back, in a pass before that of the
  /// strains; linear simplices need no such pass (see `map_back`).
  static constexpr bool maps_back_by_points = maps_back && !Shape::constant_gradient;
  /// Whether points move with the velocities that were mapped back, which strain them, and not with those of the grid
  /// update. Affine transfers keep angular momentum only with the latter.
  static constexpr bool moves_mapped = maps_back_by_points && !Transfer::affine;
  /// Whether points are strained before the forces, with the node velocities at the start of the step.
  static constexpr bool strains_first = StressUpdate::strains_first;
  static constexpr bool strains_at_middle = requires { StressUpdate::strains_at_middle; };
  /// How many halves of the square of a step's gradient its strain includes: see `MidpointStrain`.
  static constexpr int squares = !strains_at_middle ? 0 : strains_first ? 1 : -1;
  /// Whether the velocities for the strains went through the points, which see of a light node as much as it
  /// weighs.
  static constexpr bool strains_by_points =
      maps_back || (strains_first && !returns_unchanged<Transfer, Shape>);
  /// Whether the light nodes at a body's edge exchange momentum with their neighbours (see `LightNodes`).
  /// With MUSL and USF their strain velocities follow those of their neighbours.
  static constexpr bool smooths_light_nodes = has_light_nodes<Shape> && !strains_by_points;
  /// Whether the velocities of the nodes are corrected (see `start_correction`).
  static constexpr bool corrects_nodes = names_iterations<Transfer>;
  /// Whether velocities at the start of the step or forces of the nodes are read, by the transfer or at light
  /// nodes; the kernels of simplices do not sum them as one.
  static constexpr bool reads_start_state = Shape::constant_gradient || has_light_nodes<Shape> ||
                                            strains_first || corrects_nodes ||
                                            arenite::reads_start_state<Transfer>;
  static constexpr bool needs_edge_mass = (maps_back || corrects_nodes) && Shape::constant_gradient;
  /// Whether the stresses of bodies with laws L are those at the middle of the step (see `add_half_step`).
  template <class... L>
  static constexpr bool centres_stress = maps_back&& Shape::constant_gradient && !averages_strain &&
                                         !AntiLocking::averages_stress && (is_linear<L> && ...);
  static constexpr bool needs_cell_sums =
      needs_edge_mass || (Shape::constant_gradient && averages_strain) || AntiLocking::averages_stress;
  static constexpr ExtraColumns extra_columns{.affine = Transfer::affine, .dilation = averages_strain};

  static_assert(Transfer::template fits<Shape>, ARENITE_SAYS_TRANSFER_SHAPE);
  static_assert(
      !corrects_nodes ||
          requires(const Transfer t) {
            { t.iterations() } -> std::same_as<int>;
          },
      "transfer: iterations must be int iterations() const, beside iterated(nodes, i)");
  static_assert(!(maps_back && Shape::constant_gradient) || !Transfer::affine,
                ARENITE_SAYS_MUSL_WITHOUT_GRADIENT);
  static_assert(AntiLocking::template fits<Shape>, ARENITE_SAYS_AVERAGES_SHAPE);

  /// Largest stable step of the composition in D dimensions, in cell sizes over the wave speed: see
  /// `stable_step`.
  ///
  /// Grid velocities v and displacements u of points that stay in their cells follow, with the lumped mass,
  /// the stiffness K / m and the map S / m of velocities to points and back (symmetric, 0 <= S <= m): USL
  /// u' = u + v - K u, v' = v - S K u (FLIP) or v' = S (v - K u) (PIC, APIC), in units of the step. Taken
  /// along an eigenvector these are quadratic equations with s in [0, 1] for S, and stable for all s if
  /// omega^2 dt^2 <= 2; MUSL, USF, and TPIC with S = m, if <= 4. On splines omega^2 <= 6 D M / rho / h^2 for
  /// any points, filled or few: a point adds V (C : grad u)^2 to K u^2 and m sum w u^2 to the mass, sum
  /// (w')^2 / w along each axis is at most 6 / h^2 (quadratic ones, at a cell's face; in general the shape's
  /// `steepness`), and the stiffest strain, the volumetric one, at most D M. Where light nodes set the limit
  /// it is measured (docs/decisions.md).
  template <int D>
  static double courant_limit() {
    if constexpr (has_light_nodes<Shape>)
      return Shape::courant_limit(strains_by_points);
    else
      return std::sqrt((strains_by_points ? 4.0 : 2.0) / (Shape::steepness * D));
  }

  /// The numerics of a step dt, s: a transfer may depend on it.
  Numerics in_step([[maybe_unused]] double dt) const {
    static_assert(
        !names_in_step<Transfer> ||
            requires(const Transfer t) {
              { t.in_step(0.0) } -> std::same_as<Transfer>;
            },
        "transfer: in_step must be Transfer in_step(double dt) const");
    Numerics of_step = *this;
    if constexpr (names_in_step<Transfer>) of_step.transfer = transfer.in_step(dt);
    return of_step;
  }

  Transfer transfer{};
  AntiLocking anti_locking{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
