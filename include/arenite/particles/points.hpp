// Points: the material points of one body as columns. Only what the composition needs is stored.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/law/law.hpp>
#include <arenite/mesh/blocks.hpp>
#include <arenite/parallel/parallel.hpp>
#include <arenite/particles/cell_list.hpp>
#include <arenite/particles/columns.hpp>
#include <arenite/particles/material_point.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Columns that not every composition needs.
struct ExtraColumns {
  bool affine = false;    ///< a point carries a velocity field (APIC, TPIC)
  bool dilation = false;  ///< a strain average needs the dilation, where the law has one
  bool ids = false;       ///< points have ids (`PointIds`)
  int part_columns = 0;   ///< numbers that parts keep with each point
};

/// The components of a quantity, a column each.
enum class Components { scalar, vector, symmetric, matrix, named, numbered };

/// Name of column k of a quantity of points in D dimensions: "mass", "position/x", "stress/xx", "history/NAME"
/// by `names` where one is there once, else "history/0".
inline std::string column_name(int D, Components components, std::string_view quantity, std::size_t k,
                               std::span<const std::string_view> names) {
  constexpr std::array<std::string_view, 6> pairs{"xx", "yy", "zz", "xy", "yz", "xz"};
  constexpr std::string_view axes = "xyz";
  const auto d = static_cast<std::size_t>(D);
  switch (components) {
    case Components::scalar:
      return std::string(quantity);
    case Components::vector:
      return joined_text({quantity, "/", axes[k]});
    case Components::symmetric:
      return joined_text({quantity, "/", pairs[k]});
    case Components::matrix:
      return joined_text({quantity, "/", axes[k % d], axes[k / d]});
    case Components::named:
      if (!names[k].empty() && std::count(names.begin(), names.end(), names[k]) == 1)
        return joined_text({quantity, "/", names[k]});
      break;
    case Components::numbered:
      break;
  }
  return joined_text({quantity, "/", k});
}

/// Columns of material points: law L gives the history, `Extra` what else the composition needs. Mass and
/// volume are those of the matter that the point represents: a metre of thickness in plane strain, the full
/// circle in axisymmetry. The order of the points changes as they move from cell to cell.
template <real_scalar T, int D, class L, ExtraColumns Extra = ExtraColumns{}>
class Points {
 public:
  using scalar = T;
  static constexpr int dimension = D;
  using History = typename L::template History<T>;
  static constexpr auto part_column_count = static_cast<std::size_t>(Extra.part_columns);
  using Point = MaterialPoint<T, D, History, part_column_count>;
  static constexpr std::size_t history_size = arenite::history_size<History>;
  static constexpr bool affine = Extra.affine, has_ids = Extra.ids;
  static constexpr bool has_dilation = [] {
    if constexpr (Extra.dilation) return dilates<L, T, D>;
    return false;
  }();

  VectorColumns<T, D> position;  ///< m
  VectorColumns<T, D> velocity;  ///< m/s
  Column<T> mass;                ///< kg
  Column<T> volume;              ///< volume that carries stress, m3: opened voids do not count
  TensorColumns<T, D> stress;    ///< Cauchy stress, Pa, tension positive
  std::array<Column<T>, history_size>
      history;                            ///< columns of the law's history, in the order of its `members()`
  MatrixColumns<T, D> velocity_gradient;  ///< [n if affine] velocity gradient of APIC or TPIC, 1/s
  Column<T> dilation;  ///< [n if has_dilation] plastic volumetric strain of the last step, -
  std::array<Column<T>, part_column_count>
      part_columns;               ///< numbers that parts keep with each point (`point_columns`)
  std::vector<std::uint64_t> id;  ///< [n if has_ids]
  std::vector<Index> cell;        ///< cell that contains the point

  std::size_t size() const { return mass.size(); }

  void push_back(const Vec<T, D>& x, const Vec<T, D>& v, T m, T vol, const Sym<T, D>& s, Index c) {
    const std::size_t p = size();
    for_each_column([](auto& column) { add_zero(column); });
    position.set(p, x);
    velocity.set(p, v);
    mass[p] = m;
    volume[p] = vol;
    stress.set(p, s);
    store_history(p, History{});
    if constexpr (has_ids) id[p] = no_id;
    cell[p] = c;
  }
  void push_back(const Point& point, Index c) {
    push_back(point.position, point.velocity, point.mass, point.volume, point.stress, c);
    const std::size_t p = size() - 1;
    store_history(p, point.history);
    if constexpr (affine) velocity_gradient.set(p, point.velocity_gradient);
    if constexpr (has_dilation) dilation[p] = point.dilation;
    for (std::size_t k = 0; k < part_column_count; ++k) part_columns[k][p] = point.part_columns[k];
    if constexpr (has_ids) id[p] = point.id;
  }

  /// Point p as a value.
  Point operator[](std::size_t p) const {
    Point point{position[p], velocity[p], volume[p], mass[p], stress[p], load_history(p)};
    if constexpr (affine) point.velocity_gradient = velocity_gradient[p];
    if constexpr (has_dilation) point.dilation = dilation[p];
    for (std::size_t k = 0; k < part_column_count; ++k) point.part_columns[k] = part_columns[k][p];
    if constexpr (has_ids) point.id = id[p];
    return point;
  }

  /// History of point p as the law's struct.
  History load_history(std::size_t p) const {
    History h{};
    std::apply(
        [&](auto&... value) {
          std::size_t k = 0;
          ((value = history[k++][p]), ...);
        },
        h.members());
    return h;
  }

  /// Histories of `count` neighbours from point p on, as packs; lanes after them repeat point p.
  template <class P>
  typename L::template History<P> load_history(std::size_t p, int count) const {
    typename L::template History<P> h{};
    std::apply(
        [&](auto&... value) {
          [[maybe_unused]] std::size_t k = 0;
          ((value = load_lanes<P>(history[k].data() + p, count, history[k][p]), ++k), ...);
        },
        h.members());
    return h;
  }

  void store_history(std::size_t p, const History& h) {
    std::apply(
        [&](const auto&... value) {
          std::size_t k = 0;
          ((history[k++][p] = value), ...);
        },
        h.members());
  }

  /// Calls `f(column)` for each stored column, a `Column` or (ids and cells) a `std::vector`.
  template <class F>
  void for_each_column(F&& f) {
    visit(*this, [&](Components, const char*, std::size_t, auto& column) { f(column); });
  }
  template <class F>
  void for_each_column(F&& f) const {
    visit(*this, [&](Components, const char*, std::size_t, const auto& column) { f(column); });
  }

  /// Calls `f(name, column)` for each stored column: "mass", "stress/xx", "history/shear_rate" or, if the
  /// law's history does not name it, "history/0".
  template <class F>
  void visit_state(F&& f) {
    visit(*this, [&](Components components, const char* quantity, std::size_t k, auto& column) {
      f(column_name(D, components, quantity, k, history_names<History>), column);
    });
  }

  /// Prefetches the columns of a point.
  void prefetch(Index p) const {
    for_each_column([&](const auto& column) { __builtin_prefetch(column.data() + p); });
  }

  /// Exchanges two points.
  void swap(Index a, Index b) {
    for_each_column([&](auto& column) { std::swap(column[a], column[b]); });
  }

  /// Copies the columns (but `cell`) into new memory, the points of each cell by the thread that works on it
  /// in loops over `blocks`: on a NUMA machine they then lie in that thread's memory (first touch). There
  /// must be no unsorted points.
  void place_by_thread(const CellList& cells, const Blocks& blocks) {
    for_each_column([&](auto& column) {
      if constexpr (std::same_as<std::remove_cvref_t<decltype(column)>, Column<T>>) {
        Column<T> next(column.size());
        blocks.for_each_block([&](std::size_t, Index begin, Index end) {
          std::copy(column.data() + cells.offset(begin), column.data() + cells.offset(end),
                    next.data() + cells.offset(begin));
        });
        column.swap(next);
      }
    });
  }

  /// Takes the memory for `more` points, so that to add them cannot fail halfway.
  void reserve_more(std::size_t more) {
    for_each_column([&](auto& column) {
      if (column.capacity() < size() + more)
        column.reserve(std::max(size() + more, column.capacity() + column.capacity() / 2));
    });
  }

  /// Takes the memory that `reorder` needs, so that a step does not.
  void reserve_spare() {
    spare_.reserve(size());
    spare_cell_.reserve(size());
    if constexpr (has_ids) spare_id_.reserve(size());
  }

  /// Puts the points into the order `order`: new point k was point order[k]. Points not named are dropped.
  void reorder(const std::vector<Index>& order) {
    for_each_column([&](auto& column) {
      auto& next = spare(column);
      next.resize(order.size());
      parallel_chunks(order.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) next[k] = column[order[k]];
      });
      column.swap(next);
    });
  }

  /// Bytes of columns a point.
  static constexpr std::size_t bytes_per_point() {
    return (2 * D + 2 + Sym<T, D>::size + history_size + (affine ? D * D : 0) + has_dilation +
            part_column_count) *
               sizeof(T) +
           sizeof(Index) + has_ids * sizeof(std::uint64_t);
  }

 private:
  template <class C>
  [[gnu::noinline]] static void add_zero(C& column) {
    column.push_back(0);
  }
  /// The table of the columns, in their order in files.
  template <class Self, class F>
  [[gnu::always_inline]] static void visit(Self& self, const F& f) {
    const auto all = [&](Components components, const char* quantity, auto& columns, std::size_t count) {
      for (std::size_t k = 0; k < count; ++k) f(components, quantity, k, columns.column(k));
    };
    using enum Components;
    all(vector, "position", self.position, D);
    all(vector, "velocity", self.velocity, D);
    f(scalar, "mass", 0, self.mass);
    f(scalar, "volume", 0, self.volume);
    all(symmetric, "stress", self.stress, Sym<T, D>::size);
    for (std::size_t k = 0; k < history_size; ++k) f(named, "history", k, self.history[k]);
    if constexpr (affine) all(matrix, "velocity_gradient", self.velocity_gradient, D * D);
    if constexpr (has_dilation) f(scalar, "dilation", 0, self.dilation);
    for (std::size_t k = 0; k < part_column_count; ++k) f(numbered, "part_columns", k, self.part_columns[k]);
    if constexpr (has_ids) f(scalar, "id", 0, self.id);
    f(scalar, "cell", 0, self.cell);
  }

  Column<T>& spare(const Column<T>&) { return spare_; }
  std::vector<Index>& spare(const std::vector<Index>&) { return spare_cell_; }
  std::vector<std::uint64_t>& spare(const std::vector<std::uint64_t>&) { return spare_id_; }

  Column<T> spare_;  // takes the next order of a column, then changes places with it
  std::vector<Index> spare_cell_;
  std::vector<std::uint64_t> spare_id_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
