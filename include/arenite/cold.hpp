// Definitions of all cold functions (core/cold.hpp), for one unit of a program whose others are compiled with ARENITE_COLD_LIBRARY: that of
// the target arenite::cold, or one of your own.
#pragma once

#include <arenite/boundary/constraints_cold.hpp>
#include <arenite/boundary/reactions_cold.hpp>
#include <arenite/boundary/walls_cold.hpp>
#include <arenite/core/error_cold.hpp>
#include <arenite/core/thread_pool.hpp>
#include <arenite/core/vector_argument_cold.hpp>
#include <arenite/core/warning_cold.hpp>
#include <arenite/io/input_file_cold.hpp>
#include <arenite/io/output_file_cold.hpp>
#include <arenite/io/pvd_cold.hpp>
#include <arenite/io/state_file_cold.hpp>
#include <arenite/io/vtu_cold.hpp>
#include <arenite/law/elasticity_cold.hpp>
#include <arenite/law/frictional_cold.hpp>
#include <arenite/mesh/blocks_cold.hpp>
#include <arenite/mesh/cartesian_grid_cold.hpp>
#include <arenite/observe/progress_cold.hpp>
#include <arenite/observe/saved_state_cold.hpp>
#include <arenite/observe/vtu_cold.hpp>
#include <arenite/observe/watch_cold.hpp>
#include <arenite/particles/cell_list_cold.hpp>
#include <arenite/particles/cell_parts_cold.hpp>
#include <arenite/particles/cell_points_cold.hpp>
#include <arenite/particles/filling_cold.hpp>
#include <arenite/particles/initial_stress_cold.hpp>
#include <arenite/particles/initial_velocity_cold.hpp>
#include <arenite/particles/jitter_cold.hpp>
#include <arenite/rigid/try_distance_cold.hpp>
#include <arenite/scene/ground_cold.hpp>
#include <arenite/scene/new_scene_warnings_cold.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template struct detail::Blocked<2>;
template struct detail::Blocked<3>;
template class BoundaryNodes<2>;
template class BoundaryNodes<3>;
template void Walls::constrain(BoundaryNodes<2>&) const;
template void Walls::constrain(BoundaryNodes<3>&) const;
template Vec<double, 2> Walls::check(const Wall&);
template Vec<double, 3> Walls::check(const Wall&);
template Mat<double, 2> detail::shares_along(const Blocked<2>&);
template Mat<double, 3> detail::shares_along(const Blocked<3>&);

template VtuData detail::columns_vtu(const PointColumns<float>&, const VtuPoints&, MorePoints<float>);
template VtuData detail::columns_vtu(const PointColumns<double>&, const VtuPoints&, MorePoints<double>);

template void detail::WatchBook::look_at_energy(double, const WatchedEnergy::Found&, bool,
                                                std::span<const WatchedBody<float>>);
template void detail::WatchBook::look_at_body(double, const WatchedBody<float>&);
template detail::WatchedSpot detail::watched_spot(const WatchedBody<float>&, std::size_t);
template void detail::WatchBook::look_at_energy(double, const WatchedEnergy::Found&, bool,
                                                std::span<const WatchedBody<double>>);
template void detail::WatchBook::look_at_body(double, const WatchedBody<double>&);
template detail::WatchedSpot detail::watched_spot(const WatchedBody<double>&, std::size_t);
template void detail::WatchBook::look_at_energy(double, const WatchedEnergy::Found&, bool,
                                                std::span<const WatchedBody<long double>>);
template void detail::WatchBook::look_at_body(double, const WatchedBody<long double>&);
template detail::WatchedSpot detail::watched_spot(const WatchedBody<long double>&, std::size_t);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
