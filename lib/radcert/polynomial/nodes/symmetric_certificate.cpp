// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/symmetric_certificate.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/matrix.h"
#include "radcert/core/work_limit.h"
#include "radcert/polynomial/nodes/enclosed_rule.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/orbit_structure.h"
#include "radcert/polynomial/nodes/symmetric_system.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

// Sixty digits of the data, as many again for the inverse, and room for the cancellation in determinants.
const WorkLimit working_bits("polynomial/symmetric_certificate: bits", 512, BallPrecision::smallest_bits,
                             "no certificate: the step that failed is named");

// The functions that the nodes are to determine: B_k of a degree, or those of a space.
struct Functions {
  int degree = 0;
  std::span<const PlanePolynomial<Rational>> space;  ///< empty: all polynomials of the degree

  [[nodiscard]] std::size_t count() const {
    return space.empty() ? polynomial_dimension(degree) : space.size();
  }
  [[nodiscard]] Rational integral(std::size_t k) const {
    if (space.empty()) return Rational(1) / ((degree + 1) * (degree + 2));
    Rational sum = 0;
    for (int i = 0; i <= space[k].degree(); ++i)
      for (int j = 0; i + j <= space[k].degree(); ++j)
        sum += space[k](i, j) * factorial(i) * factorial(j) / factorial(i + j + 2);
    return sum;
  }
};

// f_k(q_j), rows by node.
Matrix<Ball> matrix_of(const Functions& functions, const std::vector<Barycentric<Ball>>& nodes) {
  if (functions.space.empty()) return bernstein_matrix(functions.degree, nodes);
  Matrix<Ball> a(nodes.size(), functions.space.size());
  for (std::size_t j = 0; j < nodes.size(); ++j)
    for (std::size_t k = 0; k < functions.space.size(); ++k)
      a(j, k) = functions.space[k].value(nodes[j].x[2], nodes[j].x[1]);
  return a;
}

// The nodes with the weights of their interpolatory rule, nearly; nothing where these cannot be found.
std::optional<SymmetricBox> start_of(const SymmetricNodes& nodes, const Functions& functions) {
  std::vector<Barycentric<Ball>> points;
  for (const Barycentric<Rational>& q : nodes.nodes())
    points.push_back({{Ball(q.x[0]), Ball(q.x[1]), Ball(q.x[2])}});
  const std::optional<Matrix<Ball>> inverse = approximate_inverse(matrix_of(functions, points));
  if (!inverse) return std::nullopt;
  SymmetricBox box;
  std::size_t place = 0;
  for (const SymmetricOrbit& orbit : nodes.orbits) {
    Ball weight(0);
    for (std::size_t k = 0; k < points.size(); ++k)
      weight += (*inverse)(k, place) * Ball(functions.integral(k));
    box.push_back({.size = orbit.size,
                   .is_held = orbit.is_held,
                   .weight = weight,
                   .a = Ball(orbit.a),
                   .b = Ball(orbit.b)});
    place += static_cast<std::size_t>(orbit.size);
  }
  for (Ball* unknown : unknowns_of(box)) *unknown = unknown->midpoint();
  return box;
}

TriangleRule<Ball> rule_of(const SymmetricBox& box) {
  TriangleRule<Ball> rule;
  for (const OrbitBox& orbit : box) {
    const std::array<Ball, 3> x = orbit.coordinates(orbit.a, orbit.b);
    for (const auto& permutation : symmetric_places(orbit.size)) {
      rule.points.push_back({{x[permutation[0]], x[permutation[1]], x[permutation[2]]}});
      rule.weights.push_back(orbit.weight);
    }
  }
  return rule;
}

}  // namespace

Outcome<SymmetricCertificate> certify(const SymmetricNodes& nodes, const Rational& radius,
                                      std::span<const PlanePolynomial<Rational>> space) {
  expects(radius.sign() > 0, "radius > 0", named("radius", radius));
  expects(nodes.precision >= nodes.degree, "precision >= degree: the rule is interpolatory",
          named("precision", nodes.precision), named("degree", nodes.degree));
  const BallPrecision scope(working_bits.value());
  const Functions functions{.degree = nodes.degree, .space = space};
  for (const PlanePolynomial<Rational>& f : space)
    expects(f.degree() <= nodes.degree, "functions of the degree that is named", named("degree", f.degree()));
  const std::size_t count = functions.count();
  if (nodes.nodes().size() != count)
    return because(std::to_string(nodes.nodes().size()) + " nodes in place of " + std::to_string(count));
  std::optional<SymmetricBox> start = start_of(nodes, functions);
  if (!start) return because("the nodes are not certainly unisolvent");
  SymmetricBox& centre = *start;
  const std::vector<Ball*> at_centre = unknowns_of(centre);
  const std::size_t n = at_centre.size();
  const std::size_t equations = static_cast<std::size_t>(invariant_count(nodes.precision));
  if (n != equations)
    return because(std::to_string(n) + " unknowns for the " + std::to_string(equations) +
                   " invariant polynomials of degree <= " + std::to_string(nodes.precision));
  SymmetricBox box = centre;
  const std::vector<Ball*> in_box = unknowns_of(box);
  const Outcome<void> proved =
      krawczyk(at_centre, in_box, radius, symmetric_residuals(centre, nodes.precision, n),
               [&] { return symmetric_residuals(box, nodes.precision, n); });
  if (!proved) return because(proved.reason());

  SymmetricCertificate certificate;
  certificate.radius = radius;
  certificate.rule = rule_of(box);
  for (const Barycentric<Ball>& q : certificate.rule.points)
    for (const Ball& coordinate : q.x)
      if (!certainly_positive(coordinate)) return because("a node is not certainly inside the triangle");
  certificate.determinant = determinant_of(matrix_of(functions, certificate.rule.points));
  if (!certificate.determinant.is_finite() || certificate.determinant.contains_zero())
    return because("the true nodes are not certainly unisolvent");
  Outcome<EnclosedPrecision> triangle = ends_at(certificate.rule, Region::triangle, nodes.precision);
  if (!triangle) return because(triangle.reason());
  // Polynomials that are odd about the centre of the parallelogram cost nothing.
  const int odd = nodes.precision + (nodes.precision % 2 == 0 ? 1 : 0);
  Outcome<EnclosedPrecision> both = ends_at(certificate.rule, Region::parallelogram, odd);
  if (!both) return because(both.reason());
  certificate.triangle = *std::move(triangle);
  certificate.parallelogram = *std::move(both);
  return certificate;
}

}  // namespace radcert
