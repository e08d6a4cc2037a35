// Any friction out of a host's values: the name of a policy's class, and its values.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <string>

#include <arenite/core/type_words.hpp>
#include <arenite/law/frictional/any_friction.hpp>
#include <arenite_host/read.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// `{"policy": "LinearRateFriction", "values": {..}}`; none: the law's own angle.
template <>
struct ValueReader<AnyFriction> {
  static AnyFriction read(const Value&, const ReadContext&);
};

#ifndef ARENITE_HOST_ELSEWHERE

ARENITE_READER AnyFriction ValueReader<AnyFriction>::read(const Value& value, const ReadContext& at) {
  if (value.is_none()) return {};
  const Value* const policy = value.find("policy");
  const auto* const name = policy ? policy->get<std::string>() : nullptr;
  const Value* const values = value.find("values");
  AnyFriction any;
  bool found = false;
  Frictions::each([&]<class P>(std::type_identity<P>) {
    if (!name || *name != type_words<P>()) return;
    any = AnyFriction{arenite::read<P>(values ? *values : Value(), at)};
    found = true;
  });
  if (!found) at.refuse(value, "must name a friction policy of the library");
  return any;
}

#endif

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
