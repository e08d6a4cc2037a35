// Options for the friction of the sand in a drop: the law, and its constants with their sources.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "../text/range.hpp"

namespace arenite::ffp {

enum class LawKind { mohr_coulomb, linear_rate, mu_i, log_rate, softening, softening_rate };

inline constexpr std::array<std::pair<std::string_view, LawKind>, 6> law_words{
    {{"mohr-coulomb", LawKind::mohr_coulomb},
     {"linear-rate", LawKind::linear_rate},
     {"mu-i", LawKind::mu_i},
     {"log-rate", LawKind::log_rate},
     {"softening", LawKind::softening},
     {"softening-rate", LawKind::softening_rate}}};

/// Friction of the sand. Defaults are those of the library's policies, and come with their sources there. SI
/// units; angles in degrees, as typed.
struct LawOptions {
  LawKind kind = LawKind::mohr_coulomb;
  double rate_time = 1e-3;           ///< s: a regulariser, no property of sand
  double rate_smoothing = 0;         ///< s; 0: none
  double mu_rise = 0.261;            ///< mu_2 - mu_s
  double mu_inertia = 0.279;         ///< I_0
  double grain_size = 0.53e-3;       ///< m
  double grain_density = 2450;       ///< kg/m^3
  double per_decade = 0.027;         ///< share of phi
  double reference_rate = 2.1e-5;    ///< 1/s
  double dilatancy_per_decade = 0;   ///< share of psi
  std::optional<double> residual;    ///< friction, deg
  double residual_dilatancy = 0;     ///< deg
  double decay = 8;                  ///< eta, per unit of plastic strain
  std::optional<double> decay_cell;  ///< m: the cell that `decay` belongs to; without: any cell

  bool softens() const { return kind == LawKind::softening || kind == LawKind::softening_rate; }
  bool grows_by_decade() const { return kind == LawKind::log_rate || kind == LawKind::softening_rate; }
};

/// Shows the options to a visitor: see `visit_options`.
template <class Options, class Visitor>
void visit_law_options(Options& o, Visitor& v) {
  v.group("Law of the sand's friction (--friction is that at rest, or the peak; docs/sand.md)");
  v.choice("--law", law_words, o.kind,
           "Angle of friction: one, or by shear rate, inertial number, plastic strain");
  v.number("--rate-time", o.rate_time, "S", Range{0, 1, "s"},
           "linear-rate: tan(phi) grows by this times the shear rate. A regulariser, no property of sand");
  v.number("--rate-smoothing", o.rate_smoothing, "S", Range{0, 1, "s"},
           "Time over which shear rates are smoothed, 0 for none");
  v.number("--mu-rise", o.mu_rise, "X", Range{0, 10},
           "mu-i: mu_2 - mu_s (Jop et al. 2006, glass beads of 0.53 mm)");
  v.number("--mu-inertia", o.mu_inertia, "X", above(0, 100), "mu-i: I_0 (Jop et al. 2006)");
  v.number("--grain-size", o.grain_size, "M", above(0, 0.1, "m"), "mu-i: size of the grains");
  v.number("--grain-density", o.grain_density, "KG_M3", above(0, 30000, "kg/m^3"),
           "mu-i: density of the grains");
  v.number(
      "--per-decade", o.per_decade, "X", Range{0, 10},
      "log-rate, softening-rate: share of phi that a decade of the rate adds (Zambrano-Cruzatty and Yerro "
      "2020, sample)");
  v.number("--reference-rate", o.reference_rate, "PER_S", above(0, 1e6, "1/s"),
           "log-rate, softening-rate: rate from which decades count (the same sample)");
  v.number("--dilatancy-per-decade", o.dilatancy_per_decade, "X", Range{0, 10},
           "softening-rate: share of psi that a decade adds (the same sample: 0.27)");
  v.number(
      "--residual-friction", o.residual, "DEG", Range{1, 60, "deg"},
      "softening, softening-rate: angle of friction after large strains; must be given (the same sample: "
      "36 for a peak of 39)");
  v.number("--residual-dilatancy", o.residual_dilatancy, "DEG", Range{0, 60, "deg"},
           "softening, softening-rate: angle of dilatancy after large strains");
  v.number("--decay", o.decay, "X", Range{0, 1000},
           "softening, softening-rate: decay of the peak per unit of plastic strain (the same sample)");
  v.number(
      "--decay-cell", o.decay_cell, "M", above(0, 1, "m"),
      "softening, softening-rate: edge of the cell that --decay is for; the decay then goes with --cell, so "
      "that a band of one cell takes the same work. Without: --decay for any cell");
}

/// Throws `error` if the law's constants do not go together, or with the peak angles, deg.
void check(const LawOptions& o, double friction, double dilatancy);

/// Adds the law, and those of its constants that it reads, to the inputs of a summary.
void add_inputs(const LawOptions& o, nlohmann::ordered_json& j);

}  // namespace arenite::ffp
