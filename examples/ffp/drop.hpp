// One drop, end to end: what `arenite-ffp drop` does once its options are read. Each
// kinematics is compiled in a file of its own.
#pragma once

#include <stdexcept>
#include <string>

#include "options.hpp"

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

void drop_axisymmetric(const DropOptions& options);
void drop_slice(const DropOptions& options);
void drop_grid(const DropOptions& options);

}  // namespace arenite::ffp
