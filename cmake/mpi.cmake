# arenite::mpi: Arenite with MPI, for arenite/mpi.hpp, where it is found. Included by Arenite's build, and by its package for
# find_package(arenite COMPONENTS mpi).
set(MPI_CXX_SKIP_MPICXX TRUE)
find_package(MPI 3.0 QUIET COMPONENTS CXX)
if(TARGET MPI::MPI_CXX AND NOT TARGET arenite::mpi)
  add_library(arenite_mpi INTERFACE)
  add_library(arenite::mpi ALIAS arenite_mpi)
  target_link_libraries(arenite_mpi INTERFACE arenite::arenite MPI::MPI_CXX)
endif()
