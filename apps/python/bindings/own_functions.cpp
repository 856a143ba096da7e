// SPDX-License-Identifier: GPL-3.0-or-later
#include "own_functions.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <variant>

#include "arrays.h"
#include "exact.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/text.h"
#include "radcert/meshless/mother_function.h"
#include "radcert/surface/surface_function.h"

namespace radcert::python {

namespace {

using Kept = std::shared_ptr<const py::object>;

/// An object that threads without the interpreter's lock may share and let go.
Kept kept(const py::object& object) {
  return {new py::object(object), [](const py::object* each) {
            // Once the interpreter has gone there is nothing to give back.
            if (Py_IsInitialized() == 0) return;
            const py::gil_scoped_acquire held;
            delete each;
          }};
}

std::string words_of(const py::object& function) {
  const bool named = py::hasattr(function, "__qualname__");
  return "estimated, by a function of Python: " +
         std::string(py::str(named ? function.attr("__qualname__") : function.get_type().attr("__name__")));
}

void values_of(const Kept& function, const std::string& place, std::span<const double> x,
               std::span<const double> y, std::span<const double> z, std::span<double> values) {
  const py::gil_scoped_acquire held;
  std::vector<double> numbers;
  numbers.reserve(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) numbers.insert(numbers.end(), {x[i], y[i], z[i]});
  const auto count = static_cast<py::ssize_t>(x.size());
  const DoubleArray found = called(*function, owning_array(std::move(numbers), {count, 3}), place, {},
                                   "a function of points (n, 3) that gives an array of doubles (n,)");
  std::copy_n(found.data(), values.size(), values.begin());
}

double mother_of(const Kept& function, double r) {
  constexpr const char* place = "/basis/mother";
  constexpr const char* allowed = "a function of a float r >= 0 that gives a finite float";
  const py::gil_scoped_acquire held;
  throw_if_interrupted();
  const py::object found = (*function)(r);
  const double value = PyFloat_AsDouble(found.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw InputError(
        {.pointer = place, .value = kind_of(found), .problem = "is no number", .allowed = allowed});
  }
  if (!std::isfinite(value))
    throw InputError({.pointer = place,
                      .value = shortest(value),
                      .problem = "is not finite, at r = " + shortest(r),
                      .allowed = allowed});
  return value;
}

}  // namespace

void set_function(Problem& problem, const std::string& part, const py::object& function) {
  const Kept held = kept(function);
  if (part == "mother") {
    auto* meshless = std::get_if<Meshless>(&problem.method);
    if (meshless == nullptr)
      throw InputError({.pointer = "/basis/mother", .problem = "is for a meshless basis"});
    MotherFunction& mother = meshless->basis.mother;
    mother = own_mother(
        words_of(function), [held](double r) { return mother_of(held, r); }, mother.support);
    return;
  }
  const std::string place = "/" + part;
  PiecewiseExpression own =
      own_function({.words = words_of(function),
                    .values = [held, place](std::span<const double> x, std::span<const double> y,
                                            std::span<const double> z, std::span<double> values) {
                      values_of(held, place, x, y, z, values);
                    }});
  (part == "solution" ? problem.solution : problem.emission) = std::move(own);
}

}  // namespace radcert::python
