// Columns: vectors or tensors of many points, component by component, so that a pack reads neighbouring
// points with one load.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <vector>

#include <arenite/core/tensor.hpp>
#include <arenite/parallel/array_memory.hpp>
#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One scalar for each point.
template <class T>
using Column = std::vector<T, ArrayMemory<T>>;

/// Prefetches the entries of a column that a loop over packs of `Width` points needs eight packs after point
/// p: such loops have little arithmetic and would otherwise wait for memory. Narrow packs do not prefetch, as
/// one cache line serves many of them.
template <int Width, class T>
void prefetch_ahead(const Column<T>& column, std::size_t p) {
  if constexpr (Width * sizeof(T) >= 32) __builtin_prefetch(column.data() + p + 8 * Width);
}

/// n values of type Value, each of N components of scalar T, stored as N columns. Reading one gives a copy;
/// `set` writes one.
template <class Value, class T, std::size_t N>
class Columns {
 public:
  using value_type = Value;

  std::size_t size() const { return column_[0].size(); }

  const Value operator[](std::size_t p) const {
    Value value;
    for (std::size_t k = 0; k < N; ++k) at(value, k) = column_[k][p];
    return value;
  }
  void set(std::size_t p, const Value& value) {
    for (std::size_t k = 0; k < N; ++k) column_[k][p] = at(value, k);
  }
  /// Sets all to one value.
  void fill(const Value& value) {
    for (std::size_t p = 0; p < size(); ++p) set(p, value);
  }
  void push_back(const Value& value) {
    for (std::size_t k = 0; k < N; ++k) column_[k].push_back(at(value, k));
  }

  /// Component k of all points.
  Column<T>& column(std::size_t k) { return column_[k]; }
  const Column<T>& column(std::size_t k) const { return column_[k]; }

  /// Component by component, `count` neighbours from point p on as packs P (or as one scalar); lanes after
  /// them are 0.
  template <class P>
  std::array<P, N> load(std::size_t p, int count) const {
    std::array<P, N> value;
    for (std::size_t k = 0; k < N; ++k) value[k] = load_lanes<P>(column_[k].data() + p, count);
    return value;
  }
  /// Loads a pack; lanes beyond the last point repeat point p: for what must be a sensible position.
  template <class P>
  std::array<P, N> load_repeated(std::size_t p, int count) const {
    std::array<P, N> value;
    for (std::size_t k = 0; k < N; ++k) value[k] = load_lanes<P>(column_[k].data() + p, count, column_[k][p]);
    return value;
  }
  /// `prefetch_ahead` of each component.
  template <int Width>
  void prefetch_ahead(std::size_t p) const {
    for (const auto& column : column_) arenite::prefetch_ahead<Width>(column, p);
  }
  template <class P>
  void store(std::size_t p, int count, const std::array<P, N>& value) {
    for (std::size_t k = 0; k < N; ++k) store_lanes(column_[k].data() + p, count, value[k]);
  }

  /// Values in order, for `for (const auto& x : points.position)`.
  class Iterator {
   public:
    using difference_type = std::ptrdiff_t;
    using value_type = Value;
    Iterator() = default;
    Iterator(const Columns& columns, std::size_t p) : columns_{&columns}, p_{p} {}
    Value operator*() const { return (*columns_)[p_]; }
    Iterator& operator++() {
      ++p_;
      return *this;
    }
    Iterator operator++(int) {
      Iterator old = *this;
      ++p_;
      return old;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.p_ == b.p_; }

   private:
    const Columns* columns_ = nullptr;
    std::size_t p_ = 0;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

  friend bool operator==(const Columns& a, const Columns& b) { return a.column_ == b.column_; }

 private:
  /// Component k of a vector or matrix of Eigen's, or of a tensor.
  template <class V>
  static auto& at(V& value, std::size_t k) {
    if constexpr (requires { V::RowsAtCompileTime; })
      return value.coeffRef(static_cast<Eigen::Index>(k));
    else
      return value[k];
  }

  std::array<Column<T>, N> column_;
};

/// Columns of vectors [D], matrices [D x D] (column by column) and symmetric tensors (components of `Sym`).
template <class T, int D>
using VectorColumns = Columns<Vec<T, D>, T, static_cast<std::size_t>(D)>;
template <class T, int D>
using MatrixColumns = Columns<Mat<T, D>, T, static_cast<std::size_t>(D* D)>;
template <class T, int D>
using TensorColumns = Columns<Sym<T, D>, T, Sym<T, D>::size>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
