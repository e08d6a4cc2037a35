# tests/ffp/driver/ runs the driver arenite-ffp from outside: one ctest test for each class of its files. It needs Python,
# without packages, and the driver, which is built with the examples.
find_package(Python3 3.8 COMPONENTS Interpreter QUIET)
if(NOT ARENITE_EXAMPLES OR NOT CLI11_FOUND OR NOT nlohmann_json_FOUND OR NOT Python3_FOUND)
  message(STATUS "The tests of the driver arenite-ffp are left out: they need the examples, CLI11, nlohmann-json and Python 3.8")
  return()
endif()

set(left_out)
execute_process(COMMAND /usr/bin/python3 -c "import matplotlib" RESULT_VARIABLE no_matplotlib OUTPUT_QUIET ERROR_QUIET)
if(no_matplotlib)
  list(APPEND left_out Pictures)
  arenite_left_out("The test of the driver's pictures" "matplotlib of /usr/bin/python3 (Debian: python3-matplotlib)")
endif()

set(long FineCells)
if(NOT ARENITE_TEST_HEAVY OR NOT nightly)
  list(APPEND left_out ${long})
endif()
set(quick Drops SameBits Mistakes Options InterruptedRuns)  # the other classes run at a change

set(tests)  # CLASS FILE ..
file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/ffp/driver/*.py)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
foreach(file IN LISTS files)
  file(STRINGS ${file} lines REGEX "^class .*\\(DriverTest\\)")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^class (.*)\\(.*" "\\1" class "${line}")
    list(APPEND tests ${class} ${file})
  endforeach()
endforeach()

while(tests)
  list(POP_FRONT tests class file)
  if(class IN_LIST left_out OR (NOT change AND NOT class IN_LIST quick))
    continue()
  endif()
  set(scratch ${CMAKE_CURRENT_BINARY_DIR}/scratch/ffp.driver_${class})
  file(MAKE_DIRECTORY ${scratch})
  add_test(NAME ffp.driver_${class}
           COMMAND ${Python3_EXECUTABLE} ${file} $<TARGET_FILE:arenite-ffp> ${class}
           WORKING_DIRECTORY ${scratch})
  set_tests_properties(ffp.driver_${class} PROPERTIES LABELS ffp TIMEOUT 300 ENVIRONMENT
                       "ARENITE_THREADS=${ARENITE_TEST_THREADS};PYTHONDONTWRITEBYTECODE=1")
  if(class IN_LIST long)
    set_tests_properties(ffp.driver_${class} PROPERTIES LABELS "ffp;heavy;nightly" TIMEOUT 900)
  elseif(class IN_LIST quick)
    arenite_label(quick ffp.driver_${class})
  else()
    arenite_label(change ffp.driver_${class})
  endif()
endwhile()
