// must print: Rigid: on a portion of a mesh velocity_in_contact(body, free_velocity, comm) of a motion with mass must sum over the portions; see arenite/rigid/motion.hpp
// errors: 1
// A guided motion of a user's own that finds its velocity from the contact in this portion alone.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

using namespace arenite;

struct Lone : BoundGuided<double, 2> {
  Lone() : BoundGuided<double, 2>(Guided{.mass = 1}) {}
  template <class Body>
  auto velocity_in_contact(const Body&, const Vec<double, 2>& free_velocity) const {
    return free_velocity;
  }
};

struct Neighbours {
  static constexpr bool is_serial = false;
  void sum_nodes(std::span<double>, std::size_t) const {}
  void share_nodes(std::span<double>, std::size_t) const {}
  void sum(std::span<double>) const {}
  double least(double value) const { return value; }
  bool first() const { return true; }
  std::size_t size() const { return 1; }
  Messages exchange(Messages messages) const { return messages; }
  void fail(const std::string&) const {}
};

int main() {
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  const auto [mesh, portion] = split_mesh(box_mesh<2>({{0, 0}, {1, 1}, {4, 4}}), std::vector<int>(32, 0), 0);
  Scene scene{PlaneStrain{},
              SimplexMesh<2>(mesh),
              Numerics<LinearSimplex, Flip, Usl>{},
              bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber)),
              rigid(DistanceSurface{Ball<2>({0.5, 0.9}, 0.3)}, Lone{}, Friction(0.1)),
              on_portion(portion, Neighbours{})};
  step(scene, 1e-6);
}
