// Watch: an observer that checks a run for implausible results, warns, and stops it at limits that the user
// sets.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/state_value.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/law/pass.hpp>
#include <arenite/mesh/full_volume.hpp>
#include <arenite/observe/point_columns.hpp>
#include <arenite/watch/damped_fall.hpp>
#include <arenite/watch/watch_limits.hpp>
#include <arenite/watch/watched_energy.hpp>
#include <arenite/watch/watched_rigids.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// The point with the greatest value of a quantity. No point while the value is negative.
struct WatchedPoint {
  double value = -1, stretch = 1;  // of the quantity; V/V0
  std::array<double, 3> place = Watched::nowhere;

  template <class Place>
  void take(double other, double its_stretch, const Place& at) {
    if (other > value) *this = {other, its_stretch, at()};
  }
};

/// Data that a watch reads from the points of a body.
struct WatchedPoints {
  double count = 0, lost = 0;      // points, and points that left the mesh
  double volume = 0, initial = 0;  // total V and V0, m3, if wanted
  WatchedPoint speed{};            // square of it, m2/s2
  WatchedPoint volume_change{};    // |V/V0 - 1|
  WatchedPoint spacing{};          // of points that tension draws apart beyond `bearing_spacing`, in cells
  WatchedPoint strength{};

  static constexpr std::size_t size = 4 + 4 * 5;
  using Numbers = std::array<double, size>;

  /// Adds the points in another tile.
  void add(const WatchedPoints& other);
};

/// A body as a watch sees it: with the points of all tiles.
struct WatchedBody {
  int number = 0, dimension = 0;
  std::string_view name{};     // empty: goes by its number
  double wave = 0;             // speed of waves, m/s
  double bearing_spacing = 0;  // beyond it a body under tension may separate between points, in cells
  WatchedPoints points{};
};

/// The mesh of a scene.
struct WatchedMesh {
  const void* mesh = nullptr;
  double (*cell_volume)(const void* mesh, Index cell) = nullptr;  // m3
};

/// The point with the greatest value of a quantity, and the text to report.
struct WatchedSpot {
  std::array<double, 3> place = Watched::nowhere;
  std::string text{};
};

/// State of a watch, and the checks that do not need the types of a scene.
class WatchRecord {
 public:
  enum Quantity : std::size_t { energy_gain, transfer, residual, volume, speed, strength, lost };

  /// Throws `error` unless all limits are positive.
  WatchRecord(const WatchLimits& limits, bool of_run);

  bool wants(Quantity q) const { return std::isfinite(seen[q].limit); }
  bool wants_energy() const { return wants(energy_gain) || wants(transfer) || wants(residual); }

  /// Records a value of a quantity; returns whether it must be reported with `report`.
  bool update(Quantity q, double time, double value, int body);
  /// Warns of the value recorded last, or throws `run_error`.
  void report(Quantity q, WatchedSpot spot);

  /// Warns.
  void report(std::string text);

  /// Finds the points of a body with the greatest values of all quantities but strength.
  template <class T>
  void read(const PointColumns<T>& points, const WatchedMesh& mesh, WatchedBody& body) const;

  void check_damping(double time, double share);
  void check_energy(double time, const WatchedEnergy::Found& found, bool tracked, const WatchedBody* bodies,
                    std::size_t count);
  void check_body(double time, const WatchedBody& body);

  std::array<Watched, 7> seen;
  std::vector<WarningText> warnings{};
  std::size_t every;
  bool of_run;
  bool hints_at_damping = true, hints_at_spacing = true;  // whether still to be given

 private:
  /// Whether the value of a quantity ends the run.
  bool stops(Quantity q, double value) const {
    return !(value <= seen[q].limit) && (!of_run || q == energy_gain || q == residual);
  }
  void warn_once(bool& wanted, std::string text);
};

/// Joins the data of the points of each body over all tiles, by one collective call of the communicator.
template <class Communicator, class Bodies>
void join_watched([[maybe_unused]] const Communicator& comm, [[maybe_unused]] Bodies& bodies) {
  if constexpr (!Communicator::is_serial) {
    std::vector<double> here;
    for (const auto& body : bodies) {
      const auto numbers = std::bit_cast<WatchedPoints::Numbers>(body.points);
      here.insert(here.end(), numbers.begin(), numbers.end());
    }
    const auto all = comm.gather(here);
    for (auto& body : bodies) body.points = {};
    WatchedPoints::Numbers of_tile;
    for (std::size_t at = 0, k = 0; at < all.size(); at += of_tile.size(), ++k) {
      std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(at), of_tile.size(), of_tile.begin());
      bodies[k % bodies.size()].points.add(std::bit_cast<WatchedPoints>(of_tile));
    }
  }
}

}  // namespace detail

/// Observer that checks a scene, or all tiles of one that is cut, at its first call, then at every
/// `limits.every`th step, and at the end of `run`: a check costs a fifth to a half of a step. It should be
/// called at every step. Past a limit it throws `run_error` with time, quantity, value, limit and place; past
/// a tenth it warns once (`on_warning`). The values found can be read from it afterwards. Observers after it
/// do not see the step at which it throws: name it last. It may be given to several runs of one scene.
template <bool OfRun>
class BasicWatch {
 public:
  /// Throws `error` unless all limits are positive.
  explicit BasicWatch(const WatchLimits& limits = {}) : record_(limits, OfRun) {}

  template <class Scene>
  void operator()(const Scene& scene) {
    if (scene.steps >= next_)
      look(scene);
    else if (!tracks_energy<Scene> && record_.wants_energy())
      scene.steps + 1 == next_ ? energy_.remember(scene) : energy_.follow(scene);
    look_at_rigids(scene);
  }
  /// Checks the scene at the end of a run, which may lie between two checks; `run` calls it.
  template <class Scene>
  void finish(const Scene& scene) {
    if (scene.steps != last_) look(scene);
  }

  /// Checks the scene now.
  template <class Scene>
  void look(const Scene& scene) {
    using Record = detail::WatchRecord;
    auto bodies = by_body<detail::WatchedBody, Scene::body_count>(scene.number_of_bodies());
    const detail::WatchedMesh mesh{&scene.mesh, [](const void* of, Index cell) {
                                     return static_cast<double>(full_volume<typename Scene::Kinematics>(
                                         *static_cast<const typename Scene::Mesh*>(of), cell));
                                   }};
    std::size_t n = 0;
    scene.for_each_body([&](const auto& body, const auto&) {
      auto& watched = bodies[n];
      watched = {.number = static_cast<int>(n),
                 .dimension = Scene::D,
                 .name = Scene::lists_bodies ? std::string_view() : Scene::body_names[n],
                 .wave = std::sqrt(body.law.wave_modulus() / body.law.density()),
                 .bearing_spacing = bearing_spacing<typename Scene::Shape>};
      watched.points.count = static_cast<double>(body.points.size());
      watched.points.lost = static_cast<double>(body.lost);
      if (record_.wants(Record::volume)) {
        const auto volumes = volume_and_initial(body);
        watched.points.volume = volumes[0];
        watched.points.initial = volumes[1];
      }
      record_.read(columns_of_points(body), mesh, watched);
      // Initial stresses may lie outside the yield surface: the first step returns them to it.
      if constexpr (!OfRun)
        if (record_.wants(Record::strength) && scene.steps > 0)
          look_at_strength<Scene::NumericsType::template width<typename Scene::T>>(body, watched);
      ++n;
    });
    detail::join_watched(scene.communicator(), bodies);
    const bool speaks = is_reporter(scene);
    if (record_.wants(Record::energy_gain) ||
        (tracks_energy<Scene> && (record_.wants(Record::transfer) || record_.wants(Record::residual))))
      if (const auto found = energy_.look(scene); found.known && speaks)
        record_.check_energy(scene.time, found, tracks_energy<Scene>, bodies.data(), bodies.size());
    if constexpr (Scene::template has_part<LocalDamping>) {
      const double share = fall_.look(scene);
      if (record_.hints_at_damping && speaks) record_.check_damping(scene.time, share);
    }
    if (speaks)
      for (const auto& body : bodies) record_.check_body(scene.time, body);
    last_ = scene.steps;
    next_ = scene.steps + record_.every;
  }

  /// State to save, without the texts of warnings already given.
  template <class F>
  void visit_state(F&& f) {
    for (Watched& w : record_.seen) {
      const StateUnder quantity(f, std::string(w.name));
      quantity("worst", w.worst);
      quantity("time", w.time);
      quantity("body", w.body);
      quantity("place", w.place);
      quantity("warned", w.warned);
    }
    f("next", next_);
    f("last", last_);
    f("hints/damping", record_.hints_at_damping);
    f("hints/spacing", record_.hints_at_spacing);
    fall_.visit_state(StateUnder(f, "fall"));
    energy_.visit_state(f);
    rigids_.visit_state(StateUnder(f, "rigids"));
  }

  /// Each quantity with its greatest value so far, in the order of `WatchLimits`.
  const std::array<Watched, 7>& seen() const { return record_.seen; }
  /// The warnings given, in order: at most one a quantity.
  const std::vector<WarningText>& warnings() const { return record_.warnings; }

  /// Does not warn of local damping: the scene is brought to rest on purpose (`settle`).
  void accept_damping() { record_.hints_at_damping = false; }

 private:
  /// At every step: a body that falls through a thin mesh is past it before the next check.
  template <class Scene>
  void look_at_rigids(const Scene& scene) {
    rigids_.look(scene, scene.steps == last_, [&](std::string text) {
      if (is_reporter(scene)) record_.report(std::move(text));
    });
  }
  template <int Width, class L, class T, int D, ExtraColumns E>
  static void look_at_strength(const Body<L, T, D, E>& body, detail::WatchedBody& watched) {
    using P = typename LawLanes<L, T, Width>::type;
    if constexpr (knows_yield<L, P, D>) {
      // Stresses much smaller than those of a strain of 1e-6 are round-off of larger ones.
      const P little(static_cast<T>(1e-6 * body.law.wave_modulus()));
      struct Worst {
        double value;
        std::size_t point;
      };
      const Worst worst = parallel_reduce(
          body.points.size(), Worst{0, body.points.size()},
          [&](std::size_t begin, std::size_t end) {
            using std::sqrt;
            Worst most{0, begin};
            for (std::size_t p = begin; p < end; p += lane_count<P>) {
              const int count = static_cast<int>(std::min<std::size_t>(lane_count<P>, end - p));
              const Sym<P, D> stress{body.points.stress.template load<P>(p, count)};
              const P size = sqrt(contract(stress, stress));
              const P beyond = yield_of(body.law, stress, body.points.template load_history<P>(p, count)) *
                               size / (size + little);
              const auto more = beyond > P(static_cast<T>(most.value));
              if (!any_of(more)) continue;
              for (int k = 0; k < count; ++k) {
                double value;
                if constexpr (is_pack<P>)
                  value = static_cast<double>(beyond[k]);
                else
                  value = static_cast<double>(beyond);
                if (value > most.value) most = {value, p + static_cast<std::size_t>(k)};
              }
            }
            return most;
          },
          [](const Worst& a, const Worst& b) { return b.value > a.value ? b : a; });
      watched.points.strength.take(worst.value, 1, [&] {
        if (worst.point >= body.points.size()) return Watched::nowhere;  // none lies beyond
        const Vec<T, D> x = body.points.position[worst.point];
        return in_space(x);
      });
    }
  }

  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max() / 2;

  detail::WatchRecord record_;
  DampedFall fall_;
  std::size_t next_ = 0, last_ = never;
  WatchedEnergy energy_;
  detail::WatchedRigids rigids_;
};

/// A watch to give to `run`.
using Watch = BasicWatch<false>;
/// The watch that `run` adds itself: it does not check strength, which would be compiled for each law.
using WatchOfRun = BasicWatch<true>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <span>

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

#endif  // ARENITE_HAS_COLD
