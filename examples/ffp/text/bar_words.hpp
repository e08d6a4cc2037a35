// An error bar in words.
#pragma once

#include <string>

#include <arenite/study/convergence.hpp>

namespace arenite::ffp {

/// "0.195 +- 0.012": two digits of the uncertainty, and the value as far.
std::string with_bar(double value, double u);

/// What the sizes of cells say, also to those who do not know what an order is. `runs`: "drops", "pushes".
std::string words_of_cells(const Convergence& cells, const std::string& runs);

}  // namespace arenite::ffp
