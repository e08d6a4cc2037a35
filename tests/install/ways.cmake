# One program of a user, ways/consumer.cpp, built in each way that docs/use.md names, and told apart by nothing else.
#   find_package, add_subdirectory, fetch_content: a project each, under flags that our headers do not pass; pkg_config and plain: the
#   compiler alone.

# arenite_way(NAME OPTIONS..): the project ways/NAME, configured with OPTIONS, built and run.
function(arenite_way name)
  add_test(NAME install.${name}
           COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/ways/${name} ${CMAKE_CURRENT_BINARY_DIR}/ways/${name}
                   --build-generator ${CMAKE_GENERATOR}
                   --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}
                                   -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER} -DEigen3_DIR=${Eigen3_DIR} ${ARGN}
                   --test-command consumer)
  set_tests_properties(install.${name} PROPERTIES LABELS "install;change" TIMEOUT 120)
endfunction()

# The same without CMake: `name`, and definitions for ways/compile.cmake.
function(arenite_compiled name)
  add_test(NAME install.${name}
           COMMAND ${CMAKE_COMMAND} -D compiler=${CMAKE_CXX_COMPILER} -D program=${CMAKE_CURRENT_BINARY_DIR}/ways/${name}_program
                   ${ARGN} -P ${CMAKE_CURRENT_SOURCE_DIR}/ways/compile.cmake)
  set_tests_properties(install.${name} PROPERTIES LABELS "install;change" TIMEOUT 60)
endfunction()

# What must not be found by who asks for it: what is newer, and what came before and may have been broken since.
math(EXPR next_patch "${PROJECT_VERSION_PATCH} + 1")
math(EXPR next_minor "${PROJECT_VERSION_MINOR} + 1")
math(EXPR next_major "${PROJECT_VERSION_MAJOR} + 1")
set(refused ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}.${next_patch} ${PROJECT_VERSION_MAJOR}.${next_minor} ${next_major}.0)
if(PROJECT_VERSION_MAJOR GREATER 0)
  math(EXPR last_major "${PROJECT_VERSION_MAJOR} - 1")
  list(APPEND refused ${last_major}.9)
elseif(PROJECT_VERSION_MINOR GREATER 0)
  math(EXPR last_minor "${PROJECT_VERSION_MINOR} - 1")
  list(APPEND refused 0.${last_minor})
endif()
list(JOIN refused "," refused)

arenite_way(find_package -DCMAKE_PREFIX_PATH=${prefix} -Dversion=${PROJECT_VERSION} -Drefused=${refused})
set_tests_properties(install.find_package PROPERTIES FIXTURES_REQUIRED installed_package)
arenite_way(add_subdirectory -Darenite_source=${PROJECT_SOURCE_DIR})
arenite_way(fetch_content -Darenite_source=${PROJECT_SOURCE_DIR})

get_target_property(eigen_include Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
arenite_compiled(plain "-Dflags=-Wall -Wextra -Wconversion -Wold-style-cast -Wcast-qual -Werror -I${PROJECT_SOURCE_DIR}/include -isystem ${eigen_include} -pthread ${CMAKE_CXX_FLAGS}")

find_program(ARENITE_PKG_CONFIG NAMES pkg-config pkgconf DOC "Tests arenite.pc, if found")
if(ARENITE_PKG_CONFIG)
  arenite_compiled(pkg_config -Dpkg_config=${ARENITE_PKG_CONFIG} -Dprefix=${prefix} -Deigen3_dir=${Eigen3_DIR} -Dversion=${PROJECT_VERSION}
                   "-Dflags=-Wold-style-cast -Werror ${CMAKE_CXX_FLAGS}")
  set_tests_properties(install.pkg_config PROPERTIES FIXTURES_REQUIRED installed_package)
else()
  arenite_left_out("Test of arenite.pc" "pkg-config (Debian: pkgconf)")
endif()
