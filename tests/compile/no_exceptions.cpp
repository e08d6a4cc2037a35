// must print: Arenite tells errors by exceptions: compile without -fno-exceptions
// compile with: -fno-exceptions
#include <arenite/arenite.hpp>
