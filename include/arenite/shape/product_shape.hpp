// Shape functions on a grid that are products along the axes: what they share. Those of one cell
// along one axis (a line) define them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Nodes of all axes: an axis of n cells has n + N - 1 nodes, of which cell c carries the N from number c on:
/// those of all points of a cell, so that packs of points share them. `Line<T>`: the functions of one cell
/// along an axis. Lengths in cell edges, s from 0 to 1 through the cell:
/// - `nodes`: N;
/// - `steepness`: the largest sum of slope^2 / value over a cell, away from the grid's faces, from which the
///   stable step follows; infinity where functions fall to zero with a slope that does not: their light nodes
///   exchange momentum (`LightNodes`), and `Shape::courant_limit` says what was measured;
/// - `least_beside_face`: share of a face node's mass that the node beside it needs for that
///   (`redistribute_at_faces`);
/// - `place(i, cells)`: of node i along an axis, where linear fields are reproduced; nodes on the faces at 0
///   and at `cells`, and perhaps some beyond;
/// - on a `RectilinearGrid` also `place(i, knots)`, m, and `Line(cell, knots)`, where `knots(i, j)` is the
///   place of line i + j of the grid, m, that of the face beyond it;
/// - `Line(cell, cells)`; `values(s)` [N] and `slopes(s, scale)` [N], the derivatives times a scale, for s a
///   scalar or a pack;
/// - `inverse_inertia()`: 1 / sum w (x_i - x)^2 if that is the same everywhere in the cell, else 0;
/// - `cells_at_face` (optional): on equal cells the functions are the same in all cells but this many at each face,
///   and the middle one is nowhere small there; then `place` and the constructor are `constexpr`.
///
/// In each cell the values add up to 1, and times the places of their nodes to s; the slopes add up to 0.
template <template <class> class Line>
struct ProductShape {
  static constexpr bool constant_gradient = false;
  static constexpr std::size_t nodes_per_axis = Line<double>::nodes;
  static constexpr double steepness = Line<double>::steepness;
  /// A node beside a face is light below this share of the mass of the node on the face: `redistribute_at_faces`.
  static constexpr double least_beside_face = Line<double>::least_beside_face;
  /// Layers of cells that share nodes with a cell, on either side.
  static constexpr Index halo = static_cast<Index>(nodes_per_axis) - 1;

  template <class M>
  static constexpr bool fits = [] {
    if constexpr (is_rectilinear<M>)
      return std::is_constructible_v<Line<typename M::scalar>, Index, typename M::Knots>;
    else
      return !is_simplex_mesh<M>;
  }();

  /// Nodes along an axis. A periodic one has as many as cells: cell c carries those from number c on, round
  /// the axis.
  template <class M>
  static Index node_count(const M& grid, int axis) {
    return is_periodic<M>(axis) ? grid.cells(axis) : grid.cells(axis) + halo;
  }
  template <class M>
  static Index node_count(const M& grid) {
    Index n = 1;
    for (int k = 0; k < M::dimension; ++k) {
      require(!is_periodic<M>(k) || grid.cells(k) > halo, "periodic: cells", grid.cells(k),
              {"must be at least ", halo + 1, " along a periodic axis"});
      n *= node_count(grid, k);
    }
    return n;
  }

  template <class M>
  static typename M::Point node_position(const M& grid, Index node) {
    typename M::Point x;
    for (int k = 0; k < M::dimension; ++k) {
      const Index nodes_on_axis = node_count(grid, k);
      x[k] = grid.lower()[k] + place(grid, k, first_cell(grid, k) + node % nodes_on_axis);
      node /= nodes_on_axis;
    }
    if constexpr (is_periodic<M>()) return grid.wrapped(x);
    return x;
  }

  /// Place of the node of number i along an axis of the whole grid, from its lower corner, m; on a periodic one
  /// without wrapping: node n lies one period after node 0.
  template <class M>
  static auto place(const M& grid, int axis, Index i) {
    using T = typename M::scalar;
    const Index cells = whole_cells(grid, axis);
    if constexpr (is_rectilinear<M>)
      return Line<T>::place(i, grid.knots(axis)) - grid.lower()[axis];
    else if (is_periodic<M>(axis))
      return grid.edge() * (Line<T>::place(i + halo, cells + 2 * halo) - static_cast<T>(halo));
    else
      return grid.edge() * Line<T>::place(i, cells);
  }

  /// Calls `f(j)` for the nodes j != i of each cell at node i: once for each cell that they share.
  template <class M, class F>
  static void for_each_neighbour(const M& grid, Index i, F&& f) {
    constexpr int D = M::dimension;
    std::array<Index, D> from, to, cell;
    Index rest = i;
    for (int k = 0; k < D; ++k) {
      const auto a = static_cast<std::size_t>(k);
      const Index nodes_on_axis = node_count(grid, k), at = rest % nodes_on_axis;
      rest /= nodes_on_axis;
      from[a] = is_periodic<M>(k) ? at + grid.cells(k) - halo : at < halo ? 0 : at - halo;
      to[a] = is_periodic<M>(k) ? from[a] + halo + 1 : std::min(at + 1, grid.cells(k));
    }
    cell = from;
    for (std::size_t k = 0; k < D;) {
      Index number = 0;
      for (std::size_t a = D; a-- > 0;) {
        const Index cells = grid.cells(static_cast<int>(a));
        number = number * cells + (is_periodic<M>(static_cast<int>(a)) ? cell[a] % cells : cell[a]);
      }
      for (const Index j : Cell<M>(grid, number).nodes)
        if (j != i) f(j);
      for (k = 0; k < D && ++cell[k] == to[k]; ++k) cell[k] = from[k];
    }
  }

  /// The node on the lower face along an axis of `cells`; the one on the upper face is as far from the end.
  static Index face_node(Index cells) {
    Index i = 0;
    while (Line<double>::place(i, cells) < 0) ++i;
    return i;
  }

  /// Calls `f` with the functions of a cell; those of a cell away from the faces have a separate type, whose
  /// functions the compiler knows.
  template <class M, class F>
  ARENITE_INLINE static auto visit_cell(const M& grid, Index c, F&& f) {
    const auto place = grid.place(c);
    if constexpr (has_inner_cells<M>)
      if (is_inner(grid, place)) return f(Cell<M, true>(grid, place));
    return f(Cell<M>(grid, place));
  }

 private:
  // Edges of a cell along each axis, m, or their inverses, 1/m: one number where they are all the same.
  template <class M, bool Inverse>
  struct Edges {
    using T = typename M::scalar;
    static constexpr std::size_t count = is_rectilinear<M> ? static_cast<std::size_t>(M::dimension) : 1;
    std::array<T, count> value;
    Edges(const M& grid, const std::array<Index, M::dimension>& place) {
      if constexpr (is_rectilinear<M>)
        for (std::size_t k = 0; k < count; ++k) {
          const auto axis = static_cast<int>(k);
          const T edge = grid.line(axis, place[k] + 1) - grid.line(axis, place[k]);
          value[k] = Inverse ? 1 / edge : edge;
        }
      else
        value[0] = Inverse ? grid.inverse_edge() : grid.edge();
    }
    T operator[](std::size_t k) const { return value[count == 1 ? 0 : k]; }
  };

 public:
  /// The functions of one cell: made once a cell, evaluated for each of its points. `Inner`: of one away from the faces.
  template <class M, bool Inner = false>
  class Cell {
   public:
    using T = typename M::scalar;
    static constexpr bool is_inner = Inner;
    static constexpr int D = M::dimension;
    static constexpr std::size_t nodes_per_axis = ProductShape::nodes_per_axis;
    static constexpr std::size_t plane = nodes_per_axis * nodes_per_axis;
    static constexpr int size = static_cast<int>(D == 2 ? plane : plane * nodes_per_axis);
    using Weights = Vec<T, size>;
    using Gradients = Eigen::Matrix<T, D, size, Eigen::DontAlign>;

    Cell(const M& grid, Index cell) : Cell(grid, grid.place(cell)) {}
    Cell(const M& grid, const std::array<Index, D>& place)
        : Cell(grid, place, std::make_index_sequence<D>{}) {}

    /// [N^D] values at x.
    Weights weights(const Vec<T, D>& x) const {
      const auto product = products(line_values(as_array(x)));
      Weights w;
      for (std::size_t i = 0; i < size; ++i) w[static_cast<int>(i)] = product[i];
      return w;
    }

    /// [D x N^D] gradients at x, 1/m.
    Gradients gradients(const Vec<T, D>& x) const {
      const auto value = line_values(as_array(x)), slope = line_slopes(as_array(x));
      Gradients g;
      for (std::size_t k = 0; k < D; ++k) {
        auto factor = value;
        factor[k] = slope[k];
        const auto product = products(factor);
        for (std::size_t i = 0; i < size; ++i) g(static_cast<int>(k), static_cast<int>(i)) = product[i];
      }
      return g;
    }

    /// [D x N^D] positions of the nodes, m.
    Gradients node_positions() const {
      Gradients x;
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = 0; k < D; ++k)
          x(static_cast<int>(k), static_cast<int>(i)) = lower_[static_cast<int>(k)] + along_[k][digit(i, k)];
      return x;
    }

    /// Functions along each axis, whose products the functions of the cell are, at positions x of a pack of
    /// points (or of one): values [D][N], slopes [D][N] in 1/m.
    template <class P>
    std::array<std::array<P, nodes_per_axis>, D> line_values(const std::array<P, D>& x) const {
      std::array<std::array<P, nodes_per_axis>, D> value;
      repeat<D>([&](std::size_t k) { value[k] = line(k).values(local(k, x)); });
      return value;
    }
    template <class P>
    std::array<std::array<P, nodes_per_axis>, D> line_slopes(const std::array<P, D>& x) const {
      std::array<std::array<P, nodes_per_axis>, D> slope;
      repeat<D>([&](std::size_t k) { slope[k] = line(k).slopes(local(k, x), per_metre_[k]); });
      return slope;
    }

    /// [D][N] offsets along each axis from positions x to the nodes, m.
    template <class P>
    std::array<std::array<P, nodes_per_axis>, D> offsets(const std::array<P, D>& x) const {
      std::array<std::array<P, nodes_per_axis>, D> offset;
      for (std::size_t k = 0; k < D; ++k)
        for (std::size_t i = 0; i < nodes_per_axis; ++i)
          offset[k][i] = P(along_[k][i]) - (x[k] - P(lower_[static_cast<int>(k)]));
      return offset;
    }

    /// 1 / sum w (x_i - x)^2 along each axis, 1/m2: the inverse inertia of APIC, which is diagonal for
    /// products that reproduce linear fields. Where it vanishes (at a face; for linear functions at any node)
    /// there is no motion about the point along that axis: 0 there.
    template <class P>
    std::array<P, D> inverse_inertia(const std::array<P, D>& x) const {
      std::array<P, D> inverse;
      for (std::size_t k = 0; k < D; ++k) {
        if (const T even = line(k).inverse_inertia(); even > 0) {
          inverse[k] = P(even * per_metre_[k] * per_metre_[k]);
          continue;
        }
        const P offset = x[k] - P(lower_[static_cast<int>(k)]);
        const auto w = line(k).values(local(k, x));
        P inertia(0);
        for (std::size_t i = 0; i < nodes_per_axis; ++i)
          inertia += w[i] * square(P(P(along_[k][i]) - offset));
        const auto some = inertia > P(std::numeric_limits<T>::epsilon() * edge_[k] * edge_[k]);
        inverse[k] = select(some, P(P(1) / select(some, inertia, P(1))), P(0));
      }
      return inverse;
    }

    /// Whether the slopes of this cell are values times `offsets` times `inverse_inertia`: a kernel that sums these has the gradient, too.
    bool has_moments_for_slopes() const requires requires { Line<T>::slopes_are_moments; }
    {
      bool all = true;
      for (std::size_t k = 0; k < D; ++k) all = all && line(k).inverse_inertia() > 0;
      return all;
    }

    std::array<Index, size> nodes;

   private:
    template <std::size_t... K>
    Cell(const M& grid, const std::array<Index, D>& place, std::index_sequence<K...>)
        : lower_{grid.lower()},
          corner_{lower_},
          edge_(grid, place),
          per_metre_(grid, place),
          line_{line_of(grid, static_cast<int>(K), place[K])...} {
      std::array<std::array<Index, nodes_per_axis>, D>
          number;  // of the nodes along each axis, times its stride
      Index stride = 1;
      for (std::size_t k = 0; k < D; ++k) {
        const auto axis = static_cast<int>(k);
        const Index count = node_count(grid, axis);
        corner_[axis] = corner_of(grid, axis, place[k]);
        for (std::size_t i = 0; i < nodes_per_axis; ++i) {
          const Index at = place[k] + static_cast<Index>(i);
          if constexpr (Inner)
            along_[k][i] = grid.edge() * (static_cast<T>(place[k]) + inner_place(i));
          else
            along_[k][i] = ProductShape::place(grid, axis, at);
          number[k][i] =
              stride * ((is_periodic<M>(axis) && at >= count ? at - count : at) - first_cell(grid, axis));
        }
        stride *= count;
      }
      repeat<size>([&](std::size_t i) {
        nodes[i] = 0;
        repeat<D>([&](std::size_t k) { nodes[i] += number[k][digit(i, k)]; });
      });
    }

    static Line<T> line_of(const M& grid, int axis, Index at) {
      if constexpr (is_rectilinear<M>)
        return Line<T>(at, grid.knots(axis));
      else if (is_periodic<M>(axis))  // as in the middle of a longer axis
        return Line<T>(at + halo, grid.cells(axis) + 2 * halo);
      else
        return Line<T>(at, whole_cells(grid, axis));
    }
    const Line<T>& line(std::size_t k) const {
      if constexpr (Inner)
        return inner_line<T>;
      else
        return line_[k];
    }
    // Of a node of an inner cell from the cell's lower end, in cell edges.
    static constexpr T inner_place(std::size_t i) {
      constexpr Index at_face = Line<T>::cells_at_face;
      return Line<T>::place(at_face + static_cast<Index>(i), 2 * at_face + 1) - static_cast<T>(at_face);
    }
    T corner_of(const M& grid, int axis, Index at) const {
      if constexpr (is_rectilinear<M>)
        return grid.line(axis, at);
      else
        return lower_[axis] + edge_[0] * static_cast<T>(at);
    }

    static constexpr std::size_t digit(std::size_t i, std::size_t k) {
      return (k == 0 ? i : k == 1 ? i / nodes_per_axis : i / plane) % nodes_per_axis;
    }

    static std::array<T, D> as_array(const Vec<T, D>& x) {
      std::array<T, D> a;
      for (std::size_t k = 0; k < D; ++k) a[k] = x[static_cast<int>(k)];
      return a;
    }

    // Place along axis k in the cell, 0 to 1.
    template <class P>
    P local(std::size_t k, const std::array<P, D>& x) const {
      return (x[k] - P(corner_[static_cast<int>(k)])) * P(per_metre_[k]);
    }

    static std::array<T, size> products(const std::array<std::array<T, nodes_per_axis>, D>& f) {
      std::array<T, size> p;
      for (std::size_t j = 0; j < size / nodes_per_axis; ++j) {
        T rest = f[1][j % nodes_per_axis];
        if constexpr (D == 3) rest = rest * f[2][j / nodes_per_axis];
        for (std::size_t i = 0; i < nodes_per_axis; ++i) p[nodes_per_axis * j + i] = f[0][i] * rest;
      }
      return p;
    }

    Vec<T, D> lower_, corner_;
    Edges<M, false> edge_;
    Edges<M, true> per_metre_;
    [[no_unique_address]] std::conditional_t<Inner, Nothing, std::array<Line<T>, D>> line_;
    std::array<std::array<T, nodes_per_axis>, D> along_;  // of the nodes from the grid's lower corner, m
  };

 private:
  template <class M>
  static constexpr bool has_inner_cells = !is_rectilinear<M> && requires {
    Line<double>::cells_at_face;
  };
  template <class M>
  static bool is_inner(const M& grid, const std::array<Index, M::dimension>& place) {
    constexpr Index at_face = Line<double>::cells_at_face;
    bool inner = true;
    for (int k = 0; k < M::dimension; ++k) {
      const Index at = place[static_cast<std::size_t>(k)];
      inner = inner && (is_periodic<M>(k) || (at >= at_face && at + at_face < whole_cells(grid, k)));
    }
    return inner;
  }
  template <class T>
  static constexpr Line<T> inner_line{Line<T>::cells_at_face, 2 * Line<T>::cells_at_face + 1};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
