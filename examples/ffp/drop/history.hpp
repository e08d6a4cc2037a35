// history.csv: one row a step, written during the run.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/io/csv.hpp>

#include "../options/gravity.hpp"

namespace arenite::ffp {

/// One row of the history. Penetration and velocity are positive down; the acceleration is the net one,
/// positive when it slows the device; mass x (acceleration + g) = reaction. Of one that turns, over a step: mass x
/// change of the velocity aside = reaction aside x step, moment of inertia x change of spin = moment x step. Masses,
/// forces and energies are those of the whole device and the whole chamber (the slice's times 18, those of one half
/// in space times 2).
/// Of a penetrometer that turns penetration is the tip's, velocity and acceleration the centre of mass's.
struct HistoryRow {
  double time_s = 0;
  double penetration_m = 0;
  double velocity_m_s = 0;
  double acceleration_m_s2 = 0;  ///< over the step that ends at `time_s`
  double reaction_N = 0;         ///< over the step that ends at `time_s`
  double time_step_s = 0;
  double kinetic_energy_J = 0;
  double strain_energy_J = 0;
  double plastic_work_J = 0;
  double contact_dissipation_J = 0;
  double external_work_J = 0;
  double transfer_loss_J = 0;
  double wall_loss_J = 0;
  double energy_residual_J = 0;
  double lost_points = 0;
  double contact_nodes = 0;
  double fill_ratio = 0;  ///< of the elements at the device; NaN, an empty field, while nothing touches
  double mean_volume_ratio = 1;   ///< mean V/V0 of the sand
  double tilt_deg = 0;            ///< of the axis to the vertical
  double aside_m = 0;             ///< way of the tip, to where it pointed at the impact
  double aside_velocity_m_s = 0;  ///< of the centre of mass, the same way
  double aside_reaction_N = 0;    ///< over the step that ends at `time_s`
  double spin_rad_s = 0;          ///< positive when the tilt grows
  double moment_N_m = 0;          ///< of the sand about the centre of mass, over that step
};

/// Columns of the history: names and members, in the order of the file. The last six are those of a
/// penetrometer that turns.
inline constexpr std::array<std::pair<const char*, double HistoryRow::*>, 24> history_columns{{
    {"time_s", &HistoryRow::time_s},
    {"penetration_m", &HistoryRow::penetration_m},
    {"velocity_m_s", &HistoryRow::velocity_m_s},
    {"acceleration_m_s2", &HistoryRow::acceleration_m_s2},
    {"reaction_N", &HistoryRow::reaction_N},
    {"time_step_s", &HistoryRow::time_step_s},
    {"kinetic_energy_J", &HistoryRow::kinetic_energy_J},
    {"strain_energy_J", &HistoryRow::strain_energy_J},
    {"plastic_work_J", &HistoryRow::plastic_work_J},
    {"contact_dissipation_J", &HistoryRow::contact_dissipation_J},
    {"external_work_J", &HistoryRow::external_work_J},
    {"transfer_loss_J", &HistoryRow::transfer_loss_J},
    {"wall_loss_J", &HistoryRow::wall_loss_J},
    {"energy_residual_J", &HistoryRow::energy_residual_J},
    {"lost_points", &HistoryRow::lost_points},
    {"contact_nodes", &HistoryRow::contact_nodes},
    {"fill_ratio", &HistoryRow::fill_ratio},
    {"mean_volume_ratio", &HistoryRow::mean_volume_ratio},
    {"tilt_deg", &HistoryRow::tilt_deg},
    {"aside_m", &HistoryRow::aside_m},
    {"aside_velocity_m_s", &HistoryRow::aside_velocity_m_s},
    {"aside_reaction_N", &HistoryRow::aside_reaction_N},
    {"spin_rad_s", &HistoryRow::spin_rad_s},
    {"moment_N_m", &HistoryRow::moment_N_m},
}};
inline constexpr std::size_t guided_columns = 18;

/// Rows of a run so far: for a saved state numbers side by side.
struct HistoryRows {
  std::vector<HistoryRow> all{};

  double* data() { return reinterpret_cast<double*>(all.data()); }
  std::size_t size() const { return all.size() * history_columns.size(); }
  void resize(std::size_t numbers) { all.resize(numbers / history_columns.size()); }
};
static_assert(sizeof(HistoryRow) == history_columns.size() * sizeof(double));

/// history.csv as it grows.
class HistoryFile {
 public:
  /// `turns`: whether the penetrometer may. Throws `error` if the file cannot be written.
  HistoryFile(const std::filesystem::path& path, bool turns)
      : columns_{turns ? history_columns.size() : guided_columns}, csv_{path, names()} {}

  void write(const HistoryRow& row) {
    std::array<std::optional<double>, history_columns.size()> values{};
    for (std::size_t i = 0; i < columns_; ++i)
      if (const double value = row.*history_columns[i].second; !std::isnan(value)) values[i] = value;
    csv_.row(std::span(values).first(columns_));
  }

 private:
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < columns_; ++i) all.emplace_back(history_columns[i].first);
    return all;
  }

  std::size_t columns_;
  CsvWriter csv_;
};

}  // namespace arenite::ffp
