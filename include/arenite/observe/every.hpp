// Moved to run/every.hpp. This name goes in version 0.2.
#pragma once

#include <arenite/run/every.hpp>
