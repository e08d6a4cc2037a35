// Arenite: everything that needs only the standard library and Eigen, but for file formats (arenite/io).
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/matter.hpp>

#include <arenite/boundary/reactions.hpp>
#include <arenite/contact.hpp>
#include <arenite/fill/regions.hpp>
#include <arenite/law/by_point.hpp>
#include <arenite/law/drive.hpp>
#include <arenite/loads.hpp>
#include <arenite/rigid.hpp>
#include <arenite/rigid/between_bodies/rigid_contact.hpp>
