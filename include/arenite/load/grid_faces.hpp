// Loaded faces of a grid: the points behind a face share its area.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/failure.hpp>
#include <arenite/core/lists.hpp>
#include <arenite/load/mesh_faces.hpp>
#include <arenite/load/node_force.hpp>
#include <arenite/load/surface_load.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The load on a face is integrated where the points of the cell behind it stand, moved onto the face, each
/// for a share of the area in proportion to its volume. The sums of the shape functions along the face are
/// then those by which the stresses of the same points act, and a uniform stress is in balance; with the
/// exact integrals in their place the points in the corners of a body of 2 x 2 points a cell are off by 6 %.
template <class T, int D>
class GridFaces {
 public:
  template <class Scene>
  GridFaces(const Scene& scene, const MeshFaces& where) {
    const auto is_meant = face_test(scene, where);
    std::vector<Index> cell;
    for_each_hull_face(scene, [&](const HullFace<T, D>& face) {
      if (!is_meant(face)) return;
      Face kept{face.axis, face.corner[0][face.axis],
                (face.upper ? T(1) : T(-1)) * Vec<T, D>(Vec<T, D>::Unit(face.axis))};
      Vec<T, D> centre = Vec<T, D>::Zero();
      for (const auto& x : face.corner) centre += x / static_cast<T>(face.corner.size());
      kept.area *= scene.mesh.volume(face.cell) / scene.mesh.edge() * Scene::Kinematics::thickness(centre);
      faces_.push_back(kept);
      cell.push_back(face.cell);
    });
    of_cell_.build(scene.mesh.cell_count(), [&](auto&& add) {
      for (std::size_t k = 0; k < cell.size(); ++k) add(cell[k], static_cast<Index>(k));
    });
  }
  std::size_t size() const { return faces_.size(); }

  /// Forces of a load into those of each field. Faces without matter behind them take none.
  template <class Scene, class Others>
  void collect(const Scene& scene, const SurfaceLoad& load, std::string_view name,
               std::vector<NodeForce<T, D>>& nodes, Others&) {
    for (auto& n : nodes) n.clear(n.force.size());
    Failure failure;
    scene.blocks.for_each_colored([&](Index c) {
      if (of_cell_[c].empty()) return;
      T matter = 0;
      scene.for_each_body([&](const auto& body, const auto&) {
        for (const Index p : body.cells[c]) matter += body.points.volume[p];
      });
      if (!(matter > 0)) return;
      const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, c);
      std::size_t number = 0;
      scene.for_each_body([&](const auto& body, const auto&) {
        auto& force = nodes[Scene::field_of(number++)].force;
        for (const Index k : of_cell_[c])
          for (const Index p : body.cells[c]) {
            Vec<T, D> x = body.points.position[p];
            x[faces_[k].axis] = faces_[k].place;
            const Vec<T, D> area = body.points.volume[p] / matter * faces_[k].area;
            failure.guard(c, [&] {
              const Vec<T, D> f = load.force(x, area, scene.time, name);
              const auto w = cell.weights(x);
              for (std::size_t i = 0; i < cell.nodes.size(); ++i)
                force[cell.nodes[i]] += w[static_cast<int>(i)] * f;
            });
          }
      });
    });
    failure.rethrow();
  }

 private:
  struct Face {
    int axis;
    T place;         // on the axis, m
    Vec<T, D> area;  // outward, thickness included, m2
  };
  std::vector<Face> faces_;
  Lists of_cell_;  // [cells] numbers of faces
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
