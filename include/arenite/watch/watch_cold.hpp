// Cold functions of watch.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <span>
#include <string>
#include <utility>

#include <arenite/watch/watch.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// v^2 of a point, in the order of sums of Eigen.
template <class T>
T speed_square(const PointColumns<T>& points, std::size_t p) {
  const auto square = [&](std::size_t k) { return points.velocity[k][p] * points.velocity[k][p]; };
  return points.dimension == 2 ? square(0) + square(1) : square(0) + (square(1) + square(2));
}

/// Where a point is, m.
template <class T>
std::array<double, 3> place_of(const PointColumns<T>& points, std::size_t p) {
  auto place = Watched::nowhere;
  for (std::size_t k = 0; k < static_cast<std::size_t>(points.dimension); ++k)
    place[k] = static_cast<double>(points.position[k][p]);
  return place;
}

/// Name of a body in messages.
ARENITE_COLD std::string body_text(const WatchedBody& body) {
  return body.name.empty() ? joined_text({"body ", body.number}) : joined_text({"body ", body.name});
}
/// "(x, y) m"
ARENITE_COLD std::string place_text(const WatchedBody& body, const WatchedPoint& point) {
  return vector_text(std::span(point.place).first(static_cast<std::size_t>(body.dimension))) + " m";
}
/// "body NAME at (x, y) m"
ARENITE_COLD std::string spot_text(const WatchedBody& body, const WatchedPoint& point) {
  return joined_text({body_text(body), " at ", place_text(body, point)});
}

ARENITE_COLD void WatchedPoints::add(const WatchedPoints& other) {
  count += other.count;
  lost += other.lost;
  volume += other.volume;
  initial += other.initial;
  for (const auto point : {&WatchedPoints::speed, &WatchedPoints::volume_change, &WatchedPoints::spacing,
                           &WatchedPoints::strength})
    if ((other.*point).value > (this->*point).value) this->*point = other.*point;
}

ARENITE_COLD WatchRecord::WatchRecord(const WatchLimits& limits, bool is_of_run)
    : seen{{{"energy_gain", "energy that nothing put in, over the energy put in", limits.energy_gain},
            {"transfer", "energy that the transfer took, over the energy put in", limits.transfer},
            {"residual", "energy booked nowhere, over the energy put in", limits.residual},
            {"volume", "change of a body's mean volume, |V/V0 - 1|", limits.volume},
            {"speed", "greatest speed of a point over the wave speed", limits.speed},
            {"strength", "stress beyond the yield surface, relative", limits.strength},
            {"lost", "share of a body's points that left the mesh", limits.lost}}},
      every{limits.every},
      of_run{is_of_run} {
  for (const Watched& w : seen)
    require(w.limit > 0, {"WatchLimits.", w.name}, w.limit, "must be positive; infinity switches it off");
  require(every > 0, "WatchLimits.every", every, "must be positive");
}

ARENITE_COLD bool WatchRecord::update(Quantity q, double time, double value, int body) {
  Watched& w = seen[q];
  if (!stops(q, value) && value <= w.worst) return false;
  w.worst = value;
  w.time = time;
  w.body = body;
  w.place = Watched::nowhere;
  return !(value <= w.limit / 10);
}

ARENITE_COLD void WatchRecord::report(Quantity q, WatchedSpot spot) {
  Watched& w = seen[q];
  const bool ends = stops(q, w.worst);
  w.place = spot.place;
  if (!ends && w.warned) return;
  const std::string text = joined_text({"t = ", w.time, " s: ", w.name, " = ", w.worst, " (", w.meaning,
                                        of_run && !ends ? "): above " : "): the limit is ",
                                        of_run && !ends ? w.limit / 10 : w.limit, "; ", spot.text});
  if (ends) throw run_error(text);
  w.warned = true;
  report(text);
}

ARENITE_COLD void WatchRecord::report(std::string text) {
  warnings.emplace_back(text);
  warn(text);
}
ARENITE_COLD void WatchRecord::warn_once(bool& wanted, std::string text) {
  wanted = false;
  report(std::move(text));
}

ARENITE_COLD void WatchRecord::check_damping(double time, double share) {
  if (share > 0.1)
    warn_once(
        hints_at_damping,
        joined_text(
            {"t = ", time, " s: local damping took ", std::round(100 * share),
             " % of the work of gravity while matter fell freely: it is made for static states; "
             "switch it off (switch_off(), in Python switch_off_damping()) once the scene is at rest"}));
}

/// The fastest point of all bodies.
ARENITE_COLD WatchedSpot fastest_spot(const WatchedBody* bodies, std::size_t count) {
  WatchedSpot spot{Watched::nowhere, "no points are left"};
  double most = -1;
  for (std::size_t b = 0; b < count; ++b) {
    const WatchedPoint& point = bodies[b].points.speed;
    if (!(point.value > most)) continue;
    most = point.value;
    spot = {point.place,
            joined_text({"the fastest point: ", spot_text(bodies[b], point), ", ", std::sqrt(most), " m/s"})};
  }
  return spot;
}

ARENITE_COLD void WatchRecord::check_energy(double time, const WatchedEnergy::Found& found, bool tracked,
                                            const WatchedBody* bodies, std::size_t count) {
  const auto judge = [&](Quantity q, double value) {
    if (wants(q) && update(q, time, value, -1)) report(q, fastest_spot(bodies, count));
  };
  judge(energy_gain, found.gain);
  if (!tracked) return;
  judge(transfer, found.transfer);
  judge(residual, found.residual);
}

template <class T>
ARENITE_COLD void WatchRecord::read(const PointColumns<T>& points, const WatchedMesh& mesh,
                                    WatchedBody& body) const {
  WatchedPoints& found = body.points;
  for (std::size_t p = 0; p < points.count; ++p) {
    const auto at = [&] { return place_of(points, p); };
    const double before = static_cast<double>(points.mass[p]) / points.density,
                 stretch = static_cast<double>(points.volume[p]) / before;
    found.speed.take(static_cast<double>(speed_square(points, p)), stretch, at);
    if (wants(volume)) found.volume_change.take(std::abs(stretch - 1), stretch, at);
    // Tension may have drawn points so far apart that their body separates between them.
    if (!hints_at_spacing || !(stretch > 1.2) ||
        !(points.stress[0][p] + points.stress[1][p] + points.stress[2][p] > 0))
      continue;
    const double cell = mesh.cell_volume(mesh.mesh, points.cell[p]);
    const double spacing = stretch * std::pow(before / cell, 1.0 / points.dimension);
    if (spacing > body.bearing_spacing) found.spacing.take(spacing, stretch, at);
  }
}

ARENITE_COLD void WatchRecord::check_body(double time, const WatchedBody& body) {
  const WatchedPoints& points = body.points;
  if (const WatchedPoint& point = points.spacing; hints_at_spacing && point.value > 0)
    warn_once(
        hints_at_spacing,
        joined_text({"t = ", time, " s: ", spot_text(body, point), ": tension has drawn points ", point.value,
                     " of a cell apart (V/V0 = ", point.stretch, "): beyond ", body.bearing_spacing,
                     " a body may part between them, or from a wall; begin with more points a cell, or let "
                     "them split (SplitPoints)"}));
  const double ratio = points.initial > 0 ? points.volume / points.initial : 1.0;  // mean V/V0
  if (wants(volume) && points.count > 0 && update(volume, time, std::abs(ratio - 1), body.number)) {
    const WatchedPoint& point = points.volume_change;
    WatchedSpot spot{point.place, joined_text({body_text(body), ": mean V/V0 = ", ratio})};
    if (point.value >= 0) spot.text += joined_text({", ", point.stretch, " at ", place_text(body, point)});
    report(volume, std::move(spot));
  }
  if (const double all = points.lost + points.count; wants(lost) && all > 0)
    if (update(lost, time, points.lost / all, body.number))
      report(lost,
             {Watched::nowhere, joined_text({body_text(body), ": ", static_cast<std::size_t>(points.lost),
                                             " of ", static_cast<std::size_t>(all), " points"})});
  if (const WatchedPoint& point = points.speed; wants(speed) && point.value >= 0) {
    const double fastest = std::sqrt(point.value);
    if (update(speed, time, fastest / body.wave, body.number))
      report(speed,
             {point.place,
              joined_text({spot_text(body, point), ": ", fastest, " m/s; waves run at ", body.wave,
                           " m/s: is young, density, a velocity or gravity in other units than Pa, kg, "
                           "m, s?"})});
  }
  if (const WatchedPoint& point = points.strength; point.value >= 0)
    if (update(strength, time, point.value, body.number))
      report(strength, {point.place, spot_text(body, point)});
}

#define ARENITE_INSTANCES(T) \
  template void WatchRecord::read(const PointColumns<T>&, const WatchedMesh&, WatchedBody&) const;
ARENITE_FOR_NUMBERS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
