// `arenite-ffp paper`: every case of the paper, and its numbers beside ours.
#pragma once

#include "../options/paper_options.hpp"

namespace arenite::ffp {

/// Runs the cases that are not finished, one after the other, writes paper.json and the figures and prints
/// the table. A case that fails is reported and the next one run. Throws `Ended` when interrupted, or at
/// the end if a case failed; `error` for a folder that cannot be used.
void paper(const PaperOptions& options);

}  // namespace arenite::ffp
