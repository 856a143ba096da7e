// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/certificate_json.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/result/certificate_parts.h"

namespace radcert {
namespace {

using certificate::BoundAtDistance;
using certificate::Claim;
using certificate::Element;
using certificate::EllipsoidCertificate;
using certificate::Face;
using certificate::Point;
using certificate::PolyhedronCertificate;

constexpr int most_degree = 12;
/// Of rho q.
constexpr int most_product_degree = 15;
JsonValue polynomial_json(const std::vector<std::vector<Rational>>& f) {
  return json_array(f, [](const std::vector<Rational>& row) {
    return json_array(row, [](const Rational& x) { return JsonValue(x.to_text()); });
  });
}

JsonValue face_json(const Face& face, const PolyhedronCertificate& c) {
  JsonValue reflectivity = face.reflectivity.to_text();
  if (!face.varying_reflectivity.empty())
    reflectivity = JsonValue::object({{"largest", face.reflectivity.to_text()},
                                      {"polynomial", polynomial_json(face.varying_reflectivity)}});
  return JsonValue::object({{"piece", c.pieces[face.piece]},
                            {"corners", json_array(face.corners, point_json)},
                            {"reflectivity", std::move(reflectivity)},
                            {"emission", polynomial_json(face.emission)}});
}

JsonValue element_json(const Element& x) {
  return JsonValue::array({x.face, x.side, x.s0, x.s1, x.t0, x.t1});
}

/// What is enclosed, and the name of the list of it.
const char* kind_of(const PolyhedronCertificate& c) {
  return c.of_function() ? "function" : c.of_values() ? "values" : "means";
}

JsonValue function_json(const PolyhedronCertificate& c) {
  return JsonValue::object(
      {{"outside", c.outside.to_text()},
       {"by_distance", json_array(c.by_distance, [](const BoundAtDistance& bound) {
          return JsonValue::object({{"outside", bound.outside.to_text()}, {"sup", double_text(bound.sup)}});
        })}});
}

JsonValue enclosures_json(const PolyhedronCertificate& c) {
  JsonValue out = JsonValue::array();
  for (std::size_t k = 0; k < c.enclosures.size(); ++k) {
    JsonValue enclosure = JsonValue::object();
    if (c.of_values())
      enclosure.set("at", point_json(c.points[k].at));
    else
      enclosure.set("piece", c.pieces[k]);
    enclosure.set("midpoint", double_text(c.enclosures[k].midpoint));
    enclosure.set("radius", double_text(c.enclosures[k].radius));
    out.push(std::move(enclosure));
  }
  return out;
}

JsonValue claim_json(const Claim& claim) {
  return JsonValue::object({{"norms", json_array(claim.norms)},
                            {"products", json_array(claim.products)},
                            {"radii", json_array(claim.radii)}});
}

JsonValue content_json(const PolyhedronCertificate& c, const std::string& command) {
  JsonValue out = document_head("certificate", command);
  out.set("of", kind_of(c));
  JsonValue problem = JsonValue::object(
      {{"pieces", json_array(c.pieces)},
       {"faces", json_array(c.faces, [&](const Face& face) { return face_json(face, c); })}});
  if (c.of_values())
    problem.set("points", json_array(c.points, [](const Point& point) {
                  return JsonValue::object({{"face", point.face}, {"at", point_json(point.at)}});
                }));
  out.set("problem", std::move(problem));
  out.set("elements", json_array(c.elements, element_json));
  out.set("degree", c.degree);
  const std::size_t size = c.elements.size() * c.powers() * c.powers();
  JsonValue coefficients = JsonValue::array();
  for (std::size_t k = 0; k < c.functions(); ++k)
    coefficients.push(bits_text({c.coefficients.data() + k * size, size}));
  out.set("coefficients", std::move(coefficients));
  if (c.of_function()) {
    out.set("claims", json_array(c.claims, [](const Claim& claim) {
              return JsonValue::object({{"largest", claim.largest}});
            }));
  } else {
    out.set("claims", json_array(c.claims, claim_json));
    out.set("sums", claim_json({c.sums.norms, c.sums.products, c.sums.radii}));
  }
  out.set(kind_of(c), c.of_function() ? function_json(c) : enclosures_json(c));
  out.set("width", double_text(c.width));
  return out;
}

std::vector<double> numbers(const JsonReader& list, std::size_t count, bool may_be_negative) {
  const std::string what = "a list of " + std::to_string(count) + " numbers";
  std::vector<double> out;
  for (const JsonReader& element : list.elements(what)) {
    out.push_back(number_from(element));
    if (!may_be_negative && !(out.back() >= 0)) element.refuse("is negative", "0 or more");
  }
  if (out.size() != count) list.refuse("has " + std::to_string(out.size()) + " numbers", what);
  return out;
}

std::size_t place_of(const JsonReader& reader, const std::vector<std::string>& pieces) {
  const std::string& name = reader.word(pieces);
  return static_cast<std::size_t>(std::find(pieces.begin(), pieces.end(), name) - pieces.begin());
}

/// Coefficients by the powers of x and y.
std::vector<std::vector<Rational>> polynomial_from(const JsonReader& reader) {
  std::vector<std::vector<Rational>> out;
  for (const JsonReader& row : reader.elements("a list of lists of coefficients")) {
    out.emplace_back();
    for (const JsonReader& x : row.elements("a list of coefficients")) out.back().push_back(exact_number(x));
  }
  const std::size_t rows = out.size();
  const std::string shape =
      "n + 1 lists of n + 1, n, ..., 1 coefficients, n at most " + std::to_string(most_degree);
  if (rows == 0 || rows > most_degree + 1) reader.refuse("is no polynomial", shape);
  for (std::size_t i = 0; i < rows; ++i)
    if (out[i].size() != rows - i) reader.refuse("is no polynomial", shape);
  return out;
}

Face read_face(const JsonReader& reader, const std::vector<std::string>& pieces) {
  reader.require_object({"piece", "corners", "reflectivity", "emission"});
  Face face{.piece = place_of(reader.at("piece", "the name of a piece"), pieces),
            .corners = {},
            .reflectivity = {},
            .emission = {}};
  const JsonReader corners = reader.at("corners", "a list of points");
  for (const JsonReader& corner : corners.elements("a list of points"))
    face.corners.push_back(exact_point(corner));
  if (face.corners.size() < 3) corners.refuse("are too few", "three corners or more");
  const JsonReader reflectivity = reader.at("reflectivity", "an exact number, or a polynomial");
  if (reflectivity.value().members() != nullptr) {
    reflectivity.require_object({"largest", "polynomial"});
    face.reflectivity = exact_number(reflectivity.at("largest", "an exact number"));
    face.varying_reflectivity = polynomial_from(reflectivity.at("polynomial", "lists of coefficients"));
  } else {
    face.reflectivity = exact_number(reflectivity);
  }
  face.emission = polynomial_from(reader.at("emission", "coefficients, by the powers of x and y"));
  return face;
}

Element read_element(const JsonReader& reader, const std::vector<Face>& faces) {
  const std::string what = "face, side, s0, s1, t0, t1";
  const std::vector<JsonReader> x = reader.elements(what);
  if (x.size() != 6) reader.refuse("is no element", what);
  const auto face = static_cast<std::size_t>(
      x[0].whole(0, static_cast<std::int64_t>(faces.size()) - 1, "the number of a face"));
  const auto side = static_cast<std::size_t>(
      x[1].whole(0, static_cast<std::int64_t>(faces[face].corners.size()) - 1, "the number of a side"));
  Element out{.face = face,
              .side = side,
              .s0 = number_from(x[2]),
              .s1 = number_from(x[3]),
              .t0 = number_from(x[4]),
              .t1 = number_from(x[5])};
  for (std::size_t k = 2; k < 6; ++k) {
    const double at = number_from(x[k]);
    // Halves of them stay exact.
    if (!(at >= 0 && at <= 1) || std::ldexp(at, 40) != std::floor(std::ldexp(at, 40)))
      x[k].refuse("is no parameter", "a multiple of 2^-40 from 0 to 1");
  }
  return out;
}

Claim read_largest(const JsonReader& reader) {
  reader.require_object({"largest"});
  const JsonReader largest = reader.at("largest", "a number");
  Claim claim{.largest = number_from(largest)};
  if (!(claim.largest >= 0)) largest.refuse("is negative", "0 or more");
  return claim;
}

void read_function(const JsonReader& reader, PolyhedronCertificate& c) {
  reader.require_object({"outside", "by_distance"});
  c.outside = exact_number(reader.at("outside", "an exact number"));
  const JsonReader list = reader.at("by_distance", "a list of bounds");
  for (const JsonReader& bound : list.elements("a list of bounds")) {
    bound.require_object({"outside", "sup"});
    const JsonReader outside = bound.at("outside", "an exact number");
    const JsonReader sup = bound.at("sup", "a decimal");
    c.by_distance.push_back({exact_number(outside), decimal_from(sup)});
    if (c.by_distance.back().outside.sign() < 0) outside.refuse("is negative", "0 or more");
    if (c.by_distance.back().sup.sign() < 0) sup.refuse("is negative", "0 or more");
  }
  if (c.by_distance.empty() || c.by_distance.size() > certificate::most_distances)
    list.refuse("has " + std::to_string(c.by_distance.size()) + " bounds",
                "from 1 to " + std::to_string(certificate::most_distances));
}

Claim read_claim(const JsonReader& reader, std::size_t goals) {
  reader.require_object({"norms", "products", "radii"});
  return {numbers(reader.at("norms", "a list of numbers"), goals + 1, false),
          numbers(reader.at("products", "a list of numbers"), goals, true),
          numbers(reader.at("radii", "a list of numbers"), goals, false)};
}

PolyhedronCertificate read_polyhedron_content(const JsonReader& reader) {
  PolyhedronCertificate c;
  const std::string& list =
      reader.at("of", "what is enclosed").word(std::vector<std::string>{"means", "values", "function"});
  const bool of_values = list == "values";
  const bool of_function = list == "function";
  std::vector<std::string> members{"schema", "radcert",      "command", "of", "problem", "elements",
                                   "degree", "coefficients", "claims",  list, "width",   "digest"};
  if (!of_function) members.emplace_back("sums");
  reader.require_object(members);
  const JsonReader problem = reader.at("problem", "pieces and faces");
  if (of_values)
    problem.require_object({"pieces", "faces", "points"});
  else
    problem.require_object({"pieces", "faces"});
  for (const JsonReader& name : problem.at("pieces", "a list of names").elements("a list of names")) {
    const std::string word = name_from(name);
    if (std::find(c.pieces.begin(), c.pieces.end(), word) != c.pieces.end())
      name.refuse("is there twice", "each name once");
    c.pieces.push_back(word);
  }
  const JsonReader faces = problem.at("faces", "a list of faces");
  for (const JsonReader& face : faces.elements("a list of faces"))
    c.faces.push_back(read_face(face, c.pieces));
  if (c.faces.size() < 4) faces.refuse("are too few", "the faces of a closed surface");
  if (of_values) {
    const JsonReader points = problem.at("points", "a list of points");
    for (const JsonReader& point : points.elements("a list of points")) {
      point.require_object({"face", "at"});
      const auto face = static_cast<std::size_t>(
          point.at("face", "the number of a face")
              .whole(0, static_cast<std::int64_t>(c.faces.size()) - 1, "the number of a face"));
      c.points.push_back({face, exact_point(point.at("at", "three coordinates"))});
    }
    if (c.points.empty()) points.refuse("has no point", "one point or more");
  }
  if (of_function) read_function(reader.at("function", "bounds by the distance"), c);
  const JsonReader elements = reader.at("elements", "a list of elements");
  for (const JsonReader& element : elements.elements("a list of elements"))
    c.elements.push_back(read_element(element, c.faces));
  c.degree =
      static_cast<int>(reader.at("degree", "the degree of the functions")
                           .whole(0, most_degree, "a whole number from 0 to " + std::to_string(most_degree)));
  for (std::size_t k = 0; k < c.faces.size(); ++k)
    if (c.degree + static_cast<int>(c.faces[k].varying_reflectivity.size()) - 1 > most_product_degree)
      reader.at("degree", "the degree of the functions")
          .refuse("and that of a reflectivity are too much together",
                  std::to_string(most_product_degree) + " or less in all");
  const JsonReader coefficients = reader.at("coefficients", "a string for each function");
  const std::vector<JsonReader> functions = coefficients.elements("a string for each function");
  if (functions.size() != c.functions())
    coefficients.refuse("has " + std::to_string(functions.size()) + " functions",
                        "one, and one for each piece or point");
  for (const JsonReader& function : functions)
    read_bits(function, c.elements.size() * c.powers() * c.powers(), c.coefficients);
  const JsonReader claims = reader.at("claims", "a claim for each element");
  for (const JsonReader& claim : claims.elements("a claim for each element"))
    c.claims.push_back(of_function ? read_largest(claim) : read_claim(claim, c.goals()));
  if (c.claims.size() != c.elements.size())
    claims.refuse("has " + std::to_string(c.claims.size()) + " claims", "one for each element");
  c.width = decimal_from(reader.at("width", "a decimal"));
  if (of_function) return c;
  Claim sums = read_claim(reader.at("sums", "norms, products and radii"), c.goals());
  c.sums = {std::move(sums.norms), std::move(sums.products), std::move(sums.radii)};
  const std::string each = of_values ? "an enclosure for each point" : "an enclosure for each piece";
  const JsonReader found = reader.at(list, each);
  const std::vector<JsonReader> enclosures = found.elements(each);
  if (enclosures.size() != c.goals())
    found.refuse("has " + std::to_string(enclosures.size()) + " enclosures", each + ", in their order");
  for (std::size_t k = 0; k < enclosures.size(); ++k) {
    if (of_values) {
      enclosures[k].require_object({"at", "midpoint", "radius"});
      const JsonReader at = enclosures[k].at("at", "three coordinates");
      if (!(exact_point(at) == c.points[k].at)) at.refuse("is not the point of this place", "the same point");
    } else {
      enclosures[k].require_object({"piece", "midpoint", "radius"});
      const JsonReader piece = enclosures[k].at("piece", "the name of a piece");
      if (place_of(piece, c.pieces) != k) piece.refuse("is not the piece of this place", c.pieces[k]);
    }
    c.enclosures.push_back(read_enclosure(enclosures[k]));
  }
  return c;
}

certificate::Certificate read_content(const JsonReader& reader) {
  if (reader.at("problem", "the equation").find("half_axes")) return read_ellipsoid_content(reader);
  return read_polyhedron_content(reader);
}

JsonValue content_json(const EllipsoidCertificate& c, const std::string& command) {
  return ellipsoid_content_json(c, command);
}

/// What the digest is of.
std::string without_digest(const JsonValue& document) {
  JsonValue out = JsonValue::object();
  for (const JsonValue::Member& member : *document.members())
    if (member.key != "digest") out.set(member.key, member.value);
  return out.compact();
}

}  // namespace

std::string certificate_text(const certificate::Certificate& certificate, const std::string& command) {
  JsonValue out = std::visit([&](const auto& c) { return content_json(c, command); }, certificate);
  out.set("digest", digest_of(out.compact()));
  return out.compact() + "\n";
}

ReadCertificate read_certificate(std::string_view text, const std::string& source) {
  const JsonValue document = parse_json(text, source);
  return with_source(source, [&] {
    const JsonReader reader(document);
    reader.require_schema("radcert/certificate/1", "a certificate");
    ReadCertificate out{.certificate = read_content(reader), .digest = digest_of(without_digest(document))};
    out.digest_holds = reader.at("digest", "the digest of the content").string("a digest") == out.digest;
    return out;
  });
}

certificate::Certificate intact_certificate(std::string_view text, const std::string& source) {
  ReadCertificate read = read_certificate(text, source);
  if (!read.digest_holds)
    throw InputError({.source = source, .pointer = "/digest", .problem = "is not that of the content"});
  return std::move(read.certificate);
}

}  // namespace radcert
