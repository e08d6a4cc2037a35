// STL files: both kinds, vertices merged, and damaged files, which do no worse than throw.
#include <arenite/io/stl.hpp>
#include <bit>
#include <fstream>
#include <sstream>

#include "../geometry/sample_surfaces.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

TriangleData read(const std::string& bytes, double scale = 1) {
  std::istringstream in(bytes);
  return read_stl(in, "file", scale);
}

std::string as_text(const TriangleData& data) {
  std::ostringstream out;
  out.precision(17);
  out << "solid with a name\n";
  for (const auto& t : data.triangles) {
    out << "  facet normal 0 0 0\n    outer loop\n";
    for (const Index i : t) out << "      vertex " << data.vertices[i].transpose() << '\n';
    out << "    endloop\n  endfacet\n";
  }
  out << "endsolid with a name\n";
  return out.str();
}

void append(std::string& bytes, std::uint32_t number) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(number >> (8 * k) & 255);
}

std::string as_binary(const TriangleData& data, std::string head = "solid that is none") {
  head.resize(80, ' ');
  append(head, static_cast<std::uint32_t>(data.triangles.size()));
  for (const auto& t : data.triangles) {
    for (int k = 0; k < 3; ++k) append(head, 0);
    for (const Index i : t)
      for (int k = 0; k < 3; ++k)
        append(head, std::bit_cast<std::uint32_t>(static_cast<float>(data.vertices[i][k])));
    head += "ab";
  }
  return head;
}

void check_same(const TriangleData& a, const TriangleData& b) {
  REQUIRE(a.triangles.size() == b.triangles.size());
  for (std::size_t t = 0; t < a.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      REQUIRE(a.vertices[a.triangles[t][k]] == b.vertices[b.triangles[t][k]]);
}

}  // namespace

TEST_CASE("STL: triangles come back, each vertex once") {
  const TriangleData box = box_surface({-1, 0, 0.5}, {1, 2, 3.25});
  for (const std::string& file : {as_text(box), as_binary(box)}) {
    const TriangleData data = read(file);
    CHECK(data.vertices.size() == 8);
    check_same(data, box);
    CHECK(read(file, 1e-3).vertices[0] == Vec<double, 3>(1e-3 * data.vertices[0]));
  }
  const TriangleData ball = ball_surface(3);  // text keeps all digits
  CHECK(read(as_text(ball)).vertices.size() == ball.vertices.size());
  check_same(read(as_text(ball)), ball);
  std::ofstream("ball.stl", std::ios::binary) << as_text(ball);
  check_same(read_stl("ball.stl"), ball);
}

TEST_CASE("STL: what programs write") {
  const std::string facet =
      "FACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1e0 -0.0 +0 VERTEX 0 1 0 ENDLOOP ENDFACET\n";
  const TriangleData two = read("SOLID\n" + facet + "ENDSOLID\r\nsolid second one\n" + facet + "endsolid");
  CHECK(two.triangles.size() == 2);
  CHECK(two.vertices.size() == 3);  // -0 is 0
  // A triangle that has become a line is left out.
  const TriangleData line = read("solid\n" + facet +
                                 "facet normal nan nan nan outer loop vertex 0 0 0 vertex 1 0 0 vertex 1 0 0 "
                                 "endloop endfacet endsolid");
  CHECK(line.triangles.size() == 1);
}

TEST_CASE("STL: text is distinguished from binary by its bytes and its length") {
  using Catch::Matchers::Contains;
  const TriangleData box = box_surface({-1, 0, 0.5}, {1, 2, 3.25});
  const std::string text = as_text(box), binary = as_binary(box);
  check_same(read("\xef\xbb\xbf" + text), box);
  check_same(read("\xef\xbb\xbf\r\n" + text), box);
  CHECK_THROWS_WITH(read("\xff\xfe" + text), "file: encoding = UTF-16: a text file must be ASCII or UTF-8");
  check_same(read(as_binary(box, "solid" + std::string(75, 'x'))), box);
  check_same(read(as_binary(box, "")), box);
  CHECK_THROWS_WITH(read("# from a scanner\n" + text), "file, line 1: word = \"#\": must be solid");
  CHECK_THROWS_WITH(read(text.substr(text.find("facet"))), "file, line 1: word = \"facet\": must be solid");
  CHECK_THROWS_WITH(read("solid" + binary), Contains("file, byte 80: number of triangles = "));
}

TEST_CASE("STL: damaged files throw") {
  using Catch::Matchers::Contains;
  const TriangleData box = box_surface({0, 0, 0}, {1, 1, 1});
  const std::string text = as_text(box), binary = as_binary(box);
  for (std::size_t n = 0; n + 22 < text.size(); ++n) REQUIRE_THROWS_AS(read(text.substr(0, n)), error);
  for (std::size_t n = 0; n < binary.size(); ++n) REQUIRE_THROWS_AS(read(binary.substr(0, n)), error);
  CHECK_THROWS_WITH(
      read(binary + "x"),
      "file, byte 80: number of triangles = 12: such a file is 684 bytes long; this one has 685");
  std::string wrong = binary;
  wrong[80] = 13;
  CHECK_THROWS_WITH(read(wrong), Contains("number of triangles = 13: such a file is 734 bytes long"));
  wrong = binary;
  wrong.replace(84 + 12, 4, std::string("\x00\x00\xc0\x7f", 4));  // a NaN
  CHECK_THROWS_WITH(read(wrong), "file, byte 96: vertex = nan: must be finite");
  CHECK_THROWS_WITH(read(as_binary({})), "file: triangles = 0: the file holds none");
  CHECK_THROWS_WITH(read("solid\nendsolid\n"), "file: triangles = 0: the file holds none");
  CHECK_THROWS_WITH(read(""), Contains("head = nothing: the file ends before this number"));
  wrong = text;
  wrong.replace(wrong.find("endloop"), 7, "vertex ");
  CHECK_THROWS_WITH(read(wrong), "file, line 7: word = \"vertex\": must be endloop");
  wrong = text;
  wrong.replace(wrong.find("vertex ") + 7, 1, "inf ");
  CHECK_THROWS_WITH(read(wrong), "file, line 4: vertex = inf: must be finite");
  wrong = text;
  wrong.replace(wrong.find("vertex ") + 7, 1, "1,5 ");
  CHECK_THROWS_WITH(read(wrong), "file, line 4: vertex = \"1,5\": must be a number");
  CHECK_THROWS_WITH(read(text, -1), "read_stl: scale = -1: must be positive");
  CHECK_THROWS_WITH(read_stl("no such file.stl"), Contains("mesh = no such file.stl: no such file"));
}
