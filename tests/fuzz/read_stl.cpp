// Fuzz target: any bytes as an STL file. The reader throws `error` or returns triangles of its vertices, no
// two of which are the same; a `TriangleSurface` of them may be refused, and gives distances otherwise.
#include <arenite/geometry/triangle_surface.hpp>
#include <arenite/io/stl.hpp>
#include <cmath>

#include "must.hpp"

using namespace arenite;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string_view file(reinterpret_cast<const char*>(bytes), size);
    const TriangleData data = shared_detail::read_stl_bytes(file, "bytes", 1);
    for (const auto& t : data.triangles) {
      for (const Index i : t) must(i < data.vertices.size());
      must(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    }
    for (const auto& x : data.vertices) must(x.allFinite());
    const TriangleSurface surface(data);
    must(!std::isnan(surface(Vec<double, 3>(0.3, 0.2, 0.1))));
    must(std::abs(surface(data.vertices[data.triangles[0][0]])) == 0);
  } catch (const error& e) {
    must(std::string_view(e.what()).find(": ") != std::string_view::npos);
  }
  return 0;
}
