// The headers that both translation units include.
#pragma once

#include <arenite/core/error.hpp>
#include <arenite/core/parallel.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/core/units.hpp>

/// Mean of (1, 2, 3) kPa, in Pa, computed in the other translation unit.
double mean_stress_elsewhere();
