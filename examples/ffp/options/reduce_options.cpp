#include "reduce_options.hpp"

#include <arenite/core/error.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

void check(const ReduceOptions& o) {
  detail::RangeCheck ranges;
  visit_reduce_options(o, ranges);
  check(static_cast<const DeviceOptions&>(o));
  require(
      !o.file.empty(), "FILE", "(none)",
      "must be given: a table with a time and a deceleration, a BlueDrop's .bin, or the folder of a drop");
  if (o.rate && (!o.time_column.empty() || o.time_unit != TimeUnit::named))
    throw error(joined_text({o.time_column.empty() ? "--time-unit" : "--time-column",
                             ": goes without --rate, which takes the time from the number of the row"}));
  require(!o.drop || !o.impact_time, "--drop", o.drop.value_or(0), "goes without --impact-time");
  require(o.medium == Medium::water || !o.drag, "--drag", o.drag.value_or(0), "needs --medium water");
}

}  // namespace arenite::ffp
