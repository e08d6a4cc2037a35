// Cost of each law for one point: per width of the packs, scalar, dimension and memory; on elastic states and
// on states of which 60 % yield; Mohr-Coulomb and Drucker-Prager beside hand-written scalar rivals.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "counting.hpp"
#include "law_states.hpp"
#include "rivals/plasticity.hpp"

namespace arenite::bench {
namespace {

/// Mean number of floating point operations that a law does for a single point.
template <class T, int D, class Law>
double operations(const Law& law, const LawStates<T, D>& states) {
  using C = Counting<T>;
  C::operations = 0;
  for (std::size_t p = 0; p < states.n; ++p) {
    const auto of = [&](const auto& columns) {
      return Sym<C, D>::each([&](std::size_t i) { return C(columns[i][p]); });
    };
    Sym<C, D> stress = of(states.stress);
    StrainStep<C, D> inc;
    inc.strain = of(states.strain);
    for (std::size_t i = 0; i < states.spins; ++i) inc.spin[i] = C(states.spin[i][p]);
    typename Law::template History<C> history{};
    law.update(stress, inc, history);
  }
  return static_cast<double>(C::operations) / static_cast<double>(states.n);
}

void report(benchmark::State& state, double points) {
  state.counters["points"] = points;
  state.counters["threads"] = 1;
}

template <int W, class T, int D, class Law>
void add_width(const std::string& name, const Law& law, double yielding) {
  benchmark::RegisterBenchmark((name + "/width:" + std::to_string(W)).c_str(), [=](benchmark::State& state) {
    auto states = law_states<T, D>(law, yielding);
    const double count = operations(law, states);
    for (auto _ : state) {
      update_all<W>(law, states);
      benchmark::ClobberMemory();
    }
    report(state, static_cast<double>(states.n));
    state.counters["flop_per_point"] = count;
  })->Unit(benchmark::kMicrosecond);
}

/// A law on elastic states and, if it yields, on states of which 60 % do.
template <class T, int D, class Law>
void add(const std::string& word, const Law& law) {
  constexpr bool yields = knows_yield<Law, T, D>;
  for (const double yielding : {0.0, 0.6}) {
    if (yielding > 0 && !yields) continue;
    const std::string name = joined_text({"law/", word, "/", D, "d/", sizeof(T) == 4 ? "float" : "double",
                                          "/", yielding > 0 ? "yielding" : "elastic"});
    add_width<1, T, D>(name, law, yielding);
    add_width<2, T, D>(name, law, yielding);
    add_width<4, T, D>(name, law, yielding);
    add_width<8, T, D>(name, law, yielding);
    if constexpr (sizeof(T) == 4) add_width<16, T, D>(name, law, yielding);
  }
}

template <class Law>
void add_all(const std::string& word, const Law& law) {
  add<double, 3>(word, law);
  add<double, 2>(word, law);
  add<float, 3>(word, law);
  add<float, 2>(word, law);
}

/// Takes all points through one step of a rival, one after another.
template <class T, class Rival>
void update_rival(const Rival& rival, LawStates<T, 3>& states) {
  for (std::size_t p = 0; p < states.n; ++p) {
    rival::Sym3<T> stress, strain;
    for (std::size_t i = 0; i < 6; ++i) {
      stress[i] = states.stress[i][p];
      strain[i] = states.strain[i][p];
    }
    states.opened[p] =
        rival.update(stress, strain, {states.spin[0][p], states.spin[1][p], states.spin[2][p]});
    for (std::size_t i = 0; i < 6; ++i) states.result[i][p] = stress[i];
  }
}

template <class T, class Rival, class Law>
void add_rival(const std::string& word, const Rival& rival, const Law& law) {
  for (const double yielding : {0.0, 0.6})
    benchmark::RegisterBenchmark(joined_text({"law/", word, "/3d/", sizeof(T) == 4 ? "float" : "double", "/",
                                              yielding > 0 ? "yielding" : "elastic", "/rival"})
                                     .c_str(),
                                 [=](benchmark::State& state) {
                                   auto states = law_states<T, 3>(law, yielding);
                                   for (auto _ : state) {
                                     update_rival(rival, states);
                                     benchmark::ClobberMemory();
                                   }
                                   report(state, static_cast<double>(states.n));
                                 })
        ->Unit(benchmark::kMicrosecond);
}

/// The rival must do the same: stops the program unless it gives the library's stresses and openings.
template <class T, class Rival, class Law>
void check_rival(const char* word, const Rival& rival, const Law& law) {
  auto mine = law_states<T, 3>(law, 0.6);
  auto theirs = mine;
  update_all<1>(law, mine);
  update_rival(rival, theirs);
  double worst = 0;
  for (std::size_t p = 0; p < mine.n; ++p) {
    for (std::size_t i = 0; i < 6; ++i)
      worst = std::max(worst, std::abs(static_cast<double>(mine.result[i][p] - theirs.result[i][p])) / 1e5);
    worst = std::max(worst, std::abs(static_cast<double>(mine.opened[p] - theirs.opened[p])));
  }
  if (worst <= (sizeof(T) == 8 ? 1e-8 : 1e-3)) return;
  std::fprintf(stderr, "benchmark.laws: the rival of %s differs from the library by %g of 100 kPa\n", word,
               worst);
  std::exit(1);
}

}  // namespace
}  // namespace arenite::bench

int main(int argc, char** argv) {
  using namespace arenite;
  using namespace arenite::bench;
  const LinearElastic elastic{{.density = density, .young = young, .poisson = poisson}};
  const MohrCoulombParameters sand{
      .density = density, .young = young, .poisson = poisson, .friction = friction};
  const DruckerPragerParameters grains{
      .density = density, .young = young, .poisson = poisson, .friction = friction};
  add_all("linear_elastic", elastic);
  add_all("mohr_coulomb", MohrCoulomb<>{sand});
  add_all("mohr_coulomb_remembers", MohrCoulomb<RemembersOpening>{sand, RemembersOpening{}});
  add_all("drucker_prager", DruckerPrager<>{grains});
  add_all("drucker_prager_remembers", DruckerPrager<RemembersOpening>{grains, RemembersOpening{}});
  const auto add_friction = [&](const std::string& word, const auto& policy) {
    add<double, 3>("mohr_coulomb_" + word, MohrCoulomb{sand, ForgetsOpening{}, policy});
    add<double, 2>("mohr_coulomb_" + word, MohrCoulomb{sand, ForgetsOpening{}, policy});
    add<double, 3>("drucker_prager_" + word, DruckerPrager{grains, ForgetsOpening{}, policy});
    add<double, 2>("drucker_prager_" + word, DruckerPrager{grains, ForgetsOpening{}, policy});
  };
  const SofteningParameters softening{.residual_friction = 0.9 * friction, .decay = 8};
  add_friction("linear_rate", LinearRateFriction{});
  add_friction("inertial", InertialFriction{});
  add_friction("logarithmic", LogarithmicFriction{});
  add_friction("softening", SofteningFriction{softening});
  add_friction("rate_softening", RateSofteningFriction{{.softening = softening}});
  const MohrCoulomb stiffening{sand, ForgetsOpening{}, ConstantFriction{}, PressureStiffness{}};
  add<double, 3>("mohr_coulomb_stiffening", stiffening);
  add<double, 2>("mohr_coulomb_stiffening", stiffening);

  const auto rivals = [&]<class T>(T) {
    const rival::MohrCoulomb<T> mohr_coulomb(density, young, poisson, friction);
    const rival::DruckerPrager<T> drucker_prager(density, young, poisson, friction);
    check_rival<T>("Mohr-Coulomb", mohr_coulomb, MohrCoulomb<>{sand});
    check_rival<T>("Drucker-Prager", drucker_prager, DruckerPrager<>{grains});
    add_rival<T>("mohr_coulomb", mohr_coulomb, MohrCoulomb<>{sand});
    add_rival<T>("drucker_prager", drucker_prager, DruckerPrager<>{grains});
  };
  rivals(double{});
  rivals(float{});

  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
