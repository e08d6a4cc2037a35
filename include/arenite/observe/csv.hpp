// A table of a run: an observer that writes named columns, computed from the scene, as comma-separated text.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/io/csv.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A column of a table: its name and its value, any callable with the scene that returns a number, an
/// optional number (none: an empty field), or a vector, which makes a column for each component, name_x, ...
template <class F>
struct CsvColumn {
  std::string name;
  F value;
};
template <class F>
CsvColumn(const char*, F) -> CsvColumn<F>;
template <class F>
CsvColumn(std::string, F) -> CsvColumn<F>;

namespace detail {

template <class V>
inline constexpr int csv_fields = 1;
template <class T, int D>
inline constexpr int csv_fields<Vec<T, D>> = D;

}  // namespace detail

/// Observer that appends a row at each call: the time, then the columns. Each row goes to the operating
/// system as a whole, so that the table can be read during the run. A run that continues from a saved state
/// continues its table. Of scenes over the portions of a mesh all compute a row, and one writes it.
template <class... F>
class CsvTable {
 public:
  CsvTable(std::filesystem::path path, CsvColumn<F>... columns)
      : path_{std::move(path)}, columns_{std::move(columns)...} {}

  template <class Scene>
  void operator()(const Scene& scene) {
    constexpr bool fits = (std::invocable<F&, const Scene&> && ...);
    static_assert(fits, "csv: a column's value is called with the scene: [](const auto& scene) { .. }");
    if constexpr (fits) {
      row_.assign(1, scene.time);
      std::apply([&](auto&... column) { (put(column.value(scene)), ...); }, columns_);
      if (!is_reporter(scene)) return;
      if (!writer_) open<Scene>();
      writer_->row(row_);
      bytes_ = writer_->bytes();
    }
  }

  template <class G>
  void visit_state(G&& g) {
    g("bytes", bytes_);
  }
  template <class Scene>
  void follow_state(const Scene&) {
    writer_.reset();  // the next row follows those that the saved state recorded
  }

 private:
  template <class Scene>
  void open() {
    std::vector<std::string> names{"time"};
    const auto add = [&]<class Value>(const std::string& name, std::type_identity<Value>) {
      constexpr int fields = detail::csv_fields<Value>;
      for (int k = 0; k < fields; ++k)
        names.push_back(fields == 1 ? name : joined_text({name, "_", "xyz"[k]}));
    };
    std::apply(
        [&](auto&... column) {
          (add(column.name, std::type_identity<
                                std::remove_cvref_t<decltype(column.value(std::declval<const Scene&>()))>>{}),
           ...);
        },
        columns_);
    make_folder_of(path_, "csv");
    writer_ = std::make_shared<CsvWriter>(path_, std::move(names), bytes_);
  }

  template <class Value>
  void put(const Value& value) {
    if constexpr (detail::csv_fields < Value >> 1) {
      for (int k = 0; k < detail::csv_fields<Value>; ++k) row_.push_back(static_cast<double>(value[k]));
    } else if constexpr (requires { value.has_value(); }) {
      row_.push_back(value ? std::optional(static_cast<double>(*value)) : std::nullopt);
    } else {
      static_assert(std::is_arithmetic_v<Value>,
                    "csv: a column's value is a number, an optional number, or a vector of the scene");
      row_.push_back(static_cast<double>(value));
    }
  }

  std::filesystem::path path_;
  std::tuple<CsvColumn<F>...> columns_;
  std::shared_ptr<CsvWriter> writer_{};  // from the first row on
  std::vector<std::optional<double>> row_{};
  std::uintmax_t bytes_ = 0;
};

/// `every(1e-3, csv("push.csv", CsvColumn{"depth", [](const auto& scene) { return ..; }}, ..))`.
template <class... F>
CsvTable<F...> csv(std::filesystem::path path, CsvColumn<F>... columns) {
  return {std::move(path), std::move(columns)...};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
