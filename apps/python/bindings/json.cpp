// SPDX-License-Identifier: GPL-3.0-or-later
#include "json.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "exact.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/formats/json/json_document.h"

namespace radcert::python {

namespace {

constexpr const char* allowed =
    "a number, a text, an expression, True, False, None, a list or a dict of these";

JsonValue json_at(const py::handle& object, const std::string& pointer, std::size_t depth);

JsonValue object_at(const py::handle& object, const std::string& pointer, std::size_t depth) {
  JsonValue out = JsonValue::object();
  // A list of its own: what the values run when they are read may change the dict.
  const auto items = py::reinterpret_steal<py::list>(PyDict_Items(object.ptr()));
  for (const py::handle& item : items) {
    const auto pair = py::reinterpret_borrow<py::tuple>(item);
    const py::object key = pair[0];
    const py::object value = pair[1];
    if (!py::isinstance<py::str>(key))
      throw InputError({.pointer = pointer,
                        .value = std::string(py::repr(key)),
                        .problem = "is a key and no text",
                        .allowed = "a dict with texts as keys"});
    const std::string name = py::str(key);
    out.set(name, json_at(value, pointer_below(pointer, name), depth + 1));
  }
  return out;
}

JsonValue array_at(const py::handle& object, const std::string& pointer, std::size_t depth) {
  JsonValue out = JsonValue::array();
  std::size_t place = 0;
  for (const py::handle& element : object) {
    out.push(json_at(element, pointer_below(pointer, place), depth + 1));
    ++place;
  }
  return out;
}

JsonValue number_at(const py::handle& object, const std::string& pointer) {
  if (PyFloat_Check(object.ptr()) != 0) {
    const double value = PyFloat_AS_DOUBLE(object.ptr());
    if (!std::isfinite(value))
      throw InputError(
          {.pointer = pointer, .value = shortest(value), .problem = "is not finite", .allowed = "numbers"});
    return value;
  }
  if (PyLong_Check(object.ptr()) != 0) {
    int overflow = 0;
    const long long whole = PyLong_AsLongLongAndOverflow(object.ptr(), &overflow);
    if (overflow == 0) return static_cast<std::int64_t>(whole);
  }
  return exact_text_of(object, pointer, allowed);
}

JsonValue json_at(const py::handle& object, const std::string& pointer, std::size_t depth) {
  if (depth > json_depth_limit)
    throw InputError({.pointer = pointer,
                      .problem = "is nested too deeply",
                      .allowed = "at most " + std::to_string(json_depth_limit) + " levels"});
  if (object.is_none()) return {};
  if (PyBool_Check(object.ptr()) != 0) return object.ptr() == Py_True;
  if (py::isinstance<py::str>(object)) return std::string(py::str(object));
  if (py::hasattr(object, "_radcert_text")) return std::string(py::str(object.attr("_radcert_text")));
  if (py::isinstance<py::dict>(object)) return object_at(object, pointer, depth);
  if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object))
    return array_at(object, pointer, depth);
  // NumPy's arrays and scalars as Python's own.
  if (py::hasattr(object, "tolist")) {
    const py::object plain = object.attr("tolist")();
    if (!plain.is(object)) return json_at(plain, pointer, depth + 1);
  }
  return number_at(object, pointer);
}

}  // namespace

JsonValue json_of(const py::handle& object, const std::string& pointer) {
  return json_at(object, pointer, 0);
}

py::object object_of(const JsonValue& value) {
  if (value.is_null()) return py::none();
  if (const bool* truth = value.boolean()) return py::bool_(*truth);
  if (const std::string* text = value.string()) return py::str(*text);
  if (const auto* elements = value.elements()) {
    py::list out;
    for (const JsonValue& element : *elements) out.append(object_of(element));
    return out;
  }
  if (const auto* members = value.members()) {
    py::dict out;
    for (const JsonValue::Member& member : *members) out[py::str(member.key)] = object_of(member.value);
    return out;
  }
  if (const auto whole = value.signed_whole()) return py::int_(*whole);
  if (const auto whole = value.unsigned_whole()) return py::int_(*whole);
  return py::float_(value.number().value_or(0));
}

}  // namespace radcert::python
