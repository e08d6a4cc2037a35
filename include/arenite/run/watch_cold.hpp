// Cold functions of watch.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include <arenite/run/watch.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// v^2 of a point, in the order of sums of Eigen.
template <class T>
T speed_square(const PointColumns<T>& points, std::size_t p) {
  const auto square = [&](std::size_t k) { return points.velocity[k][p] * points.velocity[k][p]; };
  return points.dimension == 2 ? square(0) + square(1) : square(0) + (square(1) + square(2));
}

/// The point with the greatest `f`; the number of points if there is none.
template <class F>
std::size_t extreme(std::size_t points, F&& f) {
  double most = -std::numeric_limits<double>::infinity();
  std::size_t found = points;
  for (std::size_t p = 0; p < points; ++p)
    if (const double value = f(p); value > most) {
      most = value;
      found = p;
    }
  return found;
}

/// What messages call a body.
template <class T>
std::string body_text(const WatchedBody<T>& body) {
  return body.name.empty() ? joined_text({"body ", body.number}) : joined_text({"body ", body.name});
}

/// Where a point is, m; nowhere if there is none of that number.
template <class T>
ARENITE_COLD std::array<double, 3> place_of(const PointColumns<T>& points, std::size_t p) {
  auto place = Watched::nowhere;
  for (std::size_t k = 0; p < points.count && k < static_cast<std::size_t>(points.dimension); ++k)
    place[k] = static_cast<double>(points.position[k][p]);
  return place;
}

/// "(x, y) m"
template <class T>
std::string place_text(const PointColumns<T>& points, std::size_t p) {
  const auto place = place_of(points, p);
  return vector_text(std::span(place).first(static_cast<std::size_t>(points.dimension))) + " m";
}

template <class T>
ARENITE_COLD WatchedSpot watched_spot(const WatchedBody<T>& body, std::size_t point) {
  return {place_of(body.points, point),
          joined_text({body_text(body), " at ", place_text(body.points, point)})};
}

ARENITE_COLD WatchBook::WatchBook(const WatchLimits& limits, bool is_of_run)
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

ARENITE_COLD bool WatchBook::takes(Quantity q, double time, double value, int body) {
  Watched& w = seen[q];
  if (!stops(q, value) && value <= w.worst) return false;
  w.worst = value;
  w.time = time;
  w.body = body;
  w.place = Watched::nowhere;
  return !(value <= w.limit / 10);
}

ARENITE_COLD void WatchBook::tell(Quantity q, WatchedSpot spot) {
  Watched& w = seen[q];
  const bool ends = stops(q, w.worst);
  w.place = spot.place;
  if (!ends && w.warned) return;
  const std::string text = joined_text({"t = ", w.time, " s: ", w.name, " = ", w.worst, " (", w.meaning,
                                        of_run && !ends ? "): above " : "): the limit is ",
                                        of_run && !ends ? w.limit / 10 : w.limit, "; ", spot.text});
  if (ends) throw run_error(text);
  w.warned = true;
  tell(text);
}

ARENITE_COLD void WatchBook::tell(std::string text) {
  warnings.emplace_back(text);
  warn(text);
}
ARENITE_COLD void WatchBook::hint(bool& wanted, std::string text) {
  wanted = false;
  tell(std::move(text));
}

ARENITE_COLD void WatchBook::look_at_damping(double time, double share) {
  if (share > 0.1)
    hint(hints_at_damping,
         joined_text(
             {"t = ", time, " s: local damping took ", std::round(100 * share),
              " % of the work of gravity while matter fell freely: it is made for static states; "
              "switch it off (switch_off(), in Python switch_off_damping()) once the scene is at rest"}));
}

/// The fastest point of all bodies.
template <class T>
ARENITE_COLD WatchedSpot fastest_spot(std::span<const WatchedBody<T>> bodies) {
  WatchedSpot spot{Watched::nowhere, "no points are left"};
  double most = -1;
  for (const auto& body : bodies) {
    const auto& points = body.points;
    const auto speed = [&](std::size_t p) { return static_cast<double>(std::sqrt(speed_square(points, p))); };
    const std::size_t p = extreme(points.count, speed);
    if (p < points.count && speed(p) > most) {
      most = speed(p);
      spot = {place_of(points, p), joined_text({"the fastest point: ", body_text(body), " at ",
                                                place_text(points, p), ", ", most, " m/s"})};
    }
  }
  return spot;
}

template <class T>
ARENITE_COLD void WatchBook::look_at_energy(double time, const WatchedEnergy::Found& found, bool tracked,
                                            std::span<const WatchedBody<T>> bodies) {
  const auto judge = [&](Quantity q, double value) {
    if (wants(q) && takes(q, time, value, -1)) tell(q, fastest_spot(bodies));
  };
  judge(energy_gain, found.gain);
  if (!tracked) return;
  judge(transfer, found.transfer);
  judge(residual, found.residual);
}

/// Warns of points that tension has drawn so far apart that their body may part between them.
template <class T>
ARENITE_COLD void WatchBook::look_at_spacing(double time, const WatchedBody<T>& body) {
  const auto& points = body.points;
  for (std::size_t p = 0; p < points.count; ++p) {
    const double before = static_cast<double>(points.mass[p]) / points.density,
                 stretch = static_cast<double>(points.volume[p]) / before;
    if (!(stretch > 1.2) || !(points.stress[0][p] + points.stress[1][p] + points.stress[2][p] > 0)) continue;
    const double cell = body.cell_volume(body.mesh, points.cell[p]);
    const double spacing = stretch * std::pow(before / cell, 1.0 / points.dimension);
    if (!(spacing > body.bearing_spacing)) continue;
    hint(hints_at_spacing,
         joined_text({"t = ", time, " s: ", body_text(body), " at ", place_text(points, p),
                      ": tension has drawn points ", spacing, " of a cell apart (V/V0 = ", stretch,
                      "): beyond ", body.bearing_spacing,
                      " a body may part between them, or from a wall; begin with more points a cell, or let "
                      "them split (SplitPoints)"}));
    return;
  }
}

template <class T>
ARENITE_COLD void WatchBook::look_at_body(double time, const WatchedBody<T>& body) {
  const auto& points = body.points;
  if (hints_at_spacing) look_at_spacing(time, body);
  if (wants(volume) && points.count > 0 &&
      takes(volume, time, std::abs(body.volume_ratio - 1), body.number)) {
    const auto local = [&](std::size_t p) {
      return static_cast<double>(points.volume[p]) * points.density / static_cast<double>(points.mass[p]);
    };
    const std::size_t p = extreme(points.count, [&](std::size_t k) { return std::abs(local(k) - 1); });
    WatchedSpot spot{place_of(points, p),
                     joined_text({body_text(body), ": mean V/V0 = ", body.volume_ratio})};
    if (p < points.count) spot.text += joined_text({", ", local(p), " at ", place_text(points, p)});
    tell(volume, std::move(spot));
  }
  if (const std::size_t all = body.lost + points.count; wants(lost) && all > 0)
    if (takes(lost, time, static_cast<double>(body.lost) / static_cast<double>(all), body.number))
      tell(lost, {Watched::nowhere, joined_text({body_text(body), ": ", body.lost, " of ", all, " points"})});
  if (!wants(speed)) return;
  const double wave = std::sqrt(body.wave_modulus / points.density);
  const auto square = [&](std::size_t k) { return static_cast<double>(speed_square(points, k)); };
  const std::size_t p = extreme(points.count, square);
  if (p >= points.count) return;
  const double fastest = std::sqrt(square(p));
  if (takes(speed, time, fastest / wave, body.number))
    tell(speed,
         {place_of(points, p),
          joined_text({body_text(body), " at ", place_text(points, p), ": ", fastest, " m/s; waves run at ",
                       wave,
                       " m/s: is young, density, a velocity or gravity in other units than Pa, kg, m, s?"})});
}

#define ARENITE_INSTANCES(T)                                                         \
  template void WatchBook::look_at_energy(double, const WatchedEnergy::Found&, bool, \
                                          std::span<const WatchedBody<T>>);          \
  template void WatchBook::look_at_body(double, const WatchedBody<T>&);              \
  template WatchedSpot watched_spot(const WatchedBody<T>&, std::size_t);
ARENITE_FOR_NUMBERS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
