// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/element_function.h"

#include <cmath>
#include <numbers>

#include "radcert/core/contract.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/reference/operator_integral.h"

namespace radcert::verification::ac98 {

ElementFunction::ElementFunction(const Problem& problem, const LevelOutcome& level)
    : surface_(surface_of(problem)),
      triangles_(triangulate(surface_, level.result.level).triangles),
      degree_(triangle_basis_of(problem.method).degree),
      inset_(triangle_basis_of(problem.method).alpha.value_or(Rational(0)).to_double()),
      nodes_per_element_(InsetBasis<double>(degree_, inset_).size()),
      values_(level.nodes.size()) {
  expects(!problem.geometry, "exact geometry");
  expects(level.nodes.size() == triangles_.size() * nodes_per_element_, "a value for each node",
          named("nodes", level.nodes.size()));
  for (const NodeValue& node : level.nodes)
    values_.at(node.element * nodes_per_element_ + node.index_in_element) = node.u_n.value;
}

SurfacePoint<double> ElementFunction::node(std::size_t element, std::size_t index) const {
  const ParameterTriangle& triangle = triangles_[element];
  return {triangle.chart, triangle.at(InsetBasis<double>(degree_, inset_).nodes().at(index).x)};
}

double ElementFunction::operator()(std::size_t element, const ParameterPoint<double>& at) const {
  const auto& v = triangles_[element].vertices;
  const double area = cross(v[1] - v[0], v[2] - v[0]);
  const double x2 = cross(at - v[0], v[2] - v[0]) / area;
  const double x3 = cross(v[1] - v[0], at - v[0]) / area;
  std::array<double, 64> basis{};
  const std::span<double> used(basis.data(), nodes_per_element_);
  InsetBasis<double>(degree_, inset_).values({{1 - x2 - x3, x2, x3}}, used);
  double sum = 0;
  for (std::size_t j = 0; j < nodes_per_element_; ++j) sum += node_value(element, j) * used[j];
  return sum;
}

Approximation ElementFunction::integral(const SurfacePoint<double>& p) const {
  Approximation total{.value = 0, .radius = 0};
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const Approximation part = reference::operator_integral(
        surface_, p, triangles_[k].chart, triangles_[k].vertices,
        [&](const SurfacePoint<double>& q, const Vector<double>&) { return (*this)(k, q.at); });
    total.value += part.value;
    total.radius += part.radius;
  }
  return total;
}

IteratedError::IteratedError(const OperatorRoute& route, const Problem& problem, const LevelOutcome& level)
    : u_n_(problem, level),
      u_(problem.solution.value(), u_n_.surface()),
      reflectivity_(problem.reflectivity),
      of_u_(route(u_n_.surface(), u_)) {}

Approximation IteratedError::operator()(const SurfacePoint<double>& p) const {
  const Chart& at = u_n_.surface().charts.at(p.chart);
  const Vector<double> x = at.in<double>().frame(p.at).point;
  const double factor =
      reflectivity_.on(at.facts().piece).evaluate<double>({x.x, x.y, x.z}) / std::numbers::pi;
  const Approximation exact = of_u_(p);
  const Approximation ours = u_n_.integral(p);
  return {.value = factor * std::abs(ours.value - exact.value),
          .radius = factor * (ours.radius + exact.radius)};
}

}  // namespace radcert::verification::ac98
