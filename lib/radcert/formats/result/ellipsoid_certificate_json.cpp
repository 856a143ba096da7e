// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/result/certificate_parts.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {
namespace {

using certificate::EllipsoidCertificate;
using certificate::Monomial;
using certificate::OnEllipsoid;

const std::vector<std::string> kinds{"means", "values", "function"};

std::string upper_decimal(const Rational& x) { return upper_text(x, DecimalForm::general(12)); }

JsonValue polynomial_json(const std::vector<Monomial>& f) {
  return json_array(f, [](const Monomial& x) {
    return JsonValue::array({x.powers[0], x.powers[1], x.powers[2], x.coefficient.to_text()});
  });
}

std::vector<Monomial> polynomial_from(const JsonReader& reader, int most) {
  const std::string what = "a list of monomials, the powers of x, y and z and a coefficient";
  std::vector<Monomial> out;
  for (const JsonReader& monomial : reader.elements(what)) {
    const std::vector<JsonReader> x = monomial.elements(what);
    if (x.size() != 4) monomial.refuse("is no monomial", "three powers and a coefficient");
    Monomial read;
    int sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      read.powers[axis] =
          static_cast<int>(x[axis].whole(0, certificate::most_sphere_powers, "a power of a coordinate"));
      sum += read.powers[axis];
    }
    if (sum > most) monomial.refuse("has too high a degree", std::to_string(most) + " or less");
    read.coefficient = exact_number(x[3]);
    out.push_back(std::move(read));
  }
  return out;
}

Rational bound_from(const JsonReader& reader) {
  Rational out = decimal_from(reader);
  if (out.sign() < 0) reader.refuse("is negative", "0 or more");
  return out;
}

void read_problem(const JsonReader& problem, EllipsoidCertificate& c) {
  if (c.of == OnEllipsoid::values)
    problem.require_object({"piece", "half_axes", "reflectivity", "emission", "points"});
  else
    problem.require_object({"piece", "half_axes", "reflectivity", "emission"});
  c.piece = name_from(problem.at("piece", "a name"));
  const JsonReader axes = problem.at("half_axes", "three half axes");
  c.half_axes = exact_point(axes);
  for (const Rational* const axis : {&c.half_axes.x, &c.half_axes.y, &c.half_axes.z})
    if (axis->sign() <= 0) axes.refuse("has a half axis that is not positive", "three positive numbers");
  c.reflectivity = polynomial_from(problem.at("reflectivity", "a list of monomials"),
                                   certificate::most_reflectivity_powers);
  c.emission =
      polynomial_from(problem.at("emission", "a list of monomials"), certificate::most_sphere_powers);
  if (c.of != OnEllipsoid::values) return;
  const JsonReader points = problem.at("points", "a list of points");
  for (const JsonReader& point : points.elements("a list of points")) c.points.push_back(exact_point(point));
  if (c.points.empty()) points.refuse("has no point", "one point or more");
}

}  // namespace

JsonValue ellipsoid_content_json(const EllipsoidCertificate& c, const std::string& command) {
  JsonValue out = document_head("certificate", command);
  out.set("of", kinds[static_cast<std::size_t>(c.of)]);
  JsonValue problem = JsonValue::object({{"piece", c.piece},
                                         {"half_axes", point_json(c.half_axes)},
                                         {"reflectivity", polynomial_json(c.reflectivity)},
                                         {"emission", polynomial_json(c.emission)}});
  if (c.of == OnEllipsoid::values) problem.set("points", json_array(c.points, point_json));
  out.set("problem", std::move(problem));
  out.set("degree", c.degree);
  JsonValue coefficients = JsonValue::array();
  coefficients.push(bits_text(c.cosines));
  coefficients.push(bits_text(c.sines));
  out.set("coefficients", std::move(coefficients));
  out.set("largest_reflectivity", c.largest_reflectivity.to_text());
  out.set("residual", c.residual);
  out.set("bound", upper_decimal(c.bound));
  JsonValue enclosures = JsonValue::array();
  for (std::size_t k = 0; k < c.enclosures.size(); ++k) {
    JsonValue enclosure = JsonValue::object();
    if (c.of == OnEllipsoid::values)
      enclosure.set("at", point_json(c.points[k]));
    else
      enclosure.set("piece", c.piece);
    enclosure.set("midpoint", double_text(c.enclosures[k].midpoint));
    enclosure.set("radius", double_text(c.enclosures[k].radius));
    enclosures.push(std::move(enclosure));
  }
  if (c.of != OnEllipsoid::function) out.set(kinds[static_cast<std::size_t>(c.of)], std::move(enclosures));
  out.set("width", upper_decimal(c.width));
  return out;
}

EllipsoidCertificate read_ellipsoid_content(const JsonReader& reader) {
  EllipsoidCertificate c;
  const std::string& of = reader.at("of", "what is enclosed").word(kinds);
  c.of = of == "means" ? OnEllipsoid::mean : of == "values" ? OnEllipsoid::values : OnEllipsoid::function;
  const bool has_numbers = c.of != OnEllipsoid::function;
  if (has_numbers)
    reader.require_object({"schema", "radcert", "command", "of", "problem", "degree", "coefficients",
                           "largest_reflectivity", "residual", "bound", of, "width", "digest"});
  else
    reader.require_object({"schema", "radcert", "command", "of", "problem", "degree", "coefficients",
                           "largest_reflectivity", "residual", "bound", "width", "digest"});
  read_problem(reader.at("problem", "the equation"), c);
  const JsonReader degree = reader.at("degree", "the degree of q");
  c.degree = static_cast<int>(degree.whole(0, certificate::most_sphere_powers, "the degree of q"));
  const JsonReader coefficients = reader.at("coefficients", "two strings");
  const std::vector<JsonReader> kinds_of = coefficients.elements("two strings");
  if (kinds_of.size() != 2) coefficients.refuse("is not of cosines and sines", "two strings");
  read_bits(kinds_of[0], EllipsoidCertificate::count(c.degree), c.cosines);
  read_bits(kinds_of[1], EllipsoidCertificate::count(c.degree), c.sines);
  c.largest_reflectivity = decimal_from(reader.at("largest_reflectivity", "a bound of the reflectivity"));
  const JsonReader residual = reader.at("residual", "a bound of the residual");
  c.residual = number_from(residual);
  if (!(c.residual >= 0)) residual.refuse("is negative", "0 or more");
  c.bound = bound_from(reader.at("bound", "a decimal"));
  if (has_numbers) {
    const JsonReader found = reader.at(of, "a list of enclosures");
    const std::size_t count = c.of == OnEllipsoid::values ? c.points.size() : 1;
    const std::vector<JsonReader> enclosures = found.elements("a list of enclosures");
    if (enclosures.size() != count)
      found.refuse("has " + std::to_string(enclosures.size()) + " enclosures",
                   std::to_string(count) + " of them");
    for (std::size_t k = 0; k < count; ++k) {
      if (c.of == OnEllipsoid::values) {
        enclosures[k].require_object({"at", "midpoint", "radius"});
        const JsonReader at = enclosures[k].at("at", "three coordinates");
        if (!(exact_point(at) == c.points[k])) at.refuse("is not the point of this place", "the same point");
      } else {
        enclosures[k].require_object({"piece", "midpoint", "radius"});
        const JsonReader piece = enclosures[k].at("piece", "the name of the piece");
        if (piece.string("a name") != c.piece) piece.refuse("is not the piece", c.piece);
      }
      c.enclosures.push_back(read_enclosure(enclosures[k]));
    }
  }
  c.width = bound_from(reader.at("width", "a decimal"));
  return c;
}

}  // namespace radcert
