// HDF5 files by the HDF Group's C library: handles that close themselves, groups and attributes, and errors
// that name the file and the reason. Needs HDF5 1.10.7 or newer (CMake: arenite::hdf5). Files have the
// oldest format that can store them, and contain no times: equal contents are equal bytes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <hdf5.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>
#include <arenite/io/input_file.hpp>
#include <arenite/io/output_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// An open object of the library, closed with its owner.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close by) : id_{id}, close_{by} {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_{std::exchange(other.id_, -1)}, close_{other.close_} {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }
  /// Closes it now; negative: the library could not.
  herr_t close() { return close_(std::exchange(id_, -1)); }

 private:
  hid_t id_;
  Close close_;
};

/// Suppresses the library's own error messages during its lifetime.
class Hdf5Quiet {
 public:
  Hdf5Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Hdf5Quiet(const Hdf5Quiet&) = delete;
  Hdf5Quiet& operator=(const Hdf5Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

enum class Hdf5Access {
  read,
  change,
  create  ///< creates it, replacing an existing file
};

/// An HDF5 file, for a short time. Names are paths ("bodies/sand/points/mass"); "/" is the file itself. Each
/// function throws "what = path: name rule (the library's reason)": `error` for a file that is read,
/// `output_error` for another.
class Hdf5File {
 public:
  /// `what` the file is, for messages.
  Hdf5File(std::filesystem::path path, Hdf5Access access, std::string what = "HDF5 file")
      : path_{std::move(path)}, what_{std::move(what)}, access_{access}, file_{open()} {}

  operator hid_t() const { return file_; }

  /// Throws `error` "what = path: rule".
  [[noreturn]] void refuse(const std::string& rule) const {
    throw error(joined_text({what_, " = ", path_.string(), ": ", rule}));
  }
  /// Result of a call of the library that did not fail.
  template <class Result>
  Result check(Result result, const std::string& name, std::string_view rule) const {
    if (result < 0) fail(joined_text({name, name.empty() ? "" : " ", rule}), reason());
    return result;
  }
  Hdf5Handle handle(hid_t id, Hdf5Handle::Close by, const std::string& name, std::string_view rule) const {
    return {check(id, name, rule), by};
  }

  bool has(const std::string& name) const {
    for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
      if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
      if (end == std::string::npos) return true;
    }
  }
  /// Makes a group, and those above it, unless they exist.
  void make_group(const std::string& name) const {
    if (name.empty() || has(name)) return;
    make_group_of(name);
    const Hdf5Handle made_by = creation(H5P_GROUP_CREATE);
    handle(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, made_by, H5P_DEFAULT), H5Gclose, name,
           "cannot be made");
  }
  /// The group that `name` is in.
  void make_group_of(const std::string& name) const {
    if (const auto end = name.find_last_of('/'); end != std::string::npos) make_group(name.substr(0, end));
  }

  /// A text of fixed length as an attribute of a group or of the file, which must not be there yet.
  void put_text(const std::string& where, const std::string& name, std::string_view value) const {
    const Hdf5Handle type = handle(H5Tcopy(H5T_C_S1), H5Tclose, name, "has no type");
    check(H5Tset_size(type, std::max<std::size_t>(value.size(), 1)), name, "cannot be as long");
    check(H5Tset_strpad(type, H5T_STR_NULLPAD), name, "has no type");
    put_attribute(where, name, type, {}, value.empty() ? "" : value.data());
  }
  /// Integers as an attribute, or as its new values; `scalar`: one, without a shape.
  void put_integers(const std::string& where, const std::string& name, std::span<const std::int64_t> values,
                    bool scalar = false) const {
    put_attribute(where, name, H5T_NATIVE_INT64,
                  scalar ? std::vector<hsize_t>{} : std::vector<hsize_t>{values.size()}, values.data());
  }
  /// How an object is made: without times.
  Hdf5Handle creation(hid_t kind) const {
    Hdf5Handle list = handle(H5Pcreate(kind), H5Pclose, "", "has no list of properties");
    check(H5Pset_obj_track_times(list, false), "", "takes no properties");
    return list;
  }

  /// Closes the file; what is left to be written is written now. Throws if it cannot be.
  void close() { check(file_.close(), "", "cannot be written; is the disk full?"); }

 private:
  [[noreturn]] void fail(const std::string& rule, const std::string& why) const {
    if (access_ == Hdf5Access::read) refuse(joined_text({rule, " (", why, ")"}));
    constexpr std::string_view word = "errno = ";
    const auto at = why.find(word);
    const int number = at == std::string::npos ? 0 : std::atoi(why.c_str() + at + word.size());
    throw output_error(joined_text({what_, " = ", path_.string(), ": ", rule, " (",
                                    number != 0 ? std::generic_category().message(number) : why, ")"}),
                       number);
  }

  Hdf5Handle open() const {
    const Hdf5Handle by = handle(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "", "has no list of properties"),
                     made_by = creation(H5P_FILE_CREATE);
    if (access_ == Hdf5Access::change)  // a reader may have it open meanwhile
      check(H5Pset_file_locking(by, false, true), "", "takes no properties");
    const std::string name = path_.string();
    if (access_ == Hdf5Access::create) {
      shared_detail::make_file(path_, path_);  // in the place of a link
      return handle(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, made_by, by), H5Fclose, "",
                    "cannot be opened for writing; does the folder exist, and may you write there?");
    }
    shared_detail::check_input(path_, what_);
    if (access_ == Hdf5Access::change) shared_detail::open_to_change(path_);  // refuses a link
    return handle(H5Fopen(name.c_str(), access_ == Hdf5Access::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR, by),
                  H5Fclose, "", "cannot be read as HDF5: it is no such file, truncated or damaged");
  }

  /// [] is a scalar.
  void put_attribute(const std::string& where, const std::string& name, hid_t type,
                     const std::vector<hsize_t>& shape, const void* values) const {
    const Hdf5Handle owner =
        handle(H5Oopen(file_, where.c_str(), H5P_DEFAULT), H5Oclose, where, "cannot be opened");
    const Hdf5Handle space =
        handle(shape.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, shape.data(), nullptr), H5Sclose,
               name, "has no shape");
    const bool there = H5Aexists(owner, name.c_str()) > 0;
    const Hdf5Handle made =
        handle(there ? H5Aopen(owner, name.c_str(), H5P_DEFAULT)
                     : H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
               H5Aclose, name, "cannot be made");
    check(H5Awrite(made, type, values), name, "cannot be written");
  }

  /// The innermost reason that the library gave.
  static std::string reason() {
    std::string text;
    const auto take = [](unsigned, const H5E_error2_t* entry, void* to) -> herr_t {
      *static_cast<std::string*>(to) = entry->desc != nullptr ? entry->desc : "";
      return 1;  // the first one is enough
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &text);
    return text.empty() ? "no reason given" : text;
  }

  Hdf5Quiet quiet_;
  std::filesystem::path path_;
  std::string what_;
  Hdf5Access access_;
  Hdf5Handle file_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
