#include "profile.hpp"

#include <cmath>
#include <limits>

namespace arenite::ffp {

namespace {

/// Mean of a column over the rows whose distance lies in (from, to]; NaN if there are none, or one is NaN.
template <class Value>
double mean(std::span<const PushRow> rows, double from, double to, Value value) {
  double sum = 0, count = 0;
  for (const PushRow& row : rows)
    if (row.pushed_m > from && row.pushed_m <= to) {
      sum += value(row);
      ++count;
    }
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::optional<Resistance> resistance_of(std::span<const PushRow> rows, double diameter) {
  if (rows.empty() || rows.back().pushed_m < 0.99 * diameter) return std::nullopt;
  const double end = rows.back().pushed_m, tiny = 1e-6 * diameter;
  const auto net = [](const PushRow& row) { return row.net_kPa(); };
  const auto in_last = [&](auto value) { return mean(rows, end - diameter + tiny, end + tiny, value); };
  Resistance r{};
  r.depth_m = rows.back().depth_m;
  r.q_c_kPa = in_last([](const PushRow& row) { return row.q_c_kPa; });
  r.net_kPa = in_last(net);
  r.f_s_kPa = in_last([](const PushRow& row) { return row.f_s_kPa; });
  r.friction_ratio_percent = 100 * r.f_s_kPa / r.q_c_kPa;
  const auto change = [&](double at) {  // in the diameter that ends there
    const double before = mean(rows, at - diameter + tiny, at - diameter / 2 + tiny, net);
    return 2 * (mean(rows, at - diameter / 2 + tiny, at + tiny, net) - before);
  };
  r.growth = change(end) / r.net_kPa;
  for (auto row = rows.rbegin(); row != rows.rend() && row->pushed_m >= diameter - tiny; ++row) {
    if (!(std::abs(change(row->pushed_m)) <= steady * std::abs(r.net_kPa))) break;
    r.steady_from_m = row->depth_m - diameter;
  }
  return r;
}

}  // namespace arenite::ffp
