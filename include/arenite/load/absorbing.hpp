// Absorbing boundary: faces of the mesh through which waves leave.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/load/face_impedance.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/part/part_energy.hpp>
#include <arenite/warnings/lost_load.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Static support of the matter at an absorbing boundary.
enum class Support {
  none,           ///< nothing: under a load that does not pass, the boundary gives way at load / impedance
  first_reaction  ///< the forces that keep its nodes in balance in the first step, from then on
};

/// Numbers that are not given are the law's: its density, sqrt(M / rho) and sqrt(G / rho).
struct AbsorbingOptions {
  double density = std::numeric_limits<double>::quiet_NaN();        ///< kg/m3
  double pressure_wave = std::numeric_limits<double>::quiet_NaN();  ///< speed of pressure waves, m/s
  double shear_wave = std::numeric_limits<double>::quiet_NaN();     ///< speed of shear waves, m/s
  Support support = Support::none;

  /// Throws `error` for a number that was given and makes no sense. `of`: what messages call them.
  void check(std::string_view of) const {
    const auto look = [&](const char* name, double given) {
      require(std::isnan(given) || (given >= 0 && std::isfinite(given)), {of, ".", name}, given,
              "must not be negative");
    };
    look("density", density);
    look("pressure_wave", pressure_wave);
    look("shear_wave", shear_wave);
  }
};

/// Dashpots of rho c_p across and rho c_s along faces of the mesh (Lysmer and Kuhlemeyer 1969, Finite dynamic
/// model for infinite media, J. Eng. Mech. Div. 95, 859-877). Waves at normal incidence leave. Of
/// others the closed form's share is reflected, by the angle to the normal: pressure waves 0.2 % of the
/// energy at 40 deg, 4 % at 60, 12 % at 70; shear waves, at a Poisson ratio of 0.25, 4 % at 30 deg and 5 % at
/// 50 (docs/validation.md).
///
/// A dashpot has no stiffness. Where the boundary carries a static stress, as under gravity, begin with that
/// state (`FillOptions::stress`, or a run that settled on walls) and set `.support =
/// Support::first_reaction`; or apply the stress as a `traction` on the same faces. Static loads that are
/// added later must be supported by walls elsewhere.
struct AbsorbingFaces {
  MeshFaces where;
  AbsorbingOptions options;
};
/// `absorbing(bottom())`, `absorbing(on("far"), {.support = Support::first_reaction})`
inline AbsorbingFaces absorbing(MeshFaces where, const AbsorbingOptions& options = {}) {
  return {std::move(where), options};
}

/// Velocity, m/s, after a step dt in which a node of mass m was driven from `start` to `free` by other forces
/// and slowed down by dashpots; `z` = dt / m times them, -. Solves v' = a - (z / dt) v with the rational
/// approximation 1 / (1 + z + z^2 / 2) of exp(-z): of second order, and stable however light the node is.
template <class T, int D>
Vec<T, D> dashpot_velocity(const Vec<T, D>& start, const Vec<T, D>& free, const Mat<T, D>& z) {
  const Mat<T, D> one = Mat<T, D>::Identity(), left = one + z + z * z / 2;
  return left.inverse() * (free + z * (free - start) / 2);
}

/// An absorbing boundary in a mesh: a part that applies the impulses of the dashpots, and records their
/// work as dissipated.
template <class T, int D>
class BoundAbsorbingFaces {
 public:
  using V = Vec<T, D>;

  explicit BoundAbsorbingFaces(AbsorbingFaces a)
      : options_{a.options}, where_{std::move(a.where)}, name_{where_.name()} {
    options_.check(called());
  }

  template <class Scene>
  void connect(Scene& scene) {
    std::vector<WaveImpedance> of_body;
    scene.for_each_body([&](const auto& body, const auto&) { of_body.push_back(impedance(body.law)); });
    faces_.emplace(scene, where_, std::move(of_body));
    require(faces_->faces() > 0 || Scene::is_portion, {called(), ": faces"}, faces_->faces(),
            "must be at least one face of the mesh's hull");
    const std::size_t all = faces_->nodes().size() * scene.fields.size();
    given_.assign(all, V::Zero());
    if (options_.support == Support::first_reaction) support_.assign(all * dim, 0);
  }

  template <class Scene>
  ContactTally apply_impulses(Scene& scene, double dt) {
    faces_->collect(scene);
    if (lost_.is_due())
      lost_.look(
          faces_->areas(scene), called(),
          " % of the faces have matter behind them: they absorb nothing; end the mesh where the body ends",
          scene.communicator());
    if (!supported_ && !support_.empty()) take_first_reaction(scene);
    const auto step = static_cast<T>(dt);
    const auto owns = scene.node_owner();
    impulse_ = V::Zero();
    for (std::size_t k = 0, at = 0; k < faces_->nodes().size(); ++k)
      for (std::size_t f = 0; f < scene.fields.size(); ++f, ++at) {
        auto& field = scene.fields[f];
        const Index i = faces_->nodes()[k];
        const T m = field.mass[i];
        given_[at].setZero();
        if (!(m > 0)) continue;
        const V free = field.velocity[i] + step / m * support(at);
        const V after = dashpot_velocity<T, D>(field.start[i], free, step / m * faces_->at(k, f));
        given_[at] = m * (after - free);
        if (owns(i)) impulse_ += m * (after - field.velocity[i]);
        field.velocity[i] = after;
      }
    return {};
  }
  template <class Scene>
  void after_grid(const Scene& scene, double dt) {
    const auto owns = scene.node_owner();
    for (std::size_t k = 0, at = 0; k < faces_->nodes().size(); ++k)
      for (std::size_t f = 0; f < scene.fields.size(); ++f, ++at) {
        const Index i = faces_->nodes()[k];
        if (!owns(i)) continue;
        const V mean = scene.fields[f].mean_velocity(i);
        dissipated_ -= static_cast<double>(given_[at].dot(mean));
        work_ += static_cast<double>(support(at).dot(mean)) * dt;
      }
  }
  PartEnergy count_energy() const { return {.dissipated = dissipated_, .external = work_}; }
  bool holds_against(const V&) const { return options_.support != Support::none; }
  template <class F>
  void visit_state(F&& f) {
    f("dissipated", dissipated_);
    f("work", work_);
    f("supported", supported_);
    f("support", std::span(support_));
  }

  /// Its name for `reaction(scene, name)`, and its impulse on the matter in the last step, N s.
  const std::string& wall_name() const { return name_; }
  const V& given_impulse() const { return impulse_; }

 private:
  static constexpr auto dim = static_cast<std::size_t>(D);

  template <class L>
  WaveImpedance impedance(const L& law) const {
    const auto chosen = [&](const char* what, double given, double of_law) {
      const double value = std::isnan(given) ? of_law : given;
      require(std::isfinite(value), {called(), ".", what}, value, "must be given: the law does not tell it");
      return value;
    };
    const double rho = law.density();
    double shear = std::numeric_limits<double>::quiet_NaN();
    if constexpr (requires { law.elasticity().shear(); }) shear = std::sqrt(law.elasticity().shear() / rho);
    const double density = chosen("density", options_.density, rho);
    return {density * chosen("pressure_wave", options_.pressure_wave, std::sqrt(law.wave_modulus() / rho)),
            density * chosen("shear_wave", options_.shear_wave, shear)};
  }

  std::string called() const { return joined_text({"absorbing(", name_, ")"}); }

  /// N, on the matter of a field at a node.
  V support(std::size_t at) const {
    V force = V::Zero();
    if (!support_.empty())
      for (std::size_t d = 0; d < dim; ++d)
        force[static_cast<int>(d)] = static_cast<T>(support_[at * dim + d]);
    return force;
  }
  template <class Scene>
  void take_first_reaction(const Scene& scene) {
    const V acceleration = scene.acceleration();
    for (std::size_t k = 0, at = 0; k < faces_->nodes().size(); ++k)
      for (std::size_t f = 0; f < scene.fields.size(); ++f, ++at) {
        if ((faces_->at(k, f).array() == 0).all()) continue;  // not of these faces
        const auto& sums = scene.fields[f].sums[faces_->nodes()[k]];
        const V force = sums.force() + sums.mass() * acceleration;
        for (std::size_t d = 0; d < dim; ++d)
          support_[at * dim + d] = -static_cast<double>(force[static_cast<int>(d)]);
      }
    supported_ = true;
  }

  AbsorbingOptions options_;
  MeshFaces where_;
  std::string name_;
  std::optional<FaceImpedance<T, D>> faces_;  // from `connect` on
  std::vector<V> given_;         // [nodes of the faces x fields] impulses of the dashpots in this step, N s
  std::vector<double> support_;  // [nodes of the faces x fields x D] N; empty without
  LostLoad lost_{0.01};          // a side may well be higher than the matter
  V impulse_ = V::Zero();        // of the last step, N s
  double dissipated_ = 0, work_ = 0;  // since the start, J
  bool supported_ = false;            // whether the first reaction is known
};

template <class Traits>
auto bind_part(const AbsorbingFaces& faces, const Traits&) {
  return BoundAbsorbingFaces<typename Traits::T, Traits::D>(faces);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
