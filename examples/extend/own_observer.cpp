// An observer of your own: any callable that takes the scene as const, here an object that also wants to
// know the end of the run. It measures the period of a bar that vibrates along its axis: T = 4 L / c.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/extend/own_observer.cpp -o own_observer -pthread && ./own_observer
//   prints: period 0.01259 s, exact 0.01265 s
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

/// Times at which the mean velocity of the body changes sign, and the period that follows from them.
class PeriodMeter {
 public:
  // At the start, and after each step.
  template <class Scene>
  void operator()(const Scene& scene) {
    const double velocity = momentum(scene.body())[0] / mass(scene.body());
    if (scene.steps > 0 && velocity * before_ < 0)
      crossings_.push_back(scene.time - scene.time_step * velocity / (velocity - before_));
    before_ = velocity;
  }

  // Optional: once, when the run has reached its end.
  template <class Scene>
  void finish(const Scene&) {
    if (crossings_.size() > 1)
      period_ = 2 * (crossings_.back() - crossings_.front()) / static_cast<double>(crossings_.size() - 1);
  }

  double period() const { return period_; }  // s; 0: not known

 private:
  double before_ = 0, period_ = 0;
  std::vector<double> crossings_;
};

int main() {
  const double length = 1, young = 100_MPa, density = 1000, exact = 4 * length / std::sqrt(young / density);
  const LinearElastic bar{{.density = density, .young = young, .poisson = 0}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1.2, 0.1}, .cell = 0.05}},
              Numerics<QuadraticBSpline, Flip, Usl>{},
              bodies(fill(Box{{0, 0}, {length, 0.1}}, bar, {.per_cell = 4, .velocity = {0.1, 0, 0}})),
              walls(left(roller), bottom(roller), top(roller))};
  PeriodMeter meter;
  run(scene, {.end = 3 * exact}, meter);
  std::printf("period %.5f s, exact %.5f s\n", meter.period(), exact);
  return std::abs(meter.period() / exact - 1) < 0.01 ? 0 : 1;
}
