// must print: Arenite needs C++20: compile with -std=c++20
// compile with: -std=c++17
#include <arenite/arenite.hpp>
