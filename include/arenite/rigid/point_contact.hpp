// Moved to arenite/rigid/with_matter/point_contact.hpp; this name goes with the next minor version.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/rigid/with_matter/point_contact.hpp>  // IWYU pragma: export
