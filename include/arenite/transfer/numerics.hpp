// Numerics: how a scene is discretised, as one value: shape function, transfer, order of the stress update,
// anti-locking.
#pragma once

#include <arenite/stabilise/anti_locking.hpp>
#include <arenite/transfer/transfer.hpp>

namespace arenite {

template <class Shape_, class Transfer_ = Flip, class Order_ = Musl, class AntiLocking_ = NoAntiLocking>
struct Numerics {
  using Shape = Shape_;
  using Transfer = Transfer_;
  using Order = Order_;
  using AntiLocking = AntiLocking_;

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

}  // namespace arenite
