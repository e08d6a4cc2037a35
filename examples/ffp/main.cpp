// arenite-ffp: drops a free-fall penetrometer into dry sand and writes what happens, and reads measured
// drops.
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <variant>

#include <arenite/core/parallel.hpp>

#include "command_line.hpp"
#include "drop.hpp"
#include "error_bar.hpp"
#include "paper.hpp"
#include "reduce.hpp"
#include "say.hpp"
#include "words.hpp"

namespace arenite::ffp {

void drop(const DropOptions& o) {
  set_threads(o.threads);
  if (o.on_grid())
    drop_grid(o);
  else
    o.kinematics == Kinematics::slice ? drop_slice(o) : drop_axisymmetric(o);
}

/// A drop, and what practitioners read off it.
void run_command(const DropOptions& o) {
  o.error_bar ? drop_with_error_bar(o) : drop(o);
  try {
    reduce_drop(o.out);
  } catch (const output_error&) {
    throw;
  } catch (const error& e) {  // too short a drop, say
    if (!o.quiet) say(joined_text("no reduced.csv: ", e.what()));
  }
}
void run_command(const ReduceOptions& o) { reduce(o); }
void run_command(const PaperOptions& o) { paper(o); }

}  // namespace arenite::ffp

int main(int argc, char** argv) {
  // A write that fails says so; the run goes on without whom it was talking to.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  using arenite::ffp::say, arenite::ffp::shown;
  try {
    const auto command = arenite::ffp::read_command_line({argv + 1, argv + argc}, std::cout);
    if (command) std::visit([](const auto& options) { arenite::ffp::run_command(options); }, *command);
    return 0;
  } catch (const arenite::ffp::Ended& e) {
    say(shown(e.what(), 2000));
    return e.exit_code();
  } catch (const arenite::output_error& e) {
    say(shown(e.what(), 2000));
    return 1;
  } catch (const arenite::error& e) {
    say(shown(e.what(), 2000));
    return 2;
  } catch (const std::bad_alloc&) {
    say("there is not enough memory");
    return 1;
  } catch (const std::exception& e) {
    say(shown(e.what(), 2000));
    return 1;
  }
}
