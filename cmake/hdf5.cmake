# arenite::hdf5: Arenite with the HDF Group's C library, for the headers that need it (observe/vtkhdf.hpp), where it is
# found. Included by Arenite's build, and by its package for find_package(arenite COMPONENTS hdf5). CMake finds HDF5 by compiling C.
include(CheckLanguage)
check_language(C)
if(CMAKE_C_COMPILER)
  enable_language(C)
  find_package(HDF5 1.10.7 QUIET COMPONENTS C)
endif()
if(TARGET hdf5::hdf5 AND NOT TARGET arenite::hdf5)
  add_library(arenite_hdf5 INTERFACE)
  add_library(arenite::hdf5 ALIAS arenite_hdf5)
  target_link_libraries(arenite_hdf5 INTERFACE arenite::arenite hdf5::hdf5)
endif()
