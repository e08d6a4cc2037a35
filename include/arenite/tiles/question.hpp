// Question: a request of all ranks, compared before it is carried out, so that ranks with different arguments report it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/bytes.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/hash.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The request of a rank, and its arguments: names with values as text.
struct Question {
  std::string asks{};
  std::vector<std::pair<std::string, std::string>> given{};

  Question& with(std::string name, std::string value) {
    given.emplace_back(std::move(name), std::move(value));
    return *this;
  }
  /// All bits of a number.
  template <class Number>
  requires std::is_arithmetic_v<Number> Question& with(std::string name, Number number) {
    std::array<char, 32> digits{};
    if constexpr (std::same_as<Number, bool>)
      return with(std::move(name), std::string(number ? "true" : "false"));
    else
      return with(std::move(name),
                  std::string(digits.data(),
                              std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr));
  }
  /// Many plain numbers, or vectors of them: how many, and a hash of their bytes.
  template <class Item>
  Question& with(std::string name, const std::vector<Item>& items) {
    Hash hash;
    hash.add(items.data(), items.size() * sizeof(Item));
    return with(std::move(name), joined_text({items.size(), " entries with hash ", hash.digits()}));
  }

  /// As bytes, and back: each word after its length.
  std::string packed() const {
    std::string bytes;
    const auto add = [&](const std::string& word) {
      append_bytes(bytes, word.size());
      bytes += word;
    };
    append_bytes(bytes, given.size());
    add(asks);
    for (const auto& [name, value] : given) {
      add(name);
      add(value);
    }
    return bytes;
  }
  /// Takes the first one off.
  static Question unpacked(std::string_view& bytes) {
    const auto next = [&] {
      const auto size = read_bytes<std::size_t>(bytes);
      const std::string word(bytes.substr(0, size));
      bytes.remove_prefix(size);
      return word;
    };
    Question question;
    question.given.resize(read_bytes<std::size_t>(bytes));
    question.asks = next();
    for (auto& [name, value] : question.given) {
      name = next();
      value = next();
    }
    return question;
  }
  bool operator==(const Question&) const = default;
};

/// Throws `error`, which names the first rank whose question is not that of rank 0, and where they differ. `of_ranks`: `packed` of all,
/// one after the other.
[[noreturn]] inline void refuse_different(std::string_view of_ranks) {
  const Question first = Question::unpacked(of_ranks);
  Question other = Question::unpacked(of_ranks);
  int rank = 1;
  for (; other == first && !of_ranks.empty(); ++rank) other = Question::unpacked(of_ranks);
  std::string told;
  if (other.asks != first.asks) {
    told = joined_text({"rank ", rank, " asks for ", other.asks, " while rank 0 asks for ", first.asks});
  } else {
    const auto given = [](const Question& q, std::size_t k) {
      return k < q.given.size() ? joined_text({q.given[k].first, " = ", q.given[k].second}) : "nothing";
    };
    std::size_t k = 0;
    while (k < first.given.size() && given(first, k) == given(other, k)) ++k;
    told = joined_text(
        {first.asks, ": rank ", rank, " was given ", given(other, k), ", rank 0 ", given(first, k)});
  }
  throw error(told + ": all ranks must ask for the same");
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
