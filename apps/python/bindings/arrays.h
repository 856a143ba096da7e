// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "python.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/approximation.h"

namespace radcert::python {

using DoubleArray = py::array_t<double, py::array::c_style>;
using IndexArray = py::array_t<std::int64_t, py::array::c_style>;

/// An array of real numbers as doubles in rows, without a copy where it is that already.
/// Result    InputError at `place` for what is no array of integers or floats. long double is refused: it
///           would be rounded
[[nodiscard]] DoubleArray double_array(const py::handle& object, const std::string& place,
                                       const std::string& allowed);

/// The same with the shape (n, columns).
[[nodiscard]] DoubleArray double_rows(const py::handle& object, std::size_t columns,
                                      const std::string& place);

/// An array of whole numbers with the shape (n, columns).
[[nodiscard]] IndexArray index_rows(const py::handle& object, std::size_t columns, const std::string& place);

/// A vector's numbers as an array that owns them.
template <class T>
[[nodiscard]] py::array_t<T> owning_array(std::vector<T> numbers, std::vector<py::ssize_t> shape) {
  auto* kept = new std::vector<T>(std::move(numbers));
  const py::capsule owner(kept, [](void* memory) { delete static_cast<std::vector<T>*>(memory); });
  return py::array_t<T>(std::move(shape), kept->data(), owner);
}
template <class T>
[[nodiscard]] py::array_t<T> owning_array(std::vector<T> numbers) {
  const auto count = static_cast<py::ssize_t>(numbers.size());
  return owning_array(std::move(numbers), {count});
}

/// Points as an array of the shape (n, 3).
template <class List, class Make>
[[nodiscard]] py::array_t<double> point_array(const List& list, const Make& point) {
  std::vector<double> numbers;
  numbers.reserve(3 * list.size());
  for (const auto& element : list) {
    const Vector<double> p = point(element);
    numbers.insert(numbers.end(), {p.x, p.y, p.z});
  }
  return owning_array(std::move(numbers), {static_cast<py::ssize_t>(list.size()), 3});
}

/// What a function of Python gives for an array with n rows: doubles in an array of the shape (n, behind...).
/// Result    InputError at `place` for another shape or type; what the function raises leaves; Interrupted
///           where the user has asked to stop
[[nodiscard]] DoubleArray called(const py::object& function, const py::array_t<double>& rows,
                                 const std::string& place, const std::vector<py::ssize_t>& behind,
                                 const std::string& allowed);

/// Numbers with their radii as three arrays: value, radius, guaranteed.
template <class List, class Make>
[[nodiscard]] py::tuple approximation_arrays(const List& list, const Make& number) {
  std::vector<double> values;
  std::vector<double> radii;
  py::array_t<bool> guaranteed(static_cast<py::ssize_t>(list.size()));
  auto proved = guaranteed.template mutable_unchecked<1>();
  py::ssize_t place = 0;
  for (const auto& element : list) {
    const Approximation x = number(element);
    values.push_back(x.value);
    radii.push_back(x.radius);
    proved(place) = x.guaranteed;
    ++place;
  }
  return py::make_tuple(owning_array(std::move(values)), owning_array(std::move(radii)), guaranteed);
}

/// The name of a type and the shape of an array, for messages: "float64 (3, 4)".
[[nodiscard]] std::string array_words(const py::array& array);

}  // namespace radcert::python
