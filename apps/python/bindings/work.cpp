// SPDX-License-Identifier: GPL-3.0-or-later
#include "work.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <string>

#include "radcert/core/errors.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/parallel.h"

namespace radcert::python {

namespace {

void serve(const py::object& progress, Progress& told) {
  const py::gil_scoped_acquire held;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  for (const std::string& words : told.take_warnings())
    if (PyErr_WarnEx(store_warning(), words.c_str(), 2) != 0) throw py::error_already_set();
  if (progress.is_none()) return;
  if (const auto report = told.take()) progress(report->first, report->second);
}

}  // namespace

void run_apart(const py::object& progress, const std::function<void(Progress&)>& action) {
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw InputError({.source = "progress",
                      .value = std::string(py::str(progress.get_type())),
                      .problem = "cannot be called",
                      .allowed = "None, or a function of a fraction and of words"});
  // It outlives the release: a thread that asks for the lock after Python's end is ended by it amid a
  // destructor, which C++ does not allow.
  const app::AtWork at_work;
  const py::gil_scoped_release released;
  app::run_apart([&](Progress& told) { serve(progress, told); }, action);
}

void add_work(py::module_& module) {
  module.def("stop_all", [] {
    const py::gil_scoped_release released;
    app::end_work();
  });
  module.def("thread_count", thread_count);
  module.def("available_memory", [] { return available_memory(); });
  module.def("limit_threads", app::limit_threads);
  py::module_::import("atexit").attr("register")(module.attr("stop_all"));
}

}  // namespace radcert::python
