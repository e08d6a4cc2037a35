// Data sets of numbers in HDF5 files that grow row by row.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <string>

#include <arenite/core/instruction_set.hpp>
#include <arenite/io/hdf5.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Numbers as a file has them: 'f' floating, 'i' signed, 'u' unsigned, and the bytes of each.
struct Hdf5Type {
  char kind = 'f';
  std::size_t bytes = 8;

  bool operator==(const Hdf5Type&) const = default;
};

namespace shared_detail {

/// The type in memory.
inline Hdf5Handle hdf5_native(const Hdf5File& file, Hdf5Type type, const std::string& name) {
  const auto by_size = [&](hid_t one, hid_t two, hid_t four, hid_t eight) {
    return type.bytes == 1   ? one
           : type.bytes == 2 ? two
           : type.bytes == 4 ? four
           : type.bytes == 8 ? eight
                             : -1;
  };
  const hid_t found =
      type.kind == 'f'   ? by_size(-1, -1, H5T_NATIVE_FLOAT, H5T_NATIVE_DOUBLE)
      : type.kind == 'i' ? by_size(H5T_NATIVE_INT8, H5T_NATIVE_INT16, H5T_NATIVE_INT32, H5T_NATIVE_INT64)
                         : by_size(H5T_NATIVE_UINT8, H5T_NATIVE_UINT16, H5T_NATIVE_UINT32, H5T_NATIVE_UINT64);
  if (found < 0)
    file.refuse(joined_text({name, " has numbers of ", type.bytes, " bytes, which are not kept"}));
  return file.handle(H5Tcopy(found), H5Tclose, name, "has no type");
}

inline Hdf5Handle hdf5_open_set(const Hdf5File& file, const std::string& name) {
  return file.handle(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, name, "cannot be opened");
}
inline Hdf5Handle hdf5_space(const Hdf5File& file, hid_t set, const std::string& name) {
  return file.handle(H5Dget_space(set), H5Sclose, name, "has no shape");
}
/// Rows and columns; where there is one dimension, 1 column.
inline std::array<hsize_t, 2> hdf5_shape(const Hdf5File& file, hid_t set, const std::string& name) {
  const Hdf5Handle space = hdf5_space(file, set, name);
  std::array<hsize_t, 2> shape{1, 1};
  const int dimensions = file.check(H5Sget_simple_extent_ndims(space), name, "has no shape");
  if (dimensions > 2) file.refuse(name + " has more than two dimensions");
  file.check(H5Sget_simple_extent_dims(space, shape.data(), nullptr), name, "has no shape");
  return shape;
}

}  // namespace shared_detail

/// Reads all numbers of a data set.
inline void get_numbers(const Hdf5File& file, const std::string& name, Hdf5Type type, void* numbers) {
  const Hdf5Handle set = shared_detail::hdf5_open_set(file, name),
                   number = shared_detail::hdf5_native(file, type, name);
  file.check(H5Dread(set, number, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), name, "cannot be read");
}

/// Makes an empty data set of rows of `columns` numbers (1: one dimension) that grows, stored on the disk in
/// chunks of `rows_of_piece` rows.
inline void make_rows(const Hdf5File& file, const std::string& name, Hdf5Type type, std::size_t columns,
                      std::size_t rows_of_piece) {
  file.make_group_of(name);
  const int dimensions = columns == 1 ? 1 : 2;
  const std::array<hsize_t, 2> empty{0, columns}, most{H5S_UNLIMITED, columns}, piece{rows_of_piece, columns};
  const Hdf5Handle space = file.handle(H5Screate_simple(dimensions, empty.data(), most.data()), H5Sclose,
                                       name, "has no shape"),
                   number = shared_detail::hdf5_native(file, type, name),
                   made_by = file.creation(H5P_DATASET_CREATE);
  file.check(H5Pset_chunk(made_by, dimensions, piece.data()), name, "has no such pieces");
  file.handle(H5Dcreate2(file, name.c_str(), number, space, H5P_DEFAULT, made_by, H5P_DEFAULT), H5Dclose,
              name, "cannot be made");
}
inline std::size_t count_rows(const Hdf5File& file, const std::string& name) {
  return static_cast<std::size_t>(
      shared_detail::hdf5_shape(file, shared_detail::hdf5_open_set(file, name), name)[0]);
}
/// Keeps the first `kept` rows, and writes `count` rows after them.
inline void put_rows(const Hdf5File& file, const std::string& name, Hdf5Type type, std::size_t kept,
                     std::size_t count, const void* numbers) {
  const Hdf5Handle set = shared_detail::hdf5_open_set(file, name);
  const hsize_t columns = shared_detail::hdf5_shape(file, set, name)[1];
  const std::array<hsize_t, 2> all{kept + count, columns}, begin{kept, 0}, size{count, columns};
  file.check(H5Dset_extent(set, all.data()), name, "cannot grow");
  if (count == 0) return;
  const Hdf5Handle there = shared_detail::hdf5_space(file, set, name),
                   here = file.handle(H5Screate_simple(columns == 1 ? 1 : 2, size.data(), nullptr), H5Sclose,
                                      name, "has no shape"),
                   number = shared_detail::hdf5_native(file, type, name);
  file.check(H5Sselect_hyperslab(there, H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr), name,
             "has no such rows");
  file.check(H5Dwrite(set, number, here, there, H5P_DEFAULT, numbers), name,
             "cannot be written; is the disk full?");
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
