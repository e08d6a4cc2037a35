# Runs a command and sends it SIGTERM once `file` is there; its exit code and what it said are `code` and `said`. Open MPI hands a signal on
# after a second: a run on ranks must take a few seconds more than it takes until `file` is there.
function(end_at file)
  string(JOIN " " command ${ARGN})
  execute_process(COMMAND sh -c "${command} & while [ ! -e ${file} ] && kill -0 $!; do sleep 0.02; done; kill -TERM $!; wait $!"
                  RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT EXISTS ${CMAKE_CURRENT_BINARY_DIR}/${file})
    message(FATAL_ERROR "${command}: no ${file}: ${said}")
  endif()
  set(code "${code}" PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()
