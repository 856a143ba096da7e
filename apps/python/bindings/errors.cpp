// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/errors.h"

#include <pybind11/stl.h>

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "python.h"
#include "radcert/core/contract.h"

namespace radcert::python {

namespace {

/// The classes of Python, one for each error of the library. They live as long as the process.
struct ErrorClasses {
  PyObject* input = nullptr;
  PyObject* environment = nullptr;
  PyObject* accuracy = nullptr;
  PyObject* contract = nullptr;
  PyObject* interrupted = nullptr;
  PyObject* store_warning = nullptr;
};

ErrorClasses& classes() {
  static ErrorClasses all;
  return all;
}

PyObject* new_class(py::module_& module, const char* name, const char* words, PyObject* base) {
  const std::string path = std::string("radcert.") + name;
  PyObject* made = PyErr_NewExceptionWithDoc(path.c_str(), words, base, nullptr);
  if (made == nullptr) throw py::error_already_set();
  module.attr(name) = py::reinterpret_borrow<py::object>(made);
  return made;
}

void set(PyObject* type, const std::exception& error) {
  const py::str words(error.what());
  PyErr_SetObject(type, words.ptr());
}

void set_input_error(const InputError& error) {
  const InputFault& fault = error.fault();
  py::object value = py::reinterpret_borrow<py::object>(classes().input)(py::str(error.what()));
  value.attr("source") = fault.source;
  value.attr("place") = fault.pointer;
  value.attr("value") = fault.value ? py::object(py::str(*fault.value)) : py::object(py::none());
  value.attr("problem") = fault.problem;
  value.attr("allowed") = fault.allowed;
  PyErr_SetObject(classes().input, value.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    set_input_error(error);
  } catch (const EnvironmentError& error) {
    set(classes().environment, error);
  } catch (const AccuracyNotReached& error) {
    set(classes().accuracy, error);
  } catch (const ContractViolation& error) {
    set(classes().contract, error);
  } catch (const Interrupted& error) {
    set(classes().interrupted, error);
  } catch (const std::filesystem::filesystem_error& error) {
    set(classes().environment, EnvironmentError(error.path1().string(), error.code().message()));
  } catch (const std::system_error& error) {
    set(classes().environment, EnvironmentError("the system", error.what()));
  }
}

}  // namespace

PyObject* store_warning() { return classes().store_warning; }

void add_errors(py::module_& module) {
  classes().input =
      new_class(module, "InputError",
                "The input is wrong.\n\n"
                "source, place, value, problem, allowed: the parts of the message. `place` is the place in\n"
                "the source, as a JSON pointer (\"/basis/alpha\") or in words (\"triangle 7\"); `value` is\n"
                "what stands there, None where nothing does.",
                PyExc_ValueError);
  classes().environment =
      new_class(module, "EnvironmentError", "The world failed: a disk, memory, threads.", PyExc_OSError);
  classes().accuracy =
      new_class(module, "AccuracyNotReached", "An accuracy or a proof that was asked for was not reached.",
                PyExc_ArithmeticError);
  classes().contract =
      new_class(module, "ContractViolation",
                "A function was called in a way that it does not allow: a defect of radcert itself,\n"
                "please report it.",
                PyExc_RuntimeError);
  classes().interrupted =
      new_class(module, "Interrupted",
                "A computation was stopped, by Ctrl-C in another thread or as Python ended. What\n"
                "Ctrl-C stops in the main thread raises KeyboardInterrupt.",
                PyExc_RuntimeError);
  classes().store_warning = new_class(
      module, "StoreWarning", "A store that was asked for cannot be written: finished work is not kept.",
      PyExc_UserWarning);
  py::register_exception_translator(translate);
  module.def(
      "refuse",
      [](std::string source, std::string place, std::optional<std::string> value, std::string problem,
         std::string allowed) {
        throw InputError({.source = std::move(source),
                          .pointer = std::move(place),
                          .value = std::move(value),
                          .problem = std::move(problem),
                          .allowed = std::move(allowed)});
      },
      py::arg("source"), py::arg("place"), py::arg("value"), py::arg("problem"), py::arg("allowed"));
}

}  // namespace radcert::python
