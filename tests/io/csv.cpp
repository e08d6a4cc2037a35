// Output of tables: exact numbers, whole rows at any time, and the error for a full disk.
#include <arenite/io/csv.hpp>
#include <arenite/io/input_file.hpp>

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
#include <sys/stat.h>
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

TEST_CASE("mistakes are reported") {
  REQUIRE_THROWS_AS(CsvWriter("no/such/folder.csv", {"a"}), output_error);
  REQUIRE_THROWS_AS(CsvWriter(".", {"a"}), error);
  REQUIRE_THROWS_AS(CsvWriter("x.csv", {}), error);
  REQUIRE_THROWS_AS(CsvWriter("x.csv", {"a", ""}), error);
  REQUIRE_THROWS_AS(CsvWriter("x.csv", {"a,b"}), error);
  REQUIRE_THROWS_WITH(CsvWriter("x.csv", {"a", "b", "a"}), "column = a: is given twice");
  CsvWriter table("x.csv", {"a", "b"});
  REQUIRE_THROWS_WITH(table.row({1}), "values in a row = 1: must be 2, the number of columns of x.csv");
}

TEST_CASE("files out: a link at a name is replaced, not followed, and what is no file is refused") {
  namespace fs = std::filesystem;
  fs::remove_all("links");
  fs::create_directories("links/folder");
  std::ofstream("links/precious") << "precious";
  const auto whole = [](const char* name) {
    shared_detail::replace_file(
        name, [](std::ostream& out) { out << "whole\n"; }, shared_detail::Sync::disk);
  };
  for (const char* name : {"links/table.csv", "links/whole", "links/whole.part"})
    fs::create_symlink("precious", name);
  fs::create_hard_link("links/precious", "links/other.csv");
  whole("links/whole");
  CsvWriter("links/table.csv", {"a"}).row({1});
  CsvWriter("links/other.csv", {"a"}).row({1});
  REQUIRE(text_of("links/precious") == "precious");
  REQUIRE(text_of("links/whole") == "whole\n");
  REQUIRE(text_of("links/table.csv") == "a\n1\n");
  REQUIRE(fs::is_regular_file(fs::symlink_status("links/table.csv")));
  REQUIRE_FALSE(fs::exists(fs::symlink_status("links/whole.part")));

  // A table that is continued is written in place, so that a link is refused.
  std::ofstream("links/precious") << "a\n1\n2\n";
  fs::create_symlink("precious", "links/linked.csv");
  REQUIRE_THROWS_AS(CsvWriter("links/linked.csv", {"a"}, 4), output_error);
  REQUIRE(text_of("links/precious") == "a\n1\n2\n");
  CsvWriter("links/precious", {"a"}, 4).row({3});
  REQUIRE(text_of("links/precious") == "a\n1\n3\n");

  REQUIRE_THROWS_WITH(whole("links/folder"),
                      Catch::Matchers::StartsWith("output = links/folder: is a folder"));
  fs::create_directory_symlink("folder", "links/to_folder");  // a folder that is reached by a link is one
  whole("links/to_folder/file");
  REQUIRE(text_of("links/folder/file") == "whole\n");
}

#if __has_include(<sys/resource.h>)
TEST_CASE("pipes and devices are neither written nor waited for") {
  using Catch::Matchers::StartsWith;
  std::remove("pipe");
  REQUIRE(mkfifo("pipe", 0600) == 0);
  REQUIRE_THROWS_WITH(CsvWriter("pipe", {"a"}), StartsWith("output = pipe: is a device, pipe or socket"));
  REQUIRE_THROWS_AS(CsvWriter("pipe", {"a"}, 2), output_error);
  REQUIRE_THROWS_WITH(shared_detail::replace_file("pipe", [](std::ostream&) {}),
                      StartsWith("output = pipe: is a device"));
  REQUIRE(std::filesystem::is_fifo("pipe"));

  using shared_detail::read_input;
  REQUIRE_THROWS_WITH(read_input("pipe", "mesh", 10),
                      "mesh = pipe: must be a regular file, not a pipe or a device");
  REQUIRE_THROWS_WITH(read_input("/dev/zero", "mesh", 10),
                      StartsWith("mesh = /dev/zero: must be a regular file, not a pipe"));
  REQUIRE_THROWS_WITH(read_input(".", "mesh", 10), "mesh = .: must be a regular file, not a folder");
  std::ofstream("eleven") << "eleven byte";
  REQUIRE_THROWS_WITH(read_input("eleven", "mesh", 10),
                      "mesh = eleven: has 11 bytes; must have at most 10 bytes");
  REQUIRE(read_input("eleven", "mesh", 11) == "eleven byte");
  std::filesystem::resize_file("eleven", std::uintmax_t{40} << 30);  // without blocks on the disk
  REQUIRE_THROWS_WITH(read_input("eleven", "mesh", std::uintmax_t{16} << 30),
                      "mesh = eleven: has 42949672960 bytes; must have at most 16 GiB");
  std::filesystem::remove("eleven");
}

TEST_CASE("a disk that is full is reported, and the rows before stay") {
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
