// Field files of a run: points, mesh and device of some steps, for ParaView.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include <arenite/observe/vtu.hpp>
#include <arenite/run/every.hpp>

namespace arenite::ffp {

/// Writes the files of a step, once.
class FieldFiles {
 public:
  explicit FieldFiles(VtuSeries series) : series_{std::move(series)} {}

  template <class Scene>
  void operator()(const Scene& scene) {
    if (last_ == scene.steps) return;
    series_(scene);
    last_ = scene.steps;
  }
  template <class F>
  void visit_state(F&& f) {
    series_.visit_state(f);
  }
  template <class Scene>
  void follow_state(const Scene& scene) {
    series_.follow_state(scene);
  }

 private:
  VtuSeries series_;
  std::optional<std::size_t> last_{};  ///< step with files
};

/// fields_*.vtu and fields.pvd in a folder, every `period` seconds. `resumed`: continues the files that
/// are there.
inline Every<FieldFiles> field_files(const std::filesystem::path& folder, double period, bool resumed) {
  return {
      period,
      FieldFiles(VtuSeries(
          folder / "fields",
          {.body_names = {"soil", "device_points"}, .mesh = true, .region = "device", .resumed = resumed}))};
}

}  // namespace arenite::ffp
