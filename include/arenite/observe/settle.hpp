// Moved to run/settle.hpp. This name goes in version 0.2.
#pragma once

#include <arenite/run/settle.hpp>
