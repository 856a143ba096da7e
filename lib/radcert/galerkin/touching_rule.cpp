// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/galerkin/touching_rule.h"

#include "radcert/core/contract.h"
#include "radcert/polynomial/rules/gauss.h"

namespace radcert {
namespace {

/// A point of the triangle 0 <= b <= a <= 1, whose vertices are (0,0), (1,0), (1,1).
struct Point {
  double a;
  double b;

  [[nodiscard]] Barycentric<double> barycentric() const { return {{1 - a, a - b, b}}; }
};

/// One part at one point of the unit cube, s = (e1, e2, e3): x and y at xi = 1, and the Jacobian there.
struct Shape {
  Point x;
  Point y;
  double jacobian;
};

void append_common_vertex(double e1, double e2, double e3, std::vector<Shape>& to) {
  const Point far{1, e1};
  const Point near{e2, e2 * e3};
  to.push_back({far, near, e2});
  to.push_back({near, far, e2});
}

void append_common_side(double e1, double e2, double e3, std::vector<Shape>& to) {
  const double j = e1 * e1;
  to.push_back({{1, e1 * e3}, {1 - e1 * e2, e1 * (1 - e2)}, j});
  to.push_back({{1, e1}, {1 - e1 * e2 * e3, e1 * e2 * (1 - e3)}, j * e2});
  to.push_back({{1 - e1 * e2, e1 * (1 - e2)}, {1, e1 * e2 * e3}, j * e2});
  to.push_back({{1 - e1 * e2 * e3, e1 * e2 * (1 - e3)}, {1, e1}, j * e2});
  to.push_back({{1 - e1 * e2 * e3, e1 * (1 - e2 * e3)}, {1, e1 * e2}, j * e2});
}

void append_identical(double e1, double e2, double e3, std::vector<Shape>& to) {
  const double j = e1 * e1 * e2;
  const auto both = [&](const Point& x, const Point& y) {
    to.push_back({x, y, j});
    to.push_back({y, x, j});
  };
  both({1, 1 - e1 + e1 * e2}, {1 - e1 * e2 * e3, 1 - e1});
  both({1, e1 * (1 - e2 + e2 * e3)}, {1 - e1 * e2, e1 * (1 - e2)});
  both({1 - e1 * e2 * e3, e1 * (1 - e2 * e3)}, {1, e1 * (1 - e2)});
}

}  // namespace

std::vector<PointPair> touching_rule(std::size_t common, int order) {
  expects(1 <= common && common <= 3, "1 to 3 vertices in common", named("vertices", common));
  const IntervalRule<double> rule = gauss_rule<double>(order, IntervalWeight::one);
  const auto append = common == 1   ? append_common_vertex
                      : common == 2 ? append_common_side
                                    : append_identical;
  std::vector<PointPair> points;
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t j = 0; j < rule.nodes.size(); ++j)
      for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        shapes.clear();
        append(rule.nodes[i], rule.nodes[j], rule.nodes[k], shapes);
        const double weight = rule.weights[i] * rule.weights[j] * rule.weights[k];
        for (const Shape& shape : shapes)
          for (std::size_t l = 0; l < rule.nodes.size(); ++l) {
            const double xi = rule.nodes[l];
            points.push_back({.first = Point{xi * shape.x.a, xi * shape.x.b}.barycentric(),
                              .second = Point{xi * shape.y.a, xi * shape.y.b}.barycentric(),
                              .weight = weight * rule.weights[l] * shape.jacobian * xi * xi * xi});
          }
      }
  return points;
}

}  // namespace radcert
