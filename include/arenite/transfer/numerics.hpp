// Numerics: how a scene is discretised, as one value: shape function, transfer, order of the stress update,
// anti-locking.
#pragma once

#include <cstddef>

#include <arenite/particles/points.hpp>
#include <arenite/stabilise/anti_locking.hpp>
#include <arenite/transfer/transfer.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Bytes of the widest register that this translation unit is compiled for. A constant of internal linkage,
/// used as a template argument: units compiled with other flags make other types and never meet in one
/// function.
constexpr std::size_t native_register_bytes =
#if defined(__AVX512F__)
    64;
#elif defined(__AVX__)
    32;
#else
    16;
#endif

/// `RegisterBytes`: size of the packs in which points are computed; sizeof(T) for plain scalars.
template <class Shape_, class Transfer_ = Flip, class Order_ = Musl, class AntiLocking_ = NoAntiLocking,
          std::size_t RegisterBytes = native_register_bytes>
struct Numerics {
  static constexpr std::size_t register_bytes = RegisterBytes;
  /// Points computed at once in scalar T.
  template <class T>
  static constexpr int width = static_cast<int>(RegisterBytes / sizeof(T));
  using Shape = Shape_;
  using Transfer = Transfer_;
  using Order = Order_;
  using AntiLocking = AntiLocking_;
  /// Whether strains are taken from velocities that were mapped back to the nodes. What TPIC takes from the
  /// nodes of a linear simplex it would hand back to each unchanged: there MUSL is USL.
  static constexpr bool remaps = Order::remaps && !(Shape::constant_gradient && Transfer::affine);
  /// Whether the points take their velocities where they are mapped back, in a pass before that of the
  /// strains; linear simplices need no such pass (see `remap`).
  static constexpr bool remaps_by_points = remaps && !Shape::constant_gradient;
  static constexpr bool needs_edge_mass = remaps && Shape::constant_gradient;
  static constexpr bool needs_cell_sums =
      needs_edge_mass || AntiLocking::averages_strain || AntiLocking::averages_stress;
  static constexpr ExtraColumns extra_columns{.affine = Transfer::affine,
                                              .dilation = AntiLocking::averages_strain};

  static_assert(Transfer::template fits<Shape>,
                "Numerics: APIC needs B-splines (its inertia tensor is singular at a node of a linear "
                "simplex: use Tpic there); "
                "Tpic needs linear simplices (use Apic on B-splines)");
  static_assert(
      AntiLocking::template fits<Shape>,
      "Numerics: NodalAveraging and ElementAverage work on linear simplices; on B-splines use NoAntiLocking");

  Transfer transfer{};
  AntiLocking anti_locking{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
