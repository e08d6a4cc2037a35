// The events in a record: the drops, and what else hits the penetrometer before, between and after them.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../drop/peaks.hpp"
#include "../text/words.hpp"
#include "measurement.hpp"

namespace arenite::ffp {

/// Settings for finding the impact.
struct ImpactSettings {
  double gravity = 9.81;                    ///< m/s^2
  double threshold = -0.8;                  ///< g
  double window = 2e-3;                     ///< s, of the moving mean; 0: none
  bool in_water = false;                    ///< the fall need not be free
  double length = 0.631;                    ///< m, of the penetrometer
  std::optional<double> impact_time{};      ///< s, in the record
  std::optional<double> impact_velocity{};  ///< m/s
  double impact_depth = 0;                  ///< m, at the impact
  double offset = 0;                        ///< m/s^2, taken off the record
  std::optional<double> drop_at{};          ///< s: of several drops that whose impact is nearest
};

/// To a tenth of a millisecond.
inline std::string text_of_time(double t) { return joined_text({std::round(t * 1e4) / 1e4}); }

/// A sample that stands out by itself, between two that agree.
struct Glitch {
  std::size_t sample = 0;
  double beside = 0;  ///< m/s^2, mean of the two
};

/// None in records of less than 500 Hz, whose samples are too far apart. `gravity`: m/s^2 of 1 g.
std::vector<Glitch> glitches_of(const Measurement& m, double gravity);
Measurement without(const std::vector<Glitch>& glitches, Measurement m);

/// Where the deceleration leaves the fall.
struct Contact {
  double time = 0;                   ///< s, in the record
  double uncertain = 0;              ///< s: what it may lie off, between its two samples
  std::optional<double> release{};   ///< s; none: the record begins in the fall
  std::optional<double> velocity{};  ///< m/s; none: not known from before
  double peak_time = 0, peak = 0;    ///< s, m/s^2, of the mean
  double depth = 0;                  ///< m, until it stands
  double end = 0;                    ///< s: it stands, or the record ends
};

/// Contacts without a rest between them: the first from which the penetrometer comes to stand within its
/// length is the impact, be it a crust over a void; the surface of deep water is none.
struct Descent {
  std::vector<Contact> contacts;
  std::size_t impact = 0;  ///< in the contacts
  double velocity = 0;     ///< m/s at the impact, from the release, or back from rest

  const Contact& at_impact() const { return contacts[impact]; }
  double end() const { return contacts.back().end; }
};

/// The deceleration, its filter and its integral. Single samples that stand out are not taken for contacts.
class RecordSearch {
 public:
  RecordSearch(Measurement m, const ImpactSettings& s);

  const Measurement& measurement() const { return m_; }
  const std::vector<double>& means() const { return means_; }
  const std::vector<double>& filtered() const { return filtered_; }

  /// All falls that end with a contact, in time.
  std::vector<Descent> falls() const;
  /// Those of them that are drops, as places: of a quarter of the largest velocity at least.
  std::vector<std::size_t> drops(const std::vector<Descent>& falls) const;
  /// Time at which it stands, some while after the peak; none if the record ends before.
  std::optional<double> rest(double peak_time) const;
  /// Time of the largest deceleration that belongs to an impact.
  double peak_after(double impact) const;
  /// Time at which the fall to an impact begins; none if the record begins in the fall.
  std::optional<double> release(double impact) const;
  /// Change of velocity between two times, m/s: positive when it slows.
  double slowed(double from, double to) const { return integral_(to) - integral_(from); }
  /// The last sample at or before a time.
  std::size_t at(double t) const;
  /// Times of shocks of more than 2 g, with their peaks, outside of the falls to contacts: s, m/s^2.
  std::vector<std::pair<double, double>> knocks(const std::vector<Descent>& falls) const;

 private:
  std::vector<double> filter(const Measurement& m, const std::vector<double>& means) const;
  Contact contact(std::size_t before, std::size_t end) const;
  void follow(Contact& c, double until) const;
  void choose_impact(Descent& fall, double until) const;

  Measurement m_, clean_;
  ImpactSettings s_;
  std::vector<double> means_, filtered_, clean_means_, clean_filtered_;
  StepIntegral integral_, clean_integral_;
  std::vector<std::size_t> still_;  ///< [n] the first sample at or after each from which it is still; n: none
};

}  // namespace arenite::ffp
