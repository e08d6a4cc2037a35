// Contact of deformable bodies: one velocity field for all (they stick), or one for each with Coulomb's law
// between them.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <arenite/contact/coulomb.hpp>
#include <arenite/contact/region_surface.hpp>
#include <arenite/transfer/node_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// All bodies move in one velocity field: no slip, no parting, no cost. The default.
struct OneField {
  static constexpr bool separate = false;
  static constexpr bool needs_mass_gradient = false;
};

/// Normals from the gradients of the bodies' masses: works everywhere, blurred over a cell.
struct MassGradient {
  static constexpr bool needs_mass_gradient = true;
};

/// Normals of the surface of a mesh region that one of two bodies fills and keeps filling (an elastic device
/// in a mesh that moves with it).
struct SurfaceOf {
  static constexpr bool needs_mass_gradient = false;
  std::string region;
  std::size_t body = 1;  ///< which of the scene's bodies fills it
};

/// Coulomb friction between bodies, each with a velocity field of its own (Bardenhagen, Brackbill, Sulsky
/// 2000).
template <class Normals_ = MassGradient>
struct Coulomb {
  using Normals = Normals_;
  static constexpr bool separate = true;
  static constexpr bool needs_mass_gradient = Normals::needs_mass_gradient;
  Friction friction;
  Normals normals{};
  /// Velocity limit of Bardenhagen et al. 2001: a velocity after contact above this share of (smallest cell
  /// at the node) / dt, which would turn a cell inside out, is scaled down to it; 0: no limit. Momentum that
  /// this takes is counted.
  double velocity_limit = 0.75;

  explicit Coulomb(Friction f, Normals n = {}, double limit = 0.75)
      : friction{f}, normals{std::move(n)}, velocity_limit{limit} {
    require(limit >= 0, "Coulomb.velocity_limit", limit, "must not be negative (0: no limit)");
  }
};

template <class C>
inline constexpr bool is_contact = false;
template <>
inline constexpr bool is_contact<OneField> = true;
template <class N>
inline constexpr bool is_contact<Coulomb<N>> = true;

/// What contact did in a step.
struct ContactTally {
  double dissipation = 0;       ///< energy lost, J
  std::size_t nodes = 0;        ///< node pairs that exchanged an impulse
  std::size_t limited = 0;      ///< node velocities scaled down by the velocity limit
  double limited_momentum = 0;  ///< sum of the magnitudes of momentum that the limit took, N s
  ContactTally& operator+=(const ContactTally& o) {
    dissipation += o.dissipation;
    nodes += o.nodes;
    limited += o.limited;
    limited_momentum += o.limited_momentum;
    return *this;
  }
};

/// Two fields that exchanged an impulse at a node, and what it left of their motion against each other.
template <class T, int D>
struct ContactPair {
  Index node;
  std::size_t first, second;  ///< fields
  Vec<T, D> normal;           ///< unit, out of the second; zero if there is none
  Vec<T, D> impulse;          ///< on the first, N s
  bool sticks;                ///< no relative motion at all, not just none along the normal
};

/// In place of a list of pairs where nobody asks for them (USL).
struct NoContactPairs {
  void clear() {}
  template <class Pair>
  void push_back(const Pair&) {}
};

/// Normals out of a region's surface, for every node of the mesh; zero where there is none.
template <class T, int D>
struct NormalMap {
  std::vector<Vec<T, D>> out;  ///< [nodes] unit, or zero
  std::size_t body = 0;        ///< the body that fills the region
};

namespace detail {

/// Unit normal out of body b towards body a at node i, or zero if there is none.
template <class Normals, class Fields, class Map>
auto normal_between(const Coulomb<Normals>&, const Fields& fields, const Map& map, std::size_t a,
                    std::size_t b, std::size_t i) {
  using V = std::remove_cvref_t<decltype(fields[0].start[0])>;
  if constexpr (Normals::needs_mass_gradient) {
    V normal = V::Zero();
    for (const auto& [f, sign] : {std::pair{b, 1}, std::pair{a, -1}}) {
      const V& g = fields[f].mass_gradient[i];
      const auto length = g.norm();
      if (length > 0) normal += (static_cast<typename V::Scalar>(sign) / length) * g;
    }
    const auto length = normal.norm();
    return V(length > std::numeric_limits<typename V::Scalar>::epsilon() ? V(normal / length) : V(V::Zero()));
  } else {
    return V(b == map.body ? map.out[i] : -map.out[i]);
  }
}

/// Lets each pair of bodies meet at the nodes that they share. An impulse is computed once and given with
/// both signs, so that momentum is kept to round-off. Calls `done(pair)` for each.
template <class Normals, class Fields, class Map, class Done>
void meet(const Coulomb<Normals>& contact, Fields& fields, const Map& map, Done&& done) {
  using V = std::remove_cvref_t<decltype(fields[0].start[0])>;
  using T = typename V::Scalar;
  constexpr int D = V::RowsAtCompileTime;
  for (std::size_t i = 0; i < fields[0].size(); ++i)
    for (std::size_t a = 0; a < fields.size(); ++a) {
      if (!(fields[a].mass[i] > 0)) continue;
      for (std::size_t b = a + 1; b < fields.size(); ++b) {
        if (!(fields[b].mass[i] > 0)) continue;
        const T ma = fields[a].mass[i], mb = fields[b].mass[i];
        V &va = fields[a].velocity[i], &vb = fields[b].velocity[i];
        const V approach = va - vb;
        const T reduced = ma * mb / (ma + mb);
        const V normal = normal_between(contact, fields, map, a, b, i);
        // Without a normal one body lies inside the other: they stick.
        const bool has_normal = normal.squaredNorm() > 0;
        const V impulse = has_normal ? coulomb_impulse<T, D>(approach, normal, reduced, contact.friction)
                                     : V(-reduced * approach);
        if (impulse.squaredNorm() == 0) continue;
        va += impulse / ma;
        vb -= impulse / mb;
        done(ContactPair<T, D>{static_cast<Index>(i), a, b, normal, impulse,
                               !has_normal || sticks<T, D>(approach, normal, contact.friction)});
      }
    }
}

}  // namespace detail

/// Lets the fields of each pair of bodies exchange impulses at the nodes that they share, and limits the
/// velocities there. `map`: a NormalMap, or anything for mass gradients. `impulses` [fields] receives the sum
/// of what each field was given, N s; `pairs` those who exchanged one, in the order of their nodes.
template <class Normals, class Fields, class Map, class Impulses, class Pairs, class T, class Size>
ContactTally exchange(const Coulomb<Normals>& contact, Fields& fields, const Map& map, Impulses& impulses,
                      Pairs& pairs, T dt, Size&& node_size) {
  ContactTally tally;
  const auto limit = [&](std::size_t i) {
    const T most = static_cast<T>(contact.velocity_limit) * node_size(static_cast<Index>(i)) / dt;
    for (auto& f : fields) {
      const T speed = f.velocity[i].norm();
      if (!(f.mass[i] > 0 && speed > most)) continue;
      tally.limited_momentum += static_cast<double>(f.mass[i] * (speed - most));
      ++tally.limited;
      f.velocity[i] *= most / speed;
    }
  };
  for (auto& sum : impulses) sum.setZero();
  pairs.clear();
  constexpr auto nowhere = static_cast<std::size_t>(-1);
  std::size_t last = nowhere;  // node whose impulses are being given; they come node by node
  detail::meet(contact, fields, map, [&](const auto& pair) {
    const std::size_t i = pair.node, a = pair.first, b = pair.second;
    const auto& impulse = pair.impulse;
    if (contact.velocity_limit > 0 && last != nowhere && last != i) limit(last);
    last = i;
    pairs.push_back(pair);
    impulses[a] += impulse;
    impulses[b] -= impulse;
    // Mean velocities over the whole step, so that forces that contact holds in balance
    // dissipate nothing.
    tally.dissipation -= static_cast<double>(
        impulse.dot(fields[a].start[i] - fields[b].start[i] + fields[a].velocity[i] - fields[b].velocity[i]) /
        2);
    ++tally.nodes;
  });
  if (contact.velocity_limit > 0 && last != nowhere) limit(last);
  return tally;
}

/// Holds the mapped velocities of MUSL, from which strains are taken, to what contact enforced: where a pair
/// of fields exchanged an impulse, both take the velocity of their common momentum, along the normal, or
/// altogether if they stick. In both directions: an impulse does no work only if the strain velocities agree
/// where it acts. Left as they are mapped they part during a rebound at nodes where contact still pushes, and
/// the impulse times that velocity is energy that nothing put in. No impulse: these velocities live for one
/// strain increment. Returns the energy that this dissipates beside what `exchange` booked, J. The points of
/// FLIP gain (impulse + dt force) (start + mapped) / 2 at each node, their strains take dt force times the
/// held velocity: with both, contact's share of the balance is exact, up to the order of the time step.
/// `Centred`: what is mapped is the mean over the step already.
template <bool Centred, class Pairs, class Fields, class T>
double hold_together(const Pairs& pairs, Fields& fields, T dt) {
  double dissipation = 0;
  for (const auto& pair : pairs) {
    const std::size_t i = pair.node;
    auto& a = fields[pair.first];
    auto& b = fields[pair.second];
    using V = std::remove_cvref_t<decltype(pair.normal)>;
    const V apart = a.mapped[i] - b.mapped[i], end = a.velocity[i] - b.velocity[i];
    const V removed = pair.sticks ? apart : V(apart.dot(pair.normal) * pair.normal);
    const T share_a = b.mass[i] / (a.mass[i] + b.mass[i]), share_b = 1 - share_a;
    const V push = dt * (share_a * a.collected[i].force() - share_b * b.collected[i].force());
    V twice = apart - end;  // what points take of the impulse, less what `exchange` booked: twice the mean
    if constexpr (Centred) twice += apart - (a.start[i] - b.start[i]);
    dissipation -= static_cast<double>(pair.impulse.dot(twice) / 2 + push.dot(removed));
    a.mapped[i] -= share_a * removed;
    b.mapped[i] += share_b * removed;
  }
  return dissipation;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
