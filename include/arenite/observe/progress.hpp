// Moved to run/progress.hpp. This name goes in version 0.2.
#pragma once

#include <arenite/run/progress.hpp>
