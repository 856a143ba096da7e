// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/node_data.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/quadrature/kernel_sums.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/surface_function.h"

namespace radcert {
namespace {

std::string number_text(double value) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return value > 0 ? "infinite" : "minus infinite";
  return shortest(value);
}

[[noreturn]] void refuse_at_node(const PiecewiseExpression& function, const std::string& pointer,
                                 const Surface& surface, std::size_t i, const CollocationPoint<double>& node,
                                 double value, const std::string& allowed) {
  const std::string& piece = surface.charts[node.at.chart].facts().piece;
  const PiecewiseExpression::Case* used = nullptr;
  for (const PiecewiseExpression::Case& part : function.cases)
    if (part.piece == piece || (part.piece == "*" && used == nullptr)) used = &part;
  const bool single = function.cases.size() == 1 && function.cases.front().piece == "*";
  const std::string where =
      "(" + shortest(node.point.x) + ", " + shortest(node.point.y) + ", " + shortest(node.point.z) + ")";
  throw InputError({.pointer = single || used == nullptr ? pointer : pointer + "/" + used->piece,
                    .value = function.on(piece).text(),
                    .problem = "is " + number_text(value) + " at node " + std::to_string(i) + " " + where +
                               " on piece " + piece,
                    .allowed = allowed});
}

/// The coordinates of a node as balls.
Vector<Ball> enclosed_point(const Chart& chart, const CollocationPoint<double>& node) {
  constexpr double roundings = coordinate_roundings * unit_roundoff<double>();
  const auto largest = std::max({std::abs(node.point.x), std::abs(node.point.y), std::abs(node.point.z)});
  Vector<double> sizes{largest, largest, largest};
  if (chart.facts().plane) {
    const Frame<double> frame = chart.in<double>().frame({0, 0});
    const auto terms = [&frame](double Vector<double>::*x) {
      return std::abs(frame.point.*x) + std::abs(frame.tangent_s.*x) + std::abs(frame.tangent_t.*x);
    };
    sizes = {terms(&Vector<double>::x), terms(&Vector<double>::y), terms(&Vector<double>::z)};
  }
  const auto ball = [](double value, double size) { return widened(Ball(value), Ball(roundings * size)); };
  return {ball(node.point.x, sizes.x), ball(node.point.y, sizes.y), ball(node.point.z, sizes.z)};
}

}  // namespace

std::optional<std::vector<double>> value_radii(const PiecewiseExpression& function, const Surface& surface,
                                               std::span<const CollocationPoint<double>> nodes,
                                               std::span<const double> values) {
  constexpr long bits = 64;
  const BallPrecision precision(bits);
  std::vector<double> radii;
  radii.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Chart& chart = surface.charts[nodes[i].at.chart];
    const Expression& f = function.on(chart.facts().piece);
    if (f.is_constant()) {
      radii.push_back(unit_roundoff<double>() * std::abs(values[i]));
      continue;
    }
    if (!chart.is_known_in_balls()) return std::nullopt;
    const Vector<Ball> q = enclosed_point(chart, nodes[i]);
    const Ball value = f.evaluate<Ball>({q.x, q.y, q.z});
    if (!value.is_finite()) return std::nullopt;
    radii.push_back(abs(value - Ball(values[i])).upper_double());
    if (!std::isfinite(radii.back())) return std::nullopt;
  }
  return radii;
}

std::vector<double> values_at_nodes(const PiecewiseExpression& function, const std::string& pointer,
                                    const Surface& surface, std::span<const CollocationPoint<double>> nodes,
                                    std::size_t first) {
  const SurfaceFunction f(function, surface);
  std::vector<double> values;
  values.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    values.push_back(f(nodes[i].at.chart, nodes[i].point));
    if (!std::isfinite(values.back()))
      refuse_at_node(function, pointer, surface, first + i, nodes[i], values.back(),
                     "an expression that is finite at every node");
  }
  return values;
}

std::vector<double> reflectivity_at_nodes(const PiecewiseExpression& reflectivity, const Surface& surface,
                                          std::span<const CollocationPoint<double>> nodes,
                                          std::size_t first) {
  std::vector<double> values = values_at_nodes(reflectivity, "/reflectivity", surface, nodes, first);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (values[i] < 0 || values[i] > 1)
      refuse_at_node(reflectivity, "/reflectivity", surface, first + i, nodes[i], values[i],
                     "values in [0, 1]");
  return values;
}

}  // namespace radcert
