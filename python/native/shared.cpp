// The symbols that the program needs in the shared object of the prebuilt compositions.
#define ARENITE_COLD_LIBRARY
#define ARENITE_HOST_ELSEWHERE
#include <arenite_host/plugin.hpp>

ARENITE_PLUGIN
