# Runs an example and shows what it printed; fails unless it ends well and, where its source says `prints: ..`, that line is in the output.
#   cmake -D program=.. -D source=.. [-D any_output=ON] -P check_output.cmake
# any_output: another compiler or other options may round differently, so that only how it ends is checked.
execute_process(COMMAND ${program} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
message("${output}${errors}")
if(NOT code EQUAL 0)
  message(FATAL_ERROR "ended with ${code}")
endif()
file(READ ${source} text)
if(NOT any_output AND text MATCHES "//   prints: ([^\n]*)\n")
  set(line "${CMAKE_MATCH_1}")
  string(FIND "${output}" "${line}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "did not print what ${source} says: ${line}")
  endif()
endif()
