// Compiles `compositions::PlaneSand` (arenite/compositions.hpp).
#include <arenite/compositions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
ARENITE_COMPOSITION(, PlaneSand, ARENITE_PLANE_SAND);
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
