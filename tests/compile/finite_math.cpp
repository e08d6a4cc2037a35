// must print: Arenite must see NaN, and add and divide as written: compile without -ffast-math
// compile with: -ffinite-math-only
#include <arenite/arenite.hpp>
