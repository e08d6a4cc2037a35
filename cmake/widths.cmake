# Flags of the compiler for each width of registers, in bytes (those with which the Python package compiles on first use). Products and
# sums are not fused: a compiler fuses others in another program, and results of one composition would differ in their last bits between
# programs. What it costs: docs/performance.md, Registers.
set(ARENITE_WIDTHS_FILE ${CMAKE_CURRENT_LIST_DIR}/../python/arenite/_widths.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARENITE_WIDTHS_FILE})

# arenite_width_flags(WIDTH OUT): OUT is the list of flags for registers of WIDTH bytes.
function(arenite_width_flags width out)
  file(READ ${ARENITE_WIDTHS_FILE} widths)
  string(JSON count ERROR_VARIABLE unknown LENGTH "${widths}" ${width} flags)
  if(unknown)
    message(FATAL_ERROR "${width} bytes is no width of registers: must be 16, 32 or 64")
  endif()
  set(flags)
  if(count GREATER 0)
    math(EXPR last "${count} - 1")
    foreach(k RANGE ${last})
      string(JSON flag GET "${widths}" ${width} flags ${k})
      list(APPEND flags ${flag})
    endforeach()
  endif()
  set(${out} ${flags} PARENT_SCOPE)
endfunction()
