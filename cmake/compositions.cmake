# arenite::compositions: common compositions, compiled once (arenite/compositions.hpp). Built only where something links it, in the
# build and with the flags of who links it: units for other instruction sets need other compositions.
# `sources`: the folder of src/compositions, in the source tree or where it is installed.
function(arenite_add_compositions sources)
  file(GLOB files CONFIGURE_DEPENDS ${sources}/*.cpp)
  add_library(arenite_compositions STATIC EXCLUDE_FROM_ALL ${files})
  add_library(arenite::compositions ALIAS arenite_compositions)
  target_link_libraries(arenite_compositions PUBLIC arenite::arenite)
endfunction()
