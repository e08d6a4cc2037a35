// must print: Arenite must see NaN, and add and divide as written: compile without -ffast-math
// compile with: -ffast-math
#include <arenite/arenite.hpp>
