// Memory of separation. Granular matter opens without stress when it is pulled beyond its tension limit;
// these policies say what happens when it is compressed again.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include <arenite/core/error.hpp>
#include <arenite/law/law.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Separated matter carries stress as soon as it is compressed again, however far it had opened. Stores
/// nothing.
struct ForgetsOpening {
  static constexpr bool remembers() { return false; }

  template <class T>
  using History = NoHistory<T>;

  /// The part of a step that the matter feels: all of it.
  template <class T, int D>
  const StrainStep<T, D>& carried(Sym<T, D>&, const StrainStep<T, D>& step, History<T>&) const {
    return step;
  }

  template <class T>
  void open(const T&, History<T>&) const {}
};

/// Separated matter carries no stress until what it had opened is closed again.
class RemembersOpening {
 public:
  static constexpr bool remembers() { return true; }

  template <class T>
  struct History {
    T opening{};  ///< volumetric strain that is still open, -, in [0, limit]
    static constexpr std::array names{"opening"};
    constexpr auto members() { return std::tie(opening); }
    constexpr auto members() const { return std::tie(opening); }
  };

  struct Parameters {
    /// Greatest opening that is remembered, a volumetric strain, -, positive. Without a limit grains that
    /// flew apart and touch again as a new heap would carry no stress until the whole opening is closed.
    double limit = 1.0;
  };

  RemembersOpening() : RemembersOpening(Parameters{}) {}
  explicit RemembersOpening(const Parameters& p) : limit_(p.limit) {
    require(p.limit > 0, "RemembersOpening.limit", p.limit, "must be positive");
  }

  double limit() const { return limit_; }

  /// Whether matter is open, and so carries no stress.
  template <class T>
  auto is_open(const History<T>& history) const {
    return history.opening > T(0);
  }

  /// The part of a step that the matter feels: none while it is open; in the step that closes it the
  /// fraction after the closure. The spin acts in full. Updates the opening in
  /// the history, and sets the stress of open matter to zero: an average over neighbours may have given it
  /// some since it opened.
  template <class T, int D>
  StrainStep<T, D> carried(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    using std::max, std::min;
    const T change = trace(step.strain);
    const T left = history.opening + change;
    const auto open = history.opening > T(0);
    const auto closes = open && left < T(0);  // then the change is negative
    const T fraction = select(closes, T(left / select(closes, change, T(-1))), select(open, T(0), T(1)));
    history.opening = select(open, T(min(max(left, T(0)), T(limit_))), T(0));
    stress = Sym<T, D>::each([&](std::size_t i) { return select(open, T(0), stress[i]); });
    return {step.strain * fraction, step.spin, step.dt};
  }

  template <class T>
  void open(const T& opening, History<T>& history) const {
    using std::min;
    history.opening = min(T(history.opening + opening), T(limit_));
  }

 private:
  double limit_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
