// summary.json of a push, and what it says in one line.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../options/push_options.hpp"
#include "../text/json_file.hpp"
#include "closed_forms.hpp"
#include "profile.hpp"

namespace arenite::ffp {

/// How a run stands.
struct PushNumbers {
  std::string status = "running";  ///< or "done", "failed", "interrupted", "disk-full"
  std::string failure{};           ///< when, where and why it ended early
  std::string started{};           ///< UTC, ISO 8601
  long points = 0, steps = 0, lost_points = 0;
  int threads = 1;
  double wall_s = 0;
  std::vector<std::string> warnings{};
};

/// Inputs by the keywords of their options, of itself values too.
Json inputs_of(const PushOptions& o);

/// Upper bound of inertia's share of the resistance: density x speed^2 / q_c.
double inertia_share(const PushOptions& o, const Resistance& r);

Json summary_of(const PushOptions& o, std::span<const PushRow> rows, const PushNumbers& run);

/// The results of a push in one line.
std::string sentence_of(const PushOptions& o, std::span<const PushRow> rows);

}  // namespace arenite::ffp
