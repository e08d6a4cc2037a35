// Manufactured solutions: errors and orders of convergence beside theory, which is 2 for B-splines, and for
// linear functions as long as no point crosses a cell.
#include "manufactured.hpp"

#include "meshes.hpp"
#include "validation.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// Errors on `cells`, 2 and 4 times as many cells along a side, over the greatest displacement; written down.
struct Study {
  Validation& file;
  Motion motion;
  double greatest;  ///< displacement, m
  int cells;
  double courant;

  /// Orders of the two refinements.
  template <class N>
  std::array<double, 2> orders(const char* name, const N& numerics, int refinements = 2) {
    std::array<double, 3> error{};
    std::array<double, 2> order{};
    for (int k = 0; k <= refinements; ++k) {
      const int n = cells << k;
      const auto place = static_cast<std::size_t>(k);
      if constexpr (N::Shape::constant_gradient) {
        const SimplexMesh<2> mesh(
            triangles(motion.lower, motion.upper, static_cast<Index>(n), static_cast<Index>(n)));
        error[place] = error_of(motion, mesh, 3, numerics, courant) / greatest;
      } else {
        const double edge = (motion.upper[0] - motion.lower[0]) / n;
        const CartesianGrid<2> grid({.lower = {motion.lower[0], motion.lower[1]},
                                     .upper = {motion.upper[0], motion.upper[1]},
                                     .cell = edge});
        error[place] = error_of(motion, grid, 4, numerics, courant) / greatest;
      }
      file.value(name, joined_text({"error over the greatest displacement on ", n, " cells a side"}), "-",
                 error[place], 0);
      if (k > 0) {
        order[place - 1] = std::log2(error[place - 1] / error[place]);
        file.value(name, joined_text({"order from ", n / 2, " to ", n, " cells"}), "-", order[place - 1], 2);
      }
    }
    return order;
  }
};

const Numerics<QuadraticBSpline, Flip, Usl> flip_usl{};
const Numerics<QuadraticBSpline, Apic, Musl> apic_musl{};
const Numerics<QuadraticBSpline, Fmpm, Usl> fmpm_usl{.transfer = {.order = 4}};
const Numerics<LinearSimplex, Flip, Musl> triangles_musl{};

}  // namespace

TEST_CASE("Axis-aligned displacements: the error falls with the square of the cell size") {
  const double amplitude = 0.002;
  Validation file("axis_aligned");
  Study study{file, axis_aligned(amplitude), amplitude, 8, 0.1};
  const auto flip = study.orders("quadratic B-splines; FLIP; USL", flip_usl);
  CHECK(flip[0] > 1.9);
  CHECK(flip[1] > 1.9);
  const auto apic = study.orders("quadratic B-splines; APIC; MUSL", apic_musl);
  CHECK(apic[0] > 1.9);
  CHECK(apic[1] > 1.9);
  const auto fmpm = study.orders("quadratic B-splines; FMPM(4); USL", fmpm_usl);
  CHECK(fmpm[0] > 1.6);
  CHECK(fmpm[1] > 1.6);
  const auto simplex = study.orders("triangles; FLIP; MUSL", triangles_musl);
  CHECK(simplex[0] > 1.9);
}

TEST_CASE("Generalised vortex: with APIC and FMPM the error falls with the square of the cell size") {
  const double turn = 0.25;
  Validation file("vortex");
  Study study{file, vortex(turn), turn, 26, 0.25};
  CHECK(study.orders("quadratic B-splines; APIC; MUSL", apic_musl, 1)[0] > 1.9);
  CHECK(study.orders("quadratic B-splines; FMPM(4); USL", fmpm_usl, 1)[0] > 1.9);
  study.orders("quadratic B-splines; FLIP; USL", flip_usl, 1);
}
