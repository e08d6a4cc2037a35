// The cold functions of all headers, compiled once.
#include <arenite/core/error_cold.hpp>
