// Lost load: warns once if a load acts on faces of cells without matter.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/parallel/communicator.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Checks the load on faces once: in the first step in which it is not zero. Warns if the share of it that
/// acts on matter is less than `least`.
class LostLoad {
 public:
  explicit LostLoad(double least) : least_{least} {}

  /// Whether the check is still to be made.
  bool is_due() const { return is_due_; }

  /// `given` = {all of it, its part on matter}, of any unit, in this scene; `what` names it, and `text`
  /// follows the percentage.
  template <class Communicator>
  void look(std::pair<double, double> given, const std::string& what, const std::string& text,
            const Communicator& comm) {
    auto& [all, taken] = given;
    sum_over(comm, all, taken);
    if (!(all > 0)) return;
    is_due_ = false;
    if constexpr (!Communicator::is_serial)
      if (!comm.first()) return;
    tell(taken / all, what, text);
  }

 private:
  void tell(double share, const std::string& what, const std::string& text) const {
    if (share < least_) warn(joined_text({what, ": ", std::floor(100 * share), text}));
  }

  double least_;
  bool is_due_ = true;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
