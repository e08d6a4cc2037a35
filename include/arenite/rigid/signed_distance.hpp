// Moved to arenite/rigid/body/signed_distance.hpp; this name goes with the next minor version.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/rigid/body/signed_distance.hpp>  // IWYU pragma: export
