// Contact of bodies of matter with each other and with frictional walls: for a scene that has any.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/contact/contact.hpp>
#include <arenite/contact/frictional_wall.hpp>
#include <arenite/matter.hpp>
#include <arenite/observe/contact_force.hpp>
