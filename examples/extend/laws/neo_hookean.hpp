// A law whose stiffness depends on the state: a neo-Hookean solid, which integrates its deformation gradient.
#include <Eigen/LU>
#include <arenite/arenite.hpp>

class NeoHookean {
 public:
  static constexpr int max_pack_width = 1;  // Eigen's matrices below take scalars, not packs
  template <class T>
  using Matrix = Eigen::Matrix<T, 3, 3>;
  template <class T>
  struct History {
    std::array<T, 9> f{1, 0, 0, 0, 1, 0, 0, 0, 1};  // deformation gradient F
    auto members() { return arenite::tied(f); }
    auto members() const { return arenite::tied(f); }
  };
  struct Parameters {                            // what Python gives by name
    double density = 0, young = 0, poisson = 0;  // kg/m3, Pa, -
  };
  explicit NeoHookean(const arenite::Elasticity& e) : e_{e} {}
  explicit NeoHookean(const Parameters& p) : e_{"NeoHookean", p.density, p.young, p.poisson} {}
  double density() const { return e_.density(); }
  double wave_modulus() const { return e_.wave_modulus(); }
  template <class T, int D>  // of a wave along the greatest stretch
  T wave_modulus(const arenite::Sym<T, D>&, const History<T>& history) const {
    const Matrix<T> f(history.f.data());
    const T stretch2 = arenite::Principal<T, D>(left_cauchy_green<D>(f)).value[0];
    return T(e_.shear()) * (1 + stretch2) + T(e_.lame()) * (1 - std::log(f.determinant()));
  }

  // F <- (I - A)^-1 (I + A) F with A = L dt / 2: a rotation where there is but spin, exact in simple shear.
  template <class T, int D>
  T update(arenite::Sym<T, D>& stress, const arenite::StrainStep<T, D>& step, History<T>& history) const {
    Matrix<T> a, one = Matrix<T>::Identity();
    for (int k = 0; k < 9; ++k) a(k / 3, k % 3) = step.gradient(k / 3, k % 3) / 2;
    const Matrix<T> f = (one - a).inverse() * (one + a) * Matrix<T>(history.f.data());
    std::copy_n(f.data(), 9, history.f.data());
    const T j = f.determinant(), shear = T(e_.shear()) / j;
    stress = add_isotropic(left_cauchy_green<D>(f) * shear, T(e_.lame()) * std::log(j) / j - shear);
    return T(0);
  }
  template <class T, int D>
  T elastic_energy(const arenite::Sym<T, D>&, const History<T>& history) const {
    const Matrix<T> f(history.f.data());
    const T j = f.determinant(), log = std::log(j);
    return (T(e_.shear() / 2) * (f.squaredNorm() - 3 - 2 * log) + T(e_.lame() / 2) * log * log) / j;
  }

 private:
  template <int D, class T>
  static arenite::Sym<T, D> left_cauchy_green(const Eigen::Matrix<T, 3, 3>& f) {
    return arenite::Sym<T, D>::each([&](int k) { return f.row(k % 3).dot(f.row(k < 3 ? k : (k + 1) % 3)); });
  }
  arenite::Elasticity e_;
};
