// Law host: a law of any type as a `HostedLaw`, in packs.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <arenite/law/drive.hpp>
#include <arenite/law/pass.hpp>
#include <arenite/parallel/parallel.hpp>
#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite_host/hosted_law.hpp>
#include <arenite_host/readers.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class Law>
class LawHost : public HostedLaw {
  using History = typename Law::template History<double>;
  static constexpr std::size_t history_count = history_size<History>;
  static constexpr int register_width = static_cast<int>(native_register_bytes / sizeof(double));

 public:
  explicit LawHost(Law law) : law_{std::move(law)} {}

  double density() const override { return law_.density(); }
  double wave_modulus() const override { return law_.wave_modulus(); }
  std::vector<std::string> history_names() const override {
    std::vector<std::string> all;
    for (const auto& name : arenite::history_names<History>) all.emplace_back(name);
    return all;
  }
  std::vector<double> history_start() const override {
    std::vector<double> all;
    const History start{};
    std::apply([&](const auto&... member) { (all.push_back(member), ...); }, start.members());
    return all;
  }

  void update(const HostedUpdate& u) const override {
    const auto each = [&](std::size_t begin, std::size_t end) {
      u.dimension == 2 ? update_range<2>(u, begin, end) : update_range<3>(u, begin, end);
    };
    parallel_chunks(u.n, each);
  }

  void elastic_energy(int dimension, std::size_t n, const double* stress, const double* history,
                      double* energy) const override {
    parallel_chunks(n, [&](std::size_t begin, std::size_t end) {
      dimension == 2 ? energy_range<2>(stress, history, energy, begin, end)
                     : energy_range<3>(stress, history, energy, begin, end);
    });
  }

  HostedPath drive(int dimension, const Value& stages, const std::vector<double>& stress,
                   const std::vector<double>& history) const override {
    return dimension == 2 ? drive_in<2>(stages, stress, history) : drive_in<3>(stages, stress, history);
  }

 private:
  template <int D>
  ARENITE_KERNEL void update_range(const HostedUpdate& u, std::size_t begin, std::size_t end) const {
    using P = typename LawLanes<Law, double, register_width>::type;
    constexpr std::size_t width = static_cast<std::size_t>(lane_count<P>), size = Sym<double, D>::size,
                          spins = D == 2 ? 1 : 3;
    std::array<double, width> lanes{};
    for (std::size_t p = begin; p < end; p += width) {
      const std::size_t count = std::min(width, end - p);
      // Unused lanes repeat the first state.
      const auto load = [&](const double* from, std::size_t columns, std::size_t k) {
        for (std::size_t i = 0; i < width; ++i) lanes[i] = from[(p + (i < count ? i : 0)) * columns + k];
        return load_lanes<P>(lanes.data(), static_cast<int>(width));
      };
      const auto store = [&](const P& value, double* to, std::size_t columns, std::size_t k) {
        store_lanes(lanes.data(), static_cast<int>(width), value);
        for (std::size_t i = 0; i < count; ++i) to[(p + i) * columns + k] = lanes[i];
      };
      StrainStep<P, D> step;
      step.dt = u.dt;
      Sym<P, D> stress;
      typename Law::template History<P> history{};
      for (std::size_t k = 0; k < size; ++k) {
        stress[k] = load(u.stress, size, k);
        step.strain[k] = load(u.strain, size, k);
      }
      for (std::size_t k = 0; k < spins; ++k) step.spin[k] = u.spin ? load(u.spin, spins, k) : P(0);
      each_member(history, [&](P& member, std::size_t k) { member = load(u.history, history_count, k); });
      const auto [opening, dilation] = inelastic(law_.update(stress, step, history));
      for (std::size_t k = 0; k < size; ++k) store(stress[k], u.stress, size, k);
      each_member(history, [&](P& member, std::size_t k) { store(member, u.history, history_count, k); });
      store(P(opening), u.opening, 1, 0);
      store(P(dilation), u.dilation, 1, 0);
    }
  }

  template <int D>
  void energy_range(const double* stress, const double* history, double* energy, std::size_t begin,
                    std::size_t end) const {
    constexpr std::size_t size = Sym<double, D>::size;
    for (std::size_t p = begin; p < end; ++p) {
      Sym<double, D> s;
      for (std::size_t k = 0; k < size; ++k) s[k] = stress[p * size + k];
      History h{};
      each_member(h, [&](double& member, std::size_t k) { member = history[p * history_count + k]; });
      if constexpr (requires { law_.elastic_energy(s, h); })
        energy[p] = law_.elastic_energy(s, h);
      else
        energy[p] = law_.elastic_energy(s);
    }
  }

  template <int D>
  HostedPath drive_in(const Value& stages, const std::vector<double>& stress,
                      const std::vector<double>& history) const {
    constexpr std::size_t size = Sym<double, D>::size;
    DrivenPoint<Law, D> point;
    require(stress.size() == size, "drive: stress", stress.size(), {"must be ", size, " numbers"});
    std::ranges::copy(stress, &point.stress[0]);
    require(history.size() == history_count, "drive: history", history.size(),
            {"must be ", history_count, " numbers"});
    each_member(point.history, [&](double& member, std::size_t k) { member = history[k]; });
    HostedPath path;
    for (const auto& at : arenite::drive(
             law_,
             arenite::read<std::vector<DriveStage<D>>>(stages, ReadContext{.name = "stages", .dimension = D}),
             point)) {
      ++path.rows;
      path.time.push_back(at.time);
      for (std::size_t k = 0; k < size; ++k) {
        path.stress.push_back(at.stress[k]);
        path.strain.push_back(at.strain[k]);
      }
      std::apply([&](const auto&... member) { (path.history.push_back(member), ...); }, at.history.members());
      path.opening.push_back(at.opening);
      path.dilation.push_back(at.dilation);
      path.work.push_back(at.work);
    }
    return path;
  }

  template <class H, class F>
  static void each_member(H& history, F&& f) {
    std::apply(
        [&](auto&... member) {
          [[maybe_unused]] std::size_t k = 0;
          (f(member, k++), ...);
        },
        history.members());
  }

  Law law_;
};

/// Makes a law of a host's values.
template <class Law>
std::unique_ptr<HostedLaw> make_hosted_law(const Value& values) {
  return std::make_unique<LawHost<Law>>(read<Law>(values, ReadContext{.name = "law"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
