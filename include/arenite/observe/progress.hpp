// Moved to run/progress.hpp. This name goes in version 0.2.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/run/progress.hpp>
