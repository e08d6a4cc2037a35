// arenite-ffp: drops a free-fall penetrometer into dry sand and writes what happens.
#include <exception>
#include <iostream>

#include <arenite/core/parallel.hpp>

#include "command_line.hpp"
#include "drop.hpp"

namespace arenite::ffp {

void drop(const DropOptions& o) {
  set_threads(o.threads);
  const bool rigid = o.device == DeviceKind::rigid;
  if (o.kinematics == Kinematics::slice)
    rigid ? drop_slice_rigid(o) : drop_slice_elastic(o);
  else
    rigid ? drop_axisymmetric_rigid(o) : drop_axisymmetric_elastic(o);
}

}  // namespace arenite::ffp

int main(int argc, char** argv) {
  try {
    const auto options = arenite::ffp::read_command_line({argv + 1, argv + argc}, std::cout);
    if (options) arenite::ffp::drop(*options);
    return 0;
  } catch (const arenite::run_error& e) {
    std::cerr << "arenite-ffp: the run failed: " << e.what() << '\n';
    return 1;
  } catch (const arenite::error& e) {
    std::cerr << "arenite-ffp: " << e.what() << '\n';
    return 2;
  } catch (const std::exception& e) {
    std::cerr << "arenite-ffp: " << e.what() << '\n';
    return 1;
  }
}
