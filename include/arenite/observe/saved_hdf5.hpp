// Moved to run/saved_hdf5.hpp. This name goes in version 0.2.
#pragma once

#include <arenite/run/saved_hdf5.hpp>
