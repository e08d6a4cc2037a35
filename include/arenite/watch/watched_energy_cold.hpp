// Cold functions of watched_energy.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/watch/watched_energy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD WatchedEnergy::Found WatchedEnergy::judge(const Balance& now, std::size_t changes,
                                                       double initial, bool tracks) {
  if (!started_) {
    started_ = true;
    start_ = now;
    put_in_ = initial;
    changes_ = changes;
  } else if (!tracks && changes_ != changes) {
    // The energy of the points lost or inserted is not known: start again.
    put_in_ += now.brought - start_.brought;
    start_ = now;
    before_ = gain_;
    changes_ = changes;
  }
  gain_ = before_ + now.gained - start_.gained;
  moved_ = std::max(moved_, std::abs(now.external - start_.external));
  if (tracks) lowest_ = std::min(lowest_, gain_);
  const auto fraction = [&](double energy) {
    const double all = put_in_ + moved_ + now.brought - start_.brought;
    const double f = energy == 0 ? 0 : energy / std::max(all, floor_);
    return f > 0 || std::isnan(f) ? f : 0;
  };
  return {true, fraction(gain_ - lowest_), fraction(now.transfer - start_.transfer),
          fraction(std::abs(now.residual - start_.residual))};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
