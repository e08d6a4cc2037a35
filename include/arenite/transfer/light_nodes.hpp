// Light nodes: nodes at the edge of a body that get the force of its points and hardly any of their mass.
// They exchange momentum with the nodes around them.
#pragma once

#include <vector>

#include <arenite/core/scalar.hpp>
#include <arenite/transfer/node_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Velocities of nodes that change in place, or apart, where what all copies of a node get is summed later.
template <class Velocities>
struct InPlace {
  Velocities& velocity;
  template <class V>
  void add(Index i, const V& v) {
    velocity[i] += v;
  }
  template <class V>
  void set(Index i, const V& v) {
    velocity[i] = v;
  }
  const auto& now(Index i) const { return velocity[i]; }
};
template <class Velocities>
InPlace(Velocities&) -> InPlace<Velocities>;
template <class Velocities>
struct Apart {
  const Velocities& velocity;
  Velocities& change;
  template <class V>
  void add(Index i, const V& v) {
    change[i] += v;
  }
  template <class V>
  void set(Index i, const V& v) {
    change[i] = v - velocity[i];
  }
  auto now(Index i) const { return (velocity[i] + change[i]).eval(); }
};

/// A point within round-off of a face leaves the node behind it without mass, but not without the force of
/// its stress, which no velocity could take up. The nodes around take its impulse, shared out by their
/// masses, so that momentum is kept: the limit of a light node's exchange (`LightNodes`) for a mass that
/// falls to nothing. The node moves as they do in the mean, for the strain of such a point. For nodes that
/// `owns(i)`; velocities change through `to`.
template <class Shape, class M, class Field, class T, class Owns, class To>
void exchange_with_neighbours(const M& mesh, const Field& nodes, T dt, const Owns& owns, To to) {
  for (Index i = 0; i < nodes.size(); ++i) {
    if (nodes.mass[i] > 0 || !owns(i)) continue;
    const auto force = nodes.collected[i].force();
    if ((force.array() == 0).all()) continue;
    T around = 0;
    Shape::for_each_neighbour(mesh, i, [&](Index j) { around += nodes.mass[j]; });
    if (!(around > 0)) continue;
    Vec<T, M::dimension> mean = nodes.velocity[i];
    Shape::for_each_neighbour(mesh, i, [&](Index j) {
      if (!(nodes.mass[j] > 0)) return;
      to.add(j, (dt / around) * force);
      mean += (nodes.mass[j] / around) * to.now(j);
    });
    to.set(i, mean);
  }
}

/// A linear function falls to zero at a face with a slope that does not fall. The node behind the face thus
/// gets the full stress of points close to it, and an arbitrarily small part of their mass: its frequency has
/// no bound, while the stable step follows the cells. (A quadratic spline's slope falls with it.)
///
/// A node is light if its mass m is below m_e = `least_share` sum m_c (h_c |grad N|)^2, over its cells, with
/// the mass m_c of their points and their smallest altitude h_c: as `p2g` leaves it in
/// `NodeSums::reach`; equilateral cells filled evenly give m = 4 m_e (3 in space). A light node goes the
/// share 1 - m / m_e of the way to the mean velocity of its neighbours, weighted by their masses, so that its
/// own force moves it as if it had the mass m_e. Each neighbour gives what the node gets: linear momentum is
/// kept to round-off, and the kinetic energy of the relative motion falls. A rotation is damped at light
/// nodes, in proportion to their mass. It is selective mass scaling (Olovsson, Simonsson, Unosson 2005,
/// doi:10.1002/nme.1293) by an exchange in place of a mass matrix. One thread: few nodes are light.
template <class T, int D>
class LightNodes {
 public:
  static constexpr double least_share = 1.0 / 12;

  /// Exchanges momentum at the light nodes of a field that `owns(i)`, all with the velocities of before,
  /// which change through `to`. Returns how many nodes are light.
  template <class Shape, class M, class Field, class Owns, class To>
  std::size_t exchange(const M& mesh, const Field& nodes, const Owns& owns, To to) {
    given_.clear();
    given_.reserve(nodes.size());  // once: a step allocates nothing
    std::size_t count = 0;
    for (Index i = 0; i < nodes.size(); ++i) {
      const T m = nodes.mass[i], enough = static_cast<T>(least_share) * nodes.collected[i].reach();
      if (!(m > 0 && m < enough) || !owns(i)) continue;
      T around = 0;  // mass of the neighbours, once for each cell that they share
      Shape::for_each_neighbour(mesh, i, [&](Index j) { around += nodes.mass[j]; });
      if (!(around > 0)) continue;
      ++count;
      const T fraction = (1 - m / enough) / around;
      const Vec<T, D> own = nodes.velocity[i];
      Shape::for_each_neighbour(mesh, i, [&](Index j) {
        if (nodes.mass[j] > 0) given_.push_back({i, j, fraction * (nodes.velocity[j] - own)});
      });
    }
    for (const Given& g : given_) {
      to.add(g.to, nodes.mass[g.from] * g.change);
      to.add(g.from, -nodes.mass[g.to] * g.change);
    }
    return count;
  }

 private:
  struct Given {
    Index to, from;
    Vec<T, D> change;  // momentum over the masses of both, m/(s kg)
  };

  std::vector<Given> given_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
