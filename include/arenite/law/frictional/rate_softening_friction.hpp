// Softening and shear rate together: peak angles that grow with the logarithm of the rate, and fall to
// residual ones with plastic shear.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/law/frictional/shear_rate.hpp>
#include <arenite/law/frictional/softening_friction.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// phi = phi_r + (phi_p(rate) - phi_r) exp(-eta eps_p), phi_p(rate) = phi_p (1 + a log10(rate / reference)),
/// and the dilatancy alike with its own factor; peak values phi_p and psi_p of the law's parameters.
/// Below the reference rate the factors are 1. Zambrano-Cruzatty & Yerro (2020), Soils and Foundations 60,
/// 668-682, and their code for users of Anura3D and Abaqus. Softening: see `SofteningFriction`.
class RateSofteningFriction {
 public:
  template <class T>
  using History = JoinedHistory<ShearRateHistory<T>, PlasticStrainHistory<T>>;

  /// Defaults of rate: sample input of the paper's code, not calibrated to a sand. Its softening: from
  /// 39 to 36 deg, dilatancy from 10 deg to 0, decay 8.
  struct Parameters {
    SofteningParameters softening{};
    double friction_per_decade = 0.027;  ///< a of phi, -, >= 0
    double dilatancy_per_decade = 0.27;  ///< a of psi, -, >= 0
    double reference_rate = 2.1e-5;      ///< 1/s, positive
    double smoothing = 0;                ///< time over which the rate is smoothed, s, >= 0; 0: none
  };

  explicit RateSofteningFriction(const Parameters& p)
      : softening_(name, p.softening),
        friction_per_decade_(p.friction_per_decade),
        dilatancy_per_decade_(p.dilatancy_per_decade),
        reference_(p.reference_rate),
        filter_(name, p.smoothing) {
    detail::check(p.friction_per_decade >= 0 && std::isfinite(p.friction_per_decade), name,
                  "friction_per_decade", p.friction_per_decade, "must not be negative");
    detail::check(p.dilatancy_per_decade >= 0 && std::isfinite(p.dilatancy_per_decade), name,
                  "dilatancy_per_decade", p.dilatancy_per_decade, "must not be negative");
    check_reference_rate(name, p.reference_rate);
  }

  bool constant() const {
    return softening_.decay() == 0 && friction_per_decade_ == 0 && dilatancy_per_decade_ == 0;
  }
  void check(const GivenAngles& given) const { softening_.check_given(given); }
  double least_slope(const GivenAngles&) const { return softening_.least_slope(); }

  template <class T, int D>
  void follow(const StrainStep<T, D>& step, History<T>& history) const {
    filter_.update(step, history);
  }
  template <class T, int D>
  T slope(const GivenAngles& given, const StrainStep<T, D>&, const Sym<T, D>&,
          const History<T>& history) const {
    return softening_.slope(peak(given.friction, friction_per_decade_, history.shear_rate),
                            softening_.left(history));
  }
  template <class T>
  T dilatancy_slope(const GivenAngles& given, const History<T>& history) const {
    return softening_.dilatancy_slope(peak(given.dilatancy, dilatancy_per_decade_, history.shear_rate),
                                      softening_.left(history));
  }

 private:
  static constexpr const char* name = "RateSofteningFriction";

  template <class T>
  T peak(double angle, double per_decade, const T& rate) const {
    return T(angle) + T(angle * per_decade) * decades_above(rate, reference_);
  }

  detail::Softening softening_;
  double friction_per_decade_, dilatancy_per_decade_, reference_;  // -, -, 1/s
  RateFilter filter_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
