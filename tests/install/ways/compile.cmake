# Compiles and runs consumer.cpp without CMake's targets, as a makefile of a user's would: `compiler` with `flags`, and with what
# `pkg_config --cflags --libs arenite` says where `pkg_config` is given. The program is written to `program`.
# `prefix`: where Arenite is installed; `eigen3_dir`: Eigen's package, beside which eigen3.pc lies; `version`: the one installed.
if(pkg_config)
  set(ENV{PKG_CONFIG_PATH} "${prefix}/share/pkgconfig:${eigen3_dir}/../../pkgconfig:$ENV{PKG_CONFIG_PATH}")
  execute_process(COMMAND ${pkg_config} --modversion arenite OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if(NOT found STREQUAL version)
    message(FATAL_ERROR "pkg-config says version ${found}, not ${version}")
  endif()
  execute_process(COMMAND ${pkg_config} --cflags --libs arenite OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "-I *" "-isystem " said "${said}")  # as docs/use.md does
  message("pkg-config: ${said}")
  string(APPEND flags " ${said}")
endif()
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${compiler} -std=c++20 ${flags} ${CMAKE_CURRENT_LIST_DIR}/consumer.cpp -o ${program} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${program} COMMAND_ERROR_IS_FATAL ANY)
