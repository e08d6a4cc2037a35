// Parameters that vary by point: members of the history that the law does not change, given as functions of
// the position when a body is filled.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

/// Linear elasticity whose moduli are those of a unit solid times a number of each point.
class Graded {
 public:
  template <class T>
  struct History {
    T young{1};  // Pa
    static constexpr std::array names{"young"};
    auto members() { return std::tie(young); }
    auto members() const { return std::tie(young); }
  };

  Graded(double density, double poisson) : unit_{"Graded", density, 1, poisson} {}
  double density() const { return unit_.density(); }
  double wave_modulus() const { return unit_.wave_modulus(); }
  template <class T, int D>
  T wave_modulus(const Sym<T, D>&, const History<T>& history) const {
    return T(unit_.wave_modulus()) * history.young;
  }
  template <class T, int D>
  T update(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    stress = turned(stress, step.spin) + unit_.stress(step.strain) * history.young;
    return T(0);
  }
  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress, const History<T>& history) const {
    return unit_.energy(stress) / history.young;
  }

 private:
  Elasticity unit_;
};

/// Friction whose slope is a number of each point.
struct FrictionByPoint {
  template <class T>
  struct History {
    T slope{0};  // tan(phi)
    static constexpr std::array names{"friction_slope"};
    auto members() { return std::tie(slope); }
    auto members() const { return std::tie(slope); }
  };
  template <class T, int D>
  T slope(double, const StrainStep<T, D>&, const History<T>& history) const {
    return history.slope;
  }
};

}  // namespace

TEST_CASE("A bar whose Young's modulus grows as (1 + x / L)^2 vibrates at the frequency of its equation") {
  // (M s^2 u')' + (omega / c0)^2 L^2 M u = 0 in s = 1 + x / L, u(1) = u(2) = 0:
  // u = sin(beta ln s) / sqrt(s) with beta = pi / ln 2, (omega L / c0)^2 = beta^2 + 1/4.
  const double length = 1, density = 1000, young = 1e5, speed = 0.01;
  const Graded law{density, 0.25};
  const double c0 = std::sqrt(young * law.wave_modulus() / density), beta = pi / std::log(2.0);
  const double omega = c0 / length * std::sqrt(beta * beta + 0.25);
  const auto mode = [&](double x) {
    return std::sin(beta * std::log(1 + x / length)) / std::sqrt(1 + x / length);
  };
  double last = 0;
  for (const int cells : {20, 40}) {
    const double h = length / cells;
    Scene scene{
        PlaneStrain{},
        CartesianGrid<2>{{.lower = {0, 0}, .upper = {length, h}, .cell = h}},
        Numerics<QuadraticBSpline, Flip, Usl>{},
        bodies(
            fill(Box{{0., 0.}, {length, h}}, law,
                 {.history = {{"young", [&](const auto& x) { return young * square(1 + x[0] / length); }}}})),
        walls(left(roller), right(roller), bottom(roller), top(roller)),
        TrackEnergy{}};
    // The wave of the stiffest point: twice as fast as at the soft end.
    CHECK(stable_step(scene) == Approx(h / (2 * c0) / std::sqrt(6)).epsilon(0.02));
    auto& points = scene.body().points;
    std::vector<double> shape;
    for (std::size_t p = 0; p < points.size(); ++p) {
      shape.push_back(mode(points.position[p][0]));
      points.velocity.set(p, Vec<double, 2>(speed * shape[p], 0));
    }
    const double kinetic = kinetic_energy(scene.body());
    double worst = 0, stored = 0;
    run(scene, {.end = 2 * 2 * pi / omega, .courant = 0.5}, [&](const auto& s) {
      double top = 0, bottom = 0;
      for (std::size_t p = 0; p < points.size(); ++p) {
        top += shape[p] * points.velocity[p][0];
        bottom += shape[p] * shape[p];
      }
      const double t = s.steps > 0 ? s.time - s.time_step / 2 : 0;
      worst = std::max(worst, std::abs(top / bottom / speed - std::cos(omega * t)));
      stored = std::max(stored, strain_energy(s.body()));
    });
    CAPTURE(worst, stored / kinetic);
    if (cells == 40) {
      CHECK(worst <= 0.03);
      CHECK(std::abs(std::log2(last / worst) - 2) <= 0.3);  // of second order, as the period of a plain bar
    }
    CHECK(stored / kinetic == Approx(1).epsilon(0.01));
    last = worst;
  }
}

TEST_CASE("Friction that grows with depth: each point is sheared to the strength of its depth") {
  const auto slope = [](const std::array<double, 3>& x) { return 0.3 + 0.5 * (1 - x[1]); };
  const MohrCoulombParameters sand{.density = 1500, .young = 1e7, .poisson = 0.3, .friction = 30_deg};
  const DruckerPragerParameters grains{
      .density = 1500, .young = 1e7, .poisson = 0.3, .friction = 30_deg, .cone = Cone::plane_strain};
  const auto check = [&](const auto& law, int steps, double tolerance) {
    auto body = make_body<PlaneStrain>(
        CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}},
        fill(Box{{0., 0.}, {1., 1.}}, law,
             {.stress = Geostatic{.surface = 1.1, .k0 = 0.6}, .history = {{"friction_slope", slope}}}),
        {.gravity = {0, -9.81, 0}});
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      auto stress = body.points.stress[p];
      auto history = body.points.load_history(p);
      StrainStep<double, 2> step;
      step.strain[3] = 1e-5;
      for (int k = 0; k < steps; ++k) law.update(stress, step, history);
      const auto x = body.points.position[p];
      const double sin = std::sin(std::atan(slope({x[0], x[1], 0})));
      const double radius = std::hypot((stress[0] - stress[1]) / 2, stress[3]);
      CHECK(radius / (-(stress[0] + stress[1]) / 2 * sin) == Approx(1).epsilon(tolerance));
      CHECK(std::abs(law.yield(stress, history)) <= 1e-13);
    }
  };
  check(MohrCoulomb{sand, ForgetsOpening{}, FrictionByPoint{}}, 1000, 1e-12);
  check(MohrCoulomb{sand, RemembersOpening{}, FrictionByPoint{}}, 1000, 1e-12);
  check(DruckerPrager{grains, ForgetsOpening{}, FrictionByPoint{}}, 3000, 1e-6);
}

TEST_CASE(
    "A column whose friction grows with depth collapses without a stress beyond the strength of its points") {
  const auto slope = [](const std::array<double, 3>& x) { return 0.2 + 0.8 * (1 - x[1]); };
  const MohrCoulomb law{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 30_deg},
                        RemembersOpening{},
                        FrictionByPoint{}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 1.2}, .cell = 0.1}},
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(Box{{0., 0.}, {0.5, 1.}}, law, {.history = {{"friction_slope", slope}}})),
              walls(left(roller), bottom(fixed)),
              gravity({0, -9.81})};
  Watch watch{{.every = 1}};
  run(scene, {.end = 0.1, .courant = 0.5}, watch);
  const Watched& strength = watch.seen()[5];
  CHECK(strength.name == "strength");
  CHECK(strength.worst <= 1e-12);
  // Friction went with the points as they changed cells and places.
  const auto& points = scene.body().points;
  double least = 1, most = 0;
  for (const double value : points.history[1]) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  CHECK(least == Approx(slope({0, 0.975, 0})));
  CHECK(most == Approx(slope({0, 0.025, 0})));
}

TEST_CASE("A member that the history does not have, or a value that is none, is refused") {
  const auto message = [](const auto& law, auto history) -> std::string {
    try {
      Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}},
                  Numerics<QuadraticBSpline, Flip>{},
                  bodies(fill(Box{{0., 0.}, {1., 1.}}, law, {.history = {history}}))};
    } catch (const error& e) {
      return e.what();
    }
    return "";
  };
  using Value = std::pair<std::string, std::function<double(const std::array<double, 3>&)>>;
  const Graded law{1000, 0.3};
  CHECK(message(law, Value{"yuong", [](const auto&) { return 1.0; }}) ==
        "FillOptions.history = yuong: must be one of: young");
  CHECK(message(law, Value{"young", [](const auto& x) { return 1 / (x[2] - x[2]); }}) ==
        "FillOptions.history, young = inf: must be finite");
  CHECK(message(law, Value{"young", [](const auto&) { return 2.0; }}).empty());
  CHECK(message(LinearElastic{{.density = 1, .young = 1, .poisson = 0}},
                Value{"young", [](const auto&) { return 1.0; }}) ==
        "FillOptions.history = young: the law's history has no member with a name");
}
