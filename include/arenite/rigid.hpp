// Rigid bodies, their motions, and their contact with the material: for a scene that has any. Contact of rigid
// bodies with each other: rigid/between_bodies/rigid_contact.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/geometry/cone_cylinder.hpp>
#include <arenite/matter.hpp>
#include <arenite/rigid/body/rigid_body.hpp>
