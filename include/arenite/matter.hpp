// Scenes of matter between walls: kinematics, meshes, shape functions, transfers, laws, walls, gravity, and what a run needs. A part of
// arenite.hpp that compiles faster; the other parts of scenes are in rigid.hpp, contact.hpp, loads.hpp and fill/regions.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/requirements.hpp>

#include <arenite/boundary/driven.hpp>
#include <arenite/boundary/gravity.hpp>
#include <arenite/boundary/walls.hpp>
#include <arenite/core/units.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/frictional/policies.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/law/with_deviatoric_strain.hpp>
#include <arenite/mesh/motion.hpp>
#include <arenite/mesh/periodic_grid.hpp>
#include <arenite/mesh/rectilinear_grid.hpp>
#include <arenite/not_included.hpp>
#include <arenite/observe/energy.hpp>
#include <arenite/observe/probe.hpp>
#include <arenite/observe/section.hpp>
#include <arenite/particles/point_ids.hpp>
#include <arenite/run/every.hpp>
#include <arenite/run/run.hpp>
#include <arenite/run/settle.hpp>
#include <arenite/scene/insert_remove.hpp>
#include <arenite/scene/split_points.hpp>
#include <arenite/version.hpp>
#include <arenite/watch/watch.hpp>
