// arenite-ffp: drops a penetrometer into dry sand or pushes one into the ground, and reads measured drops.
#include <csignal>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <arenite/parallel/parallel.hpp>

#include "command/command.hpp"
#include "command/values.hpp"
#include "drop/drop.hpp"
#include "drop/error_bar.hpp"
#include "paper/paper.hpp"
#include "paper/paper_cases.hpp"
#include "push/push.hpp"
#include "reduce/reduce.hpp"
#include "reduce/reduction.hpp"
#include "text/say.hpp"
#include "text/words.hpp"
#ifdef ARENITE_FFP_COMMAND_LINE
#include "command/command_line.hpp"
#endif

namespace arenite::ffp {

namespace {

std::map<std::string, void (*)(const DropOptions&)>& drop_units() {
  static std::map<std::string, void (*)(const DropOptions&)> units{{"default", drop_default}};
  return units;
}

/// Before anything is run.
void require_built(const std::set<std::string>& units) {
  std::string missing;
  for (const auto& unit : units)
    if (!drop_units().contains(unit)) missing += (missing.empty() ? "" : ", ") + unit;
  if (!missing.empty()) throw NotBuilt(missing);
}

}  // namespace

DropUnit::DropUnit(const std::string& name, void (*run)(const DropOptions&)) { drop_units()[name] = run; }

void drop(const DropOptions& o) {
  set_threads(o.threads);
  drop_units().at(unit_of(o))(o);
}

namespace {

void (*push_unit)(const PushOptions&) = nullptr;

}  // namespace

PushUnit::PushUnit(void (*run)(const PushOptions&)) { push_unit = run; }

void push(const PushOptions& o) {
  if (push_unit == nullptr) throw NotBuilt("push");
  push_unit(o);
}
void run_command(const PushOptions& o) { o.error_bar ? push_with_error_bar(o) : push(o); }

/// A drop, and what practitioners read off it.
void run_command(const DropOptions& o) {
  require_built({unit_of(o)});  // those of its error bar differ only in numbers
  o.error_bar ? drop_with_error_bar(o) : drop(o);
  try {
    reduce_drop(o.out);
  } catch (const output_error&) {
    throw;
  } catch (const error& e) {  // too short a drop, say
    if (!o.quiet) say(joined_text({"no reduced.csv: ", e.what()}));
  }
}
void run_command(const ReduceOptions& o) { reduce(o); }
void run_command(const PaperOptions& o) {
  std::set<std::string> units;
  for (const PaperCase& c : paper_cases(o)) units.insert(unit_of(c.options));
  require_built(units);
  paper(o);
}

/// The command of the words, or of the values that they announce; none for a question, which is answered.
std::optional<Command> read_command(const std::vector<std::string>& words) {
  if (words == std::vector<std::string>{"values"}) return read_values(std::cin, std::cout);
#ifdef ARENITE_FFP_COMMAND_LINE
  return read_command_line(words, std::cout);
#else
  throw error(
      "command line: this program was built without CLI11, which reads typed options; install it (Debian: "
      "libcli11-dev) and build arenite-ffp anew. Python's arenite.ffp works without");
#endif
}

}  // namespace arenite::ffp

int main(int argc, char** argv) {
  // A write that fails reports it; the run continues without its reader.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  using arenite::ffp::say, arenite::ffp::shown;
  try {
    const auto command = arenite::ffp::read_command({argv + 1, argv + argc});
    if (command) std::visit([](const auto& options) { arenite::ffp::run_command(options); }, *command);
    return 0;
  } catch (const arenite::ffp::Ended& e) {
    say(shown(e.what(), 2000));
    return e.exit_code();
  } catch (const arenite::output_error& e) {
    say(shown(e.what(), 2000));
    return 1;
  } catch (const arenite::ffp::NotBuilt& e) {
    say(e.what());
    return 3;
  } catch (const arenite::ffp::SeveralDrops& e) {
    say(e.what());
    return 2;
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
