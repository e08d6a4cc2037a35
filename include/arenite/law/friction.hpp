// Moved to arenite/law/frictional/friction.hpp; this name goes with the next minor version.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/frictional/friction.hpp>  // IWYU pragma: export
