// The paper's numbers beside those of our cases.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "../drop/history.hpp"
#include "../options/options.hpp"
#include "../options/paper_options.hpp"
#include "../text/json_file.hpp"
#include "../text/table_reader.hpp"
#include "paper_cases.hpp"

namespace arenite::ffp {

/// The number of this name; none if there is no such.
std::optional<double> number_at(const Json& object, const char* key);

/// The results of a case as its folder has them.
struct CaseResult {
  Json summary = Json::object();
  std::vector<double> time, depth, step;  ///< [rows] s, m, s: of the history

  bool done() const { return summary.value("status", Json()) == "done"; }
  std::optional<double> number(const char* key) const {
    return done() ? number_at(summary, key) : std::nullopt;
  }
  /// Uncertainty of a number, if the run has found it.
  std::optional<double> bar(const char* key) const {
    if (!done() || !summary.contains("uncertainty")) return std::nullopt;
    const Json& all = summary["uncertainty"];
    return all.contains(key) ? number_at(all[key], "u") : std::nullopt;
  }
  /// Depth at a time, m; none beyond the history.
  std::optional<double> depth_at(double t) const {
    if (time.empty() || t < time.front() || t > time.back()) return std::nullopt;
    const auto i = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
    if (i == 0) return depth[0];
    return depth[i - 1] + (t - time[i - 1]) / (time[i] - time[i - 1]) * (depth[i] - depth[i - 1]);
  }
};

/// Reads the files of a case's folder; without a summary the result is empty. Throws `error` that names the
/// history if a row of it is none.
CaseResult result_of_case(const std::filesystem::path& folder);

/// One line of the table.
struct Comparison {
  std::string quantity, unit, model;  ///< model: kinematics and law
  std::optional<double> paper;
  std::optional<double> ours;
  std::optional<double> bar{};  ///< of ours
  std::string note{};

  std::optional<double> difference() const {
    return paper && ours ? std::optional{*ours - *paper} : std::nullopt;
  }
};

/// Speed of a compression wave in the paper's sand, m/s.
double sand_wave_speed();

using CaseResults = std::map<std::string, CaseResult>;

/// The lines of the table for the results that there are.
std::vector<Comparison> paper_comparisons(const PaperOptions& o, const CaseResults& results);

/// paper.json as a value: the cases by their folders, and the comparisons.
Json paper_json(const PaperOptions& o, const std::vector<PaperCase>& cases, const CaseResults& results);

/// The table that a user reads, a part a model.
void print_paper_table(const std::vector<Comparison>& all, std::ostream& out);

}  // namespace arenite::ffp
