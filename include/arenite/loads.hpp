// Loads, damping, and faces that absorb waves: for a scene that has any.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/load/absorbing.hpp>
#include <arenite/load/body_force.hpp>
#include <arenite/load/damping.hpp>
#include <arenite/load/face_traction.hpp>
#include <arenite/load/point_load.hpp>
#include <arenite/load/point_traction.hpp>
#include <arenite/matter.hpp>
