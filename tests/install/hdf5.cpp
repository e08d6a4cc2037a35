// The optional headers that need HDF5, from an installed copy.
#include <arenite/io/state_hdf5.hpp>

int main() {
  arenite::write_state_hdf5("consumer.h5", {{"version", "1"}}, {});
  return arenite::StateHdf5("consumer.h5").terms().size() == 1 ? 0 : 1;
}
