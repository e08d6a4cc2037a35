// A result with its error bar, as JSON and in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include <arenite/error_bar/convergence.hpp>
#include <arenite/error_bar/uncertainty.hpp>

#include "../text/json_file.hpp"

namespace arenite::ffp {

struct BarredResult {
  double value = 0;
  std::optional<Convergence> cells;  ///< nothing: one of the runs with coarser cells has no result
  Uncertainty uncertainty;           ///< parts by name; "cells" is one

  bool converged() const { return cells && cells->converged; }
};

/// "value", "u" and what that is made of; null: unknown.
Json json_of(const BarredResult& r);

/// "0.195 +- 0.012 m", or what is known of it.
std::string words_of(const BarredResult& r, const std::string& unit);

/// Convergence with the cells in words, also for readers new to orders. `runs`: "drops", "pushes".
std::string words_of_cells(const BarredResult& r, const std::string& runs);

}  // namespace arenite::ffp
