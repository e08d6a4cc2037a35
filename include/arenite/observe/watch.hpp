// Moved to run/watch.hpp. This name goes in version 0.2.
#pragma once

#include <arenite/run/watch.hpp>
