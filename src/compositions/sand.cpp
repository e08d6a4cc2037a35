// Compiles `compositions::Sand` (arenite/compositions.hpp).
#include <arenite/compositions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
ARENITE_COMPOSITION(, Sand, ARENITE_SAND);
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
