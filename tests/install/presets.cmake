# CMake takes CMakePresets.json, what it sets of ours are options that the build tree `build` has, and one of the presets configures.
execute_process(COMMAND ${CMAKE_COMMAND} --list-presets=all WORKING_DIRECTORY ${source} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

file(READ ${source}/CMakePresets.json presets)
string(REGEX MATCHALL "\"ARENITE_[A-Z0-9_]+\": \"[^\"]*\"" settings "${presets}")
list(TRANSFORM settings REPLACE "\"(ARENITE_[A-Z0-9_]+)\".*" "\\1")
list(REMOVE_DUPLICATES settings)
list(REMOVE_ITEM settings ARENITE_EXTREMES)  # read by tests from the environment
file(READ ${build}/CMakeCache.txt cache)
foreach(setting IN LISTS settings)
  if(NOT cache MATCHES "\n${setting}:")
    message(FATAL_ERROR "CMakePresets.json sets ${setting}, which is no option")
  endif()
endforeach()

file(REMOVE_RECURSE ${scratch})
execute_process(COMMAND ${CMAKE_COMMAND} --preset native -B ${scratch} -DARENITE_TESTS=OFF -DARENITE_EXAMPLES=OFF -DARENITE_BENCHMARKS=OFF
                        -DARENITE_HDF5=OFF -DCMAKE_CXX_COMPILER=${compiler} -DEigen3_DIR=${Eigen3_DIR}
                WORKING_DIRECTORY ${source} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(READ ${scratch}/CMakeCache.txt cache)
foreach(setting CMAKE_BUILD_TYPE:[A-Z]+=Release ARENITE_NATIVE:BOOL=ON CMAKE_GENERATOR:INTERNAL=Ninja)
  if(NOT cache MATCHES "\n${setting}\n")
    message(FATAL_ERROR "the preset `native` does not set ${setting}")
  endif()
endforeach()
