// Traction on faces of the mesh.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <arenite/load/grid_faces.hpp>
#include <arenite/load/simplex_faces.hpp>
#include <arenite/warnings/lost_load.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A traction, Pa, on faces of the mesh: `traction(top(), {0, -100_kPa})`. It acts on the matter in the cells
/// of the faces, and stays where the mesh is. Exact if matter fills those cells up to the faces, as it
/// does where the mesh moves with it. Where it has moved by a share s of a cell of a resting grid, stresses
/// are off by up to 3 s in the last cell and by s in the next; where no matter is left in a cell the load is
/// lost, which the first step warns of. For a surface that lies or goes elsewhere: `traction(surface(..),
/// ..)`.
struct FaceTraction {
  MeshFaces where;
  SurfaceLoad load;
};

inline FaceTraction traction(MeshFaces where, VectorFunction t) {
  return {std::move(where), SurfaceLoad(std::move(t))};
}
/// A vector, Pa, times a function of time (or of place and time): `traction(top(), {0, -100_kPa}, Ramp{..})`.
inline FaceTraction traction(MeshFaces where, const Triple& t, const ScalarFunction& factor) {
  return {std::move(where), SurfaceLoad(VectorFunction(t, factor))};
}
/// A pressure, Pa, against the outward normal: a number, or a function of time, or of place and time.
inline FaceTraction pressure(MeshFaces where, ScalarFunction p) {
  return {std::move(where), SurfaceLoad(std::move(p))};
}

/// A traction in a mesh: a part that adds the forces of the start of the step. `Faces`: `SimplexFaces` or
/// `GridFaces`.
template <class T, int D, class Faces>
class BoundFaceTraction : public BookedForces<T, D> {
 public:
  explicit BoundFaceTraction(FaceTraction t)
      : load_{std::move(t.load)},
        where_{std::move(t.where)},
        name_{joined_text({load_.name(), " on ", where_.name()})} {}

  template <class Scene>
  void connect(Scene& scene) {
    faces_.emplace(scene, where_);
    require(faces_->size() > 0 || Scene::is_portion, name_ + ": faces", faces_->size(),
            "must be at least one face of the mesh's hull");
    BookedForces<T, D>::connect(scene);
  }
  template <class Scene>
  void add_force(Scene& scene, double) {
    faces_->collect(scene, load_, name_, this->forces_);
    if (lost_.is_due())
      lost_.look(
          faces_->magnitudes(scene, load_, name_), name_,
          joined_text({" % of it acts on matter; the rest is lost on faces without any behind them; end the "
                       "mesh where the body ends, or load its points, ",
                       load_.name(), "(surface(..), ..)"}),
          scene.communicator());
    this->add_to(scene);
  }

 private:
  SurfaceLoad load_;
  MeshFaces where_;
  std::string name_;
  std::optional<Faces> faces_;  // from `connect` on
  LostLoad lost_{0.98};
};

template <class Traits>
auto bind_part(const FaceTraction& traction, const Traits&) {
  using T = typename Traits::T;
  using Faces = std::conditional_t<is_simplex_mesh<typename Traits::Mesh>, SimplexFaces<T, Traits::D>,
                                   GridFaces<T, Traits::D>>;
  return BoundFaceTraction<T, Traits::D, Faces>(traction);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
