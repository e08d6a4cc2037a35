# What our own executables (tests, examples, benchmarks) are compiled with. Nothing here reaches a user of the library.
add_library(arenite_warnings INTERFACE)
target_compile_options(arenite_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                                                  $<$<BOOL:${ARENITE_WERROR}>:-Werror>)
# g++ notes at every pack passed by value that GCC 4.6 changed the ABI; nothing here was ever compiled by an older one.
target_compile_options(arenite_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)

add_library(arenite_headers INTERFACE)  # of units that compile all of the headers themselves
target_link_libraries(arenite_headers INTERFACE arenite::arenite arenite_warnings)
# Eigen's intrinsics for AVX-512 make g++ 12 warn of numbers that it does not see set.
target_compile_options(arenite_headers INTERFACE
    $<$<BOOL:${ARENITE_NATIVE}>:-march=native>
    $<$<AND:$<BOOL:${ARENITE_NATIVE}>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)

add_library(arenite_developer INTERFACE)
target_link_libraries(arenite_developer INTERFACE arenite_headers arenite::cold)

if(NOT ARENITE_BENCHMARKS AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  target_compile_options(arenite_cold PRIVATE -O1)  # a third less of the compiler's time; a drop takes as long
endif()
foreach(target arenite_cold arenite_compositions)
  target_link_libraries(${target} PRIVATE arenite_headers)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
endforeach()

find_program(ARENITE_CCACHE ccache DOC "Compiler cache, used if found")
if(ARENITE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ARENITE_CCACHE})
endif()

set(CMAKE_CXX_EXTENSIONS OFF)  # ISO C++20, without the compilers' own additions

# arenite_left_out(WHAT PACKAGES): says that WHAT is not built for want of PACKAGES; an error with ARENITE_REQUIRE_ALL.
function(arenite_left_out what packages)
  if(ARENITE_REQUIRE_ALL)
    message(FATAL_ERROR "${what} cannot be built: ${packages} not found")
  endif()
  message(STATUS "${what} left out: ${packages} not found")
endfunction()
