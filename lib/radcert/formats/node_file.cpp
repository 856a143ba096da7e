// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/node_file.h"

#include <string>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/formats/json_document.h"
#include "radcert/formats/json_reader.h"
#include "radcert/polynomial/lattice.h"
#include "radcert/scalar/real.h"

namespace radcert {

namespace {

constexpr const char* schema = "radcert/nodes/1";
constexpr int largest_node_degree = 12;
constexpr const char* coordinate_allowed = "a decimal or fraction in a string, from 0 to 1";

Barycentric<Rational> read_node(const JsonReader& node) {
  const std::vector<JsonReader> coordinates = node.elements("three barycentric coordinates");
  if (coordinates.size() != 3)
    node.refuse("has " + std::to_string(coordinates.size()) + " coordinates",
                "three barycentric coordinates");
  Barycentric<Rational> q;
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    q.x[i] = coordinates[i].rational(coordinate_allowed);
    if (q.x[i].sign() < 0 || q.x[i] > Rational(1))
      coordinates[i].refuse("puts the node outside the triangle", coordinate_allowed);
    sum += q.x[i];
  }
  if (sum != Rational(1))
    node.refuse("has the sum " + exact_text(sum),
                "coordinates with the exact sum 1, such as [\"0.1\", \"0.2\", \"0.7\"]");
  return q;
}

void require_different(const std::vector<JsonReader>& places,
                       const std::vector<Barycentric<Rational>>& nodes) {
  for (std::size_t j = 0; j < nodes.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (nodes[i] == nodes[j])
        places[j].refuse("is the same point as node " + std::to_string(i), "different nodes");
}

// The set that the orbits of a certificate and the first node of each describe.
SymmetricNodes symmetric_of(const JsonReader& certificate, int degree,
                            const std::vector<Barycentric<Rational>>& nodes) {
  certificate.require_object({"method", "precision", "radius", "orbits"});
  const std::vector<std::string> methods = {"krawczyk"};
  (void)certificate.at("method", "krawczyk").word(methods);
  const std::string precision_allowed = "the degree of precision, from the degree of the nodes to 40";
  SymmetricNodes set;
  set.degree = degree;
  set.precision =
      static_cast<int>(certificate.at("precision", precision_allowed).whole(degree, 40, precision_allowed));
  const JsonReader list = certificate.at("orbits", "an array of orbits in the order of the nodes");
  std::size_t place = 0;
  for (const JsonReader& orbit : list.elements("orbits in the order of the nodes")) {
    orbit.require_object({"size", "held"});
    const std::string size_allowed = "1, 3 or 6";
    const JsonReader size = orbit.at("size", size_allowed);
    const auto points = size.whole(1, 6, size_allowed);
    if (points != 1 && points != 3 && points != 6) size.refuse("is not allowed", size_allowed);
    if (place + static_cast<std::size_t>(points) > nodes.size())
      list.refuse("has more points than there are nodes", "the orbits of the nodes");
    const std::array<Rational, 3>& x = nodes[place].x;
    set.orbits.push_back({.size = static_cast<int>(points),
                          .a = points == 3 ? x[1] : x[0],
                          .b = x[1],
                          .is_held = orbit.at("held", "true or false").boolean("true or false")});
    place += static_cast<std::size_t>(points);
  }
  if (set.nodes() != nodes)
    list.refuse("does not make the nodes of the file",
                "orbits in the order of the nodes, see radcert schema nodes");
  return set;
}

std::optional<SymmetricCertificate> read_certificate(const JsonReader& root, int degree,
                                                     const std::vector<Barycentric<Rational>>& nodes) {
  const auto certificate = root.find("certificate");
  if (!certificate) return std::nullopt;
  const SymmetricNodes set = symmetric_of(*certificate, degree, nodes);
  const std::string radius_allowed = "a positive number";
  const JsonReader at = certificate->at("radius", radius_allowed);
  const Rational radius = at.rational(radius_allowed);
  if (radius.sign() <= 0) at.refuse("is not allowed", radius_allowed);
  Outcome<SymmetricCertificate> proof = certify(set, radius);
  if (!proof) certificate->refuse("proves nothing: " + proof.reason(), "a claim that Krawczyk's test proves");
  return *std::move(proof);
}

NodeFile read(const JsonValue& document) {
  const JsonReader root(document);
  if (document.members() == nullptr) root.refuse("is " + document.kind(), "an object: nodes");
  const std::vector<std::string> schemas = {schema};
  (void)root.at("schema", schema).word(schemas);
  root.require_object({"schema", "radcert", "command", "degree", "nodes", "certificate"});
  const std::string degree_allowed = "a whole number from 0 to " + std::to_string(largest_node_degree);
  const int degree =
      static_cast<int>(root.at("degree", degree_allowed).whole(0, largest_node_degree, degree_allowed));
  const std::size_t needed = polynomial_dimension(degree);
  const JsonReader list = root.at("nodes", "an array of nodes");
  const std::vector<JsonReader> places = list.elements("nodes, three barycentric coordinates each");
  if (places.size() != needed)
    throw InputError({.pointer = list.pointer(),
                      .problem = "has " + std::to_string(places.size()) + " nodes: too " +
                                 (places.size() < needed ? "few" : "many"),
                      .allowed = std::to_string(needed) + " nodes for degree " + std::to_string(degree)});
  std::vector<Barycentric<Rational>> nodes;
  nodes.reserve(places.size());
  for (const JsonReader& place : places) nodes.push_back(read_node(place));
  require_different(places, nodes);
  Outcome<LagrangeFunctions, NotUnisolvent> functions = lagrange_functions(nodes);
  if (!functions)
    throw InputError(
        {.pointer = list.pointer(),
         .problem = "is not unisolvent: " + functions.reason().to_text(),
         .allowed = "nodes that determine every polynomial of degree " + std::to_string(degree)});
  return {.functions = *std::move(functions), .certificate = read_certificate(root, degree, nodes)};
}

/// The decimals of a fraction with a denominator of 2s and 5s, by shifting the point; nothing for others.
std::optional<std::string> finite_decimal(const Rational& value) {
  Rational scaled = abs(value);
  std::size_t decimals = 0;
  constexpr std::size_t most_decimals = 200;
  for (; !scaled.is_integer(); ++decimals) {
    if (decimals == most_decimals) return std::nullopt;
    scaled *= 10;
  }
  std::string digits = scaled.to_text();
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  if (decimals > 0) digits.insert(digits.size() - decimals, 1, '.');
  return (value.sign() < 0 ? "-" : "") + digits;
}

}  // namespace

std::string exact_text(const Rational& value) { return finite_decimal(value).value_or(value.to_text()); }

NodeFile read_nodes(const std::filesystem::path& path) {
  const JsonValue document = read_json(path);
  return with_source(path.string(), [&] { return read(document); });
}

NodeFile parse_nodes(std::string_view text, const std::string& source) {
  const JsonValue document = parse_json(text, source);
  return with_source(source, [&] { return read(document); });
}

JsonValue nodes_json(int degree, std::span<const Barycentric<Rational>> nodes) {
  JsonValue out = JsonValue::object();
  out.set("schema", schema);
  out.set("degree", degree);
  out.set("nodes", json_array(nodes, [](const Barycentric<Rational>& node) {
            return json_array(node.x, [](const Rational& x) { return JsonValue(exact_text(x)); });
          }));
  return out;
}

JsonValue nodes_json(const SymmetricNodes& set, const Rational& radius) {
  JsonValue out = nodes_json(set.degree, set.nodes());
  JsonValue certificate = JsonValue::object();
  certificate.set("method", "krawczyk");
  certificate.set("precision", set.precision);
  certificate.set("radius", exact_text(radius));
  certificate.set("orbits", json_array(set.orbits, [](const SymmetricOrbit& orbit) {
                    JsonValue entry = JsonValue::object();
                    entry.set("size", orbit.size);
                    entry.set("held", orbit.is_held);
                    return entry;
                  }));
  out.set("certificate", std::move(certificate));
  return out;
}

}  // namespace radcert
