// The options of the reproduction of the paper.
#pragma once

#include <string>

#include "../text/range.hpp"
#include "law_options.hpp"
#include "option_table.hpp"

namespace arenite::ffp {

/// The law that stands beside Mohr-Coulomb when none is named.
LawOptions other_law();

struct PaperOptions {
  std::string out = "out/paper";
  bool quick = false;            ///< only the half-section
  LawOptions law = other_law();  ///< beside Mohr-Coulomb
  double cell = 0.01;            ///< m
  int threads = 0;
  bool error_bar = false;  ///< of the rigid half-sections with 20 and 40 deg
  bool anew = false, no_pictures = false, quiet = false;
};

/// Shows the options to a visitor: see `visit_options`.
template <class Options, class Visitor>
void visit_paper_options(Options& o, Visitor& v) {
  v.group("Cases");
  v.flag("--quick", o.quick,
         "The half-section alone, without the slice: at most two minutes on two processors");
  v.number("--cell", o.cell, "M", Range{0.0025, 0.04, "m"},
           "Edge of the cells around the cone; the paper's is 0.01");
  v.flag("--error-bar", o.error_bar,
         "Find the uncertainty of the rigid half-sections with 20 deg and fully rough (drop --error-bar): "
         "three times "
         "their time and more");
  visit_law_options(o.law, v);
  v.group("Run");
  v.text("--out", o.out, "DIR", "Folder of the results; each case has a folder in it");
  v.number("--threads", o.threads, "N", Range{0, 1024}, "Threads, 0 for all");
  v.flag("--anew", o.anew,
         "Run cases again that are finished, and from their start those that were interrupted");
  v.flag("--no-pictures", o.no_pictures, "Draw nothing");
  v.flag("--quiet", o.quiet, "Nothing on the terminal but errors and warnings");
}

/// Throws `error("--option = value: rule")` at the first value that breaks a rule.
void check(const PaperOptions& o);

}  // namespace arenite::ffp
