// Moved to run/saved_state.hpp. This name goes in version 0.2.
#pragma once

#include <arenite/run/saved_state.hpp>
