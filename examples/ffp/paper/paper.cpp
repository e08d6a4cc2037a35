// The cases of the paper from first to last. No scene is included here, so that it compiles in seconds.
#include "paper.hpp"

#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include "../drop/drop.hpp"
#include "../drop/error_bar.hpp"
#include "../text/json_file.hpp"
#include "../text/python_script.hpp"
#include "../text/say.hpp"
#include "../text/words.hpp"
#include "paper_cases.hpp"
#include "paper_table.hpp"

namespace arenite::ffp {

namespace {

/// paper.json of the cases so far.
void write(const PaperOptions& o, const std::vector<PaperCase>& cases, const CaseResults& results) {
  write_json(std::filesystem::path{o.out} / "paper.json", paper_json(o, cases, results));
}

}  // namespace

void paper(const PaperOptions& o) {
  std::error_code code;
  std::filesystem::create_directories(o.out, code);
  require(!code, "--out", shown(o.out), "the folder cannot be made: " + code.message());
  const auto cases = paper_cases(o);
  CaseResults results;
  std::string failed;
  int exit_code = 0;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const PaperCase& c = cases[k];
    if (!o.quiet) say(joined_text({"case ", k + 1, " of ", cases.size(), ": ", c.name}));
    try {
      c.options.error_bar ? drop_with_error_bar(c.options) : drop(c.options);
    } catch (const Ended& e) {
      if (e.exit_code() > 128) {
        write(o, cases, results);
        throw Ended(joined_text({"case ", c.name, ": ", e.what(), "; the same command goes on"}),
                    e.exit_code());
      }
      say(joined_text({"case ", c.name, ": ", e.what()}));
      failed += (failed.empty() ? "" : ", ") + c.name;
      exit_code = e.exit_code();
    } catch (const error& e) {
      throw error(joined_text({"case ", c.name, ": ", e.what(), "; --anew runs it again"}));
    }
    results.emplace(c.name, result_of_case(c.options.out));
  }
  write(o, cases, results);
  if (!o.quiet) {
    print_paper_table(paper_comparisons(o, results), std::cout);
    std::cout << "\nFiles: " << shown((std::filesystem::path{o.out} / "paper.json").string()) << std::endl;
  }
  if (!o.no_pictures && run_script("plot_paper.py", {o.out}) && !o.quiet)
    std::cout << "Figures 3 to 6: " << shown((std::filesystem::path{o.out} / "figure*.png").string())
              << ", .svg" << std::endl;
  if (exit_code != 0) throw Ended("these cases failed: " + failed, exit_code);
}

}  // namespace arenite::ffp
