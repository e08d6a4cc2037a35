// must print: Arenite must see NaN: compile without -ffast-math
// compile with: -ffinite-math-only
#include <arenite/arenite.hpp>
