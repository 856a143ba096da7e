// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/problem/node_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/expression/parse.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/polynomial_expression.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/real_zeros.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/real.h"

namespace radcert {

namespace {

constexpr const char* schema = "radcert/nodes/1";
constexpr int largest_node_degree = 12;
constexpr int largest_claimed_precision = 40;
constexpr const char* precision_allowed = "the degree of precision, from the degree of the nodes to 40";
constexpr const char* coordinate_allowed = "a decimal or fraction in a string, from 0 to 1";

// A problem is solved with fractions so close to irrational numbers: as many digits as node files have, and
// the rounding of no arithmetic that it is solved in.
const Rational& number_width() {
  static const Rational width = 1 / power(Rational(10), 70);
  return width;
}

// The zero of a polynomial in an interval that holds one and no other.
struct FileNumber {
  RationalPolynomial polynomial;
  RealZero zero;
};

FileNumber read_number(const JsonReader& number) {
  number.require_object({"polynomial", "between"});
  const std::string polynomial_allowed = "coefficients, the constant first, not all of them zero beyond it";
  const JsonReader list = number.at("polynomial", polynomial_allowed);
  std::vector<Rational> coefficients;
  for (const JsonReader& each : list.elements(polynomial_allowed))
    coefficients.push_back(each.rational("a decimal or fraction in a string"));
  const RationalPolynomial polynomial(std::move(coefficients));
  if (polynomial.degree() < 1) list.refuse("is constant", polynomial_allowed);
  const std::string between_allowed = "two numbers, the smaller one first";
  const JsonReader place = number.at("between", between_allowed);
  const std::vector<JsonReader> ends = place.elements(between_allowed);
  if (ends.size() != 2) place.refuse("has " + std::to_string(ends.size()) + " numbers", between_allowed);
  const Rational lower = ends[0].rational(between_allowed);
  const Rational upper = ends[1].rational(between_allowed);
  if (upper < lower) place.refuse("has the larger one first", between_allowed);
  const std::vector<RealZero> zeros = real_zeros(polynomial, lower, upper, number_width());
  if (zeros.size() != 1)
    throw InputError(
        {.pointer = place.pointer(),
         .problem = "holds " +
                    (zeros.empty() ? std::string("no zero") : std::to_string(zeros.size()) + " zeros") +
                    " of " + polynomial.to_text(),
         .allowed = "an interval that holds one zero and no other"});
  return {.polynomial = polynomial, .zero = zeros.front()};
}

// A coordinate exactly, and a fraction beside it.
struct Coordinate {
  AlgebraicExpression exact;
  Rational near;
};

// The numbers x, y, z that a file defines for its coordinates: those that are irrational generate a field.
struct Numbers {
  std::array<std::optional<Coordinate>, 3> of_name;
  AlgebraicField field{{}};

  [[nodiscard]] bool any() const {
    return std::any_of(of_name.begin(), of_name.end(), [](const auto& n) { return n.has_value(); });
  }
};

Numbers read_numbers(const JsonReader& root) {
  Numbers out;
  const auto numbers = root.find("numbers");
  if (!numbers) return out;
  const auto known = names(ExpressionVariables::space);
  numbers->require_object({known[0], known[1], known[2]});
  std::vector<AlgebraicNumber> irrational;
  for (std::size_t i = 0; i < out.of_name.size(); ++i) {
    const auto place = numbers->find(known[i]);
    if (!place) continue;
    const auto [polynomial, zero] = read_number(*place);
    const Rational middle = (zero.lower + zero.upper) / 2;
    out.of_name[i] = Coordinate{.exact = zero.is_exact() ? AlgebraicExpression(middle)
                                                         : AlgebraicExpression::number(irrational.size()),
                                .near = middle};
    if (!zero.is_exact()) irrational.emplace_back(polynomial, zero);
  }
  out.field = AlgebraicField(std::move(irrational));
  return out;
}

// The sign of a number of the file, or a refusal where it takes too many digits.
int sign_at(const JsonReader& place, const Numbers& numbers, const AlgebraicExpression& x) {
  const Outcome<int> sign = numbers.field.sign(x);
  if (!sign) place.refuse("is not decided: " + sign.reason(), "numbers of smaller degrees and coefficients");
  return *sign;
}

// A coordinate: a number, or an expression in the file's numbers.
Coordinate read_coordinate(const JsonReader& place, const Numbers& numbers) {
  const std::string* text = place.value().string();
  if (text == nullptr || !numbers.any()) {
    const Rational value = place.rational(coordinate_allowed);
    return {.exact = value, .near = value};
  }
  const std::string allowed = "sums, products and quotients of fractions and of the file's numbers";
  const auto expression = parse_expression(*text);
  if (!expression) place.refuse(expression.reason().to_text(), allowed);
  std::vector<Coordinate> values;
  for (const ExpressionNode& node : expression->nodes()) {
    const auto left = [&] { return values[static_cast<std::size_t>(node.left)]; };
    const auto right = [&] { return values[static_cast<std::size_t>(node.right)]; };
    switch (node.kind) {
      case ExpressionKind::literal: values.push_back({.exact = node.literal, .near = node.literal}); break;
      case ExpressionKind::variable: {
        const std::optional<Coordinate>& number = numbers.of_name.at(static_cast<std::size_t>(node.variable));
        if (!number) place.refuse("has a number that the file does not define", allowed);
        values.push_back(*number);
        break;
      }
      case ExpressionKind::negate: values.push_back({.exact = -left().exact, .near = -left().near}); break;
      case ExpressionKind::add:
        values.push_back({.exact = left().exact + right().exact, .near = left().near + right().near});
        break;
      case ExpressionKind::subtract:
        values.push_back({.exact = left().exact - right().exact, .near = left().near - right().near});
        break;
      case ExpressionKind::multiply:
        values.push_back({.exact = left().exact * right().exact, .near = left().near * right().near});
        break;
      case ExpressionKind::divide:
        if (sign_at(place, numbers, right().exact) == 0) place.refuse("divides by zero", allowed);
        if (right().near == 0)
          place.refuse("divides by a number that 70 digits do not tell from zero", allowed);
        values.push_back({.exact = left().exact / right().exact, .near = left().near / right().near});
        break;
      default: place.refuse("has another operation", allowed);
    }
  }
  return values.back();
}

// A node exactly, and one with fractions beside it.
struct Node {
  std::array<AlgebraicExpression, 3> exact{Rational(0), Rational(0), Rational(0)};
  Barycentric<Rational> near;
};

Node read_node(const JsonReader& node, const Numbers& numbers) {
  const std::vector<JsonReader> coordinates = node.elements("three barycentric coordinates");
  if (coordinates.size() != 3)
    node.refuse("has " + std::to_string(coordinates.size()) + " coordinates",
                "three barycentric coordinates");
  Node out;
  for (std::size_t i = 0; i < 3; ++i) {
    auto [exact, near] = read_coordinate(coordinates[i], numbers);
    const int below = sign_at(coordinates[i], numbers, exact);
    const int above = sign_at(coordinates[i], numbers, Rational(1) - exact);
    if (below < 0 || above < 0)
      coordinates[i].refuse("puts the node outside the triangle", coordinate_allowed);
    out.near.x[i] = below == 0 ? Rational(0) : above == 0 ? Rational(1) : near;
    out.exact[i] = std::move(exact);
  }
  const Rational sum = out.near.x[0] + out.near.x[1] + out.near.x[2];
  if (sign_at(node, numbers, out.exact[0] + out.exact[1] + out.exact[2] - Rational(1)) != 0)
    node.refuse(
        "has the sum " + (numbers.field.size() > 0 ? nearest_text(sum, DecimalForm::general(17)) + ", nearly"
                                                   : exact_text(sum)),
        "coordinates with the exact sum 1, such as [\"0.1\", \"0.2\", \"0.7\"]");
  // The roundings of the three may not have the sum 0.
  *std::max_element(out.near.x.begin(), out.near.x.end()) += 1 - sum;
  return out;
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
  SymmetricNodes set;
  set.degree = degree;
  set.precision = static_cast<int>(certificate.at("precision", precision_allowed)
                                       .whole(degree, largest_claimed_precision, precision_allowed));
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

// The nodes of a certificate without orbits, with the weights of their interpolatory rule.
FreeNodes free_of(const JsonReader& certificate, const LagrangeFunctions& functions) {
  certificate.require_object({"method", "precision", "parallelogram", "radius", "held"});
  const std::vector<std::string> methods = {"krawczyk"};
  (void)certificate.at("method", "krawczyk").word(methods);
  FreeNodes set;
  set.degree = functions.degree();
  set.triangle = static_cast<int>(certificate.at("precision", precision_allowed)
                                      .whole(set.degree, largest_claimed_precision, precision_allowed));
  const std::string even_allowed = "an even degree of precision on the parallelogram, from 0 to 40";
  const JsonReader even = certificate.at("parallelogram", even_allowed);
  set.parallelogram = static_cast<int>(even.whole(0, largest_claimed_precision, even_allowed));
  if (set.parallelogram % 2 != 0) even.refuse("is odd", even_allowed);
  const TriangleRule<Rational> rule = interpolatory_rule(functions);
  const std::string held_allowed = "for each node which of \"x2\" and \"x3\" were chosen";
  const JsonReader list = certificate.at("held", held_allowed);
  const std::vector<JsonReader> held = list.elements(held_allowed);
  if (held.size() != functions.size())
    list.refuse(
        "is for " + std::to_string(held.size()) + " nodes in place of " + std::to_string(functions.size()),
        held_allowed);
  for (std::size_t j = 0; j < held.size(); ++j) {
    const std::array<Rational, 3>& x = functions.nodes()[j].x;
    FreeNode node{.s = x[2], .t = x[1], .weight = rule.weights[j]};
    for (const JsonReader& name : held[j].elements(held_allowed)) {
      const std::vector<std::string> coordinates = {"x2", "x3"};
      (name.word(coordinates) == "x2" ? node.holds_t : node.holds_s) = true;
    }
    set.nodes.push_back(std::move(node));
  }
  return set;
}

/// `space` is empty for all polynomials of the degree.
std::optional<SymmetricCertificate> read_certificate(const JsonReader& root,
                                                     const LagrangeFunctions& functions,
                                                     std::span<const PlanePolynomial<Rational>> space) {
  const auto certificate = root.find("certificate");
  if (!certificate) return std::nullopt;
  const std::string radius_allowed = "a positive number";
  const auto radius = [&] {
    const JsonReader at = certificate->at("radius", radius_allowed);
    Rational value = at.rational(radius_allowed);
    if (value.sign() <= 0) at.refuse("is not allowed", radius_allowed);
    return value;
  };
  const auto proof_of = [&]() -> Outcome<SymmetricCertificate> {
    const auto held = certificate->find("held");
    if (!held) {
      const SymmetricNodes set = symmetric_of(*certificate, functions.degree(), functions.nodes());
      return certify(set, radius(), space);
    }
    if (!space.empty())
      held->refuse("is for all polynomials of a degree", "orbits, where the file has a space");
    const FreeNodes set = free_of(*certificate, functions);
    return certify(set, radius());
  };
  Outcome<SymmetricCertificate> proof = proof_of();
  if (!proof) certificate->refuse("proves nothing: " + proof.reason(), "a claim that Krawczyk's test proves");
  return *std::move(proof);
}

// Nodes as fractions, and exactly where these are not.
struct NodeList {
  std::vector<Barycentric<Rational>> near;
  std::optional<AlgebraicNodes> exact;
};

NodeList read_node_list(const JsonReader& root, std::size_t needed, const std::string& of) {
  const Numbers numbers = read_numbers(root);
  const JsonReader list = root.at("nodes", "an array of nodes");
  const std::vector<JsonReader> places = list.elements("nodes, three barycentric coordinates each");
  if (places.size() != needed)
    throw InputError({.pointer = list.pointer(),
                      .problem = "has " + std::to_string(places.size()) + " nodes: too " +
                                 (places.size() < needed ? "few" : "many"),
                      .allowed = std::to_string(needed) + " nodes for " + of});
  NodeList out;
  AlgebraicNodes exact{.field = numbers.field, .nodes = {}, .space = {}};
  for (const JsonReader& place : places) {
    Node node = read_node(place, numbers);
    out.near.push_back(std::move(node.near));
    exact.nodes.push_back(std::move(node.exact));
  }
  require_different(places, out.near);
  if (numbers.field.size() > 0) out.exact = std::move(exact);
  return out;
}

PolynomialSpace read_space(const std::vector<JsonReader>& places,
                           std::vector<PlanePolynomial<Rational>>& polynomials) {
  const std::string allowed = "polynomials in x1, x2, x3 of degree " + std::to_string(largest_node_degree) +
                              " at most, such as \"x1\" and \"27*x1*x2*x3\"";
  PolynomialSpace space;
  for (const JsonReader& place : places) {
    const auto expression = parse_expression(place.string(allowed), ExpressionVariables::barycentric);
    if (!expression) place.refuse(expression.reason().to_text(), allowed);
    Outcome<PlanePolynomial<Rational>> polynomial = polynomial_of(*expression, largest_node_degree);
    if (!polynomial) place.refuse(polynomial.reason(), allowed);
    space.degree = std::max(space.degree, polynomial->degree());
    polynomials.push_back(*std::move(polynomial));
  }
  for (const PlanePolynomial<Rational>& p : polynomials)
    space.functions.push_back(bernstein_coefficients(p, space.degree));
  return space;
}

std::string point_text(const Barycentric<Rational>& x) {
  return "(" + x.x[0].to_text() + ", " + x.x[1].to_text() + ", " + x.x[2].to_text() + ")";
}

// Collocation with functions whose sum is not 1 does not converge. The sum's largest distance from 1 at the
// places of its Bernstein coefficients shows where and by how much.
void require_constants(const JsonReader& space, const LagrangeFunctions& functions) {
  if (functions.reproduced_degree() >= 0) return;
  Barycentric<Rational> worst;
  Rational sum_there = 1;
  std::vector<Rational> values(functions.size());
  for (const Barycentric<Rational>& x : inset_nodes(functions.degree(), Rational(0))) {
    functions.values(x, values);
    Rational sum = 0;
    for (const Rational& value : values) sum += value;
    if (abs(sum - 1) <= abs(sum_there - 1)) continue;
    worst = x;
    sum_there = sum;
  }
  throw InputError({.pointer = space.pointer(),
                    .problem = "does not contain the constants: the interpolant of 1 at the nodes is " +
                               sum_there.to_text() + " at " + point_text(worst),
                    .allowed = "functions among whose combinations is 1, as x1 + x2 + x3"});
}

NodeFile read_own_space(const JsonReader& root, const JsonReader& key) {
  if (const auto degree = root.find("degree"))
    degree->refuse("stands beside a space", "a degree, or a space, not both");
  const std::vector<JsonReader> places = key.elements("functions: polynomials in x1, x2, x3");
  // As many as there are polynomials of the largest degree.
  if (places.empty() || places.size() > polynomial_dimension(largest_node_degree))
    throw InputError({.pointer = key.pointer(),
                      .problem = "has " + std::to_string(places.size()) + " functions",
                      .allowed = "1 to " + std::to_string(polynomial_dimension(largest_node_degree))});
  std::vector<PlanePolynomial<Rational>> polynomials;
  const PolynomialSpace space = read_space(places, polynomials);
  const JsonReader list = root.at("nodes", "an array of nodes");
  NodeList nodes =
      read_node_list(root, places.size(), "a space of " + std::to_string(places.size()) + " functions");
  Outcome<LagrangeFunctions, NotUnisolvent> functions = lagrange_functions(space, nodes.near);
  if (!functions)
    throw InputError({.pointer = list.pointer(),
                      .problem = "is not unisolvent: " + functions.reason().to_text() +
                                 ", where f_0 is the first function of the space",
                      .allowed = "nodes that determine every function of the space"});
  require_constants(key, *functions);
  std::vector<std::string> texts;
  for (const JsonReader& place : places) texts.push_back(*place.value().string());
  std::optional<SymmetricCertificate> certificate = read_certificate(root, *functions, polynomials);
  if (nodes.exact) nodes.exact->space = std::move(polynomials);
  return {.functions = *std::move(functions),
          .algebraic = std::move(nodes.exact),
          .certificate = std::move(certificate),
          .space = std::move(texts),
          .digest = {}};
}

NodeFile read(const JsonValue& document) {
  const JsonReader root(document);
  root.require_schema(schema, "an object: nodes");
  root.require_object({"schema", "radcert", "command", "degree", "space", "numbers", "nodes", "certificate"});
  if (const auto space = root.find("space")) return read_own_space(root, *space);
  const std::string degree_allowed = "a whole number from 0 to " + std::to_string(largest_node_degree);
  const int degree =
      static_cast<int>(root.at("degree", degree_allowed).whole(0, largest_node_degree, degree_allowed));
  const JsonReader list = root.at("nodes", "an array of nodes");
  NodeList nodes = read_node_list(root, polynomial_dimension(degree), "degree " + std::to_string(degree));
  Outcome<LagrangeFunctions, NotUnisolvent> functions = lagrange_functions(nodes.near);
  if (!functions)
    throw InputError(
        {.pointer = list.pointer(),
         .problem = "is not unisolvent: " + functions.reason().to_text(),
         .allowed = "nodes that determine every polynomial of degree " + std::to_string(degree)});
  if (nodes.exact) nodes.exact->space = monomials(degree);
  std::optional<SymmetricCertificate> certificate = read_certificate(root, *functions, {});
  return {.functions = *std::move(functions),
          .algebraic = std::move(nodes.exact),
          .certificate = std::move(certificate),
          .space = {},
          .digest = {}};
}

JsonValue node_list(std::span<const Barycentric<Rational>> nodes) {
  return json_array(nodes, [](const Barycentric<Rational>& node) {
    return json_array(node.x, [](const Rational& x) { return JsonValue(exact_text(x)); });
  });
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
  return parse_nodes(with_source(path.string(), [&] { return read_file(path, json_size_limit); }),
                     path.string());
}

NodeFile parse_nodes(std::string_view text, const std::string& source) {
  const JsonValue document = parse_json(text, source);
  NodeFile file = with_source(source, [&] { return read(document); });
  file.digest = digest_of(text);
  return file;
}

JsonValue nodes_json(int degree, std::span<const Barycentric<Rational>> nodes) {
  JsonValue out = JsonValue::object();
  out.set("schema", schema);
  out.set("degree", degree);
  out.set("nodes", node_list(nodes));
  return out;
}

JsonValue nodes_json(std::span<const std::string> space, std::span<const Barycentric<Rational>> nodes) {
  JsonValue out = JsonValue::object();
  out.set("schema", schema);
  out.set("space", json_array(space));
  out.set("nodes", node_list(nodes));
  return out;
}

JsonValue nodes_json(const FreeNodes& set, const Rational& radius) {
  JsonValue out = nodes_json(set.degree, set.points());
  JsonValue certificate = JsonValue::object();
  certificate.set("method", "krawczyk");
  certificate.set("precision", set.triangle);
  certificate.set("parallelogram", set.parallelogram);
  certificate.set("radius", exact_text(radius));
  certificate.set("held", json_array(set.nodes, [](const FreeNode& node) {
                    std::vector<std::string> held;
                    if (node.holds_t) held.emplace_back("x2");
                    if (node.holds_s) held.emplace_back("x3");
                    return json_array(held);
                  }));
  out.set("certificate", std::move(certificate));
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
