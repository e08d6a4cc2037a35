// Compiles `compositions::DroppedIntoSand` (arenite/compositions.hpp).
#include <arenite/compositions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
ARENITE_COMPOSITION(, DroppedIntoSand, ARENITE_DROPPED_INTO_SAND);
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
