// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/free_nodes.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/polynomial/nodes/enclosed_rule.h"
#include "radcert/polynomial/nodes/symmetric_system.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "radcert/scalar/dual.h"

namespace radcert {
namespace {

constexpr long bits = 512;  // as certify of symmetric nodes
constexpr int digits = 62;

/// (s - centre)^i (t - centre)^j.
struct Moment {
  Rational centre;
  int i = 0;
  int j = 0;

  [[nodiscard]] Rational integral() const {
    PlanePolynomial<Rational> f = constant_polynomial<Rational>(1);
    for (int k = 0; k < i; ++k) f = product(f, affine_polynomial<Rational>(-centre, 1, 0));
    for (int k = 0; k < j; ++k) f = product(f, affine_polynomial<Rational>(-centre, 0, 1));
    Rational sum = 0;
    for (int a = 0; a <= f.degree(); ++a)
      for (int b = 0; a + b <= f.degree(); ++b)
        sum += f(a, b) * factorial(a) * factorial(b) / factorial(a + b + 2);
    return sum;
  }
};

std::vector<Moment> moments_of(int triangle, int parallelogram) {
  std::vector<Moment> list;
  const auto add = [&](int degree, const Rational& centre) {
    for (int j = 0; j <= degree; ++j) list.push_back({.centre = centre, .i = degree - j, .j = j});
  };
  for (int k = 0; k <= triangle; ++k) add(k, Rational(1, 3));
  for (int k = triangle + 1; k <= parallelogram; ++k)
    if (k % 2 == 0) add(k, Rational(1, 2));
  return list;
}

struct NodeBox {
  Ball weight, s, t;
  bool holds_s = false;
  bool holds_t = false;
};
using Box = std::vector<NodeBox>;

std::vector<Ball*> unknowns_of(Box& box) {
  std::vector<Ball*> all;
  for (NodeBox& node : box) {
    all.push_back(&node.weight);
    if (!node.holds_s) all.push_back(&node.s);
    if (!node.holds_t) all.push_back(&node.t);
  }
  return all;
}

Box box_of(const FreeNodes& nodes) {
  Box box;
  for (const FreeNode& node : nodes.nodes)
    box.push_back({.weight = Ball(node.weight),
                   .s = Ball(node.s),
                   .t = Ball(node.t),
                   .holds_s = node.holds_s,
                   .holds_t = node.holds_t});
  for (Ball* unknown : unknowns_of(box)) *unknown = unknown->midpoint();
  return box;
}

BallResiduals residuals(const Box& box, const std::vector<Moment>& moments, std::size_t unknowns) {
  BallResiduals out{.values = {}, .derivatives = Matrix<Ball>(moments.size(), unknowns)};
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const Moment& moment = moments[k];
    const Ball centre(moment.centre);
    Ball sum(-moment.integral());
    std::size_t place = 0;
    for (const NodeBox& node : box) {
      const Dual<Ball> s(node.s - centre, Ball(1), Ball(0));
      const Dual<Ball> t(node.t - centre, Ball(0), Ball(1));
      const Dual<Ball> value = power(s, moment.i) * power(t, moment.j);
      sum += node.weight * value.value;
      out.derivatives(k, place++) = value.value;
      if (!node.holds_s) out.derivatives(k, place++) = node.weight * value.by_s;
      if (!node.holds_t) out.derivatives(k, place++) = node.weight * value.by_t;
    }
    out.values.push_back(sum);
  }
  return out;
}

TriangleRule<Ball> rule_of(const Box& box) {
  TriangleRule<Ball> rule;
  for (const NodeBox& node : box) {
    rule.points.push_back({{Ball(1) - node.s - node.t, node.t, node.s}});
    rule.weights.push_back(node.weight);
  }
  return rule;
}

}  // namespace

std::vector<Barycentric<Rational>> FreeNodes::points() const {
  std::vector<Barycentric<Rational>> out;
  for (const FreeNode& node : nodes) out.push_back({{Rational(1) - node.s - node.t, node.t, node.s}});
  return out;
}

int free_equations(int triangle, int parallelogram) {
  expects(triangle >= 0, "triangle >= 0", named("triangle", triangle));
  int count = (triangle + 1) * (triangle + 2) / 2;
  for (int k = triangle + 1; k <= parallelogram; ++k) count += k % 2 == 0 ? k + 1 : 0;
  return count;
}

std::optional<FreeNodes> sharpened(const FreeNodes& nodes) {
  const BallPrecision scope(bits);
  const std::vector<Moment> moments = moments_of(nodes.triangle, nodes.parallelogram);
  Box box = box_of(nodes);
  const std::vector<Ball*> unknowns = unknowns_of(box);
  if (unknowns.size() != moments.size()) return std::nullopt;
  if (!newton(unknowns, [&] { return residuals(box, moments, unknowns.size()); })) return std::nullopt;
  const auto decimal = [](const Ball& x) {
    const BallDecimal nearest = x.decimal(digits);
    return Rational::parse(nearest.midpoint).value();
  };
  FreeNodes out = nodes;
  for (std::size_t j = 0; j < box.size(); ++j) {
    out.nodes[j].weight = decimal(box[j].weight);
    if (!box[j].holds_s) out.nodes[j].s = decimal(box[j].s);
    if (!box[j].holds_t) out.nodes[j].t = decimal(box[j].t);
  }
  return out;
}

Outcome<SymmetricCertificate> certify(const FreeNodes& nodes, const Rational& radius) {
  expects(radius.sign() > 0, "radius > 0", named("radius", radius));
  expects(nodes.triangle >= nodes.degree, "triangle >= degree: the rule is interpolatory",
          named("triangle", nodes.triangle), named("degree", nodes.degree));
  expects(nodes.parallelogram % 2 == 0, "an even degree parallelogram",
          named("parallelogram", nodes.parallelogram));
  const BallPrecision scope(bits);
  const std::size_t count = static_cast<std::size_t>((nodes.degree + 1) * (nodes.degree + 2) / 2);
  if (nodes.nodes.size() != count)
    return because(std::to_string(nodes.nodes.size()) + " nodes in place of " + std::to_string(count));
  const std::vector<Moment> moments = moments_of(nodes.triangle, nodes.parallelogram);
  Box centre = box_of(nodes);
  const std::vector<Ball*> at_centre = unknowns_of(centre);
  const std::size_t n = at_centre.size();
  if (n != moments.size())
    return because(std::to_string(n) + " unknowns for " + std::to_string(moments.size()) + " equations");
  Box box = centre;
  const std::vector<Ball*> in_box = unknowns_of(box);
  const Outcome<void> proved = krawczyk(at_centre, in_box, radius, residuals(centre, moments, n),
                                        [&] { return residuals(box, moments, n); });
  if (!proved) return because(proved.reason());

  SymmetricCertificate certificate;
  certificate.radius = radius;
  certificate.rule = rule_of(box);
  for (const Barycentric<Ball>& q : certificate.rule.points)
    for (const Ball& coordinate : q.x)
      if (!certainly_positive(coordinate)) return because("a node is not certainly inside the triangle");
  certificate.determinant = determinant_of(bernstein_matrix(nodes.degree, certificate.rule.points));
  if (!certificate.determinant.is_finite() || certificate.determinant.contains_zero())
    return because("the true nodes are not certainly unisolvent");
  Outcome<EnclosedPrecision> triangle = ends_at(certificate.rule, Region::triangle, nodes.triangle);
  if (!triangle) return because(triangle.reason());
  const int even = std::max(nodes.parallelogram, nodes.triangle - nodes.triangle % 2);
  Outcome<EnclosedPrecision> both = ends_at(certificate.rule, Region::parallelogram, even + 1);
  if (!both) return because(both.reason());
  certificate.triangle = *std::move(triangle);
  certificate.parallelogram = *std::move(both);
  return certificate;
}

}  // namespace radcert
