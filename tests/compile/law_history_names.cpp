// must print: law: History::names must be a static constexpr std::array with a name for each of members()
// A history with two members and one name.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  template <class T>
  struct History : NoHistory<T> {
    T a{}, b{};
    static constexpr std::array names{"a"};
    auto members() { return std::tie(a, b); }
    auto members() const { return std::tie(a, b); }
  };
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
