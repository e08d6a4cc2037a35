// Parts of a random scene, made from a draw: meshes, laws, region, walls, velocities.
#pragma once

#include "../mesh/sample_meshes.hpp"
#include "draw.hpp"

namespace arenite::extremes {

/// Cells along an axis of the mesh; the body takes the middle third to half of them.
template <int D>
constexpr int cells_along = D == 2 ? 10 : 6;

template <int D, real_scalar T>
CartesianGrid<D, T> grid(const Draw& d) {
  typename CartesianGrid<D, T>::Parameters p;
  p.lower.fill(0);
  p.upper.fill(d.cell * cells_along<D>);
  p.cell = d.cell;
  return CartesianGrid<D, T>(p);
}

/// The same box of triangles or tetrahedra, at random places but on the hull; region 1 ("device") is the
/// block in the middle of the upper third if there is to be one.
template <int D>
MeshData<D> simplex_data(const Draw& d, bool device = false) {
  const int n = D == 2 ? cells_along<D> : 4;
  const double size = d.cell * n;
  test::SampleMesh<D> o{};
  o.cells.fill(n);
  o.upper = Vec<double, D>::Constant(size);
  o.jitter = d.jitter;
  o.seed = static_cast<unsigned>(d.seed);
  if (device)
    o.region = [size](const Vec<double, D>& x) {
      bool in = x[1] > 0.6 * size && x[1] < 0.8 * size;
      for (int k = 0; k < D; ++k)
        if (k != 1) in = in && std::abs(x[k] - 0.5 * size) < 0.2 * size;
      return in ? 1 : 0;
    };
  auto data = test::sample_data(o);
  data.region_names = {{"soil", 0}, {"device", 1}};
  return data;
}
template <int D, real_scalar T>
SimplexMesh<D, T> simplices(const Draw& d, bool device = false) {
  return SimplexMesh<D, T>(simplex_data<D>(d, device));
}

/// Extent of a mesh, m.
template <class M>
double extent(const M& mesh) {
  if constexpr (is_simplex_mesh<M>) {
    double most = 0;
    for (const auto& x : mesh.positions()) most = std::max(most, static_cast<double>(x[0]));
    return most;
  } else {
    return static_cast<double>(mesh.upper(0));
  }
}

/// A box, or the ellipsoid in it.
struct Blob {
  std::array<double, 3> lower, upper;
  bool round;
  template <int D>
  bool contains(const Vec<double, D>& x) const {
    double far = 0;
    for (int k = 0; k < D; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double s = (2 * x[k] - lower[i] - upper[i]) / (upper[i] - lower[i]);
      far = round ? far + s * s : std::max(far, std::abs(s));
    }
    return far < 1;
  }
};

/// Part of the mesh that body `number` of `count` takes; two lie one above the other.
template <int D>
Blob blob(const Draw& d, double size, int number = 0, int count = 1, bool axisymmetric = false) {
  Blob b{{0.29, 0.29, 0.29}, {0.71, 0.71, 0.71}, d.round};
  if (d.layout == Layout::floor) {
    b.lower = {0, 0, 0};
    b.upper = {1, 0.6, 1};
    b.round = false;
  }
  if (axisymmetric) {
    b.lower[0] = 0;
    b.upper[0] = d.layout == Layout::floor ? 1 : 0.5;
    b.round = false;
  }
  const double low = b.lower[1], height = b.upper[1] - b.lower[1];
  b.lower[1] = low + height * number / count;
  b.upper[1] = low + height * (number + 1) / count;
  for (auto* end : {&b.lower, &b.upper})
    for (double& x : *end) x *= size;
  return b;
}

/// The mesh of a scene that has no device.
template <class M>
M mesh_of(const Draw& d) {
  if constexpr (is_simplex_mesh<M>)
    return simplices<M::dimension, typename M::scalar>(d);
  else if constexpr (requires { M::periodic_axes; })
    return M(grid<M::dimension, typename M::scalar>(d));
  else if constexpr (
      requires { typename M::Parameters; } && requires(typename M::Parameters p) { p.x; }) {
    // Cells of d.cell in the middle, at most twice as large to both sides.
    static_assert(M::dimension == 2);
    std::vector<double> lines;
    for (int i = 0; i <= cells_along<2>; ++i) {
      const double s = 2.0 * i / cells_along<2> - 1;
      lines.push_back(d.cell * cells_along<2> * (1 + s * (0.75 + 0.25 * s * s)) / 2);
    }
    return M({.x = lines, .y = lines});
  } else
    return grid<M::dimension, typename M::scalar>(d);
}

template <class N>
N numerics_of(const Draw& d) {
  N numerics{};
  if constexpr (requires { numerics.transfer.fraction; }) numerics.transfer.fraction = d.share;
  return numerics;
}

/// A policy of friction or stiffness with drawn constants.
template <class P>
P policy(const Draw& d) {
  Random random(~d.seed);
  const double decay = random.uniform(0, 20);
  const SofteningParameters softening{.residual_friction = d.friction > 0 ? 0.7 * d.friction : 0.0,
                                      .residual_dilatancy = 0.5 * d.dilatancy,
                                      .decay = std::same_as<P, SofteningFriction> ? 10 : decay};
  const double smoothing = random.chance(0.5) ? 0 : random.decades(1e-6, 1) * d.cell / d.wave();
  const PressureStiffness::Parameters pressure{.exponent = random.uniform(),
                                               .reference_pressure = d.young * random.decades(1e-5, 0.1),
                                               .lowest_pressure = d.young * random.decades(1e-7, 1e-3)};
  if constexpr (std::same_as<P, SofteningFriction>)
    return P(softening);
  else if constexpr (std::same_as<P, RateSofteningFriction>)
    return P({.softening = softening, .smoothing = smoothing});
  else if constexpr (std::same_as<P, LogarithmicFriction>)
    return P({.per_decade = random.uniform(0, 0.1), .smoothing = smoothing});
  else if constexpr (std::same_as<P, LinearRateFriction>)
    return P({.time = random.decades(1e-6, 1), .smoothing = smoothing});
  else if constexpr (std::same_as<P, InertialFriction>)
    return P({.rise = random.uniform(0, 1),
              .reference_inertia = random.decades(1e-2, 1),
              .grain_size = random.decades(1e-6, 1e-2),
              .smoothing = smoothing});
  else if constexpr (std::same_as<P, PressureStiffness>)
    return P(pressure);
  else if constexpr (std::same_as<P, RateStiffness>)
    return P({.residual = random.uniform(0.1, 1), .decay = decay, .pressure = pressure});
  else
    return {};
}

/// A law with drawn constants; the primary template is that of `LinearElastic`.
template <class L>
struct LawOf {
  static L make(const Draw& d, double young) {
    return L{{.density = d.density, .young = young, .poisson = d.poisson}};
  }
};
template <template <class, class, class> class L, class Memory, class Friction, class Stiffness>
struct LawOf<L<Memory, Friction, Stiffness>> {
  static auto make(const Draw& d, double young) {
    return L<Memory, Friction, Stiffness>{{.density = d.density,
                                           .young = young,
                                           .poisson = d.poisson,
                                           .friction = d.friction,
                                           .cohesion = d.cohesion,
                                           .dilatancy = d.dilatancy},
                                          Memory{},
                                          policy<Friction>(d),
                                          policy<Stiffness>(d)};
  }
};
template <class L, int D>
struct LawOf<WithDeviatoricStrain<L, D>> {
  static auto make(const Draw& d, double young) {
    return WithDeviatoricStrain<L, D>(LawOf<L>::make(d, young));
  }
};
template <class L>
L law(const Draw& d, double contrast = 1) {
  return LawOf<L>::make(d, d.young * contrast);
}

template <class M>
FillOptions fill_options(const Draw& d, const M& mesh) {
  FillOptions o;
  if (is_simplex_mesh<M>)
    o.per_cell = M::dimension == 2 ? (d.fine ? 10 : 3) : (d.fine ? 10 : 4);
  else
    o.per_cell = M::dimension == 2 ? (d.fine ? 9 : 4) : (d.fine ? 27 : 8);
  if (d.per_cell > 0) o.per_cell = d.per_cell;
  if (d.k0 >= 0 && d.gravity > 0) o.stress = Geostatic{.surface = 0.6 * extent(mesh), .k0 = d.k0};
  return o;
}

template <int D>
Walls walls_of(const Draw& d) {
  Walls w;
  if (d.layout == Layout::free) return w;
  const Condition c = d.smooth ? roller : fixed;
  w.list = {left(c), right(c), bottom(c), top(c)};
  if (D == 3) {
    w.list.push_back(front(c));
    w.list.push_back(back(c));
  }
  return w;
}

inline Gravity gravity_of(const Draw& d) { return gravity(Triple{0, -d.gravity, 0}); }

/// Gives the points of all bodies their velocities, and the energy balance their energy. A second body moves
/// against the first. In most scenes without walls a motion that would leave the mesh is slowed down.
template <class Scene>
void set_in_motion(Scene& scene, Draw& d) {
  constexpr int D = Scene::D;
  using V = Vec<double, D>;
  const double size = extent(scene.mesh);
  const V centre = V::Constant(size / 2), mean = d.random.direction<D>();
  double speed = d.speed;
  if (d.layout == Layout::free && d.random.chance(0.8)) {
    const double cells = d.steps * d.courant * speed / (speed + d.wave());  // of travel
    if (cells > 2) speed *= 2 / cells;
  }
  const double rate = 2 * speed / size;
  double sign = 1;
  scene.for_each_body([&](auto& body, const auto&) {
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const V x = body.points.position[p].template cast<double>() - centre;
      V v = V::Zero();
      switch (d.motion) {
        case Motion::uniform:
          v = sign * speed * mean;
          break;
        case Motion::spin:
          v[0] = -rate * x[1];
          v[1] = rate * x[0];
          break;
        case Motion::stretch:
          v = rate * mean.dot(x) * mean;
          break;
        case Motion::noise:
          v = speed * d.random.direction<D>();
          break;
      }
      if constexpr (Scene::Kinematics::hoop)
        v[0] = d.motion == Motion::stretch ? rate * (x[0] + centre[0]) : 0;
      body.points.velocity.set(p, v.template cast<typename Scene::T>());
    }
    sign = -sign;
  });
  auto& balance = scene.template part<TrackEnergy>();
  balance = {};
  balance.connect(scene);
}

}  // namespace arenite::extremes
