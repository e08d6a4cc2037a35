// An array of a VTU file as a recipe: its name, shape and number type, and how to fetch its values.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Number types of a VTU array.
template <class T>
concept vtu_number = std::same_as<T, double> || std::same_as<T, float> || std::same_as<T, std::int32_t> ||
    std::same_as<T, std::uint32_t> || std::same_as<T, std::int64_t> || std::same_as<T, std::uint8_t>;

namespace shared_detail {

template <vtu_number T>
constexpr const char* vtu_type() {
  if constexpr (std::floating_point<T>) return sizeof(T) == 8 ? "Float64" : "Float32";
  if constexpr (std::same_as<T, std::uint8_t>) return "UInt8";
  if constexpr (std::same_as<T, std::uint32_t>) return "UInt32";
  return sizeof(T) == 8 ? "Int64" : "Int32";
}

/// A number as files have it: VTK knows no `long double`.
template <class V>
using VtuNumber = std::conditional_t<std::same_as<V, long double>, double, V>;

/// Return type of a function of an item's number: a number, or an array of them.
template <class V>
struct VtuItem {
  using type = VtuNumber<V>;
  static constexpr std::size_t components = 1;
  static type stored(V value) { return static_cast<type>(value); }
};
template <class V, std::size_t N>
struct VtuItem<std::array<V, N>> {
  using type = VtuNumber<V>;
  static constexpr std::size_t components = N;
  static std::array<type, N> stored(const std::array<V, N>& value) {
    std::array<type, N> all;
    for (std::size_t k = 0; k < N; ++k) all[k] = static_cast<type>(value[k]);
    return all;
  }
};

}  // namespace shared_detail

/// A named array, shape [items x components], as a recipe: values are fetched while the file is written, so
/// that no column has to be copied or padded first. What the recipe refers to must live until then.
/// Components: 1; 3 (vector); 6 (symmetric tensor: xx, yy, zz, xy, yz, zx, ParaView's order); 9 (tensor, row
/// by row).
struct VtuArray {
  std::string name;
  std::size_t items = 0;
  std::size_t components = 1;
  std::string_view type;  ///< VTK's name of the number type
  std::size_t number_bytes = 0;
  /// Writes items [begin, end) to `out`, (end - begin) * components * number_bytes bytes.
  std::function<void(std::size_t begin, std::size_t end, char* out)> fetch;
};

/// A view of `values`, shape [items x components]. Throws `error` if the length is no multiple of
/// `components`.
template <vtu_number T>
VtuArray vtu_array(std::string name, std::size_t components, std::span<const T> values) {
  require(components > 0 && values.size() % components == 0, {"length of array ", name}, values.size(),
          {"must be a multiple of its components, ", components});
  auto fetch = [=](std::size_t begin, std::size_t end, char* out) {
    if (end > begin)
      std::memcpy(out, values.data() + begin * components, (end - begin) * components * sizeof(T));
  };
  return {std::move(name), values.size() / components, components, shared_detail::vtu_type<T>(), sizeof(T),
          std::move(fetch)};
}

/// An array of a vector's values; the vector must outlive it.
template <vtu_number T, class Allocator>
VtuArray vtu_array(std::string name, std::size_t components, const std::vector<T, Allocator>& values) {
  return vtu_array(std::move(name), components, std::span<const T>(values));
}

template <vtu_number T, class Allocator>
VtuArray vtu_array(std::string name, std::size_t components,
                   const std::vector<T, Allocator>&& values) = delete;

/// `f(i)` for each item i: a number, or a std::array of 3, 6 or 9 numbers; `long double` is stored as double.
template <class F>
requires std::invocable<const F&, std::size_t> VtuArray vtu_array(std::string name, std::size_t items, F f) {
  using Item = shared_detail::VtuItem<std::remove_cvref_t<std::invoke_result_t<const F&, std::size_t>>>;
  using T = typename Item::type;
  static_assert(vtu_number<T>,
                "vtu_array: f(i) must return a number (double, float, 32- or 64-bit integer) or an array");
  auto fetch = [f = std::move(f)](std::size_t begin, std::size_t end, char* out) {
    for (std::size_t i = begin; i < end; ++i, out += Item::components * sizeof(T)) {
      const auto value = Item::stored(f(i));
      std::memcpy(out, &value, Item::components * sizeof(T));
    }
  };
  return {std::move(name), items,           Item::components, shared_detail::vtu_type<T>(),
          sizeof(T),       std::move(fetch)};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
