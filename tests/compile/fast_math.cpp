// must print: Arenite must see NaN: compile without -ffast-math
// compile with: -ffast-math
#include <arenite/arenite.hpp>
