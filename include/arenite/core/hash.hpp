// Hash: 64 bits by which bytes are compared, for files and inputs.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Hash of bytes that come in pieces: equal for equal bytes, however they were cut. FNV-1a over words of
/// eight bytes, with a fold of the upper half after each, so that no change of one word goes unseen. It finds
/// damage and mix-ups, not malice. http://www.isthe.com/chongo/tech/comp/fnv
class Hash {
 public:
  void add(const void* data, std::size_t bytes) {
    if (bytes == 0) return;  // data may be null
    const auto* byte = static_cast<const unsigned char*>(data);
    size_ += bytes;
    if (kept_ > 0) {
      const std::size_t fill = std::min(bytes, word_.size() - kept_);
      std::memcpy(word_.data() + kept_, byte, fill);
      kept_ += fill;
      byte += fill;
      bytes -= fill;
      if (kept_ < word_.size()) return;
      take(word_.data());
    }
    for (; bytes >= word_.size(); bytes -= word_.size(), byte += word_.size()) take(byte);
    kept_ = bytes;
    if (bytes > 0) std::memcpy(word_.data(), byte, bytes);
  }

  std::uint64_t value() const {
    Hash end = *this;
    std::fill(end.word_.begin() + static_cast<std::ptrdiff_t>(kept_), end.word_.end(), 0);
    end.take(end.word_.data());
    std::memcpy(end.word_.data(), &size_, sizeof(size_));
    end.take(end.word_.data());
    return end.value_;
  }
  /// As 16 hexadecimal digits.
  std::string digits() const {
    const std::uint64_t sum = value();
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[(sum >> shift) & 15];
    return text;
  }

 private:
  void take(const unsigned char* eight) {
    std::uint64_t word = 0;
    std::memcpy(&word, eight, sizeof(word));
    value_ = (value_ ^ word) * 0x100000001b3;
    value_ ^= value_ >> 32;
  }

  std::uint64_t value_ = 0xcbf29ce484222325, size_ = 0;
  std::array<unsigned char, 8> word_{};  // bytes that do not fill a word yet
  std::size_t kept_ = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
