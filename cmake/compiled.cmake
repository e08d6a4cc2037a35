# What is compiled once, only where something links it, in the build and with the flags of who links it: code for other instruction
# sets has other names. `sources`: the folder src, in the source tree or where it is installed.
#
# arenite::cold: cold functions (arenite/core/cold.hpp).
# arenite::compositions: common compositions, (arenite/compositions.hpp).
function(arenite_add_compiled sources)
  add_library(arenite_cold STATIC EXCLUDE_FROM_ALL ${sources}/cold/cold.cpp)
  add_library(arenite::cold ALIAS arenite_cold)
  target_compile_definitions(arenite_cold PUBLIC ARENITE_COLD_LIBRARY)
  target_link_libraries(arenite_cold PUBLIC arenite::arenite)

  file(GLOB files CONFIGURE_DEPENDS ${sources}/compositions/*.cpp)
  add_library(arenite_compositions STATIC EXCLUDE_FROM_ALL ${files})
  add_library(arenite::compositions ALIAS arenite_compositions)
  target_link_libraries(arenite_compositions PUBLIC arenite::cold)
endfunction()
