// Random scenes in tiles against the same scenes as a whole: the same ending, points, momentum and energy.
#include <arenite/tiles.hpp>

#include "runner.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

/// Sums over a scene, added tile by tile.
struct Sums {
  std::size_t points = 0;
  double mass = 0, carried = 0, kinetic = 0, strain = 0;  // kg, kg m/s, J, J
  Vec<double, 3> momentum = Vec<double, 3>::Zero();
  bool finite = true;

  template <class Scene>
  void add(const Scene& scene) {
    scene.for_each_body([&](const auto& body, const auto&) {
      points += body.points.size();
      mass += arenite::mass(body);
      kinetic += kinetic_energy(body);
      strain += strain_energy(body);
      momentum.template head<Scene::D>() += arenite::momentum(body);
      for (std::size_t p = 0; p < body.points.size(); ++p) {
        carried += static_cast<double>(body.points.mass[p] * body.points.velocity[p].norm());
        finite = finite && is_finite(body.points, p);
      }
    });
  }
};

/// How the run of a scene, or of tiles, ended: its message, if it was stopped.
template <class Runs>
std::string run_of(Runs& runs, const RunOptions& options) {
  try {
    run(runs, options);
  } catch (const run_error& e) {
    return e.what();
  }
  return "";
}

/// `data`: what `distribute` cuts, of which `Mesh` is the whole.
template <class K, class L, class N, class Mesh, class Data>
Outcome compared(Draw& d, const Mesh& whole_mesh, const Data& data) {
  constexpr int D = Mesh::dimension;
  const int tiles = 1 + d.random.pick(8);
  const auto mean = d.random.template direction<D>();
  const double size = d.cell * (is_simplex_mesh<Mesh> && D == 3 ? 4 : cells_along<D>);
  double stiffer = 1;
  const auto velocity = [&d, mean, size](const std::array<double, 3>& x) {
    std::array<double, 3> v{};
    const double rate = 2 * d.speed / size;
    if (d.motion == Motion::spin) v = {-rate * (x[1] - size / 2), rate * (x[0] - size / 2), 0};
    for (int k = 0; k < D && d.motion != Motion::spin; ++k) {
      const auto i = static_cast<std::size_t>(k);
      v[i] = d.motion == Motion::stretch ? rate * mean[k] * (x[i] - size / 2) : d.speed * mean[k];
    }
    if (K::hoop) v[0] = 0;
    return v;
  };
  const auto make = [&](auto mesh, auto... portion) {
    const Blob region = blob<D>(d, size, 0, 1, K::hoop);
    FillOptions fills = fill_options(d, whole_mesh);
    fills.velocity = velocity;
    return Scene{K{},
                 mesh,
                 numerics_of<N>(d),
                 bodies(fill(region, law<L>(d, stiffer), fills)),
                 walls_of<D>(d),
                 gravity_of(d),
                 portion...};
  };
  Outcome o;
  o.message = joined_text({tiles, " tiles"});
  const auto end_with = [&](Ending ending, const std::string& message = "") {
    o.ending = ending;
    if (!message.empty()) o.message += ": " + message;
    return o;
  };
  try {
    auto whole = make(whole_mesh);
    see_start(whole, d.cell, o);
    OneRank here;
    auto cut = distribute(here, data, {.tiles = tiles}, make);
    const int steps = 40;
    const RunOptions options{.end = steps * d.courant * stable_step(whole), .courant = d.courant};
    const std::string one = run_of(whole, options), other = run_of(cut, options);
    Sums of_whole, of_cut;
    of_whole.add(whole);
    cut.for_each_tile([&](const auto& scene) { of_cut.add(scene); });
    o.steps = whole.steps;
    // If one run stops by itself, the other may continue for a while; a point that crosses more cells in a
    // step than the ghost cells of a tile ends the run of tiles.
    const bool too_far = other.find("beyond its ghost cells") != other.npos;
    if ((!one.empty() && !other.empty()) || too_far) return end_with(Ending::stopped, other);
    if (one.empty() != other.empty())
      return end_with(Ending::untyped, joined_text({"alone: ", one, " ", whole.steps, " steps; in tiles: ",
                                                    other, " ", cut.steps(), " steps"}));
    if (!of_whole.finite || !of_cut.finite) return end_with(Ending::nan);
    // Matter at rest moves by round-off of its stresses.
    const double still = 1e-6 * of_whole.mass * d.wave();
    // Differences: of points and steps, which must agree; of momentum and energy, over the tolerance.
    const auto apart = [&](const Sums& from, std::size_t its_steps) {
      return std::max<double>(
          {2 * std::abs(static_cast<double>(from.points) - static_cast<double>(of_whole.points)),
           2 * std::abs(static_cast<double>(its_steps) - static_cast<double>(whole.steps)),
           (from.momentum - of_whole.momentum).norm() / (1e-6 * (of_whole.carried + still)),
           (std::abs(from.kinetic - of_whole.kinetic) + std::abs(from.strain - of_whole.strain)) /
               (1e-5 * (of_whole.kinetic + std::abs(of_whole.strain) + 1e-6 * still * d.wave()))});
    };
    o.momentum = apart(of_cut, cut.steps());
    if (o.momentum <= 1) return end_with(Ending::sound);
    // Otherwise over the effect of round-off in such a scene: as a whole, stiffer by 1e-12.
    stiffer = 1 + 1e-12;
    auto shaken = make(whole_mesh);
    run_of(shaken, options);
    Sums of_shaken;
    of_shaken.add(shaken);
    o.momentum /= 100 * apart(of_shaken, shaken.steps);
    return end_with(o.momentum <= 1 ? Ending::sound : Ending::pushed);
  } catch (const error& e) {
    return end_with(Ending::refused, e.what());
  } catch (const std::exception& e) {
    return end_with(Ending::untyped, e.what());
  }
}

template <class K, int D, class L, class N>
Outcome on_grid(Draw& d) {
  const auto mesh = grid<D, double>(d);
  return compared<K, L, N>(d, mesh, mesh);
}
template <int D, class L, class N>
Outcome on_simplices(Draw& d) {
  const auto data = simplex_data<D>(d);
  return compared<std::conditional_t<D == 2, PlaneStrain, ThreeDimensional>, L, N>(d, SimplexMesh<D>(data),
                                                                                   data);
}

}  // namespace

TEST_CASE("Random scenes in tiles end as a whole scene does") {
  run_scenes("tiles_more",
             {{"tiles plane FLIP MUSL Mohr-Coulomb grid",
               on_grid<PlaneStrain, 2, MohrCoulomb<>, Numerics<QuadraticBSpline>>},
              {"tiles solid APIC USL Drucker-Prager grid",
               on_grid<ThreeDimensional, 3, DruckerPrager<>, Numerics<QuadraticBSpline, Apic, Usl>>},
              {"tiles plane FLIP MUSL averages Mohr-Coulomb triangles",
               on_simplices<2, MohrCoulomb<>, Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>>},
              {"tiles solid TPIC USL elastic tetrahedra",
               on_simplices<3, LinearElastic, Numerics<LinearSimplex, Tpic, Usl>>},
              {"tiles axisymmetric AFLIP MUSL elastic grid",
               on_grid<Axisymmetric, 2, LinearElastic, Numerics<QuadraticBSpline, Aflip>>}},
             100);
}
