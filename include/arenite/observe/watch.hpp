// Watch: an observer that looks at a run for what cannot be right, warns, and stops it at limits that the
// user sets.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/state_value.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/observe/energy.hpp>
#include <arenite/transfer/law_pass.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Limits of a `Watch`. Past a limit the run stops, past a tenth of it comes one warning. Infinity switches a
/// quantity off: it is not computed.
struct WatchLimits {
  /// Energy that nothing put in, over all that was put in (the energy there was, and the work of gravity,
  /// loads and prescribed motions), -: the balance's residual, and dissipation that is negative, above their
  /// lowest value at a look, so that energy that transfers took hides no gain. Without `TrackEnergy` what was
  /// dissipated is not known: then only a gain beyond it since the first look shows, and none at the end of
  /// a run between two looks. An elastic law stretched by 0.1, beyond the small strains that it is made for,
  /// shows 0.03.
  double energy_gain = 0.1;
  /// Energy that transfers and time steps took, over all that was put in, -. Needs `TrackEnergy`. More than 1
  /// cannot be; APIC takes 0.17 in a column of sand that collapses, so that the warning comes at a half.
  double energy_loss = 5;
  /// Change of a body's mean volume, |V/V0 - 1|, voids that opened included, -.
  double volume = 0.5;
  /// How far the stress of a point lies outside the yield surface, as `yield(stress)` of its law has it, -:
  /// for laws with that member. A law that returns to its surface stays within round-off (1e-13, in float
  /// 5e-5).
  double strength = 0.1;
  /// Share of a body's points that left the mesh, -.
  double lost = 0.1;
  /// Steps from one look to the next.
  std::size_t every = 100;
};

/// What a `Watch` saw of one quantity: its greatest value so far.
struct Watched {
  static constexpr std::array<double, 3> nowhere{std::numeric_limits<double>::quiet_NaN(),
                                                 std::numeric_limits<double>::quiet_NaN(),
                                                 std::numeric_limits<double>::quiet_NaN()};

  std::string_view name;     ///< the limit's name in `WatchLimits`
  std::string_view meaning;  ///< in words
  double limit = 0;
  double worst = std::numeric_limits<double>::quiet_NaN();  ///< -; NaN: not looked at
  double time = std::numeric_limits<double>::quiet_NaN();   ///< of the worst value, s
  int body = -1;                                            ///< of the worst value; -1: the whole scene
  /// Position of the point that shows it most, m; NaN below a tenth of the limit, and where no point does.
  std::array<double, 3> place = nowhere;
  bool warned = false;
};

/// Observer that looks at a scene at its first call, then at every `limits.every`th step, and at the end of
/// `run`: a look costs a fifth to a half of a step. It wants to be called at every step. Past a limit it
/// throws `run_error` with time, quantity, value, limit and place; past a tenth it warns once (`on_warning`).
/// What it saw can be read from it afterwards. Observers behind it do not see the step at which it throws:
/// name it last. For one scene; it may be given to several runs of it.
class Watch {
 public:
  /// Throws `error` unless all limits are positive.
  explicit Watch(const WatchLimits& limits = {})
      : seen_{{{"energy_gain", "energy that nothing put in, over the energy put in", limits.energy_gain},
               {"energy_loss", "energy that the numerics took, over the energy put in", limits.energy_loss},
               {"volume", "change of a body's mean volume, |V/V0 - 1|", limits.volume},
               {"strength", "stress beyond the yield surface, relative", limits.strength},
               {"lost", "share of a body's points that left the mesh", limits.lost}}},
        every_{limits.every} {
    for (const Watched& w : seen_)
      require(w.limit > 0, shared_detail::join("WatchLimits.", w.name), w.limit,
              "must be positive; infinity switches it off");
    require(every_ > 0, "WatchLimits.every", every_, "must be positive");
  }

  template <class Scene>
  void operator()(const Scene& scene) {
    if (scene.steps >= next_)
      look(scene);
    else if (tracks_energy<Scene> || scene.steps + 1 == next_)
      remember(scene);
  }
  /// Looks at the end of a run, which may lie between two looks; `run` calls it.
  template <class Scene>
  void finish(const Scene& scene) {
    if (scene.steps != last_) look(scene);
  }

  /// Looks now.
  template <class Scene>
  void look(const Scene& scene) {
    if (wants(energy_gain) || (tracks_energy<Scene> && wants(energy_loss))) look_at_energy(scene);
    int number = 0;
    scene.for_each_body([&](const auto& body, const auto&) {
      if (wants(volume)) look_at_volume(scene, body, number);
      if (wants(lost)) look_at_lost(scene, body, number);
      // Initial stresses may lie outside: the first step takes them back.
      if (wants(strength) && scene.steps > 0)
        look_at_strength<Scene::NumericsType::template width<typename Scene::T>>(scene, body, number);
      ++number;
    });
    last_ = scene.steps;
    next_ = scene.steps + every_;
  }

  /// What it remembers but the texts of its warnings, for a run that goes on elsewhere.
  template <class F>
  void visit_state(F&& f) {
    for (Watched& w : seen_) {
      const StateUnder quantity(f, std::string(w.name));
      quantity("worst", w.worst);
      quantity("time", w.time);
      quantity("body", w.body);
      quantity("place", w.place);
      quantity("warned", w.warned);
    }
    f("next", next_);
    f("last", last_);
    f("start/stored", start_.stored);
    f("start/external", start_.external);
    f("start/gained", start_.gained);
    f("put_in", put_in_);
    f("moved", moved_);
    f("floor", floor_);
    f("gain", gain_);
    f("lowest", lowest_);
    f("before", before_);
    f("held/strain", held_.strain);
    f("held/potential", held_.potential);
    f("held_before/strain", held_before_.strain);
    f("held_before/potential", held_before_.potential);
    f("held_step", held_step_);
    f("follows", follows_);
    f("started", started_);
    f("changes", changes_);
    f("held_changes", held_changes_);
  }

  /// Each quantity with its greatest value so far, in the order of `WatchLimits`.
  const std::array<Watched, 5>& seen() const { return seen_; }
  /// The warnings given, in order: at most one a quantity.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  enum Quantity : std::size_t { energy_gain, energy_loss, volume, strength, lost };

  /// A point that shows a quantity most, and what to say of it.
  struct Spot {
    std::array<double, 3> place = Watched::nowhere;
    std::string text;
  };

  bool wants(Quantity q) const { return std::isfinite(seen_[q].limit); }

  /// Takes a value of a quantity; `spot()` gives the `Spot`, once there is something to say.
  template <class F>
  void judge(Quantity q, double time, double value, int body, F&& spot) {
    Watched& w = seen_[q];
    const bool stops = !(value <= w.limit), worse = !(value <= w.worst);
    if (!stops && !worse) return;
    w.worst = value;
    w.time = time;
    w.body = body;
    w.place = Watched::nowhere;
    if (value <= w.limit / 10) return;
    const Spot at = spot();
    w.place = at.place;
    if (!stops && w.warned) return;
    const std::string text = shared_detail::join("t = ", time, " s: ", w.name, " = ", value, " (", w.meaning,
                                                 "): the limit is ", w.limit, "; ", at.text);
    if (stops) throw run_error(text);
    w.warned = true;
    warnings_.push_back(text);
    warn(text);
  }

  /// Points lost, inserted and removed since the start.
  template <class Scene>
  static std::size_t changes(const Scene& scene) {
    std::size_t n = scene.lost_points();
    scene.for_each_body(
        [&](const auto& body, const auto&) { n += body.inserted.count + body.removed.count; });
    return n;
  }

  /// What positions hold of the energy, J: works of stresses and against gravity, or strain and potential
  /// energy.
  struct Held {
    double strain = 0, potential = 0;
    double sum() const { return strain + potential; }
  };
  template <class Scene>
  static Held held(const Scene& scene) {
    Held h;
    if constexpr (tracks_energy<Scene>) {
      const auto& balance = scene.template part<TrackEnergy>();
      h = {balance.stress_work, -balance.gravity_work};
    } else {
      const Vec<double, Scene::D> g = scene.acceleration().template cast<double>();
      scene.for_each_body([&](const auto& body, const auto&) {
        h.strain += strain_energy(body);
        h.potential -= detail::sum_points(body, 0.0, [&](std::size_t p) {
          double along = 0;
          for (int k = 0; k < Scene::D; ++k)
            along += g[k] * static_cast<double>(body.points.position.column(static_cast<std::size_t>(k))[p]);
          return static_cast<double>(body.points.mass[p]) * along;
        });
      });
    }
    return h;
  }
  /// Keeps that of this step and of the one before.
  template <class Scene>
  void remember(const Scene& scene) {
    if ((!wants(energy_gain) && !wants(energy_loss)) || held_step_ == scene.steps) return;
    const std::size_t now = changes(scene);
    follows_ = held_step_ + 1 == scene.steps && (tracks_energy<Scene> || held_changes_ == now);
    held_changes_ = now;
    held_before_ = std::exchange(held_, held(scene));
    held_step_ = scene.steps;
  }

  /// Energies, J: kinetic and strain energy; work from outside since some time; energy that nothing put in
  /// since some time.
  struct Balance {
    double stored = 0, external = 0, gained = 0;
  };
  template <class Scene>
  Balance balance(const Scene& scene) const {
    Balance b;
    if constexpr (tracks_energy<Scene>) {
      const Energies e = energies(scene);
      b.stored = e.kinetic + e.strain + e.stored;
      b.external = e.external + e.inserted;
      // Dissipation that is negative is energy made: by a law, or in contact.
      b.gained = e.residual - std::min(e.plastic, 0.0) - std::min(e.contact, 0.0);
    } else {
      const PartEnergy parts = energy_of_parts(scene);
      double kinetic = 0;
      scene.for_each_body([&](const auto& body, const auto&) { kinetic += kinetic_energy(body); });
      kinetic += parts.kinetic + parts.stored;
      b.stored = kinetic + held_.strain;
      b.external = parts.external - held_.potential;
      b.gained = kinetic + held_.sum() - parts.external;
    }
    // What the velocity gradients of points hold they give back to their velocities.
    scene.for_each_body([&](const auto& body, const auto&) {
      const double spread = gradient_kinetic_energy<typename Scene::Shape>(scene.mesh, scene.blocks, body);
      b.stored += spread;
      b.gained += spread;
    });
    // Velocities are those of the middle of a step where positions are those of its end: energy sways by a
    // share of (frequency x step) unless the positions' part of it is taken half a step earlier.
    // Stresses that are centred are those of the middle already.
    if (follows_) b.gained -= (held_.potential - held_before_.potential) / 2;
    if (follows_ && !Scene::centres_stress) b.gained -= (held_.strain - held_before_.strain) / 2;
    return b;
  }

  /// What was gained since the lowest look (without `TrackEnergy`: the first), and lost since the first.
  template <class Scene>
  void look_at_energy(const Scene& scene) {
    remember(scene);
    if (!follows_ && scene.steps > 0) return;
    const Balance now = balance(scene);
    if (!started_) {
      started_ = true;
      start_ = now;
      floor_ = creep(scene);
      put_in_ = now.stored;
      changes_ = changes(scene);
      if constexpr (tracks_energy<Scene>)
        put_in_ = std::max(put_in_, scene.template part<TrackEnergy>().initial());
    } else if (!tracks_energy<Scene> && changes_ != changes(scene)) {
      // What the points took with them or brought is not known: start anew.
      start_ = now;
      before_ = gain_;
      changes_ = changes(scene);
    }
    gain_ = before_ + now.gained - start_.gained;
    moved_ = std::max(moved_, std::abs(now.external - start_.external));
    if constexpr (tracks_energy<Scene>) lowest_ = std::min(lowest_, gain_);
    const auto fraction = [&](double energy) {
      return energy == 0 ? 0 : energy / std::max(put_in_ + moved_, floor_);
    };
    const auto spot = [&] { return fastest(scene); };
    if (wants(energy_gain)) judge(energy_gain, scene.time, clipped(fraction(gain_ - lowest_)), -1, spot);
    if (tracks_energy<Scene> && wants(energy_loss))
      judge(energy_loss, scene.time, clipped(fraction(-gain_)), -1, spot);
  }

  /// max(x, 0), but NaN stays.
  static double clipped(double x) { return x > 0 || std::isnan(x) ? x : 0; }

  /// Work of gravity on all points in a fall by a hundredth of a cell, J: what is less than that is a scene
  /// at rest.
  template <class Scene>
  static double creep(const Scene& scene) {
    double all = 0, whole = 0;
    scene.for_each_body([&](const auto& body, const auto&) { all += mass(body); });
    for (Index c = 0; c < scene.mesh.cell_count(); ++c) whole += static_cast<double>(scene.mesh.volume(c));
    const double cell = std::pow(whole / scene.mesh.cell_count(), 1.0 / Scene::D);
    return 0.01 * cell * all * static_cast<double>(scene.acceleration().norm());
  }

  /// What messages call a body.
  template <class Scene>
  static std::string body_of(int number) {
    return "body " + Scene::body_name(static_cast<std::size_t>(number));
  }

  template <class Scene, class B>
  void look_at_volume(const Scene& scene, const B& body, int number) {
    const double ratio = mean_volume_ratio(body);
    judge(volume, scene.time, std::abs(ratio - 1), number, [&] {
      const double density = body.law.density();
      const auto local = [&](std::size_t p) {
        return static_cast<double>(body.points.volume[p]) * density /
               static_cast<double>(body.points.mass[p]);
      };
      const std::size_t p = extreme(body, [&](std::size_t k) { return std::abs(local(k) - 1); });
      Spot s = at(body, p);
      s.text = shared_detail::join(body_of<Scene>(number), ": mean V/V0 = ", ratio);
      if (p < body.points.size()) s.text += shared_detail::join(", ", local(p), " at ", written(body, p));
      return s;
    });
  }

  template <class Scene, class B>
  void look_at_lost(const Scene& scene, const B& body, int number) {
    const std::size_t all = body.lost + body.points.size();
    if (all == 0) return;
    judge(lost, scene.time, static_cast<double>(body.lost) / static_cast<double>(all), number, [&] {
      return Spot{Watched::nowhere,
                  shared_detail::join(body_of<Scene>(number), ": ", body.lost, " of ", all, " points")};
    });
  }

  template <int Width, class Scene, class L, class T, int D, ExtraColumns E>
  void look_at_strength(const Scene& scene, const Body<L, T, D, E>& body, int number) {
    using P = typename LawLanes<L, T, Width>::type;
    if constexpr (knows_yield<L, P, D>) {
      // Stresses much smaller than those of a strain of 1e-6 are round-off of larger ones.
      const P small(static_cast<T>(1e-6 * body.law.wave_modulus()));
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
                               size / (size + small);
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
      judge(strength, scene.time, worst.value, number, [&] {
        Spot s = at(body, worst.point);
        s.text = shared_detail::join(body_of<Scene>(number), " at ", written(body, worst.point));
        return s;
      });
    }
  }

  template <class Scene>
  static Spot fastest(const Scene& scene) {
    Spot s{Watched::nowhere, "no points are left"};
    double most = -1;
    int number = 0;
    scene.for_each_body([&](const auto& body, const auto&) {
      const auto speed = [&](std::size_t p) { return static_cast<double>(body.points.velocity[p].norm()); };
      const std::size_t p = extreme(body, speed);
      if (p < body.points.size() && speed(p) > most) {
        most = speed(p);
        s = at(body, p);
        s.text = shared_detail::join("the fastest point: ", body_of<Scene>(number), " at ", written(body, p),
                                     ", ", most, " m/s");
      }
      ++number;
    });
    return s;
  }

  /// The point with the greatest `f`; the number of points if there is none.
  template <class B, class F>
  static std::size_t extreme(const B& body, F&& f) {
    double most = -std::numeric_limits<double>::infinity();
    std::size_t found = body.points.size();
    for (std::size_t p = 0; p < body.points.size(); ++p)
      if (const double value = f(p); value > most) {
        most = value;
        found = p;
      }
    return found;
  }

  template <class B>
  static Spot at(const B& body, std::size_t p) {
    Spot s;
    if (p < body.points.size()) {
      const auto x = body.points.position[p];
      for (int k = 0; k < static_cast<int>(x.size()); ++k)
        s.place[static_cast<std::size_t>(k)] = static_cast<double>(x[k]);
    }
    return s;
  }
  template <class B>
  static std::string written(const B& body, std::size_t p) {
    return shared_detail::listed(body.points.position[p]) + " m";
  }

  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max() / 2;

  std::array<Watched, 5> seen_;
  std::vector<std::string> warnings_;
  std::size_t every_, next_ = 0, last_ = never;
  // Of the energy.
  Balance start_{};              // at the first look; without TrackEnergy: when points were last lost
  double put_in_ = 0;            // kinetic and strain energy at the first look, J
  double moved_ = 0;             // the greatest work from outside since then, J
  double floor_ = 0;             // what is less is a scene at rest, J
  double gain_ = 0;              // at the last look, J
  double lowest_ = 0;            // the least that it was at a look, J; without TrackEnergy: 0
  double before_ = 0;            // until points were last lost, J
  Held held_{}, held_before_{};  // after step held_step_ and the one before
  std::size_t held_step_ = never;
  bool follows_ = false;                        // whether the one before is known
  bool started_ = false;                        // whether it has looked
  std::size_t changes_ = 0, held_changes_ = 0;  // of the points: at the last look; at held_step_
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
