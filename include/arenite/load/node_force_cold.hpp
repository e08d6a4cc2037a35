// Cold functions of node_force.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <functional>

#include <arenite/load/node_force.hpp>
#include <arenite/parallel/failure.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T, int D>
ARENITE_COLD void NodeForce<T, D>::clear(std::size_t nodes) {
  if (force.size() != nodes) force.assign(nodes, zeros<Vec<T, D>>());
  parallel_chunks(nodes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) force[i] = zeros<Vec<T, D>>();
  });
}

template <class T, int D>
ARENITE_COLD void NodeForce<T, D>::set(std::span<const NodeSums<T, D>> sums, const NodePlaces<T, D>& places,
                                       const ForceAt& force_at) {
  Failure failure;
  parallel_chunks(sums.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      force[i] = zeros<Vec<T, D>>();
      if (sums[i].mass() > 0) failure.guard(i, [&] { force[i] = force_at(places[i], sums[i]); });
    }
  });
  failure.rethrow();
}

template <class T, int D>
ARENITE_COLD void NodeForce<T, D>::add_to(std::span<NodeSums<T, D>> sums) const {
  parallel_chunks(force.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (acts_at(i)) sums[i].add_force(force[i]);
  });
}

template <class T, int D>
ARENITE_COLD double NodeForce<T, D>::work(double dt, const NodeMotion<T, D>& motion) const {
  const auto& end_velocity = *motion.end;
  return parallel_reduce(
      force.size(), 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
          if (!acts_at(i) || (!motion.owner.empty() && motion.owner[i] != motion.portion)) continue;
          const Vec<T, D> mean = motion.start == nullptr
                                     ? end_velocity[i]
                                     : Vec<T, D>(((*motion.start)[i] + end_velocity[i]) / 2);
          sum += static_cast<double>(force[i].dot(mean)) * dt;
        }
        return sum;
      },
      std::plus<>{});
}

template <class T, int D>
ARENITE_COLD Vec<T, D> NodeForce<T, D>::total() const {
  Vec<T, D> sum = zeros<Vec<T, D>>();
  for (const auto& f : force) sum += f;
  return sum;
}

#define ARENITE_INSTANCES(T, D) template class NodeForce<T, D>;
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
