#include "barred_result.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

/// "0.195 +- 0.012": two digits of the uncertainty, and the value as far.
std::string with_bar(double value, double u) {
  const int decimals = u > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(u))), 0, 9) : 6;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f +- %.*f", decimals, value, decimals, u);
  return text.data();
}

}  // namespace

Json json_of(const BarredResult& r) {
  Json j;
  j["value"] = r.value;
  j["u"] = or_null(r.uncertainty.total());
  if (!r.uncertainty.total()) j["u_at_least"] = r.uncertainty.known();
  j["order"] = or_null(r.cells ? r.cells->order : std::nullopt);
  j["extrapolated"] = or_null(r.cells ? r.cells->extrapolated : std::nullopt);
  j["converged"] = r.converged();
  for (const auto& part : r.uncertainty.parts()) j["parts"][part.name] = or_null(part.value);
  return j;
}

std::string words_of(const BarredResult& r, const std::string& unit) {
  const auto total = r.uncertainty.total();
  if (total) return with_bar(r.value, *total) + " " + unit;
  return rounded(r.value) + " " + unit + " +- unknown (at least " + rounded(r.uncertainty.known()) + " " +
         unit + ")";
}

std::string words_of_cells(const BarredResult& r, const std::string& runs) {
  if (!r.cells) return "unknown";
  if (r.cells->trend == Trend::constant) return "constant";
  const auto order = r.cells->order;
  const std::string text = order ? " (order " + rounded(*order) + ")" : "";
  if (r.converged()) return "converged" + text + ", limit " + rounded(*r.cells->extrapolated);
  return "not converged: " +
         (!order         ? "it goes up and down with the size"
          : *order <= 0  ? "it changes more, the smaller the cells" + text
          : *order < 0.5 ? "its changes hardly shrink with the cells" + text
          : *order > 2   ? "its changes shrink faster than the order of the method allows" + text
                         : runs + " with cells of one size differ by as much" + text) +
         ", so that no bar can be defended; 3 times the spread is told";
}

}  // namespace arenite::ffp
