// Steps of the penetrometer's default drop (axisymmetric triangles, 28 points each, contact with a rigid
// body, a mesh that moves), after it has hit the sand.
//   --short  fewer steps
#include "../examples/ffp/drop/model.hpp"
#include "whole.hpp"

int main(int argc, char** argv) {
  using namespace arenite;
  using namespace arenite::bench;
  const bool brief = take_flag(argc, argv, "--short");
  for (const int threads : {1, 2})
    add_steps("step/drop_axisymmetric/double/arenite",
              {.warm_up = brief ? 20 : 300, .steps = brief ? 10 : 100, .threads = threads, .courant = 0.5},
              [] {
                const ffp::DropOptions o;
                return ffp::rigid_scene<ffp::AxisymmetricModel, NodalAndElementAverage, RigidVelocity>(
                    o, ffp::plain_sand(o));
              });
  return run_benchmarks(argc, argv);
}
