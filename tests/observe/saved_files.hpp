// Steps with observers, and files as bytes: what the tests of saved states share.
#pragma once

#include <arenite/scene/stable_step.hpp>
#include <arenite/scene/step.hpp>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

namespace arenite::test {

template <class Scene, class... Observers>
void steps(Scene& scene, int count, Observers&... observers) {
  for (int k = 0; k < count; ++k) {
    step(scene, 0.4 * stable_step(scene));
    (observers(std::as_const(scene)), ...);
  }
}

inline std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
inline void write(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

}  // namespace arenite::test
