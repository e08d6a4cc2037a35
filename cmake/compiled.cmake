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

# `include`: the folder of the library's headers.
function(arenite_add_compiled sources include)
  arenite_add_cold(arenite_cold ${sources})
  add_library(arenite::cold ALIAS arenite_cold)

  # A unit for each composition of the header.
  set(header ${include}/arenite/compositions.hpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  file(STRINGS ${header} names REGEX "^ARENITE_COMPOSITION\\(")
  set(files)
  foreach(name IN LISTS names)
    string(REGEX REPLACE "^ARENITE_COMPOSITION\\(([A-Za-z]+),.*" "\\1" name "${name}")
    set(file ${CMAKE_CURRENT_BINARY_DIR}/compositions/${name}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "#define ARENITE_COMPILE_${name} ~,\n#include <arenite/compositions.hpp>\n")
    list(APPEND files ${file})
  endforeach()
  add_library(arenite_compositions STATIC EXCLUDE_FROM_ALL ${files})
  add_library(arenite::compositions ALIAS arenite_compositions)
  target_link_libraries(arenite_compositions PUBLIC arenite::cold)
endfunction()
