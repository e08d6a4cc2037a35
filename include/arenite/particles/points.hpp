// Points: the material points of one body as columns. Only what the composition needs is stored.
#pragma once

#include <tuple>
#include <vector>

#include <arenite/law/law.hpp>

namespace arenite {

/// Columns of material points: law L gives the history, `Affine` whether a point carries a velocity field
/// (APIC, TPIC). Mass and volume are those of what the point stands for: a metre of thickness in plane
/// strain, the full circle in axisymmetry.
template <real T, int D, class L, bool Affine>
class Points {
 public:
  using History = typename L::template History<T>;
  static constexpr std::size_t history_size = std::tuple_size_v<decltype(std::declval<History&>().members())>;
  static constexpr bool affine = Affine;

  std::vector<Vec<T, D>> position;  ///< m
  std::vector<Vec<T, D>> velocity;  ///< m/s
  std::vector<T> mass;              ///< kg
  std::vector<T> volume;            ///< volume that bears stress, m3: opened voids do not count
  std::vector<Sym<T, D>> stress;    ///< Cauchy stress, Pa, tension positive
  std::array<std::vector<T>, history_size>
      history;                    ///< columns of the law's history, in the order of its `members()`
  std::vector<Mat<T, D>> motion;  ///< [n if Affine] B of APIC (m2/s) or L of TPIC (1/s)
  std::vector<Index> cell;        ///< cell that holds the point

  std::size_t size() const { return mass.size(); }

  void push_back(const Vec<T, D>& x, const Vec<T, D>& v, T m, T vol, const Sym<T, D>& s, Index c) {
    position.push_back(x);
    velocity.push_back(v);
    mass.push_back(m);
    volume.push_back(vol);
    stress.push_back(s);
    History start{};
    std::apply(
        [&](auto&... value) {
          std::size_t k = 0;
          (history[k++].push_back(value), ...);
        },
        start.members());
    if constexpr (Affine) motion.push_back(Mat<T, D>::Zero());
    cell.push_back(c);
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

  void store_history(std::size_t p, const History& h) {
    std::apply(
        [&](const auto&... value) {
          std::size_t k = 0;
          ((history[k++][p] = value), ...);
        },
        h.members());
  }

  /// Calls `f(column)` for each stored column.
  template <class F>
  void for_each_column(F&& f) {
    visit(*this, f);
  }
  template <class F>
  void for_each_column(F&& f) const {
    visit(*this, f);
  }

  /// Puts the points into the order `order`: new point k was point order[k]. Points not named are dropped.
  void reorder(const std::vector<Index>& order) {
    for_each_column([&](auto& column) {
      std::remove_reference_t<decltype(column)> next(order.size());
      for (std::size_t k = 0; k < order.size(); ++k) next[k] = column[order[k]];
      column = std::move(next);
    });
  }

  /// Bytes of columns a point.
  static constexpr std::size_t bytes_per_point() {
    return 2 * sizeof(Vec<T, D>) + (2 + history_size) * sizeof(T) + sizeof(Sym<T, D>) +
           (Affine ? sizeof(Mat<T, D>) : 0) + sizeof(Index);
  }

 private:
  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f(self.position);
    f(self.velocity);
    f(self.mass);
    f(self.volume);
    f(self.stress);
    for (auto& column : self.history) f(column);
    if constexpr (Affine) f(self.motion);
    f(self.cell);
  }
};

}  // namespace arenite
