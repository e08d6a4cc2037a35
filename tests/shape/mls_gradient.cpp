// Splines with gradients of moving least squares: linear fields, the formula of MLS-MPM, balance up to the faces.
#include <arenite/arenite.hpp>

#include "grids.hpp"

using namespace arenite;
using namespace arenite::test;

TEMPLATE_TEST_CASE("MLS gradients: unity, linear fields and their gradients", "", double, float) {
  check_completeness<MlsGradient<QuadraticBSpline>, TestType, false>();
  check_completeness<MlsGradient<CubicBSpline>, TestType, false>();
}

TEST_CASE("MLS gradients: in the inner cells those of MLS-MPM, 4 w (x_i - x) / h^2 and 3 w (x_i - x) / h^2") {
  const double h = 0.5;
  const auto check = [h]<class Spline>(std::type_identity<Spline>, double inverse) {
    const auto g = grid<2>({9, 9}, h);
    const typename MlsGradient<Spline>::template Cell<CartesianGrid<2>> cell(g, 40);
    const typename Spline::template Cell<CartesianGrid<2>> spline(g, 40);
    for (const Vec<double, 2>& x : {Vec<double, 2>(2.05, 2.3), Vec<double, 2>(2.4, 2.01)}) {
      const auto w = cell.weights(x);
      CHECK(w == spline.weights(x));
      const auto gradient = cell.gradients(x), node = cell.node_positions();
      for (int i = 0; i < w.size(); ++i)
        CHECK((gradient.col(i) - inverse * w[i] * (node.col(i) - x) / (h * h)).norm() < 1e-14 / h);
    }
  };
  check(std::type_identity<QuadraticBSpline>{}, 4);
  check(std::type_identity<CubicBSpline>{}, 3);
  CHECK(std::abs(steepest<MlsGradient<QuadraticBSpline>>() - 4) < 1e-12);
  CHECK(std::abs(steepest<MlsGradient<CubicBSpline>>() - 3) < 1e-12);
}

TEST_CASE("MLS gradients: a uniform stress is in balance up to the walls") {
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  const auto pressure = [](const auto&) { return std::array<double, 6>{-1e4, -1e4, -1e4}; };
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 0.75}, .cell = 0.125}},
              Numerics<MlsGradient<QuadraticBSpline>, Apic, Usl>{},
              bodies(fill(Box{{0, 0}, {1, 0.75}}, rubber, {.per_cell = 4, .stress = pressure})),
              walls(bottom(roller), top(roller), left(roller), right(roller))};
  const double dt = stable_step(scene), free_fall = 1e4 / 1000 / 0.125 * dt;
  step(scene, dt);
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) CHECK(points.velocity[p].norm() <= 1e-12 * free_fall);
}

static_assert(shape_function<MlsGradient<QuadraticBSpline>, CartesianGrid<2>> &&
              shape_function<MlsGradient<QuadraticBSpline>, CartesianGrid<3, float>> &&
              !shape_function<MlsGradient<CubicBSpline>, SimplexMesh<2>>);
