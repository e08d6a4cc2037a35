// How a random scene ended, and the laws of nature that say whether it may end so.
#pragma once

#include <arenite/observe/energy.hpp>
#include <arenite/watch/watch.hpp>

#include "draw.hpp"

namespace arenite::extremes {

/// The first five are sound, the others are faults.
enum class Ending {
  sound,    ///< ran to its end, laws kept
  damped,   ///< the same, but the transfer took more than a tenth of the energy
  left,     ///< the same, but points left the mesh
  stopped,  ///< run_error that names the time
  refused,  ///< error when it was made
  gained,   ///< ended with energy from nowhere
  pushed,   ///< ended with momentum from nowhere
  nan,      ///< ended with numbers that are not finite
  empty,    ///< ended without any point, in silence
  untyped   ///< an exception of another kind, or without the time
};
inline constexpr std::array<const char*, 10> ending_names{"sound",  "damped", "left", "stopped", "refused",
                                                          "GAINED", "PUSHED", "NAN",  "EMPTY",   "UNTYPED"};
inline bool is_fault(Ending e) { return e >= Ending::gained; }

struct Outcome {
  Ending ending = Ending::sound;
  /// Residual, and what the law gave beyond what it had stored, over the energy put in, -.
  double energy = 0;
  double momentum = 0;         ///< error over its bound, -
  double volume = 1;           ///< largest mean V / V0 of a body
  double least = 1, most = 1;  ///< V / V0 of points, as the run ended, -
  double thinnest = 1;         ///< size of the smallest cell over the edge drawn, -
  double speed = 0;            ///< of the fastest point at the start, m/s
  double rigid = 0;          ///< mass of the heaviest rigid body over that of all matter; 0: none has a mass
  std::size_t per_cell = 0;  ///< most points in a cell at the start
  std::size_t lost = 0;
  std::size_t steps = 0;
  std::string message{};
  std::string scene{};  ///< the type of the scene, as the compiler writes it
  std::string text() const {
    return joined_text({ending_names[static_cast<std::size_t>(ending)],
                        " energy=",
                        energy,
                        " momentum=",
                        momentum,
                        " V/V0=",
                        volume,
                        " lost=",
                        lost,
                        " steps=",
                        steps,
                        " J=",
                        least,
                        " to ",
                        most,
                        " thinnest=",
                        thinnest,
                        " points=",
                        per_cell,
                        " speed=",
                        speed,
                        " rigid=",
                        rigid,
                        message.empty() ? "" : " | ",
                        message});
  }
};

/// Observer that records the balances of a scene, and ends the run after `steps`.
template <class Scene>
class Books {
 public:
  struct Enough {};

  Books(std::size_t steps, double cell) : steps_{steps}, cell_{cell} {}

  void operator()(const Scene& scene) {
    check_momentum(scene);
    const Energies e = energies(scene);
    external_ = std::max(external_, std::abs(e.external));
    // The energy of a fall by a hundredth of a cell is negligible: the scene is at rest.
    double creep = 0;
    scene.for_each_body([&](const auto& body, const auto&) { creep += 0.01 * cell_ * mass(body); });
    creep *= static_cast<double>(scene.acceleration().norm());
    double strain = 0, brought = 0;  // of points inserted
    scene.for_each_body([&](const auto& body, const auto&) {
      strain += body.inserted.strain_energy;
      brought += body.inserted.strain_energy + body.inserted.kinetic_energy;
    });
    const auto& balance = scene.template part<TrackEnergy>();
    const double given = std::max(balance.initial() + external_ + brought, creep);
    kinetic_ = std::max(kinetic_, e.kinetic);
    // Round-off of the sums of energies.
    const double floor = static_cast<double>(scene.steps) * epsilon * (kinetic_ + e.strain + given);
    // The law cannot give back more than it had stored.
    const double gain = e.residual - e.transfer - e.walls - e.lag +
                        std::max(0.0, -balance.stress_work - balance.initial_strain - strain);
    outcome.energy = std::abs(gain) <= floor ? 0 : gain / std::max(given, floor);
    outcome.steps = scene.steps;
    outcome.lost = scene.lost_points();
    scene.for_each_body([&](const auto& body, const auto&) {
      outcome.volume = std::max(outcome.volume, mean_volume_ratio(body));
    });
    if (scene.steps >= steps_) throw Enough{};
  }

  Outcome outcome{};

 private:
  using V = Vec<double, Scene::D>;
  static constexpr double epsilon = std::numeric_limits<typename Scene::T>::epsilon();

  /// Impulse on the matter in the last step, N s, of a part that gives it: a load, an absorbing or frictional
  /// face.
  template <class Part>
  static V impulse_of(const Part& part, double dt) {
    if constexpr (requires { part.given_impulse(); })
      return part.given_impulse().template cast<double>();
    else if constexpr (requires { part.force(); })
      return dt * part.force().template cast<double>();
    else
      return V::Zero();
  }

  /// The momentum of points and free rigid bodies must be the previous one plus that from gravity, loads,
  /// walls, other rigid bodies and inserted and removed points. The balance restarts after points have left.
  /// Radial momentum is not conserved in axisymmetry.
  void check_momentum(const Scene& scene) {
    V now = V::Zero(), joined = V::Zero();
    // Of the last step: points were inserted and removed after it.
    V given = mass_ * scene.time_step * acceleration_;
    acceleration_ = scene.acceleration().template cast<double>();  // of the step to come
    double carried = 0, limited = 0, pushed = 0;
    mass_ = 0;
    scene.for_each_body([&](const auto& body, const auto&) {
      Vec<long double, Scene::D> own =
          Vec<long double, Scene::D>::Zero();  // many equal parts would round alike
      mass_ += mass(body);
      joined += body.inserted.momentum - body.removed.momentum;
      for (std::size_t p = 0; p < body.points.size(); ++p) {
        own += static_cast<long double>(body.points.mass[p]) *
               body.points.velocity[p].template cast<long double>();
        const auto& s = body.points.stress[p];
        const double size = static_cast<double>(scene.mesh.size(body.points.cell[p]));
        carried += static_cast<double>(body.points.mass[p] * body.points.velocity[p].norm());
        // The affine part gives each node a share; the shares sum to zero up to round-off.
        if constexpr (Scene::NumericsType::Transfer::affine)
          carried +=
              static_cast<double>(body.points.mass[p] * body.points.velocity_gradient[p].norm()) * cell_;
        pushed += static_cast<double>(body.points.volume[p]) *
                  std::sqrt(static_cast<double>(contract(s, s))) / size * scene.time_step;
      }
      now += own.template cast<double>();
    });
    limited = scene.limited_momentum;
    V outside = scene.wall_impulse.template cast<double>();
    scene.for_each_rigid([&](const auto& body) {
      if constexpr (requires { body.motion.angular_momentum(); }) {  // a `Free` one
        const V own = body.motion.mass * body.velocity.template cast<double>();
        now += own;
        carried += own.norm();
        mass_ += body.motion.mass;
      } else {
        outside -= body.impulse.template cast<double>();
      }
    });
    V pressed = V::Zero();
    scene.for_each_part([&](const auto& part) {
      const V impulse = impulse_of(part, scene.time_step);
      pressed += impulse;
      pushed += impulse.norm();
    });
    given += pressed;
    if (scene.steps == 0 || scene.lost_points() != lost_) {
      lost_ = scene.lost_points();
      expected_ = now;
      scale_ = 0;
      carried_ = carried;
      limited_ = limited;
      since_ = scene.steps;
    } else {
      const V from_outside = outside - outside_;
      const V from_points = joined - joined_;  // apart: the sums may be far larger than what changes
      expected_ += given + from_outside + from_points;
      scale_ += pushed + given.norm() + from_outside.norm();
      carried_ = std::max(carried_, carried);
      V error = now - expected_;
      if constexpr (Scene::Kinematics::hoop) error[0] = 0;
      const double bound = epsilon * (64 * scale_ + 16 * static_cast<double>(scene.steps - since_) *
                                                        (carried_ + outside.norm())) +
                           2 * (limited - limited_);
      const double over = error.norm() / bound;
      if (!(over <= outcome.momentum) && (bound > 0 || error.norm() > 0)) outcome.momentum = over;
    }
    outside_ = outside;
    joined_ = joined;
  }

  std::size_t steps_, lost_ = 0, since_ = 0;
  double cell_, external_ = 0, kinetic_ = 0, scale_ = 0, carried_ = 0, limited_ = 0, mass_ = 0;
  V acceleration_ = V::Zero(), expected_ = V::Zero(), outside_ = V::Zero(), joined_ = V::Zero();
};

template <class Scene>
std::string type_of_scene() {
  return __PRETTY_FUNCTION__;
}

/// Records the initial state of a scene: type, smallest cell, speed, points per cell, mass of rigid bodies.
template <class Scene>
void see_start(const Scene& scene, double cell, Outcome& o) {
  o.scene = type_of_scene<Scene>();
  for (Index c = 0; c < scene.mesh.cell_count(); ++c)
    o.thinnest = std::min(o.thinnest, static_cast<double>(scene.mesh.size(c)) / cell);
  double matter = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    matter += mass(body);
    for (std::size_t p = 0; p < body.points.size(); ++p)
      o.speed = std::max(o.speed, static_cast<double>(body.points.velocity[p].norm()));
    for (Index c = 0; c < scene.mesh.cell_count(); ++c)
      o.per_cell = std::max(o.per_cell, static_cast<std::size_t>(body.cells[c].size()));
  });
  scene.for_each_rigid([&](const auto& body) {
    if constexpr (requires { body.motion.mass; })
      o.rigid = std::max(o.rigid, static_cast<double>(body.motion.mass) / matter);
  });
}

/// Records the final volumes of a scene; returns whether all of its numbers are finite.
template <class Scene>
bool see_end(const Scene& scene, Outcome& o) {
  bool finite = true;
  scene.for_each_body([&](const auto& body, const auto&) {
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      finite = finite && is_finite(body.points, p);
      const double ratio = static_cast<double>(body.points.volume[p]) * body.law.density() /
                           static_cast<double>(body.points.mass[p]);
      o.least = std::min(o.least, ratio);
      o.most = std::max(o.most, ratio);
    }
  });
  return finite;
}

/// Runs a scene for the steps of its draw, with the watch that a user would have on, and judges it. Sand may
/// fly apart and points may leave the mesh: the watch has no limits there. `make`: returns the scene.
template <class Make>
Outcome judge(Draw& d, Make&& make) {
  using Scene = decltype(make());
  Books<Scene> books(static_cast<std::size_t>(d.steps), d.cell);
  Outcome& o = books.outcome;
  const auto end_with = [&](Ending ending, const std::string& message = "") {
    o.ending = ending;
    o.message = message;
    return o;
  };
  bool running = false;
  try {
    Scene scene = make();
    see_start(scene, d.cell, o);
    const double step = d.courant * stable_step(scene);
    running = true;
    constexpr double any = std::numeric_limits<double>::infinity();
    Watch watch({.volume = any, .speed = any, .lost = any, .every = 8});
    try {
      run(scene, {.end = d.steps * step, .courant = d.courant}, books, watch);
    } catch (const typename Books<Scene>::Enough&) {
      watch.look(scene);
    }
    const bool finite = see_end(scene, o);
    if (!finite || !std::isfinite(o.energy)) return end_with(Ending::nan);
    if (scene.point_count() == 0) return end_with(Ending::empty);
  } catch (const run_error& e) {
    return end_with(
        running && std::string_view(e.what()).starts_with("t = ") ? Ending::stopped : Ending::untyped,
        e.what());
  } catch (const error& e) {
    return end_with(running ? Ending::untyped : Ending::refused, e.what());
  } catch (const std::exception& e) {
    return end_with(Ending::untyped, e.what());
  }
  if (!(o.momentum <= 1)) return end_with(Ending::pushed);
  if (!(o.energy <= 0.1)) return end_with(Ending::gained);
  if (o.lost > 0) return end_with(Ending::left);
  return end_with(o.energy < -0.1 ? Ending::damped : Ending::sound);
}

}  // namespace arenite::extremes
