// Node field: what one velocity field of the background mesh stores. A scene has one, or one for each body in
// contact.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include <arenite/core/tensor.hpp>
#include <arenite/parallel/parallel.hpp>
#include <arenite/simd/pack.hpp>
#include <arenite/transfer/node_sums.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A pack of a node's vector: the lanes of `lanes` are its components from `first` on, the others 0.
template <class T, int D, class L>
NodePack<T, D> node_pack(std::size_t first, const L& lanes) {
  std::array<T, 8> all{};
  store_lanes(all.data() + first, lane_count<L>, lanes);
  return NodePack<T, D>::load(all.data());
}

/// Vectors of a cell's nodes as rows of scalars, which packs of points read one by one.
template <class T, int D, std::size_t Size>
struct CellVectors {
  static constexpr std::size_t lanes = static_cast<std::size_t>(NodePack<T, D>::width);
  static constexpr std::size_t dimension = static_cast<std::size_t>(D);
  alignas(lanes * sizeof(T)) std::array<std::array<T, lanes>, Size> row;

  CellVectors() = default;
  template <class Cell, class Vectors>
  CellVectors(const Cell& cell, const Vectors& of_nodes) {
    repeat<Size>([&](std::size_t i) { set(i, of_nodes.pack(cell.nodes[i])); });
  }

  void set(std::size_t i, const NodePack<T, D>& value) { value.store(row[i].data()); }
  NodePack<T, D> pack(std::size_t i) const { return NodePack<T, D>::load(row[i].data()); }
  const std::array<T, lanes>& operator[](std::size_t i) const { return row[i]; }
};

/// The first of two sets of vectors, or the second where a composition has no first.
template <class Rows>
const Rows& value_or(const Rows& own, const Rows&) {
  return own;
}
template <class Rows>
const Rows& value_or(const Nothing&, const Rows& instead) {
  return instead;
}

/// Sums over the nodes for points, and sums of second vectors.
template <class Sums, class Value>
struct TwoSums : Sums {
  Value second;
};
template <class Sums, class Value>
TwoSums(Sums, Value) -> TwoSums<Sums, Value>;

/// A vector for each node, padded to a whole pack, so that one load reads and one store writes it.
template <class T, int D>
class NodeVectors {
  struct Whole {
    Vec<T, D> value;
  };
  struct Padded {
    Vec<T, D> value;
    T spare = 0;  // a number always: what is computed with it is thrown away, but has to cost no more
  };
  using Slot = std::conditional_t<D == 2, Whole, Padded>;
  static_assert(sizeof(Slot) == sizeof(NodePack<T, D>));

 public:
  NodeVectors() = default;
  NodeVectors(std::size_t n, const Vec<T, D>& value) { assign(n, value); }
  NodeVectors(std::initializer_list<Vec<T, D>> values) {
    for (const auto& value : values) slots_.push_back(Slot{value});
  }
  void assign(std::size_t n, const Vec<T, D>& value) { slots_.assign(n, Slot{value}); }

  std::size_t size() const { return slots_.size(); }
  bool empty() const { return slots_.empty(); }
  std::size_t bytes() const { return slots_.size() * sizeof(Slot); }
  Vec<T, D>& operator[](std::size_t i) { return slots_[i].value; }
  const Vec<T, D>& operator[](std::size_t i) const { return slots_[i].value; }

  /// All numbers as they lie in memory, the spare ones among them.
  std::span<T> numbers() { return {reinterpret_cast<T*>(slots_.data()), bytes() / sizeof(T)}; }

  /// The vector of node i as a pack; the value of the spare lane is arbitrary.
  NodePack<T, D> pack(std::size_t i) const { return NodePack<T, D>::load(lanes_of_slot(i)); }
  void set(std::size_t i, const NodePack<T, D>& a) { a.store(lanes_of_slot(i)); }
  void add(std::size_t i, const NodePack<T, D>& a) { set(i, pack(i) + a); }

  template <class S>
  class Iterator {
   public:
    explicit Iterator(S* at) : at_{at} {}
    auto& operator*() const { return at_->value; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    bool operator==(const Iterator& o) const { return at_ == o.at_; }

   private:
    S* at_;
  };
  auto begin() { return Iterator<Slot>(slots_.data()); }
  auto end() { return Iterator<Slot>(slots_.data() + size()); }
  auto begin() const { return Iterator<const Slot>(slots_.data()); }
  auto end() const { return Iterator<const Slot>(slots_.data() + size()); }

  friend bool operator==(const NodeVectors& a, const NodeVectors& b) {
    return a.size() == b.size() &&
           std::equal(a.slots_.begin(), a.slots_.end(), b.slots_.begin(),
                      [](const Slot& s, const Slot& t) { return s.value == t.value; });
  }

 private:
  const T* lanes_of_slot(std::size_t i) const { return reinterpret_cast<const T*>(&slots_[i]); }
  T* lanes_of_slot(std::size_t i) { return reinterpret_cast<T*>(&slots_[i]); }

  std::vector<Slot> slots_;
};

/// Columns over all nodes of the mesh. `Mapped`: a second velocity for the stress update (MUSL); `Gradient`:
/// the gradient of mass, for contact normals. `Corrected`: what a node correction needs. `StartState`: the velocity at
/// the start of the step and the force, apart (`reads_start_state`). What is not asked for is not stored.
template <real_scalar T, int D, bool Mapped, bool Gradient, bool Corrected = false, bool StartState = true>
struct NodeField {
  static constexpr bool has_mass_gradient = Gradient, has_start_state = StartState;
  using Sums = std::conditional_t<StartState, NodeSums<T, D>, NodeMomentum<T, D>>;

  std::vector<Sums> sums;       ///< [nodes] what `p2g` sums and `update_grid` reads
  std::vector<T> mass;          ///< [nodes] kg
  std::vector<Index> massless;  ///< nodes without mass that points or loads touch: see `list_massless`
  [[no_unique_address]] std::conditional_t<StartState, NodeVectors<T, D>, Nothing>
      start;                        ///< [nodes if StartState] velocity at the step's begin, m/s
  NodeVectors<T, D> velocity;       ///< [nodes] velocity at the step's end, m/s
  NodeVectors<T, D> mapped;         ///< [nodes if Mapped] momentum, then velocity for the stress update, m/s
  NodeVectors<T, D> mass_gradient;  ///< [nodes if Gradient] sum of m grad N, kg/m: points out of the body
  NodeVectors<T, D> correction;     ///< [nodes if Corrected] sum of the residuals, m/s
  NodeVectors<T, D> residual;       ///< [nodes if Corrected] of the last iteration, m/s
  NodeVectors<T, D> mapped_residual;  ///< [nodes if Corrected] the residual mapped back, kg m/s
  bool centred;  ///< whether what is mapped is the mean over the step (see `add_half_step`)

  explicit NodeField(Index nodes, bool is_centred = false)
      : sums(nodes),
        mass(nodes, T(0)),
        start(nodes, zeros<Vec<T, D>>()),
        velocity(nodes, zeros<Vec<T, D>>()),
        mapped(Mapped ? nodes : 0, zeros<Vec<T, D>>()),
        mass_gradient(Gradient ? nodes : 0, zeros<Vec<T, D>>()),
        correction(Corrected ? nodes : 0, zeros<Vec<T, D>>()),
        residual(correction),
        mapped_residual(correction),
        centred(is_centred) {}

  std::size_t size() const { return mass.size(); }

  /// Sets to zero what the points add to.
  void clear() {
    [[maybe_unused]] const NodePack<T, D> zero(0);
    parallel_chunks(size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        sums[i] = {};
        if constexpr (Mapped) mapped.set(i, zero);
        if constexpr (Gradient) mass_gradient.set(i, zero);
      }
    });
  }

  /// Velocity from which strains are computed.
  const NodeVectors<T, D>& strain_velocity() const {
    if constexpr (Mapped) return mapped;
    return velocity;
  }
  /// Mean over the step of the velocity of node i, m/s: impulses times it are work. Of the start velocity
  /// and the strain velocity, after that is mapped back and before it is constrained (`after_grid`).
  Vec<T, D> mean_velocity(std::size_t i) const {
    if constexpr (Mapped)
      if (centred) return mapped[i];
    return (start[i] + strain_velocity()[i]) / 2;
  }

  std::size_t bytes() const {
    return size() * (sizeof(Sums) + sizeof(T)) + (StartState ? 2 : 1) * velocity.bytes() + mapped.bytes() +
           mass_gradient.bytes() + correction.bytes() + residual.bytes() + mapped_residual.bytes();
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
