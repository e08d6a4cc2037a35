// Functions of the host as functions of the library: of time, of place and time, of place.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <arenite/fill/initial_stress.hpp>
#include <arenite/fill/initial_velocity.hpp>
#include <arenite/functions/place_function.hpp>
#include <arenite/functions/time_function.hpp>
#include <arenite_host/read.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A number; a function of time, `{"of_time": f}`, or of place and time, `{"of_place": f}`, of rows
/// (x, y, z, t); a table or a ramp.
template <>
struct ValueReader<ScalarFunction> {
  static ScalarFunction read(const Value&, const ReadContext&);
};

/// Up to three numbers; a signal; a function as that of a number; `{"direction": .., "factor": ..}`.
template <>
struct ValueReader<VectorFunction> {
  static VectorFunction read(const Value&, const ReadContext&);
};

/// `{3, 1, 0}`, or a function of the position.
template <>
struct ValueReader<InitialVelocity> {
  static InitialVelocity read(const Value&, const ReadContext&);
};
/// `{"geostatic": {..}}`, or a function of the position.
template <>
struct ValueReader<InitialStress> {
  static InitialStress read(const Value&, const ReadContext&);
};
template <>
struct ValueReader<std::function<double(const Triple&)>> {
  static std::function<double(const Triple&)> read(const Value&, const ReadContext&);
};
/// A test of a node's position.
template <>
struct ValueReader<std::function<bool(const Triple&)>> {
  static std::function<bool(const Triple&)> read(const Value&, const ReadContext&);
};

#ifndef ARENITE_HOST_ELSEWHERE

namespace detail {

/// A function of place of the host, asked for all places of a body at once.
template <std::size_t Count>
std::shared_ptr<BatchedFunction<Count>> at_once(const Value& value, const ReadContext& at) {
  auto f = std::make_shared<BatchedFunction<Count>>(at.of_places(*value.function()), at.dimension, at.name);
  if (at.places)
    at.places->what.push_back(f);
  else
    f->compute();
  return f;
}

/// Rows {time, value} of a `Table`, or a `Ramp`, which the host names so.
inline std::optional<std::function<double(double)>> time_factor(const Value& value, const ReadContext& at) {
  if (const Value* rows = value.find("table")) {
    std::vector<Table::Row> table;
    for (const auto& row : read<std::vector<std::array<double, 2>>>(*rows, at))
      table.emplace_back(row[0], row[1]);
    return Table(std::move(table));
  }
  if (const Value* ramp = value.find("ramp")) {
    const auto of = read<Ramp>(*ramp, at.renamed("Ramp"));
    of.check();
    return of;
  }
  return {};
}

}  // namespace detail

ARENITE_READER ScalarFunction ValueReader<ScalarFunction>::read(const Value& value, const ReadContext& at) {
  if (const double* x = value.get<double>()) return *x;
  if (auto factor = detail::time_factor(value, at)) return *std::move(factor);
  if (const Value* f = value.find("of_time"); f && f->function())
    return [g = *f->function(), name = at.name](double t) { return detail::call_row<1>(g, {t}, name)[0]; };
  if (const Value* f = value.find("of_place"); f && f->function())
    return [g = *f->function(), name = at.name](const Triple& x, double t) {
      return detail::call_row<1>(g, {x[0], x[1], x[2], t}, name)[0];
    };
  at.refuse(value, "must be a number, or a function of time or of place and time");
}
ARENITE_READER VectorFunction ValueReader<VectorFunction>::read(const Value& value, const ReadContext& at) {
  if (detail::is_numbers(value)) {
    const auto v = arenite::read<Triple>(value, at);
    return VectorFunction({v[0], v[1], v[2]});
  }
  if (const HostSignal* signal = value.get<HostSignal>())
    return VectorFunction([at = *signal](double) -> Triple { return *at; });
  if (const Value* factor = value.find("factor"))
    return VectorFunction(arenite::read<Triple>(*value.find("direction"), at),
                          arenite::read<ScalarFunction>(*factor, at));
  if (const Value* f = value.find("of_time"); f && f->function())
    return VectorFunction([g = *f->function(), name = at.name](double t) -> Triple {
      return detail::call_row<3>(g, {t}, name);
    });
  if (const Value* f = value.find("of_place"); f && f->function())
    return VectorFunction([g = *f->function(), name = at.name](const Triple& x, double t) -> Triple {
      return detail::call_row<3>(g, {x[0], x[1], x[2], t}, name);
    });
  at.refuse(value, "must be up to 3 numbers, or a function of time or of place and time");
}
ARENITE_READER InitialVelocity ValueReader<InitialVelocity>::read(const Value& value, const ReadContext& at) {
  if (!value.function()) return arenite::read<Triple>(value, at);
  return [f = detail::at_once<3>(value, at)](const Triple& x) { return (*f)(x); };
}
ARENITE_READER InitialStress ValueReader<InitialStress>::read(const Value& value, const ReadContext& at) {
  if (const Value* ground = value.find("geostatic"))
    return arenite::read<Geostatic>(*ground, at.renamed("Geostatic"));
  if (!value.function()) at.refuse(value, "must be Geostatic, or a function of the position");
  return InitialStress(
      [f = detail::at_once<6>(value, at)](const Triple& x) -> std::array<double, 6> { return (*f)(x); });
}
ARENITE_READER std::function<double(const Triple&)> ValueReader<std::function<double(const Triple&)>>::read(
    const Value& value, const ReadContext& at) {
  if (const double* x = value.get<double>()) return [c = *x](const Triple&) { return c; };
  if (!value.function()) at.refuse(value, "must be a number, or a function of the position");
  return [f = detail::at_once<1>(value, at)](const Triple& x) { return (*f)(x)[0]; };
}
ARENITE_READER std::function<bool(const Triple&)> ValueReader<std::function<bool(const Triple&)>>::read(
    const Value& value, const ReadContext& at) {
  if (value.is_none()) return {};
  if (!value.function()) at.refuse(value, "must be a function of the position");
  auto f = std::make_shared<BatchedFunction<1>>(at.of_places(*value.function()), at.dimension, at.name);
  f->note(at.nodes ? *at.nodes : std::vector<Triple>{});
  f->compute();
  return [f](const Triple& x) { return (*f)(x)[0] != 0; };
}

#endif

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
