// Gaussian elimination against Eigen's decompositions and a matrix whose inverse is known.
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <arenite/core/linear_solve.hpp>
#include <limits>
#include <random>
#include <vector>

#include "catch.hpp"

namespace {

using namespace arenite;

std::mt19937 generator{7};

template <int N>
Mat<double, N> random_matrix() {
  std::normal_distribution<double> normal;
  Mat<double, N> a;
  for (int k = 0; k < N * N; ++k) a.data()[k] = normal(generator);
  return a;
}

template <int N>
void check_random_systems() {
  for (int k = 0; k < 200; ++k) {
    Mat<double, N> a = random_matrix<N>();
    const Vec<double, N> units =
        Vec<double, N>(random_matrix<N>().col(0)).array().exp();  // rows of other units
    a = units.asDiagonal() * a;
    const Vec<double, N> b = random_matrix<N>().col(0);
    const Vec<double, N> x = solve_linear<N>(a, b), of_eigen = a.fullPivLu().solve(b);
    const double size = of_eigen.norm() * a.fullPivLu().inverse().norm() * a.norm();
    CHECK((x - of_eigen).norm() <= 1e-14 * size);
    CHECK((inverse_of<N>(a) - a.inverse()).norm() <= 1e-14 * a.norm() * a.inverse().squaredNorm());
  }
}

}  // namespace

TEST_CASE("systems of random numbers are solved as Eigen solves them") {
  check_random_systems<1>();
  check_random_systems<2>();
  check_random_systems<3>();
  check_random_systems<6>();
}

TEST_CASE("Hilbert's matrix of order 6 has the known inverse") {
  // Entry (i, j) of the inverse is a whole number: Choi, Am. Math. Monthly 90 (1983), 301-312.
  Mat<double, 6> hilbert;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) hilbert(i, j) = 1.0 / (i + j + 1);
  const Mat<double, 6> inverse = inverse_of<6>(hilbert);
  CHECK(inverse(0, 0) == Approx(36).epsilon(1e-8));
  CHECK(inverse(5, 5) == Approx(698544).epsilon(1e-8));
  CHECK(inverse(2, 3) == Approx(-1411200).epsilon(1e-8));
}

TEST_CASE("rows are exchanged where a pivot is zero") {
  Mat<double, 2> a;
  a << 0, 2, 4, 0;
  const Vec<double, 2> x = solve_linear<2>(a, Vec<double, 2>(6, 8));
  CHECK(x[0] == 2);
  CHECK(x[1] == 3);
}

TEST_CASE("a singular matrix leaves nothing finite to be taken for a solution") {
  CHECK_FALSE(solve_linear<3>(Mat<double, 3>::Zero(), Vec<double, 3>::Ones()).allFinite());
  Mat<double, 2> twice;
  twice << 1, 2, 2, 4;
  CHECK_FALSE(inverse_of<2>(twice).allFinite());
}

TEST_CASE("a system whose size is known at run time is solved") {
  constexpr std::size_t n = 40;
  std::normal_distribution<double> normal;
  std::vector<double> a(n * n), b(n);
  for (double& value : a) value = normal(generator);
  for (double& value : b) value = normal(generator);
  const Eigen::MatrixXd matrix = Eigen::Map<Eigen::MatrixXd>(a.data(), n, n);
  const Eigen::VectorXd right = Eigen::Map<Eigen::VectorXd>(b.data(), n),
                        of_eigen = matrix.fullPivLu().solve(right);
  solve_in_place(a.data(), b.data(), n, 1);
  CHECK((Eigen::Map<Eigen::VectorXd>(b.data(), n) - of_eigen).norm() < 1e-11 * of_eigen.norm());
}

TEST_CASE("positive definite is what Cholesky's decomposition finds") {
  int found = 0;
  for (int k = 0; k < 500; ++k) {
    Mat<double, 6> a = random_matrix<6>();
    a = a * a.transpose() - 0.2 * (k % 10) * Mat<double, 6>::Identity();
    const bool positive = a.llt().info() == Eigen::Success;
    found += positive;
    CHECK(is_positive_definite<6>(a) == positive);
  }
  CHECK(found > 50);
  CHECK(found < 450);
  CHECK_FALSE(is_positive_definite<2>(Mat<double, 2>::Zero()));
  CHECK_FALSE(is_positive_definite<2>(Mat<double, 2>::Constant(std::numeric_limits<double>::quiet_NaN())));
}
