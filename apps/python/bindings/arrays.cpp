// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <algorithm>

#include "exact.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"

namespace radcert::python {

namespace {

[[noreturn]] void refuse(const std::string& place, const std::string& value, const std::string& problem,
                         const std::string& allowed) {
  throw InputError({.pointer = place, .value = value, .problem = problem, .allowed = allowed});
}

/// Any object as NumPy reads it.
py::array any_array(const py::handle& object, const std::string& place, const std::string& allowed) {
  if (py::isinstance<py::str>(object) || object.is_none())
    refuse(place, std::string(py::str(object)), "is " + kind_of(object), allowed);
  // NumPy would read what the mask hides.
  if (py::hasattr(object, "mask") && py::hasattr(object, "filled"))
    refuse(place, kind_of(object), "is a masked array", allowed + ", all of whose numbers count");
  try {
    return py::module_::import("numpy").attr("asarray")(object).cast<py::array>();
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    refuse(place, kind_of(object), "is no array: " + std::string(py::str(error.value())), allowed);
  }
}

void require_rows(const py::array& array, std::size_t columns, const std::string& place) {
  if (array.ndim() == 2 && array.shape(1) == static_cast<py::ssize_t>(columns)) return;
  refuse(place, array_words(array), "has another shape",
         "an array of the shape (n, " + std::to_string(columns) + ")");
}

}  // namespace

std::string array_words(const py::array& array) {
  return std::string(py::str(array.dtype())) + " " + std::string(py::str(array.attr("shape")));
}

DoubleArray double_array(const py::handle& object, const std::string& place, const std::string& allowed) {
  const py::array array = any_array(object, place, allowed);
  const char kind = array.dtype().kind();
  constexpr py::ssize_t eight = 8;
  const bool is_float = kind == 'f' && array.dtype().itemsize() <= eight;
  if (!is_float && kind != 'i' && kind != 'u')
    refuse(place, array_words(array), "is no array of doubles", allowed);
  // A whole number from 2^53 on may have been rounded: a check costs little beside what follows.
  DoubleArray doubles = DoubleArray::ensure(array);
  if (!doubles) refuse(place, array_words(array), "is no array of doubles", allowed);
  if (!is_float && array.size() > 0) {
    const py::module_ numpy = py::module_::import("numpy");
    if (numpy.attr("abs")(doubles).attr("max")().cast<double>() >= 0x1p53)
      refuse(place, array_words(array), "has whole numbers from 2^53 on, not all of which doubles hold",
             allowed);
  }
  return doubles;
}

DoubleArray double_rows(const py::handle& object, std::size_t columns, const std::string& place) {
  const DoubleArray array =
      double_array(object, place, "an array of doubles of the shape (n, " + std::to_string(columns) + ")");
  require_rows(array, columns, place);
  return array;
}

DoubleArray called(const py::object& function, const py::array_t<double>& rows, const std::string& place,
                   const std::vector<py::ssize_t>& behind, const std::string& allowed) {
  throw_if_interrupted();  // a sum may call it a thousand times
  const DoubleArray found = double_array(function(rows), place, allowed);
  std::vector<py::ssize_t> shape{rows.shape(0)};
  shape.insert(shape.end(), behind.begin(), behind.end());
  if (!std::equal(shape.begin(), shape.end(), found.shape(), found.shape() + found.ndim()))
    refuse(place, array_words(found),
           "has another shape, for an array (" + std::to_string(rows.shape(0)) + ", " +
               std::to_string(rows.shape(1)) + ")",
           allowed);
  return found;
}

IndexArray index_rows(const py::handle& object, std::size_t columns, const std::string& place) {
  const std::string allowed = "an array of whole numbers of the shape (n, " + std::to_string(columns) + ")";
  const py::array array = any_array(object, place, allowed);
  const char kind = array.dtype().kind();
  if (array.size() > 0 && kind != 'i' && kind != 'u')
    refuse(place, array_words(array), "is no array of whole numbers", allowed);
  require_rows(array, columns, place);
  // Unsigned numbers beyond 2^63 become negative, which no index is.
  const IndexArray indices = IndexArray::ensure(array);
  return indices ? indices : IndexArray::ensure(array.attr("astype")("int64"));
}

}  // namespace radcert::python
