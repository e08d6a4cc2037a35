// The resistance by depth: history.csv of a push, and what is read off it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace arenite::ffp {

/// Means over a twentieth of a diameter of way, at its end. Forces of explicit steps ring from step to step, means over way do not.
struct PushRow {
  double time_s = 0;
  double depth_m = 0;                 ///< of the tip
  double pushed_m = 0;                ///< way of the tip
  double force_N = 0;                 ///< all of it
  double q_c_kPa = 0;                 ///< of the tip, over the section
  double f_s_kPa = 0;                 ///< of the sleeve, over its mantle; NaN before it has gone a diameter
  double friction_ratio_percent = 0;  ///< f_s / q_c
  double vertical_stress_kPa = 0;     ///< at rest, at the tip
  double kinetic_energy_J = 0;
  double plastic_work_J = 0;
  double contact_dissipation_J = 0;
  double external_work_J = 0;
  double transfer_loss_J = 0;
  double energy_residual_J = 0;
  double lost_points = 0;
  double fill_ratio = 0;  ///< of the elements at the penetrometer
  double mean_volume_ratio = 1;

  double net_kPa() const { return q_c_kPa - vertical_stress_kPa; }
};

inline constexpr std::array<std::pair<const char*, double PushRow::*>, 17> push_columns{{
    {"time_s", &PushRow::time_s},
    {"depth_m", &PushRow::depth_m},
    {"pushed_m", &PushRow::pushed_m},
    {"force_N", &PushRow::force_N},
    {"q_c_kPa", &PushRow::q_c_kPa},
    {"f_s_kPa", &PushRow::f_s_kPa},
    {"friction_ratio_percent", &PushRow::friction_ratio_percent},
    {"vertical_stress_kPa", &PushRow::vertical_stress_kPa},
    {"kinetic_energy_J", &PushRow::kinetic_energy_J},
    {"plastic_work_J", &PushRow::plastic_work_J},
    {"contact_dissipation_J", &PushRow::contact_dissipation_J},
    {"external_work_J", &PushRow::external_work_J},
    {"transfer_loss_J", &PushRow::transfer_loss_J},
    {"energy_residual_J", &PushRow::energy_residual_J},
    {"lost_points", &PushRow::lost_points},
    {"fill_ratio", &PushRow::fill_ratio},
    {"mean_volume_ratio", &PushRow::mean_volume_ratio},
}};

/// The results of a push.
struct Resistance {
  double depth_m;                          ///< of the tip, at the end
  double q_c_kPa, net_kPa;                 ///< means over the last diameter
  double f_s_kPa, friction_ratio_percent;  ///< the same; NaN: no sleeve yet
  double
      growth;  ///< of the net resistance in a further diameter, over itself, from the halves of the last diameter
  std::optional<double>
      steady_from_m;  ///< depth from which it stays within `steady` of its last; none: it still grows or falls
};

/// Net resistance changes less than this in a diameter: a steady state.
inline constexpr double steady = 0.05;

/// Nothing where less than a diameter was pushed. diameter: m.
std::optional<Resistance> resistance_of(std::span<const PushRow> rows, double diameter);

}  // namespace arenite::ffp
