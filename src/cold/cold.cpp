// The cold functions of all headers, compiled once.
#include <arenite/cold.hpp>
