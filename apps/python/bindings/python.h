// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

// The module radcert._core: the library for Python, one source a part. What is pleasant to write in Python,
// as names of surfaces and operators of expressions, is in the package beside it; what is computed or decided
// is in the library.
namespace radcert::python {

namespace py = pybind11;

/// The class radcert.StoreWarning.
[[nodiscard]] PyObject* store_warning();

/// Each adds its part of the module.
void add_errors(py::module_& module);
void add_work(py::module_& module);
void add_exact(py::module_& module);
void add_references(py::module_& module);
void add_expressions(py::module_& module);
void add_meshes(py::module_& module);
void add_factors(py::module_& module);
void add_bases(py::module_& module);
void add_problems(py::module_& module);
void add_own_surfaces(py::module_& module);
void add_solutions(py::module_& module);
void add_pictures(py::module_& module);
void add_experiments(py::module_& module);
void add_guarantees(py::module_& module);
void add_edges(py::module_& module);
void add_verification(py::module_& module);

/// Lets no object of the bound classes be made, or change its class, but by the library; after all classes.
/// Maths     pybind11 takes the memory of an object for the object: `__new__` without `__init__`, an
///           assignment to `__class__`, and what `copy` and `pickle` do without being asked would let it read
///           what is not there. Every object here comes from a function, so no class needs a constructor
/// Result    `__new__` raises TypeError for each class, for what derives from it and for the base of all;
///           assignments to `__class__` and to members of a class do so too
void seal_classes();

}  // namespace radcert::python
