# Where Eigen is not found, the first error is the cure: when `source` is configured, when the package in `prefix` is asked for, and when
# `compiler` meets our headers. Projects go to `scratch`.
file(REMOVE_RECURSE ${scratch})
file(CONFIGURE OUTPUT ${scratch}/user/CMakeLists.txt CONTENT "cmake_minimum_required(VERSION 3.21)
project(user LANGUAGES CXX)
find_package(arenite REQUIRED)\n")
file(CONFIGURE OUTPUT ${scratch}/user.cpp CONTENT "#include <arenite/arenite.hpp>\n")

# names(FIRST COMMAND..): the command fails, and its first error, a line that holds FIRST and what follows, names the package.
function(names first)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${ARGN} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
  string(FIND "${said}" "${first}" at)
  if(result EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "must fail without Eigen, and begin its first error with '${first}'; it said\n${said}")
  endif()
  # From the first error to where a second one begins. Its length is that of the paths in it.
  string(LENGTH "${first}" past)
  string(SUBSTRING "${said}" ${at} -1 told)
  string(SUBSTRING "${told}" ${past} -1 told)
  string(FIND "${told}" "${first}" second)
  string(SUBSTRING "${told}" 0 ${second} told)
  string(REGEX REPLACE "[ \n]+" " " told "${told}")
  if(NOT told MATCHES "Arenite needs Eigen 3.4 or newer[^()]*\\(Debian, Ubuntu: libeigen3-dev\\)")
    message(FATAL_ERROR "the first error must name the package; it said\n${said}")
  endif()
endfunction()

set(without ${CMAKE_COMMAND} -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
names("CMake Error" ${without} -S ${source} -B ${scratch}/library)
names("CMake Error" ${without} -S ${scratch}/user -B ${scratch}/user/build -DCMAKE_PREFIX_PATH=${prefix})
names("error: " ${compiler} -std=c++20 -fsyntax-only -I ${source}/include ${scratch}/user.cpp)
