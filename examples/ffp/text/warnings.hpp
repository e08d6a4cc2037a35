// The warnings of one run: kept for the summary, and said as they come.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/warning.hpp>

#include "say.hpp"
#include "words.hpp"

namespace arenite::ffp {

/// While it lives, the library's warnings come here.
class WarningLog {
 public:
  /// `said`: they are also printed as they come.
  explicit WarningLog(bool said)
      : before_{on_warning([this, said](const std::string& text) {
          if (said) say("warning: " + shown(text, 1000));
          texts_.push_back(text);
        })} {}
  WarningLog(const WarningLog&) = delete;
  WarningLog& operator=(const WarningLog&) = delete;
  ~WarningLog() { on_warning(std::move(before_)); }

  const std::vector<std::string>& texts() const { return texts_; }
  /// Puts those of an earlier part of the run in front; one that both have is kept once.
  void add_earlier(std::vector<std::string> earlier) {
    for (auto& text : texts_)
      if (std::ranges::find(earlier, text) == earlier.end()) earlier.push_back(std::move(text));
    texts_ = std::move(earlier);
  }

 private:
  std::vector<std::string> texts_;
  WarningHook before_;
};

}  // namespace arenite::ffp
