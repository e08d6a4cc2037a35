// Resistances by theory, to compare with the numbers of a push.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../options/push_options.hpp"

namespace arenite::ffp {

/// Factor of a cone of 60 deg in Tresca soil, (q_c - vertical stress) / strength (Teh and Houlsby 1991, Geotechnique 41, 17-34):
///
///   N = 4/3 (1 + ln Ir) (1.25 + Ir / 2000) + 2.4 a_f - 0.2 a_s - 1.8 D
///
/// a_f, a_s: roughness of cone and shaft, 0 to 1; D = (vertical - horizontal stress) / (2 strength). For Ir of 50 to 500.
double teh_houlsby(double rigidity_index, double face, double shaft, double anisotropy);

/// Pressure, Pa, at which a spherical cavity in Mohr-Coulomb soil grows without limit (Yu and Houlsby 1991, Geotechnique 41, 173-183):
/// large strains in the plastic zone, elastic outside.
struct CavitySoil {
  double young, poisson;
  double friction, dilatancy;  ///< rad; 0 < friction, dilatancy <= friction
  double cohesion;             ///< Pa
};
double cavity_limit(const CavitySoil& soil, double initial_pressure);

/// A resistance by theory.
struct ClosedForm {
  std::string name, source;
  double value;         ///< Pa, net of the vertical stress in clay
  bool is_lower_guide;  ///< the resistance must be more
};

/// Those that apply to a push at a depth of the tip, m; none: no theory here fits it.
std::vector<ClosedForm> closed_forms(const PushOptions& o, double depth);

}  // namespace arenite::ffp
