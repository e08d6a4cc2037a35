// Node gaps: how far matter has parted from a rigid body at the nodes that the body touches.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <vector>

#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The gaps of one body, m, by field and node. A node that the body no longer touches has none.
template <class T>
class NodeGaps {
 public:
  /// Gives touched nodes the velocity with which each may close its gap in a step of dt, s.
  template <class Touched>
  void give(std::vector<Touched>& touched, std::size_t nodes, T dt) {
    for (std::size_t k = 0; k < gap_.size(); ++k) at(field_[k], node_[k], nodes) = gap_[k];
    for (auto& t : touched)
      if (!t.inside && t.field * nodes + t.node < all_.size()) t.closing = at(t.field, t.node, nodes) / dt;
    for (std::size_t k = 0; k < gap_.size(); ++k) at(field_[k], node_[k], nodes) = 0;
  }
  /// Follows the step: `parting(t)` is the velocity with which matter parts from the body at a touched node, m/s.
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

 private:
  T& at(std::size_t field, std::size_t node, std::size_t nodes) {
    const std::size_t place = field * nodes + node;
    if (place >= all_.size()) all_.resize(std::max((field + 1) * nodes, all_.size()));
    return all_[place];
  }

  std::vector<std::size_t> field_, node_;
  std::vector<T> gap_;  // m, above zero
  std::vector<T> all_;  // [fields x nodes], zero between steps
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
