// A shape function of your own on a grid, written out: uniform GIMP, which the library has as `UGimp`
// (Bardenhagen and Kober 2004, The generalized interpolation material point method, CMES 5, 477-496), hats
// averaged over a point's domain, here half a cell wide. Where a domain would reach across a face of the grid
// it ends there on both sides of the point: then unity and linear fields are exact up to faces, and a wall is
// exactly the nodes on it.
#pragma once

#include <arenite/arenite.hpp>

/// The functions of one cell along one axis, in cell edges (arenite/shape/product_shape.hpp): of the nodes
/// one cell before it, at its ends, and one cell after. A grid of n cells thus has a node beyond each face.
template <class T>
class SmoothHatLine {
 public:
  static constexpr std::size_t nodes = 4;
  // Largest sum of slope^2 / value, at a quarter of a cell: 4 + 4 + 4/3. The stable step follows.
  static constexpr double steepness = 28.0 / 3;
  // Near a face they are hats: the node beside it is light below this share of the mass of the node on it.
  static constexpr double least_beside_face = 0.5;

  static T place(arenite::Index i, arenite::Index) { return static_cast<T>(i) - 1; }

  SmoothHatLine(arenite::Index cell, arenite::Index cells)
      : before_{cell == 0 ? T(0) : T(1)}, after_{cell + 1 == cells ? T(0) : T(1)} {}

  /// [4] at s, 0 to 1 through the cell, a number or a pack of them: hats, and what their kinks lose.
  template <class P>
  std::array<P, 4> values(const P& s) const {
    const P a = behind(s), b = ahead(s), low = a * a * P(before_), high = b * b * P(after_);
    return {low, P(1) - s - low - low + high, s + low - high - high, high};
  }
  /// Their derivatives, times a scale.
  template <class P>
  std::array<P, 4> slopes(const P& s, T scale) const {
    const P low = behind(s) * P(-2 * before_ * scale), high = ahead(s) * P(2 * after_ * scale), hat(scale);
    return {low, high - low - low - hat, low - high - high + hat, high};
  }
  T inverse_inertia() const { return 0; }  // nowhere the same in a whole cell

 private:
  // How far the domain, half a cell wide, reaches into the cells before and after; with it (2 l)^2 = 4 l.
  template <class P>
  static P behind(const P& s) {
    using std::max;
    return max(P(P(0.25) - s), P(0));
  }
  template <class P>
  static P ahead(const P& s) {
    using std::max;
    return max(P(s - P(0.75)), P(0));
  }

  T before_, after_;  // 1, or 0 if there is no cell
};

struct SmoothHat : arenite::ProductShape<SmoothHatLine> {
  static constexpr const char* name = "SmoothHat";
};
