// The optional headers that need HDF5, from an installed copy.
#include <arenite/io/hdf5_sets.hpp>

int main() {
  arenite::Hdf5File file("consumer.h5", arenite::Hdf5Access::create);
  arenite::make_rows(file, "numbers", {'f', 8}, 1, 16);
  const double number = 1;
  arenite::put_rows(file, "numbers", {'f', 8}, 0, 1, &number);
  return arenite::count_rows(file, "numbers") == 1 ? 0 : 1;
}
