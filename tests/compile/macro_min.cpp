// must print: A macro has a name that Arenite uses (min, max, check, require or one capital letter)
// As windows.h has them, after a header of the standard library.
#include <cstddef>
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#include <arenite/arenite.hpp>
