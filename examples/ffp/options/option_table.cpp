#include "option_table.hpp"

#include <algorithm>

namespace arenite::ffp {

void check_in_space(const DropOptions& o) {
  if (!o.in_space()) {
    require(o.tilt == 0, "--tilt", o.tilt, "needs --kinematics space");
    for (const auto& [name, value] :
         {std::pair{"--centre-of-mass", o.centre_of_mass}, {"--gyration", o.gyration}})
      require(!value, name, value.value_or(0), "needs --kinematics space");
    return;
  }
  require(o.on_grid() && o.device == DeviceKind::rigid && o.contact_kind() == ContactKind::rigid &&
              !o.averages() && o.mesh.empty() && o.split_share() == 0,
          "--kinematics", "space",
          "needs --mesh-kind grid, --device rigid, --contact rigid and --anti-locking off, and goes without "
          "--mesh and --split");
}

namespace {

void check_chamber(const DropOptions& o) {
  const Chamber c = o.chamber();
  const double wide = 5 * o.outer_diameter() / 2, deep = o.moving_zone() + o.outer_diameter();
  if (o.chamber_radius)
    require(c.radius >= wide, "--chamber-radius", c.radius,
            {"must be at least five times the penetrometer's radius, ", wide, " m"});
  if (o.soil_depth)
    require(c.soil_depth >= deep, "--soil-depth", c.soil_depth,
            {"must be at least --moving-depth and a diameter, ", deep, " m"});
}

/// Rows of a fitted mesh cut the outline; where it is too flat to be cut, cells have no height. Its tip and its top may be flat.
void check_outline_in_mesh(const DropOptions& o) {
  constexpr double flattest = 0.25;  // dy / ds; 15 deg to the horizontal
  const auto outline = o.outline();
  if (!outline || o.on_grid() || !o.mesh.empty()) return;
  const double cell = o.mesh_sizes().cone_cell();
  const auto& corners = outline->corners();
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Point2 &from = corners[k - 1].at, &to = corners[k].at;
    if (to[1] < cell || from[1] > o.whole_length() - cell) continue;
    if (to[1] - from[1] < flattest * (to - from).norm())
      throw error(joined_text({"--mesh-kind fitted: the outline of ", o.device_name(), " from (", from[0],
                               ", ", from[1], ") to (", to[0], ", ", to[1],
                               ") m is flatter than 15 deg to the horizontal; take --mesh-kind grid"}));
  }
}

}  // namespace

void check(const DropOptions& o) {
  detail::RangeCheck ranges;
  visit_options(o, ranges);
  require(o.dilatancy <= o.friction, "--dilatancy", o.dilatancy,
          {"must lie in [0, ", o.friction, "] deg, from nothing to the sand's angle of friction"});
  check(o.law, o.friction, o.dilatancy);
  check(static_cast<const DeviceOptions&>(o));
  if (o.mesh.empty()) check_mass(o);
  check_chamber(o);
  check_outline_in_mesh(o);
  if (const double fillet = o.fillet_radius(); fillet > 0 && fillet < 0.001 * o.size() && o.mesh.empty()) {
    const double most = fillet * o.shape().apex;
    require(o.mesh_sizes().cone_cell() <= most, "--fillet", fillet,
            {"below ", 0.001 * o.size(), " m needs --cell-at-cone of at most ", most, " m, to be seen"});
  }
  if (o.cell_at_cone) {
    require(*o.cell_at_cone <= o.cell_size(), "--cell-at-cone", *o.cell_at_cone,
            {"must not exceed --cell = ", o.cell_size(), " m"});
    require(o.kinematics == Kinematics::axisymmetric && o.mesh.empty(), "--cell-at-cone", *o.cell_at_cone,
            "needs --kinematics axisymmetric, and goes without --mesh");
  }
  require(o.split_share() == 0 || o.split_share() >= 1, "--split", o.split_share(),
          "must be 0 or at least 1");
  require(o.split_share() == 0 || o.device == DeviceKind::rigid, "--split", o.split_share(),
          "needs --device rigid");
  check_in_space(o);
  if (o.on_grid()) {
    require(o.kinematics != Kinematics::slice && o.device == DeviceKind::rigid && o.mesh.empty() &&
                o.contact_kind() != ContactKind::centre_of_mass && !o.averages(),
            "--mesh-kind", "grid",
            "needs --kinematics axisymmetric or space, --device rigid, --contact points or rigid and "
            "--anti-locking off, and goes without --mesh");
  } else {
    require(o.contact_kind() != ContactKind::points, "--contact", "points", "needs --mesh-kind grid");
  }
  if (!o.averages() && !o.on_grid())
    require(o.device == DeviceKind::rigid && o.contact_kind() == ContactKind::rigid, "--anti-locking", "off",
            "needs --device rigid and --contact rigid");
  if (o.law.kind != LawKind::mohr_coulomb && !o.on_grid())
    require(o.device == DeviceKind::rigid && o.contact_kind() == ContactKind::rigid && o.averages(), "--law",
            word_of(law_words, o.law.kind), "needs --device rigid, --contact rigid and --anti-locking on");
  require(o.k0 || (o.earth_pressure() >= 0 && o.earth_pressure() <= 3), "--poisson", exactly(o.poisson),
          {"must give an earth pressure at rest poisson / (1 - poisson) in [0, 3], not ", o.earth_pressure(),
           ", unless --k0 is given"});
  require(o.contact_offset == 0 || o.mesh.empty(), "--contact-offset", exactly(o.contact_offset),
          "goes without --mesh");
  if (!o.mesh.empty())
    require(arenite::shared_detail::check_input(o.mesh, "--mesh", arenite::shared_detail::most_mesh_bytes,
                                                shown(o.mesh)) > 0,
            "--mesh", shown(o.mesh), "must be a file that is not empty");
  const int n = o.points_in_element();
  const auto among = [n](const auto& counts) {
    return std::find(counts.begin(), counts.end(), n) != counts.end();
  };
  if (o.in_space())
    require(among(space_points), "--points-per-element", n,
            "must be " + listed(space_points) + " in the cells of a grid in space");
  else if (o.on_grid())
    require(among(grid_points), "--points-per-element", n,
            "must be " + listed(grid_points) + " in the cells of a grid");
  else if (o.kinematics == Kinematics::slice)
    require(among(tetrahedron_points), "--points-per-element", n,
            "must be " + listed(tetrahedron_points) + " in the slice's tetrahedra");
  else
    require(among(triangle_points), "--points-per-element", n,
            "must be " + listed(triangle_points) + " in triangles");
  if (o.error_bar) {
    require(o.mesh.empty(), "--mesh", shown(o.mesh), "goes without --error-bar, which needs coarser meshes");
    require(o.cell_size() <= largest_cell_with_bar(o), "--cell", o.cell_size(),
            {"must be at most ", largest_cell_with_bar(o),
             " m with --error-bar, which runs drops at twice the cell"});
  }
  require(o.fields_every == 0 || o.end / o.fields_every <= most_fields, "--fields-every", o.fields_every,
          {"must be 0, for none, or at least ", o.end / most_fields, " s, for ", most_fields,
           " sets of files until --end = ", o.end, " s"});
  require(!o.out.empty(), "--out", "\"\"", "must name a folder");
}

}  // namespace arenite::ffp
