// Meshes for Python: Gmsh files, and elements of other readers, by the rules of the library's reader.
#pragma once

#include <pybind11/pybind11.h>

namespace arenite::python {

/// Adds `read_gmsh` and `gather_mesh` to the native core.
void add_meshes(pybind11::module_& m);

}  // namespace arenite::python
