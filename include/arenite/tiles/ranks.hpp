// Ranks: the processes that have tiles of one mesh, and what they do for each other.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/tiles/question.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The processes among which the tiles of a mesh are dealt out. All of them call the same members in the same order, one thread at a
/// time in each. What waits for another process throws `run_error` if that one has failed.
class Ranks {
 public:
  /// Bytes for another rank, and room for as many as it sends.
  struct Swap {
    int rank = 0;
    std::span<const std::byte> to;
    std::span<std::byte> from;
  };

  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  virtual void swap(std::span<const Swap> with) = 0;
  /// Bytes for each of some ranks, which call it with this one among theirs. Returns those from each, in the same order.
  virtual std::vector<std::string> exchange(std::span<const int> ranks,
                                            const std::vector<std::string>& to) = 0;
  /// Each number becomes the sum of those of all ranks.
  virtual void sum(std::span<std::int64_t> numbers) = 0;
  /// The numbers of all ranks, in their order.
  virtual std::vector<double> gather(const std::vector<double>& numbers) = 0;
  /// The same of bytes.
  virtual std::string gather(const std::string& bytes) = 0;
  /// The least number of all ranks; none of them is NaN.
  virtual double least(double number) = 0;
  /// This rank has failed: the others throw where they wait.
  virtual void fail(const std::string& what) = 0;
  /// Compares what all ranks ask, before it is done, in one small message. Throws `error` that names rank and difference, on all ranks.
  /// Returns whether one of them says `yes`.
  virtual bool agree(const Question& question, bool yes = false) = 0;
  /// This rank's program ends: others that wait for it in `agree` throw.
  virtual void leave() {}
};

/// One process, which has all tiles.
class OneRank final : public Ranks {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  void swap(std::span<const Swap>) override {}
  std::vector<std::string> exchange(std::span<const int>, const std::vector<std::string>&) override {
    return {};
  }
  void sum(std::span<std::int64_t>) override {}
  std::vector<double> gather(const std::vector<double>& numbers) override { return numbers; }
  std::string gather(const std::string& bytes) override { return bytes; }
  double least(double number) override { return number; }
  void fail(const std::string&) override {}
  bool agree(const Question&, bool yes = false) override { return yes; }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
