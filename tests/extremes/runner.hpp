// Runs random scenes of a unit's compositions. A scene's seed chooses its composition, and everything in it.
//
// In the environment ARENITE_EXTREMES="FIRST COUNT" runs those seeds and prints a line for each: composition,
// ending, seed, figures, draw, type of the scene, separated by tabs. So a failure is replayed with ARENITE_EXTREMES="SEED 1".
#pragma once

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "catch.hpp"
#include "outcome.hpp"
#include "parts.hpp"

namespace arenite::extremes {

struct Composition {
  const char* name;
  Outcome (*run)(Draw&);
};

inline void run_scenes(const char* unit, const std::vector<Composition>& compositions, int in_tests) {
  const char* const wanted = std::getenv("ARENITE_EXTREMES");
  unsigned long long first = 0, count = static_cast<unsigned long long>(in_tests);
  if (wanted) REQUIRE(std::sscanf(wanted, "%llu %llu", &first, &count) == 2);
  on_warning({});
  for (auto seed = first; seed < first + count; ++seed) {
    const Composition& composition = compositions[seed % compositions.size()];
    Draw draw(seed);
    const Outcome outcome = composition.run(draw);
    const std::string text = draw.text();  // after the run: a composition may change its draw
    const std::string replay =
        joined_text({"replay: ARENITE_EXTREMES=\"", seed, " 1\" test.extremes.", unit});
    CAPTURE(composition.name, outcome.text(), text, replay);
    if (wanted) {
      std::printf("scene\t%s\t%s\t%llu\t%s\t%s\t%s\n", composition.name,
                  ending_names[static_cast<std::size_t>(outcome.ending)], seed, outcome.text().c_str(),
                  text.c_str(), outcome.scene.c_str());
      std::fflush(stdout);
    }
    CHECK(!is_fault(outcome.ending));
  }
}

}  // namespace arenite::extremes
