#include "paper_options.hpp"

namespace arenite::ffp {

LawOptions other_law() {
  LawOptions law;
  law.kind = LawKind::log_rate;
  return law;
}

void check(const PaperOptions& o) {
  detail::RangeCheck ranges;
  visit_paper_options(o, ranges);
  const DropOptions paper;
  check(o.law, paper.friction, paper.dilatancy);
  require(!o.error_bar || o.cell <= largest_cell_with_bar(DropOptions{}), "--cell", o.cell,
          {"must be at most ", largest_cell_with_bar(DropOptions{}), " m with --error-bar"});
  require(!o.out.empty(), "--out", "\"\"", "must name a folder");
}

}  // namespace arenite::ffp
