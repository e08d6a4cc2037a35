// The state of a scene and its observers as bytes by name: to compare it, or to restore it in another scene.
#pragma once

#include <arenite/scene/state.hpp>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace arenite::test {

class StateBuffer {
 public:
  StateBuffer() = default;
  template <class Scene, class... Observers>
  explicit StateBuffer(const Scene& scene, const Observers&... observers) {
    const auto save = [&](std::string_view name, const auto& value) {
      auto& bytes = bytes_[std::string(name)];
      if (!bytes.empty()) throw std::logic_error("state: " + std::string(name) + " twice");
      const auto from = [&](const auto* numbers, std::size_t size) {
        const auto* const first = reinterpret_cast<const unsigned char*>(numbers);
        bytes.assign(first, first + size);
        bytes.push_back('.');  // never empty
      };
      if constexpr (requires { value.data(); })
        from(value.data(), value.size() * sizeof(*value.data()));
      else
        from(&value, sizeof(value));
    };
    for_each_state(scene, save);
    std::size_t number = 0;
    (visit_state_of(observers, "observers/" + std::to_string(number++), save), ...);
  }

  template <class Scene, class... Observers>
  void restore(Scene& scene, Observers&... observers) const {
    std::size_t taken = 0;
    const auto write = [&](std::string_view name, auto& value) {
      const auto& bytes = bytes_.at(std::string(name));
      const std::size_t size = bytes.size() - 1;
      ++taken;
      if constexpr (requires { value.data(); }) {
        const std::size_t count = size / sizeof(*value.data());
        if constexpr (resizable_state_array<std::remove_reference_t<decltype(value)>>) value.resize(count);
        if (value.size() != count) throw std::logic_error("state: the size of " + std::string(name));
        if (count > 0) std::memcpy(value.data(), bytes.data(), size);
      } else {
        std::memcpy(&value, bytes.data(), sizeof(value));
      }
    };
    for_each_state(scene, write);
    std::size_t number = 0;
    (visit_state_of(observers, "observers/" + std::to_string(number++), write), ...);
    if (taken != bytes_.size()) throw std::logic_error("state: values left over");
    follow_state(scene);
  }

  /// The first name whose bytes differ; empty if there is none.
  static std::string first_difference(const StateBuffer& a, const StateBuffer& b) {
    for (const auto& [name, bytes] : a.bytes_) {
      const auto other = b.bytes_.find(name);
      if (other == b.bytes_.end() || other->second != bytes) return name;
    }
    return a.bytes_.size() == b.bytes_.size() ? "" : "more values";
  }
  bool has(const std::string& name) const { return bytes_.count(name) > 0; }
  /// Bytes of a value.
  std::size_t size(const std::string& name) const { return bytes_.at(name).size() - 1; }
  std::vector<unsigned char>& of(const std::string& name) { return bytes_.at(name); }

 private:
  std::map<std::string, std::vector<unsigned char>> bytes_;
};

}  // namespace arenite::test
