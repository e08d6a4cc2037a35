// Contact of deformable bodies: one velocity field for all (they stick), or one for each with Coulomb's law
// between them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/contact/coulomb.hpp>
#include <arenite/contact/hold.hpp>
#include <arenite/contact/normals.hpp>
#include <arenite/core/by_body.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/part/part_energy.hpp>
#include <arenite/transfer/node_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Names the kind `OnlyOne` of contacts of bodies: a scene has one at most.
struct ContactOfBodies;

/// All bodies move in one velocity field: no slip, no parting, no cost. The default.
struct OneField {
  using OnlyOne = ContactOfBodies;
  static constexpr bool separates_bodies = false;
};

/// Coulomb friction between bodies, each with its own velocity field (Bardenhagen, Brackbill, Sulsky 2000).
/// It acts at nodes that receive mass from both bodies, before their surfaces touch: at a distance of 1.5 to
/// 2.5 cells with quadratic B-splines, 0.75 to 1.75 with linear simplices, depending on where nodes lie
/// (tests/contact/acting_distance_heavy.cpp).
template <class Normals = MassGradient>
struct Coulomb {
  Friction friction;
  Normals normals{};
  /// Velocity limit of Bardenhagen et al. 2001: a velocity after contact above this share of (smallest cell
  /// at the node) / dt, which would turn a cell inside out, is scaled down to it; 0: no limit. Momentum that
  /// this removes is counted.
  double velocity_limit = 0.75;

  explicit Coulomb(Friction f, Normals n = {}, double limit = 0.75)
      : friction{f}, normals{std::move(n)}, velocity_limit{limit} {
    require(limit >= 0, "Coulomb.velocity_limit", limit, "must not be negative (0: no limit)");
  }
  /// Refused by the compiler: a number may be an angle or a coefficient.
  template <class Number, class... More>
  requires std::is_arithmetic_v<Number>
  explicit Coulomb(Number, const More&...) : Coulomb(Friction(0.0)) {
    static_assert(!std::is_arithmetic_v<Number>,
                  "Coulomb: the friction is Friction(angle): say Coulomb(Friction(20_deg))");
  }
};

/// Two fields that exchanged an impulse at a node, and their relative velocity after it.
template <class T, int D>
struct ContactPair {
  Index node;
  std::size_t first, second;  ///< fields
  Vec<T, D> normal;           ///< unit, out of the second; zero if there is none
  Vec<T, D> impulse;          ///< on the first, N s
  bool sticks;                ///< no relative motion at all, not just none along the normal
  Vec<T, D> after;            ///< velocity of the first against the second with the impulse, m/s
};

namespace detail {

/// Lets each pair of bodies exchange impulses at the nodes that they share. An impulse is computed once and
/// applied with both signs, so that momentum is conserved to round-off. Calls `done(pair)` for each.
template <class Normals, class Fields, class Done>
void apply_in_pairs(const Friction& friction, const Normals& normals, Fields& fields, Done&& done) {
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
        const V normal = normals.between(fields, a, b, i);
        // Without a normal one body lies inside the other.
        const auto given = normal.squaredNorm() > 0 ? coulomb<T, D>(approach, normal, reduced, friction)
                                                    : stick<T, D>(approach, reduced);
        if (given.impulse.squaredNorm() == 0) continue;
        va += given.impulse / ma;
        vb -= given.impulse / mb;
        done(ContactPair<T, D>{static_cast<Index>(i), a, b, normal, given.impulse, given.sticks, va - vb});
      }
    }
}

}  // namespace detail

/// Lets the fields of each pair of bodies exchange impulses at the nodes that they share, and limits the
/// velocities there. `impulses` [fields] receives the sum of what each field was given, N s; `pairs` those
/// of bodies between which one acts, in the order of their nodes. What is summed is that of nodes that `owns(node)`.
template <class Contact, class Normals, class Fields, class Impulses, class Pairs, class T, class Size,
          class Owns = OwnsAll>
ContactTally apply_contact(const Contact& contact, const Normals& normals, Fields& fields, Impulses& impulses,
                           Pairs& pairs, T dt, Size&& node_size, const Owns& owns = {}) {
  static_assert(contact_normals<Normals, Fields>,
                "Coulomb: the normals lack a member; see arenite/contact/normals.hpp");
  ContactTally tally;
  const auto limit = [&](std::size_t i) {
    const T most = static_cast<T>(contact.velocity_limit) * node_size(static_cast<Index>(i)) / dt;
    for (auto& f : fields) {
      const T speed = f.velocity[i].norm();
      if (!(f.mass[i] > 0 && speed > most)) continue;
      f.velocity[i] *= most / speed;
      if (!owns(static_cast<Index>(i))) continue;
      tally.limited_momentum += static_cast<double>(f.mass[i] * (speed - most));
      ++tally.limited;
    }
  };
  for (auto& sum : impulses) sum.setZero();
  pairs.clear();
  constexpr auto nowhere = static_cast<std::size_t>(-1);
  std::size_t last = nowhere;  // node whose impulses are being given; they come node by node
  detail::apply_in_pairs(contact.friction, normals, fields, [&](const auto& pair) {
    const std::size_t i = pair.node, a = pair.first, b = pair.second;
    const auto& impulse = pair.impulse;
    if (contact.velocity_limit > 0 && last != nowhere && last != i) limit(last);
    last = i;
    pairs.push_back(pair);
    if (!owns(pair.node)) return;
    impulses[a] += impulse;
    impulses[b] -= impulse;
    // Mean velocities over the whole step, so that forces in equilibrium with
    // contact dissipate nothing.
    tally.dissipation -=
        static_cast<double>(impulse.dot(fields[a].start[i] - fields[b].start[i] + pair.after) / 2);
    ++tally.nodes;
  });
  if (contact.velocity_limit > 0 && last != nowhere) limit(last);
  return tally;
}

/// Constrains the mapped velocities of each pair to those of their common momentum (see `hold`). Returns the
/// energy that this dissipates, J.
template <class Pairs, class Fields, class T, class Owns = OwnsAll>
double hold_together(const Pairs& pairs, Fields& fields, T dt, const Owns& owns = {}) {
  double dissipation = 0;
  for (const auto& pair : pairs) {
    const std::size_t i = pair.node;
    auto& a = fields[pair.first];
    auto& b = fields[pair.second];
    using V = std::remove_cvref_t<decltype(pair.normal)>;
    const V apart = a.mapped[i] - b.mapped[i];
    const T share_a = b.mass[i] / (a.mass[i] + b.mass[i]), share_b = 1 - share_a;
    const V force = share_a * a.sums[i].force() - share_b * b.sums[i].force();
    const auto held = hold<T, V::RowsAtCompileTime>(apart, pair.normal, pair.sticks, force, dt);
    if (owns(pair.node)) dissipation += held.dissipation;
    a.mapped[i] -= share_a * held.removed;
    b.mapped[i] += share_b * held.removed;
  }
  return dissipation;
}

/// Dissipation of the pairs beyond that recorded by `apply_contact` (see `rest_of_dissipation`), J.
template <class Pairs, class Fields, class Owns = OwnsAll>
double rest_between(const Pairs& pairs, const Fields& fields, const Owns& owns = {}) {
  double dissipation = 0;
  for (const auto& pair : pairs) {
    if (!owns(pair.node)) continue;
    const std::size_t i = pair.node;
    const auto &a = fields[pair.first], &b = fields[pair.second];
    const auto mean = (a.mean_velocity(i) - b.mean_velocity(i)).eval();
    dissipation -= static_cast<double>(pair.impulse.dot(mean - (a.start[i] - b.start[i] + pair.after) / 2));
  }
  return dissipation;
}

/// Coulomb contact in a scene: a part that exchanges impulses between the bodies.
template <class T, int D, class Normals, std::size_t Fields>
struct BoundCoulomb {
  using OnlyOne = ContactOfBodies;
  static constexpr bool separates_bodies = true;
  static constexpr bool needs_mass_gradient = Normals::needs_mass_gradient;
  static constexpr int contact_order = 0;
  static constexpr std::string_view state_name = "contact";

  Friction friction;
  double velocity_limit;
  Normals normals;
  ByBody<Vec<T, D>, Fields> impulse{};  ///< on each body in the last step, N s
  std::vector<ContactPair<T, D>>
      pairs{};            ///< bodies that pushed on each other in the last step, node by node
  double dissipated = 0;  ///< since the start, J

  template <class Scene>
  void connect(const Scene& scene) {
    if constexpr (requires { normals.connect(scene); }) normals.connect(scene);
    const std::size_t bodies = scene.fields.size();
    impulse = by_body<Vec<T, D>, Fields>(bodies);
    for (auto& sum : impulse) sum.setZero();
    // A step allocates nothing, unless more than four bodies share each node.
    pairs.reserve(scene.fields[0].size() * std::min<std::size_t>(bodies * (bodies - 1) / 2, 6));
  }
  template <class Scene>
  ContactTally apply_impulses(Scene& scene, double dt) {
    const auto size = [&](Index i) { return scene.mesh.node_size(i); };
    const auto tally = apply_contact(*this, normals, scene.fields, impulse, pairs, static_cast<T>(dt), size,
                                     scene.node_owner());
    dissipated += tally.dissipation;
    return tally;
  }
  /// On a body in the last step, N s.
  const Vec<T, D>& contact_impulse(std::size_t body) const { return impulse[body]; }
  template <class Scene>
  double after_grid(const Scene& scene, double) {
    const double dissipation = rest_between(pairs, scene.fields, scene.node_owner());
    dissipated += dissipation;
    return dissipation;
  }
  template <class Scene>
  double constrain_mapped(Scene& scene, double dt) {
    const double dissipation = hold_together(pairs, scene.fields, static_cast<T>(dt), scene.node_owner());
    dissipated += dissipation;
    return dissipation;
  }
  PartEnergy count_energy() const { return {.dissipated = dissipated}; }
  template <class F>
  void visit_state(F&& f) {
    f("dissipated", dissipated);
    f("impulse", std::span(impulse[0].data(), impulse.size() * static_cast<std::size_t>(D)));
  }
};

template <class N, class Traits>
auto bind_part(const Coulomb<N>& contact, const Traits& traits) {
  using T = typename Traits::T;
  constexpr int D = Traits::D;
  constexpr bool maps_back = Traits::NumericsType::maps_back;
  const auto normals = bound(contact.normals, traits);
  using Normals = std::remove_const_t<decltype(normals)>;
  constexpr bool complete = [] {
    if constexpr (requires { std::bool_constant<Normals::needs_mass_gradient>(); })
      return contact_normals<
          Normals, ByBody<NodeField<T, D, maps_back, Normals::needs_mass_gradient>, Traits::body_count>>;
    else
      return false;
  }();
  static_assert(complete,
                "Coulomb: the normals lack a member: static constexpr bool needs_mass_gradient, "
                "between(fields, a, b, node) const; see arenite/contact/normals.hpp");
  if constexpr (complete) {
    return BoundCoulomb<T, D, Normals, Traits::body_count>{contact.friction, contact.velocity_limit, normals};
  } else {
    return OneField{};  // already reported
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
