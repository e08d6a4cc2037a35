// Shape functions of a cell at a point, in matrices of any size: the algebra of checks is compiled once, not for each function.
#pragma once

#include <cmath>

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

  double off_unity() const { return std::abs(value.sum() - 1); }  ///< sum of values - 1
  double off_linear() const {
    return (node * value - point).norm();
  }  ///< sum of values times nodes - point, m
  double gradient_sum() const { return gradient.rowwise().sum().norm(); }  ///< 1/m
  double off_identity() const {  ///< sum of nodes times gradients - identity
    return (node * gradient.transpose() - Eigen::MatrixXd::Identity(point.size(), point.size())).norm();
  }
  double least() const { return value.minCoeff(); }
};

}  // namespace arenite::test
