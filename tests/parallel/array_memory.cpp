// Memory of long arrays: it keeps the values written, and arrays of similar length start at different
// offsets in a page.
#include "catch.hpp"

#include <arenite/parallel/array_memory.hpp>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <set>
#include <vector>

#ifdef __linux__
#include <unistd.h>
#endif

using namespace arenite;

namespace {

template <class T>
using Array = std::vector<T, ArrayMemory<T>>;

template <class T>
std::uintptr_t begin_of(const Array<T>& a) {
  return reinterpret_cast<std::uintptr_t>(a.data());
}

}  // namespace

TEMPLATE_TEST_CASE("arrays of any length keep their numbers through copies, moves and growth", "", float,
                   double, std::uint32_t) {
  // Nothing, short, just long, long, just below a large page, above.
  for (const std::size_t n : {0u, 1u, 100u, 8192u, 16384u, 70000u, 262143u, 262144u, 600000u}) {
    Array<TestType> a(n);
    std::iota(a.begin(), a.end(), TestType(1));
    Array<TestType> copy = a, spare;
    spare.swap(a);
    a = std::move(spare);
    a.push_back(TestType(7));
    REQUIRE(a.size() == n + 1);
    REQUIRE(std::equal(copy.begin(), copy.end(), a.begin()));
    REQUIRE((n == 0 || copy.back() == static_cast<TestType>(n)));
  }
}

TEST_CASE("long arrays begin at different lines of a page, very long ones with a large page") {
  constexpr std::size_t page = ArrayMemory<double>::page, line = ArrayMemory<double>::line;
  std::vector<Array<double>> columns(20);
  std::set<std::uintptr_t> lines;
  for (auto& column : columns) {
    column.resize(100000);
    REQUIRE(begin_of(column) % line == 0);
    lines.insert(begin_of(column) % page / line);
  }
  REQUIRE(lines.size() == columns.size());
  const Array<double> large(1000000);
  REQUIRE(begin_of(large) % ArrayMemory<double>::large_page == 0);
}

#ifdef __linux__
TEST_CASE("memory is taken page by page, when a number is first written") {
  // Pages of this process that lie in memory.
  const auto resident = [] {
    std::ifstream status("/proc/self/statm");
    std::size_t all = 0, in_memory = 0;
    status >> all >> in_memory;
    return in_memory * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  };
  const std::size_t n = 8000000, before = resident();
  REQUIRE(before > 0);
  Array<double> a(n);
  REQUIRE(resident() - before < n * sizeof(double) / 4);
  std::fill(a.begin(), a.end(), 1.0);
  REQUIRE(resident() - before > n * sizeof(double) / 2);
}
#endif
