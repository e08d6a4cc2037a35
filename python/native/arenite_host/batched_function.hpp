// Functions of place that the host is asked for once, for all places together: one call of an interpreter
// costs as much as the arithmetic of a thousand places.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite_host/value.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// A row of `Count` numbers out of what a function of the host returned for one argument; of three numbers
/// the last may be missing.
template <std::size_t Count>
std::array<double, Count> row_of(const HostArray& out, std::size_t row, std::size_t rows,
                                 const std::string& name) {
  const std::size_t n = out.numbers.size() / rows;
  if (n == 0 || n * rows != out.numbers.size() || n > Count || (Count != 3 && n != Count))
    throw error(joined_text({name, " = a function that returns ", out.numbers.size(), " numbers for ", rows,
                             rows == 1 ? " place" : " places", ": must return ", Count == 3 ? "up to " : "",
                             Count, " for each"}));
  std::array<double, Count> numbers{};
  std::copy_n(out.numbers.begin() + static_cast<std::ptrdiff_t>(row * n), n, numbers.begin());
  return numbers;
}

/// Calls a function of the host with one row.
template <std::size_t Count>
std::array<double, Count> call_row(const HostFunction& f, std::vector<double> arguments,
                                   const std::string& name) {
  const std::size_t columns = arguments.size();
  return row_of<Count>(f({std::move(arguments), {1, columns}}), 0, 1, name);
}

}  // namespace detail

/// Base of functions of place: a first pass records positions, the host evaluates them in one call, and later
/// passes, in the same order, replay the values.
class AnyBatchedFunction {
 public:
  using Place = std::array<double, 3>;

  virtual ~AnyBatchedFunction() = default;
  /// Evaluates the recorded positions in one call; later passes replay the values.
  virtual void compute() = 0;
  /// The next pass begins.
  void rewind() { next_ = 0; }

 protected:
  bool notes_ = true;
  std::size_t next_ = 0;
  std::vector<Place> places_{};
};

/// A function of place with values of `Count` numbers. A position out of order is evaluated separately.
template <std::size_t Count>
class BatchedFunction : public AnyBatchedFunction {
 public:
  using Row = std::array<double, Count>;

  BatchedFunction(HostFunction f, int dimension, std::string name)
      : f_{std::move(f)}, dimension_{static_cast<std::size_t>(dimension)}, name_{std::move(name)} {}

  Row operator()(const Place& x) {
    if (notes_) {
      places_.push_back(x);
      return {};
    }
    for (std::size_t k = next_; k < places_.size(); ++k)
      if (places_[k] == x) {
        next_ = k + 1;
        return values_[k];
      }
    return detail::call_row<Count>(f_, {x.begin(), x.begin() + static_cast<std::ptrdiff_t>(dimension_)},
                                   name_);
  }

  void note(const std::vector<Place>& places) { places_ = places; }
  void compute() override {
    notes_ = false;
    rewind();
    if (places_.empty()) return;
    HostArray at{{}, {places_.size(), dimension_}};
    at.numbers.reserve(places_.size() * dimension_);
    for (const Place& x : places_)
      at.numbers.insert(at.numbers.end(), x.begin(), x.begin() + static_cast<std::ptrdiff_t>(dimension_));
    const HostArray out = f_(at);
    values_.resize(places_.size());
    for (std::size_t p = 0; p < places_.size(); ++p)
      values_[p] = detail::row_of<Count>(out, p, places_.size(), name_);
  }

 private:
  HostFunction f_;
  std::size_t dimension_;
  std::string name_;
  std::vector<Row> values_{};
};

/// Values of functions of place at all positions of a scene, from which its tiles read theirs: a function receives all positions at
/// once, however the scene is cut. Functions are identified by address: copies of values share them.
class PlaceMemory {
 public:
  /// The function that a reader calls instead of `f`. Until `close` it calls `f`, and stores the first call for several positions, which
  /// has all; after `close` it returns the stored values, evaluates a single other position separately, and refuses others.
  HostFunction ask(const HostFunction& f, const std::string& name) {
    if (is_closed_) {
      const auto found = kept_.find(&f);
      if (found == kept_.end()) return f;
      return [f, name, kept = found->second](const HostArray& at) { return take(*kept, f, at, name); };
    }
    return [f, kept = kept_[&f] = std::make_shared<Kept>()](const HostArray& at) {
      HostArray out = f(at);
      if (kept->at.numbers.empty() && at.rows() > 1) *kept = {at, out, {}};
      return out;
    };
  }
  void close() {
    is_closed_ = true;
    for (auto& [f, kept] : kept_) {
      if (kept->at.numbers.empty()) continue;
      kept->order.resize(kept->at.rows());
      std::iota(kept->order.begin(), kept->order.end(), std::size_t{0});
      const auto& of = *kept;
      std::ranges::stable_sort(kept->order, [&of](std::size_t a, std::size_t b) {
        return std::ranges::lexicographical_compare(of.place(a), of.place(b));
      });
    }
  }

 private:
  /// Row `k` of an array of `rows` rows.
  static std::span<const double> row(const HostArray& of, std::size_t k, std::size_t rows) {
    const std::size_t columns = of.numbers.size() / rows;
    return std::span(of.numbers).subspan(k * columns, columns);
  }
  struct Kept {
    HostArray at{}, out{};
    std::vector<std::size_t> order{};  // [rows] ascending places; equal ones in the order of the call

    std::span<const double> place(std::size_t k) const { return row(at, k, at.rows()); }
  };

  static HostArray take(const Kept& kept, const HostFunction& f, const HostArray& at,
                        const std::string& name) {
    HostArray out{{}, {at.rows()}};
    std::map<std::size_t, std::ptrdiff_t> taken;  // rows used of repeated positions, by the first row
    for (std::size_t k = 0; k < at.rows(); ++k) {
      const auto wanted = row(at, k, at.rows());
      const auto is_there = [&](auto r) {
        return r != kept.order.end() && std::ranges::equal(kept.place(*r), wanted);
      };
      auto found = std::ranges::partition_point(kept.order, [&](std::size_t r) {
        return std::ranges::lexicographical_compare(kept.place(r), wanted);
      });
      if (!is_there(found)) {
        if (at.rows() == 1) return f(at);
        throw run_error(joined_text({name,
                                     " = a function of positions: is asked once, for those of the whole "
                                     "scene, and a tile of it has another one, ",
                                     vector_text(wanted), " m (exact_volume has other points at cuts)"}));
      }
      if (is_there(found + 1))
        if (const auto again = found + taken[*found]++; is_there(again)) found = again;
      const auto numbers = row(kept.out, *found, kept.at.rows());
      out.numbers.insert(out.numbers.end(), numbers.begin(), numbers.end());
    }
    return out;
  }

  bool is_closed_ = false;
  std::map<const HostFunction*, std::shared_ptr<Kept>> kept_{};
};

/// The functions of place of one body: those that say where it is, and those that say what is there.
struct PlaceFunctions {
  std::vector<std::shared_ptr<AnyBatchedFunction>> where{}, what{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
