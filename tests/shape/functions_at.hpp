// Shape functions of a cell at a point, in matrices of any size: the algebra of checks is compiled once, not for each function.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

namespace arenite::test {

/// Vectors of any dimension and precision, as columns.
template <class V>
Eigen::VectorXd of_any_size(const V& x) {
  Eigen::VectorXd column(x.size());
  for (int k = 0; k < x.size(); ++k) column[k] = x[k];
  return column;
}

/// Values, gradients and nodes of a cell's functions at a point; nodes one to a column.
struct FunctionsAt {
  Eigen::VectorXd point, value;
  Eigen::MatrixXd gradient, node;

  template <class Cell, class Point>
  FunctionsAt(const Cell& cell, const Point& x) : point(of_any_size(x)), value(of_any_size(cell.weights(x))) {
    const auto slopes = cell.gradients(x);
    const auto places = cell.node_positions();
    gradient.resize(x.size(), value.size());
    node.resize(x.size(), value.size());
    for (int i = 0; i < value.size(); ++i)
      for (int k = 0; k < x.size(); ++k) {
        gradient(k, i) = slopes(k, i);
        node(k, i) = places(k, i);
      }
  }

  /// Sum of values - 1.
  double off_unity() const { return std::abs(value.sum() - 1); }
  /// Sum of values times nodes - point, m.
  double off_linear() const { return (node * value - point).norm(); }
  /// Sum of gradients, 1/m.
  double gradient_sum() const { return gradient.rowwise().sum().norm(); }
  /// Sum of nodes times gradients - identity.
  double off_identity() const {
    return (node * gradient.transpose() - Eigen::MatrixXd::Identity(point.size(), point.size())).norm();
  }
  double least() const { return value.minCoeff(); }
  /// Largest distance of a node from where `Shape` says that it lies, m.
  template <class Shape, class Mesh, class Cell>
  double off_nodes(const Mesh& mesh, const Cell& cell) const {
    double most = 0;
    for (int i = 0; i < value.size(); ++i) {
      const auto at = of_any_size(Shape::node_position(mesh, cell.nodes[static_cast<std::size_t>(i)]));
      const double off = (at - node.col(i)).norm();
      if (std::isnan(off)) return off;
      most = std::max(most, off);
    }
    return most;
  }
};

}  // namespace arenite::test
