// Light nodes: nodes at the edge of a body that get the force of its points and hardly any of their mass.
// They exchange momentum with the nodes around them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

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
};

/// Mass of the nodes around node i, once for each cell that they share, kg.
template <class Shape, class M, class Field>
typename M::scalar mass_around(const M& mesh, const Field& nodes, Index i) {
  typename M::scalar around = 0;
  Shape::for_each_neighbour(mesh, i, [&](Index j) { around += nodes.mass[j]; });
  return around;
}

/// Lists the nodes without mass that points or loads touch, of those that `owns(i)`, in `nodes.massless`.
///
/// A point within round-off of a face leaves the node opposite it without mass (`negligible_mass`), though
/// not without the force of its stress, and its velocity gradient reads that node. Such a node is tied to
/// the nodes around it: it has the mean of their velocities, weighted by their masses
/// (`average_neighbours`), and they get its impulse in the same shares (`redistribute_forces`). So momentum is
/// conserved, the work of its force is theirs, and rigid translation causes no strain wherever the points
/// are. It is the limit of a light node's exchange (`LightNodes`) for a mass that falls to nothing.
template <class Field, class Owns>
void list_massless(Field& nodes, const Owns& owns) {
  nodes.massless.clear();
  nodes.massless.reserve(nodes.size());  // once: a step allocates nothing
  for (Index i = 0; i < nodes.size(); ++i) {
    if (nodes.mass[i] > 0 || !owns(i)) continue;
    const auto& sums = nodes.sums[i];
    if (sums.reach() > 0 || !(sums.force().array() == 0).all()) nodes.massless.push_back(i);
  }
}

/// The impulses of listed nodes' forces over a step dt, s, for the nodes around them, whose velocities change
/// through `to`.
template <class Shape, class M, class Field, class T, class To>
void redistribute_forces(const M& mesh, const Field& nodes, T dt, To to) {
  for (const Index i : nodes.massless) {
    const auto force = nodes.sums[i].force();
    if ((force.array() == 0).all()) continue;
    const T around = mass_around<Shape>(mesh, nodes, i);
    if (!(around > 0)) continue;
    Shape::for_each_neighbour(mesh, i, [&](Index j) {
      if (nodes.mass[j] > 0) to.add(j, (dt / around) * force);
    });
  }
}

/// Gives listed nodes the mean velocity of the nodes around them; what momentum they have of a negligible
/// mass goes there. Velocities [nodes] change through `to`.
template <class Shape, class M, class Field, class Velocities, class To>
void average_neighbours(const M& mesh, const Field& nodes, const Velocities& velocity, To to) {
  using T = typename M::scalar;
  for (const Index i : nodes.massless) {
    const T around = mass_around<Shape>(mesh, nodes, i);
    if (!(around > 0)) continue;
    Vec<T, M::dimension> mean = Vec<T, M::dimension>::Zero();
    Shape::for_each_neighbour(mesh, i, [&](Index j) { mean += (nodes.mass[j] / around) * velocity[j]; });
    const Vec<T, M::dimension> left = (nodes.sums[i].mass() / around) * (velocity[i] - mean);
    Shape::for_each_neighbour(mesh, i, [&](Index j) {
      if (nodes.mass[j] > 0) to.add(j, left);
    });
    to.set(i, mean);
  }
}

/// A linear function falls to zero at a face with a slope that does not. The node opposite the face thus
/// gets the full stress of points close to it, and an arbitrarily small part of their mass: its frequency has
/// no bound, while the stable step follows the cells. (A quadratic spline's slope falls with it.)
///
/// A node is light if its mass m is below m_e = `least_share` sum m_c (h_c |grad N|)^2, over its cells, with
/// the mass m_c of their points and their smallest altitude h_c: as `p2g` leaves it in
/// `NodeSums::reach`; equilateral cells filled evenly give m = 4 m_e (3 in space). A light node moves the
/// share 1 - m / m_e of the way to the mean velocity of its neighbours, weighted by their masses, so that its
/// own force moves it as if it had the mass m_e. Each neighbour gives what the node gets: linear momentum is
/// conserved to round-off, and the kinetic energy of the relative motion falls. A rotation is damped at light
/// nodes, in proportion to their mass. It is selective mass scaling (Olovsson, Simonsson, Unosson 2005,
/// doi:10.1002/nme.1293) by an exchange in place of a mass matrix. One thread: few nodes are light.
template <class T, int D>
class LightNodes {
 public:
  static constexpr double least_share = least_light_share;

  /// Exchanges momentum at the light nodes of a field that `owns(i)`, all with the velocities before the
  /// exchange, which change through `to`. Returns how many nodes are light.
  template <class Shape, class M, class Field, class Owns, class To>
  std::size_t redistribute(const M& mesh, const Field& nodes, const Owns& owns, To to) {
    given_.clear();
    given_.reserve(nodes.size());  // once: a step allocates nothing
    std::size_t count = 0;
    for (Index i = 0; i < nodes.size(); ++i) {
      const T m = nodes.mass[i], enough = static_cast<T>(least_share) * nodes.sums[i].reach();
      if (!(m > 0 && m < enough) || !owns(i)) continue;
      const T around = mass_around<Shape>(mesh, nodes, i);
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
