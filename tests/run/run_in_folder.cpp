// Runs in a folder: the lock, the status, and a run that is interrupted, or killed, and resumes with the same bits.
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <arenite/arenite.hpp>
#include <arenite/run/run_in_folder.hpp>
#include "catch.hpp"

using namespace arenite;
namespace fs = std::filesystem;

namespace {

auto column() {
  const LinearElastic soil{{.density = 1540, .young = 1_MPa, .poisson = 0.3}};
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.2, 0.2}, .cell = 0.05}},
               Numerics<QuadraticBSpline>{},
               bodies(fill(Box{{0, 0}, {0.1, 0.15}}, soil)),
               walls(bottom(fixed), left(roller), right(roller)),
               gravity({0, -9.81})};
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream{file}.rdbuf();
  return text.str();
}

/// Raises a signal once, at a step.
struct Raise {
  int signal;
  std::size_t at;
  template <class Scene>
  void operator()(const Scene& scene) const {
    if (scene.steps == at) std::raise(signal);
  }
};

/// Counts its calls, which it saves.
struct Count {
  std::uint64_t calls = 0;
  template <class Scene>
  void operator()(const Scene&) {
    ++calls;
  }
  template <class F>
  void visit_state(F&& f) {
    f("calls", calls);
  }
};

}  // namespace

TEST_CASE("a run that is interrupted, and continues, ends with the bits of one that was not") {
  fs::remove_all("whole");
  fs::remove_all("parts");
  auto whole = column();
  auto count = every(0.01, Count{});
  REQUIRE(run_in_folder(whole, {.end = 0.1}, {.folder = "whole"}, count) == RunEnd::finished);
  REQUIRE_THAT(text_of("whole/status.json"),
               Catch::Contains("\"status\": \"finished\"") && Catch::Contains("\"failure\": null") &&
                   Catch::Contains("\"time_s\": 0.1,") && Catch::Contains("\"resumed_at_s\": []"));
  std::uint64_t counted = 0;
  for (const std::size_t at : {std::size_t{7}, std::size_t{20}}) {
    auto part = column();
    auto here = every(0.01, Count{});
    std::signal(SIGTERM, SIG_DFL);
    REQUIRE(run_in_folder(part, {.end = 0.1}, {.folder = "parts", .resume = at > 7}, here,
                          Raise{SIGTERM, at}) == RunEnd::interrupted);
    REQUIRE(part.steps == at);
    REQUIRE_THAT(text_of("parts/status.json"), Catch::Contains("\"status\": \"interrupted\""));
  }
  auto last = column();
  auto here = every(0.01, Count{});
  REQUIRE(run_in_folder(last, {.end = 0.1}, {.folder = "parts", .resume = true}, here, Raise{SIGTERM, 0}) ==
          RunEnd::finished);
  counted = here.called().calls;
  REQUIRE(counted == count.called().calls);
  REQUIRE(last.steps == whole.steps);
  REQUIRE(text_of("whole/checkpoint.state").size() == text_of("parts/checkpoint.state").size());
  const auto &a = whole.template body<0>().points, &b = last.template body<0>().points;
  for (std::size_t p = 0; p < a.size(); ++p)
    REQUIRE((a.position[p] == b.position[p] && a.velocity[p] == b.velocity[p]));
  REQUIRE(run_in_folder(last, {.end = 0.12}, {.folder = "parts", .resume = true}, here, Raise{SIGTERM, 0}) ==
          RunEnd::finished);
}

TEST_CASE("a run that is killed continues from its last checkpoint") {
  fs::remove_all("killed");
  const ::pid_t child = ::fork();
  if (child == 0) {
    auto scene = column();
    run_in_folder(scene, {.end = 0.1}, {.folder = "killed", .checkpoint_every = 0.02}, [](const auto& s) {
      if (s.time > 0.05) std::raise(SIGKILL);
    });
    ::_exit(0);
  }
  int how = 0;
  REQUIRE((::waitpid(child, &how, 0) == child && WIFSIGNALED(how)));
  REQUIRE_THAT(text_of("killed/status.json"), Catch::Contains("\"status\": \"running\""));
  auto rest = column(), whole = column();
  REQUIRE(run_in_folder(rest, {.end = 0.1}, {.folder = "killed", .resume = true}, [](const auto&) {}) ==
          RunEnd::finished);
  REQUIRE_THAT(text_of("killed/status.json"), Catch::Contains("\"resumed_at_s\": [0.04"));
  run(whole, {.end = 0.1});
  REQUIRE(whole.steps == rest.steps);
  REQUIRE(whole.template body<0>().points.position[0] == rest.template body<0>().points.position[0]);
}

TEST_CASE("a run that fails says so in its folder; one that is stopped by an observer too") {
  fs::remove_all("fails");
  auto scene = column();
  const auto fails = [](const auto& s) {
    if (s.steps == 3) throw run_error("the \"third\" step");
  };
  REQUIRE_THROWS_WITH(run_in_folder(scene, {.end = 0.1}, {.folder = "fails"}, fails), "the \"third\" step");
  REQUIRE_THAT(text_of("fails/status.json"), Catch::Contains("\"status\": \"failed\"") &&
                                                 Catch::Contains(R"("failure": "the \"third\" step")") &&
                                                 Catch::Contains("\"steps\": 3,"));
  auto other = column();
  const auto stops = [](const auto& s) { return s.steps == 5 ? RunFlow::stop : RunFlow::go_on; };
  REQUIRE(run_in_folder(other, {.end = 0.1}, {.folder = "fails"}, stops) == RunEnd::stopped);
  REQUIRE_THAT(text_of("fails/status.json"), Catch::Contains("\"status\": \"stopped\""));
}

TEST_CASE("what cannot be is refused, and the folder is as it was") {
  fs::remove_all("refused");
  auto scene = column();
  REQUIRE_THROWS_WITH(run_in_folder(scene, {.end = 0.1}, {}), "RunRecord.folder = \"\": must be given");
  REQUIRE_THROWS_WITH(run_in_folder(scene, {.end = 0.1}, {.folder = "refused", .checkpoint_every = 0}),
                      "RunRecord.checkpoint_every = 0: must be positive (s)");
  REQUIRE_THROWS_WITH(run_in_folder(scene, {}, {.folder = "refused"}),
                      Catch::Contains("RunOptions.end = nan"));
  REQUIRE(!fs::exists("refused"));
  REQUIRE(run_in_folder(scene, {.end = 0.01}, {.folder = "refused", .recipe = "35 deg"}) == RunEnd::finished);
  const std::string state = text_of("refused/checkpoint.state"), status = text_of("refused/status.json");
  auto again = column();
  REQUIRE_THROWS_WITH(
      run_in_folder(again, {.end = 0.1}, {.folder = "refused", .resume = true, .recipe = "30 deg"}),
      Catch::Contains("recipe: 35 deg"));
  REQUIRE((again.steps == 0 && text_of("refused/checkpoint.state") == state &&
           text_of("refused/status.json") == status));
  std::ofstream{"refused/pictures.pvd"} << "kept\n";
  REQUIRE(run_in_folder(again, {.end = 0.001}, {.folder = "refused"}) == RunEnd::finished);  // from the start
  REQUIRE(text_of("refused/pictures.pvd") == "kept\n");
  std::ofstream{"refused/.arenite.lock"} << "mine\n";
  REQUIRE_THROWS_WITH(run_in_folder(again, {.end = 0.1}, {.folder = "refused"}),
                      "RunRecord.folder = refused: .arenite.lock holds what no run has written, and no lock "
                      "of a run; remove it, or name "
                      "another folder");
}

TEST_CASE("two runs do not share a folder") {
  fs::remove_all("shared");
  int held[2], done[2];
  REQUIRE((::pipe(held) == 0 && ::pipe(done) == 0));
  const ::pid_t child = ::fork();
  char byte = 0;
  if (child == 0) {
    const RunFolder folder("shared", RunFolder::Earlier::kept);
    if (::write(held[1], &byte, 1) == 1 && ::read(done[0], &byte, 1) == 1) ::_exit(0);
    ::_exit(1);
  }
  REQUIRE(::read(held[0], &byte, 1) == 1);
  auto scene = column();
  REQUIRE_THROWS_WITH(
      run_in_folder(scene, {.end = 0.1}, {.folder = "shared"}),
      joined_text({"RunRecord.folder = shared: is in use by the run with process id ", child}));
  REQUIRE(::write(done[1], &byte, 1) == 1);
  int how = 0;
  REQUIRE((::waitpid(child, &how, 0) == child && how == 0));
  REQUIRE(run_in_folder(scene, {.end = 0.001}, {.folder = "shared"}) == RunEnd::finished);
  const RunFolder own("shared", RunFolder::Earlier::kept);  // nor do two of one process
  for (int again = 0; again < 2; ++again)
    REQUIRE_THROWS_WITH(
        run_in_folder(scene, {.end = 0.1}, {.folder = "shared"}),
        joined_text({"RunRecord.folder = shared: is in use by the run with process id ", ::getpid()}));
}

TEST_CASE("a signal is noted, found by the next check, and harmless before and after") {
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, SIG_DFL);
    {
      const StopSignals signals;
      REQUIRE_NOTHROW(signals.check());
      std::raise(signal);
      try {
        signals.check();
        FAIL("not noted");
      } catch (const Interruption& e) {
        REQUIRE(e.exit_code() == 128 + signal);
        REQUIRE(std::string{e.what()} ==
                (signal == SIGINT ? "interrupted by SIGINT" : "interrupted by SIGTERM"));
      }
    }
    REQUIRE(std::signal(signal, SIG_IGN) == SIG_DFL);
    {
      const StopSignals signals;  // what was ignored stays ignored
      std::raise(signal);
      REQUIRE_NOTHROW(signals.check());
    }
    REQUIRE(std::signal(signal, SIG_DFL) == SIG_IGN);
  }
}
