# run_on(RANKS OUTPUT STATUS ERRORS ARGUMENTS..): runs the program on so many ranks, as root too. OUTPUT: what it printed.
function(run_on ranks output status errors)
  set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
  set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
  set(ENV{OMPI_MCA_rmaps_base_oversubscribe} 1)
  set(ENV{ASAN_OPTIONS} fast_unwind_on_malloc=0)  # read by programs built with sanitizers alone
  set(ENV{LSAN_OPTIONS} suppressions=${CMAKE_CURRENT_FUNCTION_LIST_DIR}/leaks_of_mpi.txt:print_suppressions=0)
  execute_process(COMMAND ${mpiexec} -n ${ranks} ${program} ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE result TIMEOUT 120)
  set(${output} "${out}" PARENT_SCOPE)
  set(${status} ${result} PARENT_SCOPE)
  set(${errors} "${err}" PARENT_SCOPE)
endfunction()
