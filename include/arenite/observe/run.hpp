// Moved to run/run.hpp. This name goes in version 0.2.
#pragma once

#include <arenite/run/run.hpp>
