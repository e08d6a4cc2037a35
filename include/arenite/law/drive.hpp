// Drive: takes one point of a law along a path on which of each component either the strain or the stress is
// prescribed: simple shear, triaxial and oedometer tests, and any mixture.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/law/law.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Prescribed strain or stress of one component over a stage of a path; default: no strain.
struct DrivenComponent {
  bool stress = false;  ///< whether it is the stress
  double value = 0;     ///< change of the strain over the stage, -, or stress at its end, Pa
};
/// The strain changes by `change`, -, evenly over the stage; shear: of the tensor, half of gamma.
inline DrivenComponent strain_by(double change) { return {false, change}; }
/// The stress goes evenly from its value at the start of the stage to `end`, Pa, tension positive.
inline DrivenComponent stress_to(double end) { return {true, end}; }

/// One stage of a path.
template <int D>
struct DriveStage {
  std::array<DrivenComponent, Sym<double, D>::size>
      components{};     ///< order of `Sym`: xx, yy, zz, xy (, yz, zx)
  double duration = 1;  ///< s, >= 0
  int steps = 100;      ///< >= 1
  /// Rotation over the stage, -: the sum of the spins (`StrainStep::spin`). Simple shear by gamma, in which
  /// x moves along y, turns by {-gamma/2}.
  std::array<double, D == 2 ? 1 : 3> spin{};

  /// Throws `error` if its numbers make no sense.
  void check() const {
    require(steps >= 1, "DriveStage.steps", steps, "must be at least 1");
    require(duration >= 0 && std::isfinite(duration), "DriveStage.duration", duration,
            "must be finite, and not negative (s)");
    for (std::size_t k = 0; k < components.size(); ++k)
      require(std::isfinite(components[k].value), {"DriveStage.components[", k, "]"}, components[k].value,
              "must be finite");
    for (const double s : spin) require(std::isfinite(s), "DriveStage.spin", s, "must be finite");
  }
};

/// A point of a law on a path.
template <class Law, int D>
struct DrivenPoint {
  Sym<double, D> stress{}, strain{};  ///< Pa; sum of the steps' strains, -
  typename Law::template History<double> history{};
  double time = 0;                   ///< s
  double opening = 0, dilation = 0;  ///< sums of what `update` returned, -
  double work = 0;                   ///< of the mean stress of each step, J/m3
};

namespace detail {

/// One step of a driven point: unknown are the strains of those components whose stress is prescribed.
template <class Law, int D>
class DriveStep {
 public:
  static constexpr int size = static_cast<int>(Sym<double, D>::size);
  using Vector = Eigen::Matrix<double, size, 1>;

  /// `share`: that of the step in what is left of the stage, -.
  DriveStep(const Law& law, const DrivenPoint<Law, D>& begin, const DriveStage<D>& stage, double share)
      : law_(law), begin_(begin), modulus_(law.wave_modulus()) {
    step_.dt = stage.duration / stage.steps;
    for (std::size_t i = 0; i < step_.spin.size(); ++i) step_.spin[i] = stage.spin[i] / stage.steps;
    double size_of_step = 0, size_of_stress = 0;
    for (std::size_t i = 0; i < begin.stress.size; ++i) {
      const auto& [stress, value] = stage.components[i];
      is_stress_[i] = stress;
      target_[i] = begin.stress[i] + (value - begin.stress[i]) * share;
      if (!stress) step_.strain[i] = value / stage.steps;
      const double change = stress ? (target_[i] - begin.stress[i]) / modulus_ : step_.strain[i];
      size_of_step = std::max(size_of_step, std::abs(change));
      size_of_stress = std::max({size_of_stress, std::abs(begin.stress[i]), stress ? std::abs(value) : 0.0});
    }
    probe_ = 1e-3 * std::max(size_of_step, 1e-10 * size_of_stress / modulus_);
    tolerance_ = 1e-12 * (size_of_stress + modulus_ * size_of_step);
  }

  /// The point at the end of the step with strains `unknown` of the components of prescribed stress.
  DrivenPoint<Law, D> end(const Vector& unknown) const {
    auto point = begin_;
    auto step = step_;
    for (std::size_t i = 0; i < point.stress.size; ++i)
      if (is_stress_[i]) step.strain[i] = unknown[static_cast<int>(i)];
    const auto parts = inelastic(law_.update(point.stress, step, point.history));
    point.strain += step.strain;
    point.time += step.dt;
    point.opening += parts.opening;
    point.dilation += parts.dilation;
    point.work += 0.5 * contract(begin_.stress + point.stress, step.strain);
    return point;
  }

  /// Prescribed stresses minus those of the point, Pa; 0 where the strain is prescribed.
  Vector residual(const DrivenPoint<Law, D>& point) const {
    Vector missing = Vector::Zero();
    for (std::size_t i = 0; i < point.stress.size; ++i)
      if (is_stress_[i]) missing[static_cast<int>(i)] = target_[i] - point.stress[i];
    return missing;
  }

  /// Newton steps that move `unknown` to the solution, each halved until it is nearer. Of solutions that do
  /// not differ in stress (flow at an edge) the one nearest to the start. Returns whether the prescribed
  /// stresses are reached.
  bool solve(Vector& unknown, DrivenPoint<Law, D>& point) const {
    point = end(unknown);
    Vector missing = residual(point);
    for (int k = 0; k < 50; ++k) {
      if (missing.norm() <= tolerance_) return true;
      const Vector step = newton_step(unknown, missing);
      double part = 1;
      for (; part > 1e-6; part *= 0.5) {
        const Vector tried = unknown + part * step;
        const auto there = end(tried);
        const Vector left = residual(there);
        if (!(left.norm() < missing.norm())) continue;
        unknown = tried;
        point = there;
        missing = left;
        break;
      }
      if (part <= 1e-6) break;
    }
    return missing.norm() <= 1e3 * tolerance_;
  }

 private:
  Vector newton_step(const Vector& unknown, const Vector& missing) const {
    Eigen::Matrix<double, size, size> slope = Eigen::Matrix<double, size, size>::Zero();  // over the modulus
    for (int j = 0; j < size; ++j) {
      if (!is_stress_[static_cast<std::size_t>(j)]) continue;
      const auto moved = [&](double by) {
        Vector v = unknown;
        v[j] += by;
        return residual(end(v));
      };
      slope.col(j) = (moved(-probe_) - moved(probe_)) / (2 * probe_ * modulus_);
    }
    // Least squares with the smallest step; components of prescribed strain have rows and columns of zeros.
    Eigen::Matrix<double, size, size> normal = slope.transpose() * slope;
    normal.diagonal().array() += 1e-12 * std::max(normal.trace(), 1e-12);
    return normal.ldlt().solve(slope.transpose() * missing) / modulus_;
  }

  const Law& law_;
  const DrivenPoint<Law, D>& begin_;
  double modulus_;  // Pa
  StrainStep<double, D> step_;
  std::array<bool, Sym<double, D>::size> is_stress_{};
  Sym<double, D> target_;     // Pa
  double probe_, tolerance_;  // strain of a difference quotient, -; Pa
};

}  // namespace detail

/// Takes a point through one stage; calls `after_step(point)` after each step. Throws `error` if the numbers
/// of the stage make no sense, and `run_error` where no strain gives the prescribed stress: matter that
/// flows carries no more.
template <class Law, int D, class AfterStep>
void drive(const Law& law, DrivenPoint<Law, D>& point, const DriveStage<D>& stage, AfterStep&& after_step) {
  stage.check();
  using Step = detail::DriveStep<Law, D>;
  typename Step::Vector unknown = Step::Vector::Zero();
  for (int k = 0; k < stage.steps; ++k) {
    const auto begin = point;
    const Step step(law, begin, stage, 1.0 / (stage.steps - k));
    if (!step.solve(unknown, point))
      throw run_error(joined_text({"drive: step ", k + 1, " of ", stage.steps,
                                   " of a stage: no strain gives the prescribed stress"}));
    after_step(std::as_const(point));
  }
}
/// A point at rest without stress, or `point`, taken through stages: its states, the first and one after each
/// step.
template <int D, class Law>
std::vector<DrivenPoint<Law, D>> drive(const Law& law, const std::vector<DriveStage<D>>& stages,
                                       DrivenPoint<Law, D> point = {}) {
  std::vector<DrivenPoint<Law, D>> states{point};
  for (const auto& stage : stages)
    drive(law, point, stage, [&](const auto& state) { states.push_back(state); });
  return states;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
