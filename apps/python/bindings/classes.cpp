// SPDX-License-Identifier: GPL-3.0-or-later
#include "python.h"

namespace radcert::python {

namespace {

PyObject* refuse_to_make(PyTypeObject* type, PyObject* /*arguments*/, PyObject* /*keywords*/) {
  PyErr_Format(PyExc_TypeError, "%s has no constructor: functions of radcert alone make what is of it",
               type->tp_name);
  return nullptr;
}

void seal(const py::handle& type) {
  auto* sealed = reinterpret_cast<PyTypeObject*>(type.ptr());
  sealed->tp_new = refuse_to_make;
  sealed->tp_flags |= Py_TPFLAGS_IMMUTABLETYPE;
}

}  // namespace

void seal_classes() {
  // The base is this module's own by PYBIND11_BUILD_ABI: no other module's classes derive from it.
  const py::handle base(py::detail::get_internals().instance_base);
  for (const py::handle& type : base.attr("__subclasses__")()) seal(type);
  seal(base);
}

}  // namespace radcert::python
