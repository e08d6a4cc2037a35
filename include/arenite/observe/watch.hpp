// Watch: an observer that looks at a run for what cannot be right, warns, and stops it at limits that the
// user sets.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/state_value.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/mesh/full_volume.hpp>
#include <arenite/observe/damped_fall.hpp>
#include <arenite/observe/watch_limits.hpp>
#include <arenite/observe/watched_energy.hpp>
#include <arenite/transfer/law_pass.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Observer that looks at a scene at its first call, then at every `limits.every`th step, and at the end of
/// `run`: a look costs a fifth to a half of a step. It wants to be called at every step. Past a limit it
/// throws `run_error` with time, quantity, value, limit and place; past a tenth it warns once (`on_warning`).
/// What it saw can be read from it afterwards. Observers behind it do not see the step at which it throws:
/// name it last. For one scene; it may be given to several runs of it.
template <bool OfRun>
class BasicWatch {
 public:
  /// Throws `error` unless all limits are positive.
  explicit BasicWatch(const WatchLimits& limits = {})
      : seen_{{{"energy_gain", "energy that nothing put in, over the energy put in", limits.energy_gain},
               {"transfer", "energy that the transfer took, over the energy put in", limits.transfer},
               {"residual", "energy booked nowhere, over the energy put in", limits.residual},
               {"volume", "change of a body's mean volume, |V/V0 - 1|", limits.volume},
               {"speed", "greatest speed of a point over the wave speed", limits.speed},
               {"strength", "stress beyond the yield surface, relative", limits.strength},
               {"lost", "share of a body's points that left the mesh", limits.lost}}},
        every_{limits.every} {
    for (const Watched& w : seen_)
      require(w.limit > 0, {"WatchLimits.", w.name}, w.limit,
              "must be positive; infinity switches it off");
    require(every_ > 0, "WatchLimits.every", every_, "must be positive");
  }

  template <class Scene>
  void operator()(const Scene& scene) {
    if (scene.steps >= next_)
      look(scene);
    else if (!tracks_energy<Scene> && scene.steps + 1 == next_ && wants_energy())
      energy_.remember(scene);
  }
  /// Looks at the end of a run, which may lie between two looks; `run` calls it.
  template <class Scene>
  void finish(const Scene& scene) {
    if (scene.steps != last_) look(scene);
  }

  /// Looks now.
  template <class Scene>
  [[gnu::cold]] void look(const Scene& scene) {
    if (wants(energy_gain) || (tracks_energy<Scene> && (wants(transfer) || wants(residual))))
      look_at_energy(scene);
    if constexpr (Scene::template has_part<LocalDamping>)
      if (hints_.damping) look_at_damping(scene);
    int number = 0;
    scene.for_each_body([&](const auto& body, const auto&) {
      if (hints_.spacing) look_at_spacing(scene, body, number);
      if (wants(volume) && body.points.size() > 0) look_at_volume(scene, body, number);
      if (wants(lost)) look_at_lost(scene, body, number);
      if (wants(speed)) look_at_speed(scene, body, number);
      // Initial stresses may lie outside: the first step takes them back.
      if constexpr (!OfRun)
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
    energy_.visit_state(f);
  }

  /// Each quantity with its greatest value so far, in the order of `WatchLimits`.
  const std::array<Watched, 7>& seen() const { return seen_; }
  /// The warnings given, in order: at most one a quantity.
  const std::vector<WarningText>& warnings() const { return warnings_; }

  /// Says nothing of local damping: the scene is brought to rest on purpose (`settle`).
  void accept_damping() { hints_.damping = false; }

 private:
  enum Quantity : std::size_t { energy_gain, transfer, residual, volume, speed, strength, lost };

  /// A point that shows a quantity most, and what to say of it.
  struct Spot {
    std::array<double, 3> place = Watched::nowhere;
    std::string text;
  };

  bool wants(Quantity q) const { return std::isfinite(seen_[q].limit); }
  bool wants_energy() const { return wants(energy_gain) || (wants(transfer) || wants(residual)); }

  /// Takes a value of a quantity; `spot()` gives the `Spot`, once there is something to say.
  [[gnu::cold]] void judge(Quantity q, double time, double value, int body,
                           const std::function<Spot()>& spot) {
    Watched& w = seen_[q];
    const bool stops = !(value <= w.limit) && (!OfRun || q == energy_gain || q == residual),
               worse = !(value <= w.worst);
    if (!stops && !worse) return;
    w.worst = value;
    w.time = time;
    w.body = body;
    w.place = Watched::nowhere;
    if (value <= w.limit / 10) return;
    const Spot at = spot();
    w.place = at.place;
    if (!stops && w.warned) return;
    const std::string text = joined_text({"t = ", time, " s: ", w.name, " = ", value, " (", w.meaning,
                                         OfRun && !stops ? "): above " : "): the limit is ",
                                         OfRun && !stops ? w.limit / 10 : w.limit, "; ", at.text});
    if (stops) throw run_error(text);
    w.warned = true;
    warnings_.emplace_back(text);
    warn(text);
  }

  template <class Scene>
  void look_at_energy(const Scene& scene) {
    const auto found = energy_.look(scene);
    if (!found.known) return;
    const auto spot = [&] { return fastest(scene); };
    if (wants(energy_gain)) judge(energy_gain, scene.time, found.gain, -1, spot);
    if constexpr (tracks_energy<Scene>) {
      if (wants(transfer)) judge(transfer, scene.time, found.transfer, -1, spot);
      if (wants(residual)) judge(residual, scene.time, found.residual, -1, spot);
    }
  }

  /// What messages call a body.
  template <class Scene>
  static std::string body_of(int number) {
    return joined_text({"body ", Scene::body_name(static_cast<std::size_t>(number))});
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
      s.text = joined_text({body_of<Scene>(number), ": mean V/V0 = ", ratio});
      if (p < body.points.size()) s.text += joined_text({", ", local(p), " at ", written(body, p)});
      return s;
    });
  }

  void hint(bool& wanted, std::string text) {
    wanted = false;
    warnings_.emplace_back(text);
    warn(text);
  }

  template <class Scene>
  void look_at_damping(const Scene& scene) {
    const double share = fall_.look(scene);
    if (share > 0.1)
      hint(hints_.damping,
           joined_text({
               "t = ", scene.time, " s: local damping took ", std::round(100 * share),
               " % of the work of gravity while matter fell freely: it is made for static states; "
               "switch it off (switch_off(), in Python switch_off_damping()) once the scene is at rest"}));
  }

  /// Warns of points that tension has drawn so far apart that their body may part between them.
  template <class Scene, class B>
  void look_at_spacing(const Scene& scene, const B& body, int number) {
    using Shape = typename Scene::Shape;
    const double density = body.law.density();
    const auto& points = body.points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double before = static_cast<double>(points.mass[p]) / density,
                   stretch = static_cast<double>(points.volume[p]) / before;
      if (!(stretch > 1.2) || !(trace(points.stress[p]) > 0)) continue;
      const auto cell =
          static_cast<double>(full_volume<typename Scene::Kinematics>(scene.mesh, points.cell[p]));
      const double spacing = stretch * std::pow(before / cell, 1.0 / Scene::D);
      if (!(spacing > bearing_spacing<Shape>)) continue;
      hint(hints_.spacing,
           joined_text({"t = ", scene.time, " s: ", body_of<Scene>(number), " at ", written(body, p),
                       ": tension has drawn points ", spacing, " of a cell apart (V/V0 = ", stretch,
                       "): beyond ", bearing_spacing<Shape>,
                       " a body may part between them, or from a wall; begin with more points a cell, or let "
                       "them split (SplitPoints)"}));
      return;
    }
  }

  template <class Scene, class B>
  void look_at_lost(const Scene& scene, const B& body, int number) {
    const std::size_t all = body.lost + body.points.size();
    if (all == 0) return;
    judge(lost, scene.time, static_cast<double>(body.lost) / static_cast<double>(all), number, [&] {
      return Spot{Watched::nowhere,
                  joined_text({body_of<Scene>(number), ": ", body.lost, " of ", all, " points"})};
    });
  }

  template <class Scene, class B>
  void look_at_speed(const Scene& scene, const B& body, int number) {
    const double wave = std::sqrt(body.law.wave_modulus() / body.law.density());
    const auto square = [&](std::size_t k) {
      return static_cast<double>(body.points.velocity[k].squaredNorm());
    };
    const std::size_t p = extreme(body, square);
    if (p >= body.points.size()) return;
    const double fastest = std::sqrt(square(p));
    judge(speed, scene.time, fastest / wave, number, [&] {
      Spot s = at(body, p);
      s.text = joined_text({
          body_of<Scene>(number), " at ", written(body, p), ": ", fastest, " m/s; waves run at ", wave,
          " m/s: is young, density, a velocity or gravity in other units than Pa, kg, m, s?"});
      return s;
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
        s.text = joined_text({body_of<Scene>(number), " at ", written(body, worst.point)});
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
        s.text = joined_text({"the fastest point: ", body_of<Scene>(number), " at ", written(body, p), ", ",
                             most, " m/s"});
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
    return joined_text({vector_text(body.points.position[p]), " m"});
  }

  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max() / 2;

  struct Hints {
    bool damping = true, spacing = true;  // whether still to be given
  };

  std::array<Watched, 7> seen_;
  Hints hints_;
  DampedFall fall_;
  std::vector<WarningText> warnings_;
  std::size_t every_, next_ = 0, last_ = never;
  WatchedEnergy energy_;
};

/// A watch to hand to `run`.
using Watch = BasicWatch<false>;
/// The one that `run` has of its own: it does not look at strength, which would be compiled for each law.
using WatchOfRun = BasicWatch<true>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
