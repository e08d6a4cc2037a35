// Rigid body in a scene: its state, and its contact with the node fields. What the soil loses in a step the
// body gains.
#pragma once

#include <vector>

#include <arenite/contact/contact.hpp>
#include <arenite/rigid/motion.hpp>
#include <arenite/rigid/surface.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A rigid body that a scene owns. Read `displacement`, `velocity` and `force` after any step.
template <class T, int D, class Surface, class Motion, class Coupling>
struct RigidBody {
  static constexpr bool is_free = Motion::free;
  static constexpr bool coupling_through_centre = Coupling::through_centre_of_mass;
  static_assert(!coupling_through_centre || (Surface::has_shares && is_free),
                "Rigid: CentreOfMass needs a MeshSurface and a Guided motion, which give the body's nodes "
                "their masses");
  Surface surface;
  Motion motion;
  Friction friction;
  Vec<T, D> axis = Vec<T, D>::Zero();          ///< unit vector of the guide; zero if prescribed
  Vec<T, D> displacement = Vec<T, D>::Zero();  ///< since the start, m
  Vec<T, D> velocity = Vec<T, D>::Zero();      ///< m/s
  Vec<T, D> force = Vec<T, D>::Zero();         ///< mean contact force on the body during the last step, N
  Vec<T, D> impulse = Vec<T, D>::Zero();       ///< contact impulse on the body since the start, N s
  double driving_work = 0;                     ///< work of gravity, load or the prescribed motion's drive, J
  std::size_t contact_nodes = 0;               ///< nodes that pushed on the body in the last step
  std::size_t inside_nodes = 0;                ///< nodes inside the body that carried mass in the last step

  /// One touched node of one field.
  struct Touch {
    std::size_t field;
    Index node;
    bool inside;
    T mass;           ///< of the field at the node, kg
    T share;          ///< what an impulse has to move, as a share of `mass`: 1, or m_rigid / (m_rigid + mass)
    Vec<T, D> start;  ///< velocity of the field before contact, m/s
    Vec<T, D> normal;                       ///< out of the body
    bool sticks = false;                    ///< to the body: no relative motion at all
    Vec<T, D> impulse = Vec<T, D>::Zero();  ///< on the field, N s
  };
  std::vector<Touch> touches{};  ///< of the last step

  double kinetic_energy() const {
    if constexpr (Motion::free) return 0.5 * motion.mass * static_cast<double>(velocity.squaredNorm());
    return 0;
  }

  /// Impulse on the field at a touched node if the body moves with velocity v.
  Vec<T, D> impulse_at(const Touch& t, const Vec<T, D>& v) const {
    const Vec<T, D> approach = t.start - v;
    if (t.inside) return -(t.share * t.mass) * approach;
    return coulomb_impulse<T, D>(approach, t.normal, t.share * t.mass, friction);
  }
};

namespace detail {

template <class Shape, class M, class R, class Fields>
void find_touches(const M& mesh, R& body, const Fields& fields) {
  using T = typename M::scalar;
  body.touches.clear();
  body.inside_nodes = 0;
  body.surface.template visit<Shape>(
      mesh, body.displacement, [&](Index node, const auto& normal, bool inside, [[maybe_unused]] T share) {
        for (std::size_t f = 0; f < fields.size(); ++f) {
          const T mass = fields[f].mass[node];
          if (!(mass > 0)) continue;
          T moved = 1;
          if constexpr (R::coupling_through_centre) {
            const T rigid_mass = share * static_cast<T>(body.motion.mass);
            if (!inside) moved = rigid_mass / (rigid_mass + mass);
          }
          body.touches.push_back({f, node, inside, mass, moved, fields[f].velocity[node], normal});
          body.inside_nodes += inside;
        }
      });
}

/// Speed along the guide that balances the impulses: f(s) = M (s - trial) + axis . sum J(s) = 0. f is made of
/// pieces that are straight (or nearly so, with friction in three dimensions), whose slopes may differ by as
/// much as soil and body: Newton steps on the pieces, inside a bracket that is halved where they leave it or
/// do not get ahead.
template <class R, class T>
T balance_speed(const R& body, T trial, T mass) {
  T soil = 0;
  for (const auto& t : body.touches) soil += t.share * t.mass;
  const auto pull = [&](T s) {
    T sum = 0;
    for (const auto& t : body.touches) sum += body.impulse_at(t, s * body.axis).dot(body.axis);
    return sum;
  };
  constexpr T round_off = std::numeric_limits<T>::epsilon();
  T s = trial, f = pull(s);
  if (f == 0) return trial;
  const T sign = f > 0 ? T(1) : T(-1);
  T near = trial;            // f has the sign of the start here, and the other one (or none) at `far`
  T far = trial - f / mass;  // here the body alone would have taken the impulse of the trial speed
  T before = std::numeric_limits<T>::infinity();
  for (int k = 0; k < 200; ++k) {
    const T h = -sign * std::sqrt(round_off) * std::max(std::abs(s - trial), std::abs(f) / (mass + soil));
    const T slope = mass + (pull(s + h) - pull(s)) / h;
    T next = s - f / slope;
    if (!((next - near) * (next - far) < 0) || 2 * std::abs(f) > before) next = near + (far - near) / 2;
    before = std::abs(f);
    const T change = std::abs(next - s);
    s = next;
    f = mass * (s - trial) + pull(s);
    (f * sign > 0 ? near : far) = s;
    if (f == 0 || change <= 4 * round_off * std::abs(s - trial)) break;
  }
  return s;
}

}  // namespace detail

/// Advances the body by dt and lets it exchange impulses with all fields. Gravity and `load` act on a guided
/// body first; then its new velocity is found with the impulses. Returns what contact dissipated.
template <class Shape, class M, class R, class Fields, class T, int D>
ContactTally collide(const M& mesh, R& body, Fields& fields, const Vec<T, D>& gravity, T time, T dt) {
  detail::find_touches<Shape>(mesh, body, fields);
  const Vec<T, D> before = body.velocity;
  Vec<T, D> trial = before;
  if constexpr (R::is_free) {
    const T drive = gravity.dot(body.axis) + static_cast<T>(body.motion.load / body.motion.mass);
    trial += dt * drive * body.axis;
    const T mass = static_cast<T>(body.motion.mass);
    const T s = trial.dot(body.axis);
    if constexpr (R::coupling_through_centre) {
      body.velocity = trial;  // impulses against the trial velocity; eq. (4) corrects it below
    } else {
      body.velocity = detail::balance_speed(body, s, mass) * body.axis;
    }
  } else {
    const auto v = body.motion.velocity(static_cast<double>(time));
    for (int k = 0; k < D; ++k) trial[k] = static_cast<T>(v[static_cast<std::size_t>(k)]);
    body.velocity = trial;
  }
  ContactTally tally;
  Vec<T, D> total = Vec<T, D>::Zero();  // on the fields
  T gained = 0;                         // by the fields: impulses times their mean velocities over the step
  T exchanged = 0;                      // magnitudes of the impulses
  body.contact_nodes = 0;
  for (auto& t : body.touches) {
    const Vec<T, D> j = body.impulse_at(t, body.velocity);
    if (j.squaredNorm() == 0) continue;
    t.impulse = j;
    t.sticks = t.inside || sticks<T, D>(t.start - body.velocity, t.normal, body.friction);
    Vec<T, D>& v = fields[t.field].velocity[t.node];
    v += j / t.mass;
    total += j;
    exchanged += j.norm();
    gained += j.dot(fields[t.field].start[t.node] + v) / 2;
    ++body.contact_nodes;
  }
  tally.nodes = body.contact_nodes;
  body.force = -total / dt;
  body.impulse -= total;
  if constexpr (R::is_free) {
    const T mass = static_cast<T>(body.motion.mass);
    // What is left of the balance is given to the body, unless it is round-off of the impulses: a very light
    // body would make a velocity of it.
    const T left = mass * (body.velocity - trial).dot(body.axis) + total.dot(body.axis);
    if (std::abs(left) > 16 * std::numeric_limits<T>::epsilon() * exchanged)
      body.velocity = trial - (total.dot(body.axis) / mass) * body.axis;
    const Vec<T, D> mean = (before + body.velocity) / 2;
    tally.dissipation = static_cast<double>(total.dot(mean) - gained);
    body.driving_work += static_cast<double>(mass * (trial - before).dot(mean));
  } else {
    tally.dissipation = static_cast<double>(total.dot(body.velocity) - gained);
    body.driving_work += static_cast<double>(total.dot(body.velocity));
  }
  body.displacement += dt * body.velocity;
  return tally;
}

/// Holds the mapped velocities of MUSL to the body where it gave an impulse, along the normal or altogether,
/// in both directions: see `hold_together`, the same between fields. Returns the energy that this dissipates
/// beside what `collide` booked, J.
template <bool Centred, class R, class Fields, class T>
double hold_to(const R& body, Fields& fields, T dt) {
  double dissipation = 0;
  for (const auto& t : body.touches) {
    if (t.impulse.squaredNorm() == 0) continue;
    using V = std::remove_cvref_t<decltype(t.normal)>;
    auto& field = fields[t.field];
    auto& v = field.mapped[t.node];
    const V apart = v - field.velocity[t.node];
    const V removed = t.sticks ? apart : V(apart.dot(t.normal) * t.normal);
    V twice = apart;
    if constexpr (Centred) twice += v - field.start[t.node];
    dissipation -=
        static_cast<double>(t.impulse.dot(twice) / 2 + dt * field.collected[t.node].force().dot(removed));
    v -= removed;
  }
  return dissipation;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
