# What is compiled once, only where something links it, in the build and with the flags of who links it: code for other instruction
# sets has other names. `sources`: the folder src, in the source tree or where it is installed.
#
# arenite::cold: cold functions (arenite/core/cold.hpp).
# arenite::compositions: common compositions (arenite/compositions.hpp).
function(arenite_add_cold target sources)
  file(GLOB files CONFIGURE_DEPENDS ${sources}/cold/*.cpp)
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${files})
  target_compile_definitions(${target} PUBLIC ARENITE_COLD_LIBRARY)
  target_link_libraries(${target} PUBLIC arenite::arenite)
endfunction()

function(arenite_add_compiled sources)
  arenite_add_cold(arenite_cold ${sources})
  add_library(arenite::cold ALIAS arenite_cold)

  file(GLOB files CONFIGURE_DEPENDS ${sources}/compositions/*.cpp)
  add_library(arenite_compositions STATIC EXCLUDE_FROM_ALL ${files})
  add_library(arenite::compositions ALIAS arenite_compositions)
  target_link_libraries(arenite_compositions PUBLIC arenite::cold)
endfunction()
