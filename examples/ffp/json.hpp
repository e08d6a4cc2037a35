// A value of JSON (RFC 8259) as the driver writes and reads it: summaries, reductions, inputs. Members of an
// object keep their order. What reads it from a file: json_file.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>

namespace arenite::ffp {

/// A value that is not what was asked for.
class json_error : public error {
  using error::error;
};

class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;

  Json() = default;  ///< null
  Json(std::nullptr_t) {}
  Json(std::same_as<bool> auto value) : kind_{Kind::boolean}, boolean_{value} {}
  template <std::integral T>
  requires(!std::same_as<T, bool>) Json(T value)
      : kind_{Kind::whole}, whole_{static_cast<std::int64_t>(value)} {}
  Json(std::floating_point auto value)
      : kind_{Kind::real}, real_{static_cast<double>(value)} {}  ///< not finite: written as null
  Json(std::string value) : kind_{Kind::text}, text_{std::move(value)} {}
  Json(std::string_view value) : Json(std::string{value}) {}
  Json(const char* value) : Json(std::string{value}) {}
  template <class T>
  Json(const std::optional<T>& value) {
    if (value) *this = Json(*value);
  }
  template <class T>
  Json(const std::vector<T>& values) : kind_{Kind::array}, elements_(values.begin(), values.end()) {}
  Json(std::initializer_list<std::pair<std::string, Json>> members);

  static Json array(std::initializer_list<Json> values = {});
  static Json object(Object members = {});

  bool is_null() const { return kind_ == Kind::null; }
  bool is_boolean() const { return kind_ == Kind::boolean; }
  bool is_number() const { return kind_ == Kind::whole || kind_ == Kind::real; }
  bool is_string() const { return kind_ == Kind::text; }
  bool is_array() const { return kind_ == Kind::array; }
  bool is_object() const { return kind_ == Kind::object; }

  /// The member of this name; null: this is no object that has it.
  const Json* find(std::string_view key) const;
  bool contains(std::string_view key) const { return find(key) != nullptr; }
  /// Throws `json_error` if there is none.
  const Json& at(std::string_view key) const;
  const Json& operator[](std::string_view key) const { return at(key); }
  const Json& operator[](std::size_t place) const { return elements().at(place); }
  /// Makes it; null becomes an object.
  Json& operator[](std::string_view key);
  /// Adds to an array; null becomes one.
  void push_back(Json value);
  const Object& items() const { return checked(is_object(), members_); }
  const Array& elements() const { return checked(is_array(), elements_); }

  /// A number, bool, string, or vector of them. Throws `json_error` if this is none.
  template <class T>
  T get() const;
  /// The member's, or `otherwise` where there is none.
  template <class T>
  T value(std::string_view key, const T& otherwise) const {
    const Json* there = find(key);
    return there != nullptr ? there->get<T>() : otherwise;
  }
  std::string value(std::string_view key, const char* otherwise) const {
    return value(key, std::string{otherwise});
  }

  /// Numbers are equal as such: 20 and 20.0.
  bool operator==(const Json& other) const;

  /// As text; with `indent` a line a value.
  std::string text(int indent = -1) const;

 private:
  enum class Kind { null, boolean, whole, real, text, array, object };
  template <class T>
  static const T& checked(bool right, const T& value) {
    if (!right) throw json_error("JSON: a value is of another kind");
    return value;
  }
  void append_to(std::string& text, int indent, int depth) const;

  // Side by side, not a variant: g++ 12 takes a variant's other members for values that are not set.
  Kind kind_ = Kind::null;
  bool boolean_ = false;
  std::int64_t whole_ = 0;
  double real_ = 0;
  std::string text_;
  Array elements_;
  Object members_;
};

inline Json::Json(std::initializer_list<std::pair<std::string, Json>> members)
    : kind_{Kind::object}, members_(members) {}
inline Json Json::array(std::initializer_list<Json> values) {
  Json made;
  made.kind_ = Kind::array;
  made.elements_ = values;
  return made;
}
inline Json Json::object(Object members) {
  Json made;
  made.kind_ = Kind::object;
  made.members_ = std::move(members);
  return made;
}

inline const Json* Json::find(std::string_view key) const {
  for (const auto& [name, value] : members_)
    if (name == key) return &value;
  return nullptr;
}
inline const Json& Json::at(std::string_view key) const {
  if (const Json* there = find(key)) return *there;
  throw json_error(joined_text("JSON: has no ", key));
}
inline Json& Json::operator[](std::string_view key) {
  if (is_null()) kind_ = Kind::object;
  checked(is_object(), members_);
  for (auto& [name, value] : members_)
    if (name == key) return value;
  return members_.emplace_back(std::string{key}, Json{}).second;
}
inline void Json::push_back(Json value) {
  if (is_null()) kind_ = Kind::array;
  checked(is_array(), elements_);
  elements_.push_back(std::move(value));
}

template <class T>
T Json::get() const {
  if constexpr (std::is_same_v<T, double>) {
    return kind_ == Kind::whole ? static_cast<double>(whole_) : checked(is_number(), real_);
  } else if constexpr (std::is_same_v<T, bool>) {
    return checked(is_boolean(), boolean_);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return checked(is_string(), text_);
  } else {
    T values;
    for (const Json& value : elements()) values.push_back(value.get<typename T::value_type>());
    return values;
  }
}

inline bool Json::operator==(const Json& other) const {
  if (is_number() && other.is_number() && kind_ != other.kind_) return get<double>() == other.get<double>();
  return kind_ == other.kind_ && boolean_ == other.boolean_ && whole_ == other.whole_ &&
         real_ == other.real_ && text_ == other.text_ && elements_ == other.elements_ &&
         members_ == other.members_;
}

namespace detail {

/// Length of the UTF-8 character at the begin of `bytes`; 0: it is none.
inline std::size_t utf8_length(std::string_view bytes) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
  const std::size_t length = byte(0) < 0x80                       ? 1
                             : byte(0) >= 0xC2 && byte(0) <= 0xDF ? 2
                             : byte(0) >= 0xE0 && byte(0) <= 0xEF ? 3
                             : byte(0) >= 0xF0 && byte(0) <= 0xF4 ? 4
                                                                  : 0;
  if (length == 0 || bytes.size() < length) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xC0) != 0x80) return 0;
  // Neither longer than needed, nor half of a surrogate pair, nor beyond U+10FFFF.
  if ((byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F) ||
      (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F))
    return 0;
  return length;
}

/// Between quotes; bytes that are no UTF-8 become U+FFFD.
inline void append_quoted(std::string& text, std::string_view value) {
  text += '"';
  for (std::size_t at = 0; at < value.size();) {
    const char c = value[at];
    const std::size_t length = utf8_length(value.substr(at));
    if (length == 0) {
      text += "\xEF\xBF\xBD";
    } else if (c == '"' || c == '\\') {
      (text += '\\') += c;
    } else if (c == '\n' || c == '\t') {
      text += c == '\n' ? "\\n" : "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      constexpr std::string_view digits = "0123456789abcdef";
      ((text += "\\u00") += digits[static_cast<std::size_t>(c) >> 4]) +=
          digits[static_cast<std::size_t>(c) & 15];
    } else {
      text += value.substr(at, length);
    }
    at += std::max<std::size_t>(length, 1);
  }
  text += '"';
}

/// The shortest that reads back as the same double, with a point or an exponent.
inline void append_json_number(std::string& text, double value) {
  if (!std::isfinite(value)) {
    text += "null";
    return;
  }
  std::array<char, 64> digits{};
  const auto form = std::abs(value) < 1e15 && (value == 0 || std::abs(value) >= 1e-4)
                        ? std::chars_format::fixed
                        : std::chars_format::scientific;
  const std::string_view number{digits.data(),
                                std::to_chars(digits.data(), digits.data() + digits.size(), value, form).ptr};
  text += number;
  if (number.find_first_of(".e") == std::string_view::npos) text += ".0";
}

}  // namespace detail

inline void Json::append_to(std::string& text, int indent, int depth) const {
  const auto line = [&](int at) {
    if (indent >= 0) (text += '\n').append(static_cast<std::size_t>(indent * at), ' ');
  };
  const auto list = [&](const auto& values, char open, char close, const auto& append) {
    text += open;
    for (const auto& value : values) {
      if (&value != &values.front()) text += ',';
      line(depth + 1);
      append(value);
    }
    if (!values.empty()) line(depth);
    text += close;
  };
  switch (kind_) {
    case Kind::null:
      text += "null";
      break;
    case Kind::boolean:
      text += boolean_ ? "true" : "false";
      break;
    case Kind::whole:
      text += std::to_string(whole_);
      break;
    case Kind::real:
      detail::append_json_number(text, real_);
      break;
    case Kind::text:
      detail::append_quoted(text, text_);
      break;
    case Kind::array:
      list(elements_, '[', ']', [&](const Json& value) { value.append_to(text, indent, depth + 1); });
      break;
    case Kind::object:
      list(members_, '{', '}', [&](const auto& member) {
        detail::append_quoted(text, member.first);
        text += indent >= 0 ? ": " : ":";
        member.second.append_to(text, indent, depth + 1);
      });
  }
}

inline std::string Json::text(int indent) const {
  std::string text;
  append_to(text, indent, 0);
  return text;
}

}  // namespace arenite::ffp
