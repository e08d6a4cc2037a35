// States in files: a saved state continues with the same bits; a foreign, truncated or damaged one is
// refused with the reason; a process that is killed while it writes leaves the last whole file.
#include <sys/wait.h>
#include <unistd.h>

#include <arenite/arenite.hpp>
#include <arenite/io/pvd.hpp>
#include <arenite/observe/vtu.hpp>
#include <arenite/run/saved_state.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "catch.hpp"
#include "saved_files.hpp"
#include "state_buffer.hpp"

using namespace arenite;
using Catch::Matchers::Contains;
using test::StateBuffer;
using test::steps, test::content_of, test::write;

namespace {

template <class Law = MohrCoulomb<>>
auto sand() {
  return Law{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}};
}

/// A heap that falls, slowed down, and spreads up to a soft wall; a ball drops into it.
template <class Law = MohrCoulomb<>>
auto make(double cell = 0.05) {
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 1}, .cell = cell}},
               Numerics<QuadraticBSpline, Apic, Usl>{},
               bodies(fill<"sand">(Box{{0., 0.}, {0.6, 0.5}}, sand<Law>())),
               walls(bottom(fixed), left(roller)),
               gravity({0, -9.81}),
               rigids(rigid<"ball">(
                   DistanceSurface{[](const auto& x) { return std::hypot(x[0] - 0.3, x[1] - 0.65) - 0.1; }},
                   Guided{.mass = 50, .velocity = -2}, Friction(20_deg))),
               absorbing(right(), {.support = Support::first_reaction}),
               LocalDamping{},
               TrackEnergy{}};
}

}  // namespace

TEST_CASE("Saved: a run continues with the same bits, on other threads too") {
  const int threads_before = threads();
  const auto watch = [] { return Watch({.lost = 1, .every = 7}); };
  set_threads(1);
  auto whole = make();
  Watch seen = watch();
  steps(whole, 40, seen);
  save_state(whole, "a.state", seen);
  steps(whole, 40, seen);
  for (const int n : {1, 2, 3}) {
    CAPTURE(n);
    set_threads(n);
    auto scene = make();
    Watch again = watch();
    restore_state(scene, "a.state", again);
    steps(scene, 40, again);
    CHECK(StateBuffer::first_difference(StateBuffer(scene, again), StateBuffer(whole, seen)) == "");
  }
  set_threads(threads_before);
}

TEST_CASE("Saved: an observer of a run saves at regular times; the run is resumed to the same end") {
  auto whole = make();
  std::vector<double> saved;
  run(whole, {.end = 0.05}, every(0.02, [&](const auto& s) {
        save_state(s, {"run_" + std::to_string(saved.size()) + ".state", "a recipe"});
        saved.push_back(s.time);
      }));
  REQUIRE(saved.size() == 3);
  auto resumed = make();
  restore_state(resumed, {"run_1.state", "a recipe"});
  CHECK(resumed.time == saved[1]);
  run(resumed, {.end = 0.05});
  CHECK(StateBuffer::first_difference(StateBuffer(resumed), StateBuffer(whole)) == "");
}

TEST_CASE("Saved: a series of files continues, is replaced with a warning, or is kept by an error") {
  std::filesystem::remove_all("series");
  const auto frames = [] { return pvd_times("series/run.pvd"); };
  std::vector<std::string> warnings;
  const auto hook = on_warning([&](const auto& text) {
    if (text.find("series = ") != std::string::npos) warnings.push_back(text);
  });
  auto scene = make();
  auto first = vtu("series/run");
  CHECK(frames().empty());
  first(scene);
  steps(scene, 2, first);
  const auto times = frames();
  REQUIRE(times == std::vector<double>{0, times[1], scene.time});
  save_state(scene, "series/state", first);
  steps(scene, 1, first);
  first(scene);  // again at the same time, as at the start of a resumed run
  CHECK(frames().size() == 4);

  auto restored = make();
  auto series = vtu("series/run");
  CHECK(frames().size() == 4);  // it is the restored observer that knows
  restore_state(restored, "series/state", series);
  CHECK(frames() == times);
  steps(restored, 1, series);
  CHECK(frames().size() == 4);

  // With other parts: the files of each frame are those that were written for it.
  auto renamed = make();
  auto other_parts = vtu("series/run", {.body_names = {"soil"}});
  restore_state(renamed, "series/state", other_parts);
  steps(renamed, 1, other_parts);
  const auto files = pvd_entries("series/run.pvd");
  REQUIRE(files.size() == 4);
  CHECK(files[2].file == "series/run_sand_0002.vtu");
  CHECK(files[3].file == "series/run_soil_0003.vtu");
  CHECK(std::ranges::all_of(files, [](const PvdEntry& e) { return std::filesystem::exists(e.file); }));

  auto without = make();
  restore_state(without, "series/state", first);
  const std::string kept = content_of("series/run_sand_0000.vtu");
  auto other = vtu("series/run");
  CHECK_THROWS_WITH(other(without), Catch::Matchers::Contains("series = series/run.pvd: holds 3 frames") &&
                                        Catch::Matchers::Contains("say resumed, else remove run.pvd"));
  CHECK(frames().size() == 3);
  CHECK(content_of("series/run_sand_0000.vtu") == kept);
  auto resumed = vtu("series/run", {.resumed = true});
  resumed(without);
  CHECK(frames() == times);
  CHECK(warnings.empty());

  auto anew = make();
  vtu("series/run")(anew);
  CHECK(frames() == std::vector<double>{0});
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("3 frames of an earlier run, t = 0 to ") != std::string::npos);
  on_warning(hook);
}

TEST_CASE("Saved: what is of another run is refused, and the scene stays as it was") {
  auto scene = make();
  steps(scene, 3);
  Watch watch;
  save_state(scene, {"mine.state", "inputs 1"}, watch);
  auto other = make();
  const StateBuffer before(other);
  const auto refusal = [&](auto& into, const SavedState& from, auto&... observers) -> std::string {
    try {
      restore_state(into, from, observers...);
    } catch (const error& e) {
      return e.what();
    }
    return "taken";
  };
  CHECK_THAT(refusal(other, {"mine.state", "inputs 2"}, watch),
             Contains("recipe: inputs 1; this one has recipe: inputs 2"));
  CHECK_THAT(refusal(other, {"mine.state"}, watch), Contains("recipe"));
  CHECK_THAT(refusal(other, {"mine.state", "inputs 1"}), Contains("values; this run has"));
  auto due = every(1, [](const auto&) {});
  CHECK_THAT(refusal(other, {"mine.state", "inputs 1"}, due), Contains("has no observers/0/due"));
  CHECK_THAT(refusal(other, {"none.state"}), Contains("none.state: no such file"));
  CHECK(StateBuffer::first_difference(StateBuffer(other), before) == "");
  auto finer = make(0.025);
  CHECK_THAT(refusal(finer, {"mine.state", "inputs 1"}, watch), Contains("mesh: CartesianGrid<2,double>"));
  auto grains = make<DruckerPrager<>>();
  CHECK_THAT(refusal(grains, {"mine.state", "inputs 1"}, watch),
             Contains("body sand: MohrCoulomb") && Contains("body sand: DruckerPrager"));
}

TEST_CASE("Saved: truncated and damaged files are refused") {
  auto scene = make();
  save_state(scene, "whole.state");
  const std::string whole = content_of("whole.state");
  auto other = make();
  const StateBuffer before(other);
  std::mt19937 random(7);
  const auto refused = [&](const std::string& content, const std::string& reason) {
    write("bad.state", content);
    REQUIRE_THROWS_WITH(restore_state(other, "bad.state"),
                        Contains("state file = bad.state: ") && Contains(reason));
  };
  refused("", "is no state file of Arenite");
  refused("<VTKFile type=\"UnstructuredGrid\">\n", "is no state file of Arenite");
  refused("arenite state 2" + whole.substr(15), "has the format 2; this program reads 1");
  refused(whole + "x", "1 bytes follow its end");
  const std::string order = shared_detail::byte_order(), opposite = order == "little" ? "big" : "little";
  const auto at = whole.find(order);
  refused(whole.substr(0, at) + opposite + whole.substr(at + order.size()), "other byte order");
  const std::size_t head = whole.find("\n\n");
  for (const std::size_t bytes : {std::size_t{20}, head / 2, head})
    refused(whole.substr(0, bytes), "is truncated");
  for (const std::size_t bytes : {head + 2, whole.size() / 2, whole.size() - 1})
    refused(whole.substr(0, bytes), "is truncated: " + std::to_string(bytes) + " bytes are left");
  for (int k = 0; k < 200; ++k) {  // one bit somewhere, in the head more often than its size asks for
    std::string damaged = whole;
    const std::size_t place = random() % (k % 2 == 0 ? head : whole.size());
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << (random() % 8)));
    CAPTURE(place);
    refused(damaged, "");
  }
  CHECK(StateBuffer::first_difference(StateBuffer(other), before) == "");
}

TEST_CASE("Saved: whole files of states that do not fit are refused, and the scene stays as it was") {
  test::check_crafted([] { return make(); },
                      [terms = detail::state_terms(make(), "")](const auto& entries) {
                        write_state_file("crafted.state", terms, entries);
                      },
                      [](auto& scene) { restore_state(scene, "crafted.state"); });
  auto scene = make();
  save_state(scene, "whole.state");
  const std::string whole = content_of("whole.state");
  const StateBuffer before(scene);
  const auto at = whole.find("\nf8 ") + 4, end = whole.find(' ', at);
  for (const std::string count : {"-1", "nan", "1e3", "18446744073709551615", "281474976710656", ""}) {
    std::string head = whole.substr(0, at) + count + whole.substr(end);
    Hash hash;
    hash.add(head.data(), head.size() - sizeof(std::uint64_t));
    const std::uint64_t sum = hash.value();
    std::memcpy(head.data() + head.size() - sizeof(sum), &sum, sizeof(sum));
    write("crafted.state", head);
    CHECK_THROWS_WITH(restore_state(scene, "crafted.state"), Contains("state file = crafted.state: is "));
  }
  write("crafted.state", "arenite state 1\n" + std::string(1 << 17, 'a'));
  CHECK_THROWS_WITH(restore_state(scene, "crafted.state"), Contains("a line of its head has"));
  CHECK(StateBuffer::first_difference(StateBuffer(scene), before) == "");
}

TEST_CASE("Saved: killed a hundred times while it writes, the last whole file loads") {
  auto scene = make();
  std::filesystem::remove("killed.state");
  const auto begin = std::chrono::steady_clock::now();
  save_state(scene, "killed.state");
  const auto one = std::chrono::steady_clock::now() - begin;
  std::mt19937 random(11);
  int written = 0;
  double last = scene.time;
  for (int k = 0; k < 100 || (written <= 20 && k < 1000); ++k) {  // more on a busy machine
    const ::pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {  // saves without a pause; nothing but the time changes, and no other thread is asked
      for (;;) {
        scene.time += 1;
        save_state(scene, "killed.state");
      }
    }
    std::this_thread::sleep_for(one * (random() % 80) / 10);  // to eight times what it takes
    ::kill(child, SIGKILL);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
    REQUIRE_NOTHROW(restore_state(scene, "killed.state"));
    REQUIRE(scene.time >= last);
    written += scene.time > last;
    last = scene.time;
  }
  CHECK(written > 20);
}

TEST_CASE("Saved: what cannot be written says so and leaves the old file") {
  auto scene = make();
  CHECK_THROWS_AS(save_state(scene, "no/such/folder/a.state"), output_error);
  CHECK_THROWS_WITH(save_state(scene, {"a.state", "two\nlines"}), Contains("line break"));
}

TEST_CASE("A hash is that of the bytes, however they are cut, and of their number") {
  std::mt19937 random(3);
  std::string bytes(1000, ' ');
  for (char& c : bytes) c = static_cast<char>(random());
  Hash whole;
  whole.add(bytes.data(), bytes.size());
  for (int k = 0; k < 100; ++k) {
    Hash pieces;
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t size = std::min<std::size_t>(random() % 20, bytes.size() - at);
      pieces.add(bytes.data() + at, size);
      at += size;
    }
    REQUIRE(pieces.value() == whole.value());
    std::string other = bytes;
    const std::size_t place = random() % other.size();
    other[place] = static_cast<char>(other[place] ^ (1 << (random() % 8)));
    Hash changed;
    changed.add(other.data(), other.size());
    REQUIRE(changed.value() != whole.value());
  }
  Hash empty, zero;
  zero.add("", 1);
  CHECK(empty.value() != zero.value());
  CHECK(whole.digits().size() == 16);
}

TEST_CASE("Types as words are the same from all compilers") {
  CHECK(type_words<double>() == "double");
  CHECK(type_words<SimplexMesh<3, float>>() == "SimplexMesh<3,float>");
  CHECK(type_words<CartesianGrid<2>>() == "CartesianGrid<2,double>");
  CHECK(type_words<WithDeviatoricStrain<MohrCoulomb<RemembersOpening>, 2>>().starts_with(
      "WithDeviatoricStrain<MohrCoulomb<RemembersOpening"));
  CHECK(type_words<MohrCoulomb<>>() != type_words<MohrCoulomb<RemembersOpening>>());
}
