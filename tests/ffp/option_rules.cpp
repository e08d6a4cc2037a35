// Options of each kind of drop: its defaults, and options that exclude each other.
#include <fstream>

#include "read_words.hpp"

using namespace arenite;
using namespace arenite::ffp;

TEST_CASE("--accuracy decides the cells and the time step that are not given") {
  const auto sizes = [](const std::vector<std::string>& given) {
    const DropOptions o = read(given);
    return std::pair{o.cell_size(), o.courant_number()};
  };
  REQUIRE(sizes({"--accuracy", "coarse"}) == std::pair{0.02, 0.9});
  REQUIRE(sizes({"--accuracy", "normal"}) == sizes({}));
  REQUIRE(sizes({"--accuracy", "fine"}) == std::pair{0.005, 0.5});
  REQUIRE(sizes({"--accuracy", "coarse", "--cell", "0.015"}) == std::pair{0.015, 0.9});
  REQUIRE(sizes({"--courant", "0.3", "--accuracy", "coarse"}) == std::pair{0.02, 0.3});
  REQUIRE(read({"--accuracy", "fine"}).mesh_sizes().cell == 0.005);
  REQUIRE(refusal_of({"drop", "--accuracy", "fine", "--cell-at-cone", "0.006"}) ==
          "--cell-at-cone = 0.006: must not exceed --cell = 0.005 m");
  REQUIRE(refusal_of({"drop", "--accuracy", "best"}) ==
          "--accuracy = best: must be coarse or normal or fine");
}

TEST_CASE("each tip has its shape and its mass") {
  REQUIRE(read({}).tip == Tip::cone);
  REQUIRE(read({}).body().flat_radius() == 0);
  REQUIRE(read({"--tip", "cone-truncated"}).body().flat_radius() == 0.0022);
  REQUIRE(read({"--tip", "cone-truncated"}).device_mass() == 7.71);
  const auto parabolic = read({"--tip", "parabolic"});
  REQUIRE(std::abs(parabolic.body().profile(0.0024184) - 0.0024184 * std::sqrt(10.0)) < 1e-15);
  REQUIRE(parabolic.device_mass() == 9.15);
  REQUIRE(read({"--tip", "blunt"}).body().tip_end() == 0);
  REQUIRE(read({"--tip", "blunt"}).device_mass() == 10.30);
  REQUIRE(read({"--tip", "blunt", "--mass", "9"}).device_mass() == 9);
  for (const char* tip : {"cone", "cone-truncated", "parabolic", "blunt"})
    REQUIRE(read({"--tip", tip}).body().length() == 0.631);
  for (const char* tip : {"parabolic", "blunt"})
    REQUIRE(refusal_of({"drop", "--tip", tip, "--shoulder", "fillet"}) ==
            "--shoulder = fillet: needs --tip cone or cone-truncated");
  // A small fillet needs cells that see it; one that is no part of the shape does not.
  const std::vector<std::string> small{"drop", "--fillet", "0.0008", "--shoulder", "fillet"};
  REQUIRE(refusal_of(small).find(
              "--fillet = 0.0008: below 0.001 m needs --cell-at-cone of at most 0.000837") == 0);
  REQUIRE(read({"--fillet", "0.0008", "--shoulder", "fillet", "--cell-at-cone", "0.0008"}).fillet == 0.0008);
  REQUIRE(read({"--fillet", "0.0008"}).fillet == 0.0008);
}

TEST_CASE("the surface that the sand touches may lie off the penetrometer's") {
  const auto o = read({"--contact-offset", "-0.002"});
  REQUIRE(std::abs(o.body().radius() - 0.04175) < 1e-15);
  REQUIRE(o.body().instrument().radius() == 0.04375);
  std::ofstream{"file.msh"} << "$MeshFormat\n";
  REQUIRE(refusal_of({"drop", "--contact-offset", "-0.002", "--mesh", "file.msh"}) ==
          "--contact-offset = -0.002: goes without --mesh");
}

TEST_CASE("field files without number are refused") {
  for (const char* period : {"1e-300", "4.9e-324", "9.9e-5"})
    REQUIRE(refusal_of({"drop", "--fields-every", period}).find(std::string{"--fields-every = "}) == 0);
  REQUIRE(refusal_of({"drop", "--fields-every", "1e-300"}) ==
          "--fields-every = 1e-300: must be 0, for none, or at least 0.0001 s, for 1000 sets of files until "
          "--end = 0.1 s");
  REQUIRE(read({"--fields-every", "1e-4"}).fields_every == 1e-4);
  REQUIRE(read({"--fields-every", "0"}).fields_every == 0);
}

TEST_CASE("laws of the sand's friction") {
  REQUIRE(read({}).law.kind == LawKind::mohr_coulomb);
  REQUIRE(read({"--law", "linear-rate", "--rate-time", "2e-3"}).law.rate_time == 2e-3);
  REQUIRE(read({"--law", "mu-i", "--grain-size", "1e-3"}).law.grain_size == 1e-3);
  REQUIRE(read({"--law", "log-rate", "--per-decade", "0.03"}).law.per_decade == 0.03);
  REQUIRE(read({"--law", "softening", "--residual-friction", "36"}).law.residual == 36);
  const auto refused = [](std::vector<std::string> words) {
    words.insert(words.begin(), "drop");
    return refusal_of(std::move(words));
  };
  REQUIRE(refused({"--law", "softening"}) == "--residual-friction = (none): must be given with this --law");
  REQUIRE(refused({"--law", "softening-rate", "--residual-friction", "41"}) ==
          "--residual-friction = 41: must not exceed --friction = 40 deg");
  REQUIRE(refused({"--law", "softening", "--residual-friction", "36", "--residual-dilatancy", "1"}) ==
          "--residual-dilatancy = 1: must not exceed --dilatancy = 0 deg");
  for (const auto& [option, value] :
       {std::pair{"--device", "elastic"}, {"--contact", "centre-of-mass"}, {"--anti-locking", "off"}})
    REQUIRE(refused({"--law", "mu-i", option, value}) ==
            "--law = mu-i: needs --device rigid, --contact rigid and --anti-locking on");
}

TEST_CASE("an error bar needs coarser drops") {
  REQUIRE(read({"--error-bar"}).error_bar);
  REQUIRE(!read({}).error_bar);
  REQUIRE(read({"--error-bar", "--cell", "0.02"}).cell == 0.02);
  REQUIRE(refusal_of({"drop", "--error-bar", "--cell", "0.021"}) ==
          "--cell = 0.021: must be at most 0.02 m with --error-bar, which runs drops at twice the cell");
  std::ofstream{"file.msh"} << "$MeshFormat\n";
  REQUIRE(refusal_of({"drop", "--error-bar", "--mesh", "file.msh"}) ==
          "--mesh = file.msh: goes without --error-bar, which needs coarser meshes");
}

TEST_CASE("jitter of the points") {
  const auto o = read({"--jitter", "0.5", "--jitter-seed", "3"});
  REQUIRE(o.jitter == 0.5);
  REQUIRE(o.jitter_seed == 3);
  REQUIRE(read({}).jitter == 0);
}

TEST_CASE("the grid: its own defaults, and options that it has not") {
  const auto o = read({"--mesh-kind", "grid"});
  REQUIRE((o.on_grid() && o.contact_kind() == ContactKind::points && !o.averages()));
  REQUIRE((o.points_in_element() == 9 && o.flip_time_constant() == 0.1 && o.split_share() == 0));
  REQUIRE(read({"--mesh-kind", "grid", "--contact", "rigid"}).contact_kind() == ContactKind::rigid);
  REQUIRE(read({"--mesh-kind", "grid", "--flip-time", "0"}).flip_time_constant() == 0);
  REQUIRE(read({"--mesh-kind", "grid", "--cell-at-cone", "0.005"}).split_share() == 4);
  REQUIRE(read({"--mesh-kind", "grid", "--law", "mu-i"}).law.kind == LawKind::mu_i);
  std::ofstream{"file.msh"} << "$MeshFormat\n";
  for (const auto& [option, value] : {std::pair{"--kinematics", "slice"},
                                      {"--device", "elastic"},
                                      {"--contact", "centre-of-mass"},
                                      {"--anti-locking", "on"},
                                      {"--mesh", "file.msh"}})
    REQUIRE(refusal_of({"drop", "--mesh-kind", "grid", option, value}) ==
            "--mesh-kind = grid: needs --kinematics axisymmetric or space, --device rigid, --contact points "
            "or rigid "
            "and --anti-locking off, and goes without --mesh");
  REQUIRE(refusal_of({"drop", "--mesh-kind", "grid", "--points-per-element", "10"}) ==
          "--points-per-element = 10: must be 4, 9, 16, 25, 36 or 49 in the cells of a grid");
  REQUIRE(refusal_of({"drop", "--contact", "points"}) == "--contact = points: needs --mesh-kind grid");
}

TEST_CASE("in space: a grid, a penetrometer that may be tilted, and what goes without") {
  const auto o = read({"--kinematics", "space", "--tilt", "5"});
  REQUIRE((o.in_space() && o.on_grid() && o.contact_kind() == ContactKind::rigid && !o.averages()));
  REQUIRE((o.points_in_element() == 8 && o.flip_time_constant() == 0.1 && o.tilt == 5));
  REQUIRE(read({"--kinematics", "space", "--gyration", "0.2"}).gyration_radius() == 0.2);
  REQUIRE(read({"--kinematics", "space", "--centre-of-mass", "0.3"}).centre_height() == 0.3);
  for (const auto& [option, value] :
       {std::pair{"--tilt", "5"}, {"--centre-of-mass", "0.3"}, {"--gyration", "0.2"}})
    REQUIRE(refusal_of({"drop", option, value}) ==
            std::string{option} + " = " + value + ": needs --kinematics space");
  const auto refused = [](const char* option, const char* value) {
    return refusal_of({"drop", "--kinematics", "space", option, value});
  };
  REQUIRE(refused("--tilt", "31") == "--tilt = 31: must lie in [0, 30] deg");
  std::ofstream{"file.msh"} << "$MeshFormat\n";
  for (const auto& [option, value] : {std::pair{"--mesh-kind", "fitted"},
                                      {"--device", "elastic"},
                                      {"--contact", "points"},
                                      {"--anti-locking", "on"},
                                      {"--split", "4"},
                                      {"--mesh", "file.msh"}})
    REQUIRE(refused(option, value) ==
            "--kinematics = space: needs --mesh-kind grid, --device rigid, --contact rigid and "
            "--anti-locking off, and goes without --mesh and --split");
  REQUIRE(refused("--points-per-element", "9") ==
          "--points-per-element = 9: must be 8, 27 or 64 in the cells of a grid in space");
  REQUIRE(refused("--cell-at-cone", "0.005").starts_with("--cell-at-cone = 0.005: needs --kinematics"));
}
