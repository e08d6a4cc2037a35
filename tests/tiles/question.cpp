// Questions of ranks: what differs is named, whichever rank it is.
#include <arenite/tiles/question.hpp>

#include "catch.hpp"

using namespace arenite;

TEST_CASE("a question: its bytes are equal only for equal numbers, and it is read back") {
  const Question asked =
      Question{"a run"}.with("end", 0.1).with("watch", true).with("mesh", std::vector<int>{1, 2});
  const std::string bytes = asked.packed();
  std::string_view rest = bytes;
  CHECK(Question::unpacked(rest) == asked);
  CHECK(rest.empty());
  CHECK(Question{"a run"}.with("end", 0.1).packed() != Question{"a run"}.with("end", 0.1 + 2e-17).packed());
  CHECK(Question{"a"}.with("b", 1).packed() != Question{"a"}.with("b", 2).packed());
}

TEST_CASE("a question: the first rank that differs, and where") {
  const auto run = [](double end) {
    return Question{"a run"}.with("courant", 0.5).with("end", end).packed();
  };
  const auto refused = [](const std::string& of_ranks, const std::string& sentence) {
    CHECK_THROWS_WITH(refuse_different(of_ranks), sentence + ": all ranks must ask for the same");
  };
  refused(run(1) + run(1) + run(2) + run(1), "a run: rank 2 was given end = 2, rank 0 end = 1");
  refused(run(1) + Question{"a sum"}.packed(), "rank 1 asks for a sum while rank 0 asks for a run");
  refused(Question{"a run"}.packed() + run(1), "a run: rank 1 was given courant = 0.5, rank 0 nothing");
}
