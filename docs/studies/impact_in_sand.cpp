// Balls and rods with a conical tip dropped into loose glass beads, axisymmetric, beside what experiments
// found: depths, exponents and prefactor of their laws, and the inertial part of the force. Each number at
// three sizes of the cells, with the uncertainty that they tell. Writes what docs/validation.py puts into
// docs/validation.md:
//
//   c++ -O3 -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/impact_in_sand.cpp -o
//   impact &&
//   ./impact
//
// Some five minutes on two cores.
#include <Eigen/Dense>
#include <arenite/arenite.hpp>
#include <arenite/error_bar/convergence.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "../../tests/support/validation.hpp"

using namespace arenite;

namespace {

constexpr double g = 9.81, bulk = 1520, inch = 0.0254;
const double repose = 24_deg;  // angle of repose of the beads

/// What falls. SI units.
struct Projectile {
  AnyDistance distance;  ///< its lowest point at the origin
  double diameter, mass, height;
};

Projectile ball(double diameter, double density) {
  return {AnyDistance::of<2>(Ball({0., diameter / 2}, diameter / 2)), diameter,
          density * pi / 6 * std::pow(diameter, 3), diameter};
}

/// A cylinder of that length with a cone of 60 degrees below it.
Projectile rod(double diameter, double length, double density) {
  const double cone = diameter / 2 / std::tan(30_deg), area = pi * diameter * diameter / 4;
  return {AnyDistance::of<2>(ConeCylinder{{.radius = diameter / 2, .apex = 60_deg, .length = cone + length}}),
          diameter, density * area * (length + cone / 3), cone + length};
}

/// The way of a projectile in the beads until it stops, a row for each step.
struct Impact {
  std::vector<double> time, depth, speed;
  double last_depth() const { return depth.back(); }
  double stopping_time() const { return time.back(); }
};

/// A fall from `height` above the surface; `deep`: of the beads, m.
Impact fall(const Projectile& p, double height, double deep, double cell) {
  const auto whole = [&](double x) { return cell * std::round(x / cell); };
  const double radius = 4 * p.diameter, speed = std::sqrt(2 * g * height);
  const MohrCoulomb beads{{.density = bulk, .young = 1e6, .poisson = 0.3, .friction = repose}};
  Scene scene{
      Axisymmetric{},
      CartesianGrid<2>{
          {.lower = {0, -whole(deep)}, .upper = {whole(radius), whole(2 * p.diameter)}, .cell = cell}},
      Numerics<QuadraticBSpline, Apic>{},
      bodies(fill<"beads">(Box{{0., -deep}, {radius, 0.}}, beads,
                           {.stress = Geostatic{.surface = 0, .k0 = 0.5}})),
      walls(bottom(fixed), left(roller), right(roller)),
      rigids(rigid<"projectile">(DistanceSurface{p.distance}, Guided{.mass = p.mass, .velocity = -speed},
                                 Friction(repose))),
      gravity({0, -g})};
  Impact impact{{0}, {0}, {speed}};
  run(scene, {.end = 1, .courant = 0.8}, [&](const auto& s) {
    const auto& body = s.template rigid<"projectile">();
    impact.time.push_back(s.time);
    impact.depth.push_back(-body.displacement[1]);
    impact.speed.push_back(-body.velocity[1]);
    return body.velocity[1] < 0 ? RunFlow::go_on : RunFlow::stop;
  });
  return impact;
}

/// Depth of a ball, m: d = 0.14 / mu (rho_b / rho_g)^(1/2) D^(2/3) H^(1/3), H = height + d.
double measured(double diameter, double density, double height) {
  double d = height;
  for (int k = 0; k < 100; ++k)
    d = 0.14 / std::tan(repose) * std::sqrt(density / bulk) * std::pow(diameter, 2.0 / 3) *
        std::cbrt(height + d);
  return d;
}

/// Least squares of rows [n, k] against `right` [n]: the k factors.
std::vector<double> least_squares(const std::vector<std::vector<double>>& rows,
                                  const std::vector<double>& right) {
  Eigen::MatrixXd a(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.front().size()));
  Eigen::VectorXd b(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    b[i] = right[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < a.cols(); ++k)
      a(i, k) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  }
  const Eigen::VectorXd x = a.colPivHouseholderQr().solve(b);
  return {x.data(), x.data() + x.size()};
}

/// Numbers by their names, at each size of the cells, in the order in which they came.
class Numbers {
 public:
  void add(const std::string& name, const std::string& unit, double reference, double size, double value) {
    if (!results_.contains(name)) order_.push_back({name, unit, reference});
    results_[name].push_back({size, value});
  }
  /// The finest value of each beside its reference, with the uncertainty in its name.
  void write(test::Validation& validation, const std::string& composition) const {
    for (const auto& [name, unit, reference] : order_) {
      const Convergence c = convergence(results_.at(name));
      std::printf("%s: %.4g +- %.2g %s (measured %.4g)%s\n", name.c_str(), c.value(), c.uncertainty,
                  unit.c_str(), reference, c.converged ? "" : ", not converged");
      char bar[64];
      std::snprintf(bar, sizeof bar, " +- %.2g%s", c.uncertainty, c.converged ? "" : " (not converged)");
      validation.value(composition, name + bar, unit, c.value(), reference);
    }
  }

 private:
  struct Name {
    std::string name, unit;
    double reference;
  };
  std::vector<Name> order_;
  std::map<std::string, std::vector<SizedResult>> results_;
};

/// `curves`: where the depths go, too, if they are to be drawn.
void balls(double share, Numbers& depths, Numbers& laws, test::Validation* curves) {
  std::vector<std::vector<double>> rows;
  std::vector<double> logs, speeds, steel_depths, times;
  std::vector<std::vector<double>> forces;
  std::vector<double> decelerations;
  const auto drop = [&](double diameter, double density, double height) {
    const Impact impact = fall(ball(diameter, density), height, 6 * diameter, diameter * share);
    const double d = impact.last_depth();
    rows.push_back({1, std::log(height + d), std::log(density / bulk), std::log(diameter)});
    logs.push_back(std::log(d));
    return impact;
  };
  for (const double density : {700.0, 2500.0, 7800.0})
    for (const double height : {0.05, 0.2, 0.5}) {
      const Impact impact = drop(inch, density, height);
      depths.add(joined_text({"depth of a ball of ", density, " kg/m3 from ", height, " m"}), "mm",
                 1e3 * measured(inch, density, height), share, 1e3 * impact.last_depth());
      if (curves)
        curves->point(joined_text({density, " kg/m3"}), "drop distance [m]", height + impact.last_depth(),
                      "depth [mm]", 1e3 * impact.last_depth(), 1e3 * measured(inch, density, height));
      if (density < 7800) continue;
      speeds.push_back(impact.speed.front());
      steel_depths.push_back(impact.last_depth());
      times.push_back(impact.stopping_time());
      // Deceleration + g = (k / m) z + v^2 / d1, the mean over some 2 ms, once the ball is half in.
      constexpr double window = 2e-3;
      for (std::size_t i = 0, j = 0; i < impact.time.size(); i = j) {
        j = i;
        while (j < impact.time.size() && impact.time[j] - impact.time[i] < window) ++j;
        if (j == impact.time.size()) break;
        const double v = (impact.speed[i] + impact.speed[j]) / 2, z = (impact.depth[i] + impact.depth[j]) / 2;
        if (z < inch / 2) continue;
        forces.push_back({z, v * v});
        decelerations.push_back((impact.speed[i] - impact.speed[j]) / (impact.time[j] - impact.time[i]) + g);
      }
    }
  for (const double diameter : {inch / 2, 2 * inch}) drop(diameter, 2500, 0.2);
  const auto law = least_squares(rows, logs);
  laws.add("exponent of the drop distance (balls)", "-", 1.0 / 3, share, law[1]);
  laws.add("exponent of the ball's density", "-", 0.5, share, law[2]);
  laws.add("exponent of the ball's diameter", "-", 2.0 / 3, share, law[3]);
  // With the exponents of the experiment, so that it has the unit m^0.
  double prefactor = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    prefactor += std::exp(logs[i] - rows[i][1] / 3 - rows[i][2] / 2 - 2 * rows[i][3] / 3) * std::tan(repose) /
                 static_cast<double>(rows.size());
  laws.add("prefactor of the depth times mu", "-", 0.14, share, prefactor);
  const auto drag = least_squares(forces, decelerations);
  laws.add("d1 over the diameter (steel ball)", "-", 3.4, share, 1 / drag[1] / inch);
  laws.add("stopping time from 0.5 m over that from 0.2 m (steel ball)", "-", 1, share, times[2] / times[1]);
}

void rods(double share, Numbers& laws) {
  constexpr double diameter = inch / 2;
  std::vector<std::vector<double>> rows;
  std::vector<double> logs;
  const auto drop = [&](double length, double height) {
    const double d = fall(rod(diameter, length, 2700), height, 16 * diameter, diameter * share).last_depth();
    rows.push_back({1, std::log(height + d), std::log(length)});
    logs.push_back(std::log(d));
  };
  for (const double height : {0.1, 0.2, 0.4}) drop(0.1, height);
  drop(0.05, 0.2);
  const auto law = least_squares(rows, logs);
  laws.add("exponent of the drop distance (rods)", "-", 1.0 / 3, share, law[1]);
  laws.add("exponent of the rod's length", "-", 0.5, share, law[2]);
}

}  // namespace

int main() {
  test::Validation of_balls("ball_in_sand", "measured"), of_laws("impact_laws", "measured");
  Numbers depths, laws;
  constexpr double finest = 1.0 / 20;
  for (const double share : {1.0 / 10, 1.0 / 14, finest}) {
    balls(share, depths, laws, share == finest ? &of_balls : nullptr);
    rods(share, laws);
  }
  depths.write(of_balls, "cells of a 20th of the diameter");
  laws.write(of_laws, "cells of a 20th of the diameter");
}
