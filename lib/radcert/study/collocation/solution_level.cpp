// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/solution_level.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/study/collocation/node_data.h"

namespace radcert {
namespace {

TriangleBasis<double> basis_of(const Problem& problem) {
  const TriangleBasisChoice* choice = find_triangle_basis(problem.method);
  if (choice == nullptr || !std::holds_alternative<Collocation>(problem.method))
    throw InputError({.source = "at",
                      .problem = std::holds_alternative<Galerkin>(problem.method)
                                     ? "is not for Galerkin's method"
                                     : "is not for a meshless basis",
                      .allowed = "a basis of functions on triangles"});
  if (problem.geometry)
    throw InputError({.source = "at",
                      .problem = "is not for an interpolated geometry",
                      .allowed = "a problem without geometry"});
  return triangle_basis(*choice);
}

/// Barycentric coordinates of a parameter point in its triangle.
Barycentric<double> barycentric_in(const ParameterTriangle& triangle, const ParameterPoint<double>& at) {
  const auto& v = triangle.vertices;
  const double whole = cross(v[1] - v[0], v[2] - v[0]);
  const double second = cross(at - v[0], v[2] - v[0]) / whole;
  const double third = cross(v[1] - v[0], at - v[0]) / whole;
  return {{1 - second - third, second, third}};
}

/// The area of the triangle through an element's corners.
double corner_area(const Surface& surface, const ParameterTriangle& triangle) {
  const ChartIn<double>& chart = surface.charts[triangle.chart].in<double>();
  const Vector<double> a = chart.frame(triangle.vertices[0]).point;
  const Vector<double> b = chart.frame(triangle.vertices[1]).point;
  const Vector<double> c = chart.frame(triangle.vertices[2]).point;
  return norm(cross(b - a, c - a)) / 2;
}

double fraction(double x) { return x - std::floor(x); }

}  // namespace

SolutionLevel::SolutionLevel(const Problem& problem, const LevelOutcome& outcome)
    : problem_(problem), basis_(basis_of(problem)), geometry_(problem, outcome.result.level, basis_) {
  for (const NodeValue& node : outcome.nodes) {
    u_n_.push_back(node.u_n);
    largest_ = std::max(largest_, std::abs(node.u_n.value));
  }
  expects(u_n_.size() == surface().nodes.size(), "a value a node of the level", named("values", u_n_.size()));
}

bool SolutionLevel::is_on_edge(const SurfacePlace& place) const {
  return lies_on_edge(surface().surface, {surface().triangulation.triangles[place.element].chart, place.at});
}

std::optional<SurfacePlace> SolutionLevel::place_of(std::size_t chart,
                                                    const ParameterPoint<double>& at) const {
  constexpr double rounding = 1e-12;
  const std::vector<ParameterTriangle>& triangles = surface().triangulation.triangles;
  std::optional<SurfacePlace> best;
  double deepest = -rounding;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (triangles[k].chart != chart) continue;
    const Barycentric<double> x = barycentric_in(triangles[k], at);
    const double least = std::min({x.x[0], x.x[1], x.x[2]});
    if (!(least > deepest)) continue;
    deepest = least;
    best = SurfacePlace{.element = k, .at = at};
  }
  return best;
}

std::vector<SurfacePlace> SolutionLevel::spread(std::size_t count) const {
  // The inverses of the root of x^3 = x + 1 and of its square.
  constexpr double first_step = 0.7548776662466927;
  constexpr double second_step = 0.5698402909980532;
  const std::vector<ParameterTriangle>& triangles = surface().triangulation.triangles;
  std::vector<double> until;
  double area = 0;
  for (const ParameterTriangle& triangle : triangles)
    until.push_back(area += corner_area(surface().surface, triangle));
  std::vector<SurfacePlace> out;
  out.reserve(count);
  std::size_t element = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(count) * area;
    while (element + 1 < triangles.size() && until[element] <= part) ++element;
    double a = fraction(0.5 + first_step * static_cast<double>(k + 1));
    double b = fraction(0.5 + second_step * static_cast<double>(k + 1));
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    // Off the sides, where u_n has two values.
    constexpr double inset = 0x1p-20;
    a = inset + (1 - 3 * inset) * a;
    b = inset + (1 - 3 * inset) * b;
    out.push_back({.element = element, .at = triangles[element].at({a, b, 1 - a - b})});
  }
  return out;
}

std::vector<ValueAt> SolutionLevel::values_at(std::span<const SurfacePlace> places, bool iterated,
                                              const OperatorRoute& route) const {
  const NodedSurface& level = surface();
  std::vector<CollocationPoint<double>> points;
  std::vector<ValueAt> out;
  for (const SurfacePlace& place : places) {
    const ParameterTriangle& triangle = level.triangulation.triangles[place.element];
    const ChartFacts& facts = level.surface.charts[triangle.chart].facts();
    points.push_back(collocation_point<double>(level.surface, {triangle.chart, place.at}));
    out.push_back({.point = points.back().point, .piece = facts.piece, .chart = facts.name, .at = place.at});
    out.back().u_n =
        value_in_element(basis_, std::span(u_n_).subspan(place.element * basis_.size(), basis_.size()),
                         largest_, barycentric_in(triangle, place.at));
  }
  if (problem_.solution && !out.empty()) {
    const std::vector<double> u = values_at_nodes(*problem_.solution, "/solution", level.surface, points);
    const auto radii = value_radii(*problem_.solution, level.surface, points, u);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].u = radii ? Approximation::estimated(u[i], (*radii)[i]) : Approximation::without_radius(u[i]);
      const double difference = std::abs(u[i] - out[i].u_n.value);
      out[i].u_n_error = radii && out[i].u_n.has_radius()
                             ? Approximation::estimated(difference, (*radii)[i] + out[i].u_n.radius +
                                                                        unit_roundoff<double>() * difference)
                             : Approximation::without_radius(difference);
    }
  }
  if (!iterated) return out;
  std::vector<CollocationPoint<double>> off_edges;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (is_on_edge(places[i])) continue;
    off_edges.push_back(points[i]);
    numbers.push_back(i);
  }
  if (off_edges.empty()) return out;
  const IteratedSolution iterate(problem_, level, basis_, u_n_, route);
  const std::vector<IteratedValue> values = iterate.at(off_edges);
  for (std::size_t k = 0; k < numbers.size(); ++k) out[numbers[k]].iterated = values[k];
  return out;
}

}  // namespace radcert
