// Tables out: exact numbers, whole rows at any time, and a full disk that is told.
#include <arenite/io/csv.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include "catch.hpp"

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#include <csignal>
#endif

using namespace arenite;

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("numbers are written in their shortest form that reads back exactly") {
  CsvWriter table("table.csv", {"time_s", "force_N", "x"});
  table.row({0, 0.1, 1.0 / 3});
  table.row({-0.0, 1e300, std::nextafter(1.0, 2.0)});
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  table.row({-nan, infinity, -infinity});
  REQUIRE(text_of("table.csv") ==
          "time_s,force_N,x\n0,0.1,0.3333333333333333\n-0,1e+300,1.0000000000000002\nnan,inf,-inf\n");

  std::mt19937_64 engine(3);
  CsvWriter random("random.csv", {"x"});
  std::vector<double> values;
  while (values.size() < 10000) {
    const auto bits = engine();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    if (!std::isfinite(x)) continue;
    values.push_back(x);
    random.row({x});
  }
  std::istringstream in(text_of("random.csv"));
  std::string line;
  std::getline(in, line);
  for (const double x : values) {
    REQUIRE(std::getline(in, line));
    REQUIRE(std::strtod(line.c_str(), nullptr) == x);
  }
}

TEST_CASE("each row is on disk as soon as it is given") {
  CsvWriter table("growing.csv", {"a", "b"});
  REQUIRE(text_of("growing.csv") == "a,b\n");
  std::string expected = "a,b\n";
  for (int i = 0; i < 2000; ++i) {
    const std::vector<double> row{double(i), 0.5};
    table.row(row);
    expected += std::to_string(i) + ",0.5\n";
    if (i % 100 == 0) REQUIRE(text_of("growing.csv") == expected);
  }
  CsvWriter moved = std::move(table);
  moved.row({1, 2});
  REQUIRE(text_of("growing.csv") == expected + "1,2\n");
}

TEST_CASE("what there is none of is an empty field") {
  CsvWriter table("gaps.csv", {"a", "b", "c"});
  table.row(std::vector<std::optional<double>>{1.5, std::nullopt, 0});
  table.row(std::vector<std::optional<double>>{std::nullopt, std::nullopt, std::nullopt});
  REQUIRE(text_of("gaps.csv") == "a,b,c\n1.5,,0\n,,\n");
}

TEST_CASE("mistakes are told") {
  REQUIRE_THROWS_AS(CsvWriter("no/such/folder.csv", {"a"}), output_error);
  REQUIRE_THROWS_AS(CsvWriter(".", {"a"}), error);
  REQUIRE_THROWS_AS(CsvWriter("x.csv", {}), error);
  REQUIRE_THROWS_AS(CsvWriter("x.csv", {"a", ""}), error);
  REQUIRE_THROWS_AS(CsvWriter("x.csv", {"a,b"}), error);
  REQUIRE_THROWS_WITH(CsvWriter("x.csv", {"a", "b", "a"}), "column = a: is given twice");
  CsvWriter table("x.csv", {"a", "b"});
  REQUIRE_THROWS_WITH(table.row({1}), "values in a row = 1: must be 2, the number of columns of x.csv");
}

#if __has_include(<sys/resource.h>)
TEST_CASE("a disk that is full is told, and the rows before stay") {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 1000;
  std::signal(SIGXFSZ, SIG_IGN);  // the write fails instead
  CsvWriter table("full.csv", {"a", "b"});
  setrlimit(RLIMIT_FSIZE, &small);
  int rows = 0;
  std::string message;
  try {
    for (; rows < 1000; ++rows) table.row({1.5, 2.5});
  } catch (const output_error& e) {
    message = e.what();
    REQUIRE(e.disk_full());
  }
  setrlimit(RLIMIT_FSIZE, &before);
  REQUIRE(rows == 124);  // 4 bytes of header, 8 a row
  REQUIRE(message.find("full.csv: cannot be written") != std::string::npos);
  REQUIRE(text_of("full.csv").substr(0, 12) == "a,b\n1.5,2.5\n");
  REQUIRE(text_of("full.csv").size() == 4 + 124 * 8);  // no part of the row that did not fit
  REQUIRE_THROWS_AS(table.row({1, 2}), output_error);
  REQUIRE(text_of("full.csv").size() == 4 + 124 * 8);
}
#endif
