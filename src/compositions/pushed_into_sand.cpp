// Compiles `compositions::PushedIntoSand` (arenite/compositions.hpp).
#include <arenite/compositions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
ARENITE_COMPOSITION(, PushedIntoSand, ARENITE_PUSHED_INTO_SAND);
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
