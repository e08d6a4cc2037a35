// Impedance of faces: dashpots of the matter at faces of the mesh, summed at the nodes of the faces.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include <arenite/core/lists.hpp>
#include <arenite/load/mesh_faces.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Density times the speeds of pressure and shear waves, Pa s/m.
struct WaveImpedance {
  double pressure = 0, shear = 0;
};

/// At a node the dashpots are C = integral N_i (z_p n n^T + z_s (I - n n^T)) dA, N s/m. On a grid it is
/// sampled at the points of the cell of a face, moved onto the face, each for a share of the area in
/// proportion to its volume, as loads on faces are (`GridFaces`); on simplices with the exact integrals of
/// N_i. Faces of cells without matter have none.
template <class T, int D>
class FaceImpedance {
 public:
  using Matrix = Mat<T, D>;

  template <class Scene>
  FaceImpedance(const Scene& scene, const MeshFaces& where, std::vector<WaveImpedance> of_body)
      : of_body_{std::move(of_body)}, fields_{scene.fields.size()} {
    const auto is_meant = face_test(scene, where);
    std::vector<Index> cell;
    std::vector<bool> touched(scene.fields[0].size(), Scene::is_portion);
    for_each_hull_face(scene, [&](const HullFace<T, D>& face) {
      if (!is_meant(face)) return;
      for_each_face_node(scene, face, [&](Index i) { touched[i] = true; });
      faces_.push_back({face.axis, face.upper, face.node});
      cell.push_back(face.cell);
    });
    of_cell_.build(scene.mesh.cell_count(), [&](auto&& add) {
      for (std::size_t k = 0; k < cell.size(); ++k) add(cell[k], static_cast<Index>(k));
    });
    place_.assign(touched.size(), none);
    for (Index i = 0; i < touched.size(); ++i) {
      if (!touched[i]) continue;
      place_[i] = static_cast<Index>(nodes_.size());
      nodes_.push_back(i);
    }
    dashpots_.assign(nodes_.size() * fields_, Matrix::Zero());
  }

  std::size_t faces() const { return faces_.size(); }
  /// Nodes with a function on one of the faces, ascending; in a scene over a portion of a mesh all.
  const std::vector<Index>& nodes() const { return nodes_; }
  /// C of a field at node number k of those, N s/m.
  const Matrix& at(std::size_t k, std::size_t field) const { return dashpots_[k * fields_ + field]; }

  /// Renews C from where mesh and points are now.
  template <class Scene>
  void collect(const Scene& scene) {
    std::ranges::fill(dashpots_, Matrix(Matrix::Zero()));
    scene.blocks.for_each_colored([&](Index c) {
      if (of_cell_[c].empty()) return;
      const T matter = matter_in(scene, c);
      if (!(matter > 0)) return;
      std::size_t number = 0;
      scene.for_each_body([&](const auto& body, const auto&) {
        const auto& z = of_body_[number];
        for (const Index k : of_cell_[c]) add(scene, body, c, faces_[k], z, Scene::field_of(number), matter);
        ++number;
      });
    });
    if constexpr (Scene::is_portion)
      scene.communicator().sum_nodes(std::span<T>(dashpots_[0].data(), dashpots_.size() * D * D),
                                     fields_ * D * D);
  }

  /// Areas of all faces, and of those of cells with matter, m2.
  template <class Scene>
  std::pair<double, double> areas(const Scene& scene) const {
    std::pair<double, double> sum{};
    for (Index c = 0; c < scene.mesh.cell_count(); ++c)
      for (const Index k : of_cell_[c]) {
        const auto area = static_cast<double>(area_of(scene, c, faces_[k]));
        sum.first += area;
        if (matter_in(scene, c) > 0) sum.second += area;
      }
    return sum;
  }

 private:
  struct Face {
    int axis;  // of a grid's: normal to it
    bool upper;
    std::array<Index, static_cast<std::size_t>(D)> node;  // of a simplex's
  };

  template <class Scene>
  static T area_of(const Scene& scene, [[maybe_unused]] Index c, const Face& face) {
    if constexpr (is_simplex_mesh<typename Scene::Mesh>) {
      std::array<Vec<T, D>, static_cast<std::size_t>(D)> x;
      T thickness = 0;
      for (std::size_t i = 0; i < D; ++i) {
        x[i] = scene.mesh.position(face.node[i]);
        thickness += Scene::Kinematics::thickness(x[i]) / T(D);
      }
      return thickness * face_area(x).norm();
    } else {
      return grid_face<typename Scene::Kinematics>(scene.mesh, c, face.axis, face.upper).second;
    }
  }

  static Matrix along(const Vec<T, D>& normal, const WaveImpedance& z) {
    const auto p = static_cast<T>(z.pressure), s = static_cast<T>(z.shear);
    return s * Matrix::Identity() + (p - s) * (normal * normal.transpose());
  }

  /// Adds the dashpots of a face for one body, by its share of the `matter` in the cell.
  template <class Scene, class Body>
  void add(const Scene& scene, const Body& body, Index c, const Face& face, const WaveImpedance& z,
           std::size_t field, T matter) {
    if constexpr (is_simplex_mesh<typename Scene::Mesh>) {
      std::array<Vec<T, D>, static_cast<std::size_t>(D)> x;
      std::array<T, static_cast<std::size_t>(D)> thickness;
      T sum = 0;
      for (std::size_t i = 0; i < D; ++i) {
        x[i] = scene.mesh.position(face.node[i]);
        sum += thickness[i] = Scene::Kinematics::thickness(x[i]);
      }
      const Vec<T, D> area = face_area(x);
      const T size = area.norm() * volume_of<T>(body, c) / matter / static_cast<T>(D * (D + 1));
      const Matrix unit = along(area.normalized(), z);
      // The integral of N_i times a thickness that is linear over the face.
      for (std::size_t i = 0; i < D; ++i) to(face.node[i], field) += size * (sum + thickness[i]) * unit;
    } else {
      const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, c);
      const auto [place, area] = grid_face<typename Scene::Kinematics>(scene.mesh, c, face.axis, face.upper);
      const Matrix unit = area / matter * along(Vec<T, D>::Unit(face.axis), z);
      for (const Index p : body.cells[c]) {
        Vec<T, D> x = body.points.position[p];
        x[face.axis] = place;
        const auto w = cell.weights(x);
        for (std::size_t i = 0; i < cell.nodes.size(); ++i)
          if (place_[cell.nodes[i]] != none)
            to(cell.nodes[i], field) += w[static_cast<int>(i)] * body.points.volume[p] * unit;
      }
    }
  }
  Matrix& to(Index node, std::size_t field) { return dashpots_[place_[node] * fields_ + field]; }

  std::vector<WaveImpedance> of_body_;
  std::size_t fields_;
  std::vector<Face> faces_;
  Lists of_cell_;                 // [cells] numbers of faces
  std::vector<Index> nodes_;      // that have a dashpot, ascending
  std::vector<Index> place_;      // [nodes of the mesh] in nodes_, or none
  std::vector<Matrix> dashpots_;  // [nodes_ x fields] N s/m
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
