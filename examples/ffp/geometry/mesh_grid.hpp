// The grid of the drop: lines along and across the axis, which need not fit the penetrometer.
#pragma once

#include <algorithm>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/mesh/rectilinear_grid.hpp>

#include "geometry.hpp"
#include "grading.hpp"
#include "mesh_axisymmetric.hpp"

namespace arenite::ffp {

/// Lines of a grid over the half-section, with the sizes of the fitted mesh: cells are as wide beside the
/// penetrometer and as high along its path, and those at the cone reach from its tip over the shoulder, both
/// ways. The surface of the sand and the zone that moves as one begin on lines.
inline RectilinearGrid<2>::Parameters grid_lines(const Device& body, const Chamber& chamber = {},
                                                 const MeshSizes& sizes = {}) {
  const double h = sizes.cell, deep = -sizes.moving_depth, edge = body.radius();
  require(edge + sizes.fine_radius < chamber.radius, "MeshSizes.fine_radius", sizes.fine_radius,
          "must end before the wall of the chamber");
  RectilinearGrid<2>::Parameters lines;
  lines.x = graded(0, chamber.radius, [&](double x) {
    const double fine = edge + sizes.fine_radius;
    const double beyond = std::max(0.0, x - fine) / (chamber.radius - fine);
    return sizes.edge(x - edge, h * (1 + (sizes.outer_ratio - 1) * beyond));
  });
  const auto append = [&](const std::vector<double>& heights) {
    lines.y.insert(lines.y.end(), heights.begin() + (lines.y.empty() ? 0 : 1), heights.end());
  };
  append(even(-chamber.soil_depth, deep, sizes.layer_ratio * h));
  append(graded(deep, 0, [&](double y) { return sizes.edge(-y, h); }));
  const double from = chamber.soil_depth / 2;  // the soil that rises around the cylinder stays below
  append(graded(0, chamber.headroom, [&](double y) {
    const double above = y > from ? (y - from) / (chamber.headroom - from) : 0;
    return sizes.edge(y - body.tip_end(), h * (1 + (sizes.top_ratio - 1) * above));
  }));
  return lines;
}

}  // namespace arenite::ffp
