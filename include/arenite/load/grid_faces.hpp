// Loaded faces of a grid: the points of the cell of a face share its area.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/lists.hpp>
#include <arenite/load/mesh_faces.hpp>
#include <arenite/load/node_force.hpp>
#include <arenite/load/surface_load.hpp>
#include <arenite/parallel/failure.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The load on a face is integrated at the points of the cell of the face, moved onto the face, each
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
      faces_.push_back({face.axis, face.upper});
      cell.push_back(face.cell);
    });
    of_cell_.build(scene.mesh.cell_count(), [&](auto&& add) {
      for (std::size_t k = 0; k < cell.size(); ++k) add(cell[k], static_cast<Index>(k));
    });
  }
  std::size_t size() const { return faces_.size(); }

  /// Computes the forces of a load on each field. Faces of cells without matter receive none.
  template <class Scene>
  void collect(const Scene& scene, const SurfaceLoad& load, std::string_view name,
               std::vector<NodeForce<T, D>>& nodes) {
    for (auto& n : nodes) n.clear(n.force.size());
    Failure failure;
    scene.blocks.for_each_colored([&](Index c) {
      if (of_cell_[c].empty()) return;
      const T matter = matter_in(scene, c);
      if (!(matter > 0)) return;
      const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, c);
      std::size_t number = 0;
      scene.for_each_body([&](const auto& body, const auto&) {
        auto& force = nodes[Scene::field_of(number++)].force;
        for (const Index k : of_cell_[c]) {
          const int axis = faces_[k].axis;
          const auto [place, outward] = placed(scene, c, faces_[k]);
          for (const Index p : body.cells[c]) {
            Vec<T, D> x = body.points.position[p];
            x[axis] = place;
            const Vec<T, D> area = body.points.volume[p] / matter * outward;
            failure.guard(c, [&] {
              const Vec<T, D> f = load.force(x, area, scene.time, name);
              const auto w = cell.weights(x);
              for (std::size_t i = 0; i < cell.nodes.size(); ++i)
                force[cell.nodes[i]] += w[static_cast<int>(i)] * f;
            });
          }
        }
      });
    });
    failure.rethrow();
  }

  /// Sums of the magnitudes of a load on all faces, and on those of cells with matter, N.
  template <class Scene>
  std::pair<double, double> magnitudes(const Scene& scene, const SurfaceLoad& load,
                                       std::string_view name) const {
    std::pair<double, double> sum{};
    for (Index c = 0; c < scene.mesh.cell_count(); ++c)
      for (const Index k : of_cell_[c]) {
        Vec<T, D> x = scene.mesh.corner(c) + scene.mesh.extent(c) / 2;
        const auto [place, outward] = placed(scene, c, faces_[k]);
        x[faces_[k].axis] = place;
        double size = 0;
        try {
          size = static_cast<double>(load.force(x, outward, scene.time, name).norm());
        } catch (const std::exception&) {  // where no matter is, it need not have a value
        }
        sum.first += size;
        if (matter_in(scene, c) > 0) sum.second += size;
      }
    return sum;
  }

 private:
  struct Face {
    int axis;
    bool upper;
  };
  /// Where a face is on its axis, m, and its area vector, out of the mesh.
  template <class Scene>
  static std::pair<T, Vec<T, D>> placed(const Scene& scene, Index c, const Face& face) {
    const auto [place, size] = grid_face<typename Scene::Kinematics>(scene.mesh, c, face.axis, face.upper);
    return {place, (face.upper ? size : -size) * Vec<T, D>(Vec<T, D>::Unit(face.axis))};
  }
  std::vector<Face> faces_;
  Lists of_cell_;  // [cells] numbers of faces
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
