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

namespace radcert {
namespace {

using certificate::Claim;
using certificate::Element;
using certificate::Enclosure;
using certificate::Face;
using certificate::Point;
using certificate::PolyhedronCertificate;

constexpr int most_degree = 12;
constexpr std::size_t digits_of_a_double = 16;
constexpr std::string_view hexadecimal = "0123456789abcdef";

/// Without the digits that are 0 in all of them.
std::string bits_text(std::span<const double> numbers) {
  std::uint64_t all = 0;
  for (const double x : numbers) all |= std::bit_cast<std::uint64_t>(x);
  constexpr int least_digits = 3;
  const int dropped = std::min(all == 0 ? 64 : std::countr_zero(all), 64 - 4 * least_digits) / 4;
  std::string out;
  out.reserve(numbers.size() * digits_of_a_double);
  for (const double x : numbers) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int shift = 60; shift >= 4 * dropped; shift -= 4)
      out += hexadecimal[(bits >> static_cast<unsigned>(shift)) & 15U];
  }
  return out;
}

/// The decimal that reads back as the double nearest to a number: certificate::summed leaves room for that.
std::string double_text(const Rational& value) { return shortest(value.to_double()); }

JsonValue point_json(const Vector<Rational>& p) {
  JsonValue out = JsonValue::array();
  for (const Rational& x : {p.x, p.y, p.z}) out.push(x.to_text());
  return out;
}

JsonValue face_json(const Face& face, const PolyhedronCertificate& c) {
  return JsonValue::object({{"piece", c.pieces[face.piece]},
                            {"corners", json_array(face.corners, point_json)},
                            {"reflectivity", face.reflectivity.to_text()},
                            {"emission", json_array(face.emission, [](const std::vector<Rational>& row) {
                               return json_array(row,
                                                 [](const Rational& x) { return JsonValue(x.to_text()); });
                             })}});
}

JsonValue element_json(const Element& x) {
  return JsonValue::array({x.face, x.side, x.s0, x.s1, x.t0, x.t1});
}

JsonValue claim_json(const Claim& claim) {
  return JsonValue::object({{"norms", json_array(claim.norms)},
                            {"products", json_array(claim.products)},
                            {"radii", json_array(claim.radii)}});
}

JsonValue content_json(const PolyhedronCertificate& c, const std::string& command) {
  JsonValue out = document_head("certificate", command);
  out.set("of", c.of_values() ? "values" : "means");
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
  out.set("claims", json_array(c.claims, claim_json));
  out.set("sums", claim_json({c.sums.norms, c.sums.products, c.sums.radii}));
  JsonValue enclosures = JsonValue::array();
  for (std::size_t k = 0; k < c.enclosures.size(); ++k) {
    JsonValue enclosure = JsonValue::object();
    if (c.of_values())
      enclosure.set("at", point_json(c.points[k].at));
    else
      enclosure.set("piece", c.pieces[k]);
    enclosure.set("midpoint", double_text(c.enclosures[k].midpoint));
    enclosure.set("radius", double_text(c.enclosures[k].radius));
    enclosures.push(std::move(enclosure));
  }
  out.set(c.of_values() ? "values" : "means", std::move(enclosures));
  out.set("width", double_text(c.width));
  return out;
}

constexpr const char* what_a_number_is = "a finite number";

double number_from(const JsonReader& reader) { return reader.number(what_a_number_is); }

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

/// An exact number of a size that double can work with.
Rational exact_number(const JsonReader& reader) {
  const std::string what = "a decimal or fraction in a string, 0 or from 1e-60 to 1e60 in size";
  Rational value = reader.rational(what);
  Rational most = 1;
  for (int k = 0; k < 60; ++k) most *= Rational(10);
  if (value.sign() != 0 && (abs(value) > most || abs(value) * most < Rational(1)))
    reader.refuse("is too large or too small", what);
  return value;
}

std::size_t place_of(const JsonReader& reader, const std::vector<std::string>& pieces) {
  const std::string& name = reader.word(pieces);
  return static_cast<std::size_t>(std::find(pieces.begin(), pieces.end(), name) - pieces.begin());
}

Vector<Rational> exact_point(const JsonReader& reader) {
  const std::vector<JsonReader> x = reader.elements("three coordinates");
  if (x.size() != 3) reader.refuse("is not a point", "three coordinates");
  return {exact_number(x[0]), exact_number(x[1]), exact_number(x[2])};
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
  face.reflectivity = exact_number(reader.at("reflectivity", "an exact number"));
  const JsonReader emission = reader.at("emission", "coefficients, by the powers of x and y");
  for (const JsonReader& row : emission.elements("a list of lists of coefficients")) {
    face.emission.emplace_back();
    for (const JsonReader& x : row.elements("a list of coefficients"))
      face.emission.back().push_back(exact_number(x));
  }
  const std::size_t rows = face.emission.size();
  const std::string shape =
      "n + 1 lists of n + 1, n, ..., 1 coefficients, n at most " + std::to_string(most_degree);
  if (rows == 0 || rows > most_degree + 1) emission.refuse("is no polynomial", shape);
  for (std::size_t i = 0; i < rows; ++i)
    if (face.emission[i].size() != rows - i) emission.refuse("is no polynomial", shape);
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

/// The doubles of one function.
void read_bits(const JsonReader& reader, std::size_t count, std::vector<double>& out) {
  const std::string what = std::to_string(count) +
                           " numbers, each as the first of the 16 hexadecimal digits of its 64 bits, as many "
                           "for all of them";
  const std::string& text = reader.string(what);
  const std::size_t digits = count == 0 ? 0 : text.size() / count;
  if (text.size() != count * digits || digits > digits_of_a_double || (count > 0 && digits == 0))
    reader.refuse("has " + std::to_string(text.size()) + " characters", what);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t bits = 0;
    for (std::size_t d = 0; d < digits; ++d) {
      const std::size_t digit = hexadecimal.find(text[i * digits + d]);
      if (digit == std::string_view::npos) reader.refuse("has a character that is no digit", what);
      bits = bits << 4U | digit;
    }
    bits <<= 4U * (digits_of_a_double - digits);
    const auto value = std::bit_cast<double>(bits);
    if (!(std::abs(value) <= 1e60))
      reader.refuse("has a number that is not finite or too large, number " + std::to_string(i),
                    "finite numbers of at most 1e60");
    out.push_back(value);
  }
}

Claim read_claim(const JsonReader& reader, std::size_t goals) {
  reader.require_object({"norms", "products", "radii"});
  return {numbers(reader.at("norms", "a list of numbers"), goals + 1, false),
          numbers(reader.at("products", "a list of numbers"), goals, true),
          numbers(reader.at("radii", "a list of numbers"), goals, false)};
}

PolyhedronCertificate read_content(const JsonReader& reader) {
  PolyhedronCertificate c;
  const bool of_values =
      reader.at("of", "what is enclosed").word(std::vector<std::string>{"means", "values"}) == "values";
  const std::string list = of_values ? "values" : "means";
  reader.require_object({"schema", "radcert", "command", "of", "problem", "elements", "degree",
                         "coefficients", "claims", "sums", list, "width", "digest"});
  const JsonReader problem = reader.at("problem", "pieces and faces");
  if (of_values)
    problem.require_object({"pieces", "faces", "points"});
  else
    problem.require_object({"pieces", "faces"});
  for (const JsonReader& name : problem.at("pieces", "a list of names").elements("a list of names")) {
    const std::string& word = name.string("a name");
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
  const JsonReader elements = reader.at("elements", "a list of elements");
  for (const JsonReader& element : elements.elements("a list of elements"))
    c.elements.push_back(read_element(element, c.faces));
  c.degree =
      static_cast<int>(reader.at("degree", "the degree of the functions")
                           .whole(0, most_degree, "a whole number from 0 to " + std::to_string(most_degree)));
  const JsonReader coefficients = reader.at("coefficients", "a string for each function");
  const std::vector<JsonReader> functions = coefficients.elements("a string for each function");
  if (functions.size() != c.functions())
    coefficients.refuse("has " + std::to_string(functions.size()) + " functions",
                        "one, and one for each piece or point");
  for (const JsonReader& function : functions)
    read_bits(function, c.elements.size() * c.powers() * c.powers(), c.coefficients);
  const JsonReader claims = reader.at("claims", "a claim for each element");
  for (const JsonReader& claim : claims.elements("a claim for each element"))
    c.claims.push_back(read_claim(claim, c.goals()));
  if (c.claims.size() != c.elements.size())
    claims.refuse("has " + std::to_string(c.claims.size()) + " claims", "one for each element");
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
    const JsonReader radius = enclosures[k].at("radius", "a decimal");
    c.enclosures.push_back(
        {enclosures[k].at("midpoint", "a decimal").rational("a decimal"), radius.rational("a decimal")});
    if (c.enclosures.back().radius.sign() < 0) radius.refuse("is negative", "0 or more");
  }
  c.width = reader.at("width", "a decimal").rational("a decimal");
  return c;
}

/// What the digest is of.
std::string without_digest(const JsonValue& document) {
  JsonValue out = JsonValue::object();
  for (const JsonValue::Member& member : *document.members())
    if (member.key != "digest") out.set(member.key, member.value);
  return out.compact();
}

}  // namespace

std::string certificate_text(const PolyhedronCertificate& certificate, const std::string& command) {
  JsonValue out = content_json(certificate, command);
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

PolyhedronCertificate intact_certificate(std::string_view text, const std::string& source) {
  ReadCertificate read = read_certificate(text, source);
  if (!read.digest_holds)
    throw InputError({.source = source, .pointer = "/digest", .problem = "is not that of the content"});
  return std::move(read.certificate);
}

}  // namespace radcert
