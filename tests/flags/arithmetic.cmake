# cmake -D source=FILE -D program=FILE -D "flags=FLAGS" -P arithmetic.cmake -- COMPILER FLAGS...
# With the flags the library refuses to compile, by its own sentence, or computes right. A flag that the compiler does not know passes.
include(${CMAKE_CURRENT_LIST_DIR}/../compile/command.cmake)
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${command} ${flags} ${source} -o ${program}
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  if(NOT output MATCHES "error: [^\n]*\"?Arenite (must|needs)|unrecognized|unknown|unsupported|not supported")
    message(FATAL_ERROR "${flags}: refused, but by another sentence than the library's:\n${output}")
  endif()
  message("refused")
  return()
endif()
execute_process(COMMAND ${program} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${flags}: compiles, and computes wrong:\n${output}")
endif()
message("right\n${output}")
