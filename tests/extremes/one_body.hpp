// Random scenes of one body, on a mesh of any kind.
#pragma once

#include "runner.hpp"

namespace arenite::extremes {

template <class K, class M, class L, class N>
Outcome one_body(Draw& d) {
  return judge(d, [&] {
    const auto mesh = mesh_of<M>(d);
    const Blob region = blob<M::dimension>(d, extent(mesh), 0, 1, K::hoop);
    Scene scene{K{},
                mesh,
                numerics_of<N>(d),
                bodies(fill(region, law<L>(d), fill_options(d, mesh))),
                walls_of<M::dimension>(d),
                gravity_of(d),
                TrackEnergy{}};
    set_in_motion(scene, d);
    return scene;
  });
}

}  // namespace arenite::extremes
