// Random scenes of one body, on a mesh of any kind, with any parts beside it.
#pragma once

#include <tuple>

#include "runner.hpp"

namespace arenite::extremes {

/// `parts(mesh)`: a tuple of what the scene has beside body, gravity and energy balance.
template <class K, class M, class L, class N, class Parts>
Outcome one_body_with(Draw& d, const Parts& parts) {
  return judge(d, [&] {
    const auto mesh = mesh_of<M>(d);
    const Blob region = blob<M::dimension>(d, extent(mesh), 0, 1, K::hoop);
    return std::apply(
        [&](const auto&... part) {
          Scene scene{K{},
                      mesh,
                      numerics_of<N>(d),
                      bodies(fill(region, law<L>(d), fill_options(d, mesh))),
                      gravity_of(d),
                      part...,
                      TrackEnergy{}};
          set_in_motion(scene, d);
          return scene;
        },
        parts(mesh));
  });
}

template <class K, class M, class L, class N>
Outcome one_body(Draw& d) {
  return one_body_with<K, M, L, N>(d, [&](const M&) { return std::tuple(walls_of<M::dimension>(d)); });
}

}  // namespace arenite::extremes
