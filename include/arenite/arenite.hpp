// Arenite: everything that needs only the standard library and Eigen, but for file formats (arenite/io).
#pragma once

#include <arenite/core/requirements.hpp>

#include <arenite/boundary/driven.hpp>
#include <arenite/boundary/gravity.hpp>
#include <arenite/boundary/reactions.hpp>
#include <arenite/boundary/walls.hpp>
#include <arenite/contact/contact.hpp>
#include <arenite/contact/frictional_wall.hpp>
#include <arenite/core/units.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/law/with_deviatoric_strain.hpp>
#include <arenite/load/absorbing.hpp>
#include <arenite/load/body_force.hpp>
#include <arenite/load/damping.hpp>
#include <arenite/load/face_traction.hpp>
#include <arenite/load/point_load.hpp>
#include <arenite/load/point_traction.hpp>
#include <arenite/mesh/motion.hpp>
#include <arenite/observe/contact_force.hpp>
#include <arenite/observe/energy.hpp>
#include <arenite/observe/every.hpp>
#include <arenite/observe/not_included.hpp>
#include <arenite/observe/probe.hpp>
#include <arenite/observe/section.hpp>
#include <arenite/observe/watch.hpp>
#include <arenite/particles/point_ids.hpp>
#include <arenite/particles/regions.hpp>
#include <arenite/rigid/cone_cylinder.hpp>
#include <arenite/rigid/rigid_body.hpp>
#include <arenite/scene/insert_remove.hpp>
#include <arenite/scene/run.hpp>
#include <arenite/scene/settle.hpp>
