// Rigid bodies, their motions, and their contact with matter and with each other: for a scene that has any.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/geometry/cone_cylinder.hpp>
#include <arenite/matter.hpp>
#include <arenite/rigid/body/rigid_body.hpp>
#include <arenite/rigid/rigid_contact.hpp>
