// How recipes are read, whatever the scene: compiled once for each width of registers, for the prebuilt compositions and for those that
// are compiled on first use.
#define ARENITE_COLD_LIBRARY
#define ARENITE_HOST_HERE
#include <arenite_host/readers.hpp>
