// Node gaps: how far matter has parted from a rigid body at the nodes that the body touches.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstddef>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The gaps of one body, m, by field and node. A node that the body no longer touches has none.
template <class T>
class NodeGaps {
 public:
  /// Gives each touched node the velocity with which it may close its gap in a step of dt, s. `fields`,
  /// `nodes`: their numbers.
  template <class Touched>
  void give(std::vector<Touched>& touched, std::size_t fields, std::size_t nodes, T dt) {
    all_.resize(fields * nodes);
    for (std::size_t k = 0; k < gap_.size(); ++k) all_[field_[k] * nodes + node_[k]] = gap_[k];
    for (auto& t : touched)
      if (!t.inside) t.closing = all_[t.field * nodes + t.node] / dt;
    for (std::size_t k = 0; k < gap_.size(); ++k) all_[field_[k] * nodes + node_[k]] = 0;
  }
  /// Updates the gaps: `parting(t)` is the velocity with which matter parts from the body at a touched node,
  /// m/s.
  template <class Touched, class Parting>
  void follow(const std::vector<Touched>& touched, T dt, Parting&& parting) {
    field_.clear(), node_.clear(), gap_.clear();
    for (const auto& t : touched) {
      const T gap = t.inside ? 0 : dt * (t.closing + parting(t));
      if (!(gap > 0)) continue;
      field_.push_back(t.field);
      node_.push_back(t.node);
      gap_.push_back(gap);
    }
  }
  template <class F>
  void visit_state(F&& f) {
    f("field", field_);
    f("node", node_);
    f("gap", gap_);
  }
  /// Throws `error` for a restored state that does not fit these numbers of fields and nodes.
  void check(std::size_t fields, std::size_t nodes) const {
    require(field_.size() == gap_.size() && node_.size() == gap_.size(), "state: gaps of a rigid body",
            gap_.size(), "must be as many as their fields and nodes");
    for (std::size_t k = 0; k < gap_.size(); ++k) {
      require(field_[k] < fields && node_[k] < nodes, "state: gap of a rigid body, node", node_[k],
              "must lie in the mesh");
      require(gap_[k] > 0 && std::isfinite(gap_[k]), "state: gap of a rigid body", gap_[k],
              "must be positive");
    }
  }

 private:
  std::vector<std::size_t> field_, node_;
  std::vector<T> gap_;  // m, above zero
  std::vector<T> all_;  // [fields x nodes], zero between steps
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
