#include "bar_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "words.hpp"

namespace arenite::ffp {

std::string with_bar(double value, double u) {
  const int decimals = u > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(u))), 0, 9) : 6;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f +- %.*f", decimals, value, decimals, u);
  return text.data();
}

std::string words_of_cells(const Convergence& cells, const std::string& runs) {
  if (cells.trend == Trend::constant) return "constant";
  const auto order = cells.order;
  const std::string text = order ? " (order " + rounded(*order) + ")" : "";
  if (cells.converged) return "converged" + text + ", limit " + rounded(*cells.extrapolated);
  return "not converged: " +
         (!order         ? "it goes up and down with the size"
          : *order <= 0  ? "it changes more, the smaller the cells" + text
          : *order < 0.5 ? "its changes hardly shrink with the cells" + text
          : *order > 2   ? "its changes shrink faster than the order of the method allows" + text
                         : runs + " with cells of one size differ by as much" + text) +
         ", so that no bar can be defended; 3 times the spread is told";
}

}  // namespace arenite::ffp
