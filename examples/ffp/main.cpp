// arenite-ffp: drops a free-fall penetrometer into dry sand and writes what happens.
#include <csignal>
#include <exception>
#include <iostream>

#include <arenite/core/parallel.hpp>

#include "command_line.hpp"
#include "drop.hpp"
#include "say.hpp"
#include "words.hpp"

namespace arenite::ffp {

void drop(const DropOptions& o) {
  set_threads(o.threads);
  o.kinematics == Kinematics::slice ? drop_slice(o) : drop_axisymmetric(o);
}

}  // namespace arenite::ffp

int main(int argc, char** argv) {
  // A write that fails says so; the run goes on without whom it was talking to.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  using arenite::ffp::say, arenite::ffp::shown;
  try {
    const auto options = arenite::ffp::read_command_line({argv + 1, argv + argc}, std::cout);
    if (options) arenite::ffp::drop(*options);
    return 0;
  } catch (const arenite::ffp::Ended& e) {
    say(shown(e.what(), 2000));
    return e.exit_code();
  } catch (const arenite::error& e) {
    say(shown(e.what(), 2000));
    return 2;
  } catch (const std::exception& e) {
    say(shown(e.what(), 2000));
    return 1;
  }
}
