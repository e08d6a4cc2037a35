// Uniform GIMP on a grid: hats averaged over a point's domain, which does not change its size. Gradients no
// longer jump where a point crosses into another cell, at the price of four nodes along each axis.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include <arenite/shape/product_shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The functions of one cell along one axis, in cell edges, of `Points` along it at first, whose domains fill
/// the cell (Bardenhagen and Kober 2004, The generalized interpolation material point method, CMES 5,
/// 477-496): of the nodes one cell before, at its ends, and one cell after. A grid of n cells thus has a
/// node beyond each face. Where a domain would reach across a face of the grid it ends there on both sides of
/// the point: so unity and linear fields are exact up to the faces, and a wall is exactly the nodes on it.
template <int Points>
struct UGimpOf {
  static_assert(Points >= 1, "UGimp: the number of points along each axis of a cell must be at least 1");

  template <class T>
  class Line {
   public:
    static constexpr std::size_t nodes = 4;
    static constexpr double half = 0.5 / Points;  ///< of the domain's width
    /// At s = `half`: the terms of the node before the cell, and of hats.
    static constexpr double steepness = 1 / half + 1 / (half * (1 - half));
    /// Near a face they are hats: the node beside it is light below this share of the mass of the node on it.
    static constexpr double least_beside_face = 0.5;

    static T place(Index i, Index) { return static_cast<T>(i) - 1; }

    Line(Index cell, Index cells)
        : before_{cell == 0 ? T(0) : T(1)}, after_{cell + 1 == cells ? T(0) : T(1)} {}

    /// [4] at s, 0 to 1 through the cell, a number or a pack of them: hats, and what their kinks lose.
    template <class P>
    std::array<P, 4> values(const P& s) const {
      constexpr T share = static_cast<T>(1 / (4 * half));
      const P a = behind(s), b = ahead(s), low = a * a * P(share * before_), high = b * b * P(share * after_);
      return {low, P(1) - s - low - low + high, s + low - high - high, high};
    }
    /// Their derivatives, times a scale.
    template <class P>
    std::array<P, 4> slopes(const P& s, T scale) const {
      constexpr T share = static_cast<T>(1 / (2 * half));
      const P low = behind(s) * P(-share * before_ * scale), high = ahead(s) * P(share * after_ * scale),
              hat(scale);
      return {low, high - low - low - hat, low - high - high + hat, high};
    }
    T inverse_inertia() const { return 0; }  // nowhere the same in a whole cell

   private:
    // How far the domain reaches into the cells before and after.
    template <class P>
    static P behind(const P& s) {
      using std::max;
      return max(P(P(static_cast<T>(half)) - s), P(0));
    }
    template <class P>
    static P ahead(const P& s) {
      using std::max;
      return max(P(s - P(static_cast<T>(1 - half))), P(0));
    }

    T before_, after_;  // 1, or 0 if there is no cell
  };
};

/// Uniform GIMP on a `CartesianGrid` (Bardenhagen and Kober 2004), of bodies with `Points` points along each
/// axis of a cell at first. (Of one point its functions are those of quadratic splines, half a cell away from
/// the faces.)
///
/// Members: see `ProductShape`.
template <int Points = 2>
struct UGimp : ProductShape<UGimpOf<Points>::template Line> {
  static constexpr const char* name = "UGimp";
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
