// One drop, end to end: what `arenite-ffp drop` does once its options are read. Each
// kinematics is compiled in its own file.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <arenite/core/error.hpp>

#include "../options/options.hpp"

namespace arenite::ffp {

/// A run that began and came to another end than the one asked for: it failed, its files could not be
/// written, or a signal ended it.
class Ended : public std::runtime_error {
 public:
  Ended(const std::string& what, int exit_code) : std::runtime_error{what}, exit_code_{exit_code} {}
  int exit_code() const { return exit_code_; }

 private:
  int exit_code_;
};

/// Runs a drop and writes all of its files into `options.out`. Throws `error` for an unusable mesh or folder,
/// which is then left as it was, and `Ended` for a run that did not come to its end; history and summary are
/// complete up to then.
void drop(const DropOptions& options);

/// The drop of the default options, or of others that keep its composition (`is_default`).
void drop_default(const DropOptions& options);
inline bool is_default(const DropOptions& o) {
  return !o.on_grid() && o.kinematics == Kinematics::axisymmetric && o.device == DeviceKind::rigid &&
         o.law.kind == LawKind::mohr_coulomb && o.contact_kind() == ContactKind::rigid && o.averages();
}

/// In what a drop on a fitted mesh differs from the default one. Two differences are refused by `check`: each
/// composition more would be compiled for all.
enum class DropKind { plain, elastic, law, centre_of_mass, no_averages };
inline constexpr std::array<std::pair<std::string_view, DropKind>, 5> drop_kind_words{
    {{"plain", DropKind::plain},
     {"elastic", DropKind::elastic},
     {"law", DropKind::law},
     {"centre-of-mass", DropKind::centre_of_mass},
     {"no-averages", DropKind::no_averages}}};

inline DropKind kind_of(const DropOptions& o) {
  if (o.device == DeviceKind::elastic) return DropKind::elastic;
  if (o.law.kind != LawKind::mohr_coulomb) return DropKind::law;
  if (o.contact_kind() == ContactKind::centre_of_mass) return DropKind::centre_of_mass;
  return o.averages() ? DropKind::plain : DropKind::no_averages;
}

/// "slice", "slice-law".
inline std::string unit_of(const std::string& model, DropKind kind) {
  return kind == DropKind::plain ? model : model + '-' + word_of(drop_kind_words, kind);
}

/// The unit that computes a drop: "default", or the name of drop_<model>.cpp, on fitted meshes with the kind of
/// drop.
inline std::string unit_of(const DropOptions& o) {
  if (is_default(o)) return "default";
  const std::string model = word_of(kinematics_words, o.kinematics);
  if (o.in_space()) return model;
  return o.on_grid() ? word_of(mesh_kind_words, o.kind_of_mesh()) : unit_of(model, kind_of(o));
}

/// Each unit but the default one adds itself, so that a program can be built without some.
struct DropUnit {
  DropUnit(const std::string& name, void (*run)(const DropOptions&));
};

/// Units that a command needs and this program was built without.
class NotBuilt : public error {
 public:
  explicit NotBuilt(const std::string& units)
      : error{joined_text({"drops = ", units,
                           ": this program was built without them; configure with -DARENITE_FFP_DROPS=all "
                           "and build it anew"})} {}
};

}  // namespace arenite::ffp
