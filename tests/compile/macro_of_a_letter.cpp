// must print: A macro has a name that Arenite uses (min, max, check, require or one capital letter)
// compile with: -DN=100
#include <arenite/arenite.hpp>
