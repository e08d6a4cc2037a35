// Text and numbers in messages: one line, and not too long.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace arenite::ffp {

/// `text` with a blank in the place of each control character; if longer than `most` bytes, without its
/// middle: "start .. end". Whole UTF-8 characters.
std::string shown(std::string_view text, std::size_t most = 120);

/// With as many digits as it was typed with.
std::string exactly(double x);

/// Three significant digits; "1960", not "1.96e+03".
std::string rounded(double x);

/// "40 s", "12 min", "5 h" or "3 days".
std::string duration(double seconds);

}  // namespace arenite::ffp
