// Hash: 64 bits that tell whether bytes are the same, for files and inputs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace arenite {

/// FNV-1a of bytes that come in pieces: equal for equal bytes, however they were cut. It finds damage and
/// mix-ups, not malice. http://www.isthe.com/chongo/tech/comp/fnv
class Hash {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* const byte = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < bytes; ++k) value_ = (value_ ^ byte[k]) * 0x100000001b3;
  }

  std::uint64_t value() const { return value_; }
  /// As 16 hexadecimal digits.
  std::string digits() const {
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[(value_ >> shift) & 15];
    return text;
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace arenite
