// Moved to run/saved_hdf5.hpp. This name goes in version 0.2.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/run/saved_hdf5.hpp>
