// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact.h"

#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::python {

namespace {

[[noreturn]] void refuse(const std::string& place, std::string value, std::string problem,
                         const std::string& allowed) {
  throw InputError(
      {.pointer = place, .value = std::move(value), .problem = std::move(problem), .allowed = allowed});
}

bool is_of(const py::handle& object, const char* module, const char* name) {
  return py::isinstance(object, py::module_::import(module).attr(name));
}

/// 2^exponent mantissa as a Fraction.
py::object binary_fraction(const BinaryNumber& number) {
  const py::object whole = py::module_::import("builtins").attr("int");
  const py::object fraction = py::module_::import("fractions").attr("Fraction");
  const py::object mantissa = whole(number.mantissa);
  const py::object exponent = whole(number.exponent);
  const py::object power = py::int_(2).attr("__pow__")(py::module_::import("builtins").attr("abs")(exponent));
  return exponent.cast<py::int_>() < py::int_(0) ? fraction(mantissa, power) : fraction(mantissa * power);
}

py::tuple binary_pair(const BinaryNumber& number) {
  const py::object whole = py::module_::import("builtins").attr("int");
  return py::make_tuple(whole(number.mantissa), whole(number.exponent));
}

const Ball& finite(const Ball& ball) {
  if (!ball.is_finite())
    throw AccuracyNotReached("a ball", "it is the whole line: " + std::string(ball.failure()));
  return ball;
}

}  // namespace

std::string kind_of(const py::handle& object) {
  if (object.is_none()) return "None";
  return "of the type " + std::string(py::str(py::type::handle_of(object).attr("__name__")));
}

Rational rational_of(const py::handle& number, const std::string& place, const std::string& allowed) {
  if (PyBool_Check(number.ptr()) != 0) refuse(place, std::string(py::str(number)), "is no number", allowed);
  if (is_of(number, "numpy", "longdouble"))
    refuse(place, std::string(py::str(number)), "is " + kind_of(number) + ", which no float holds",
           allowed + "; float(x) rounds it");
  if (PyFloat_Check(number.ptr()) != 0 || is_of(number, "numpy", "floating")) {
    const double value = py::float_(py::reinterpret_borrow<py::object>(number));
    if (!std::isfinite(value)) refuse(place, shortest(value), "is not finite", allowed);
    return Rational::exactly(value);
  }
  std::string text;
  if (py::isinstance<py::str>(number)) {
    text = std::string(py::str(number));
  } else if (PyIndex_Check(number.ptr()) != 0) {
    const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(number.ptr()));
    if (!whole) {
      py::error_already_set error;
      if (!error.matches(PyExc_TypeError)) throw error;
      refuse(place, std::string(py::repr(number)), "is " + kind_of(number), allowed);
    }
    text = std::string(py::str(whole));
  } else if (is_of(number, "fractions", "Fraction") || is_of(number, "decimal", "Decimal")) {
    text = std::string(py::str(number));
  } else {
    refuse(place, std::string(py::repr(number)), "is " + kind_of(number), allowed);
  }
  Outcome<Rational> value = Rational::parse(text);
  if (!value) refuse(place, text, "is no number: " + value.reason(), allowed);
  return std::move(value).value();
}

std::string exact_text_of(const py::handle& number, const std::string& place, const std::string& allowed) {
  return rational_of(number, place, allowed).to_text();
}

py::object fraction_of(const Rational& number) {
  return py::module_::import("fractions").attr("Fraction")(number.to_text());
}

void add_exact(py::module_& module) {
  module.def("exact_text", [](const py::handle& number, const std::string& place) {
    return exact_text_of(number, place,
                         "an int, a Fraction, a Decimal, a finite float, or a text like \"1/3\"");
  });
  module.def(
      "upper_text", [](double bound) { return upper_text(bound); }, "A bound from above in decimal");
  py::class_<Ball>(
      module, "Ball",
      "A real number enclosed: it is proved to lie within `radius` of `midpoint`.\n\n"
      "Fractions and pairs (mantissa, exponent) are exact, decimals and floats are rounded outwards.")
      .def_property_readonly(
          "midpoint", [](const Ball& ball) { return binary_fraction(finite(ball).midpoint_binary()); },
          "fractions.Fraction, exactly")
      .def_property_readonly(
          "radius", [](const Ball& ball) { return binary_fraction(finite(ball).radius_binary()); },
          "fractions.Fraction, exactly")
      .def_property_readonly(
          "midpoint_binary", [](const Ball& ball) { return binary_pair(finite(ball).midpoint_binary()); },
          "(mantissa, exponent): mantissa 2^exponent, exactly")
      .def_property_readonly(
          "radius_binary", [](const Ball& ball) { return binary_pair(finite(ball).radius_binary()); },
          "(mantissa, exponent): mantissa 2^exponent, exactly")
      .def_property_readonly("is_exact", [](const Ball& ball) { return ball.is_exact(); })
      .def(
          "decimal",
          [](const Ball& ball, int digits) {
            constexpr int most = 100'000;
            if (digits < 1 || digits > most)
              throw InputError({.source = "digits",
                                .value = std::to_string(digits),
                                .allowed = "a whole number from 1 to 100000"});
            const BallDecimal text = finite(ball).decimal(digits);
            return py::make_tuple(text.midpoint, text.radius);
          },
          py::arg("digits") = 20, "(midpoint, radius) as decimals that enclose the ball")
      .def(
          "float_ball",
          [](const Ball& ball) {
            const Approximation rounded = enclosing(finite(ball));
            return py::make_tuple(rounded.value, rounded.radius);
          },
          "(value, radius) as floats that enclose the ball")
      .def(
          "bounds", [](const Ball& ball) { return py::make_tuple(ball.lower_double(), ball.upper_double()); },
          "(lower, upper) as floats about the ball, infinite where it is not bounded")
      .def("__float__", [](const Ball& ball) { return finite(ball).to_double(); })
      .def(
          "contains",
          [](const Ball& ball, const py::handle& number) {
            return ball.contains(rational_of(number, "number", "an exact number or a float"));
          },
          py::arg("number"), "Whether an exact number lies in the ball")
      .def(
          "overlaps", [](const Ball& a, const Ball& b) { return overlaps(a, b); }, py::arg("other"),
          "Whether both have a number in common")
      .def("__repr__", [](const Ball& ball) { return "<Ball " + ball.to_text(20) + ">"; })
      .def("__str__", [](const Ball& ball) { return ball.to_text(20); });
}

}  // namespace radcert::python
