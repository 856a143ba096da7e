// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/iterated_solution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "radcert/collocation/nodal_integral.h"
#include "radcert/core/contract.h"
#include "radcert/polynomial/basis_limits.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/study/collocation/node_data.h"
#include "radcert/study/operator_at_nodes.h"
#include "radcert/study/stopwatch.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr double unknown = std::numeric_limits<double>::infinity();

Approximation within(double value, double radius) {
  return std::isfinite(radius) ? Approximation::estimated(value, radius)
                               : Approximation::without_radius(value);
}

/// The radii of a function's values, infinite where they are not known.
std::vector<double> radii_of(const PiecewiseExpression& function, const Surface& surface,
                             std::span<const CollocationPoint<double>> points,
                             std::span<const double> values) {
  return value_radii(function, surface, points, values).value_or(std::vector<double>(points.size(), unknown));
}

/// A number times a radius that may be infinite, where 0 times anything is 0.
double times(double factor, double radius) { return factor == 0 ? 0 : factor * radius; }

/// The larger of two numbers without their signs, and the larger of their radii; for maxima of errors.
void take_larger(std::optional<Approximation>& largest, const Approximation& error) {
  const double value = std::abs(error.value);
  if (!largest) {
    largest = within(value, error.radius);
    return;
  }
  largest = within(std::max(largest->value, value), std::max(largest->radius, error.radius));
}

/// The weights of the rule of degree 2 over the check points, for the mean over a triangle: near the corners,
/// and near the middles of the sides.
/// Maths     3 a + 3 b = 1, and x_1^2 has the mean 1/6: 83/121 a + 73/169 b = 1/6
std::array<double, 6> check_weights() {
  const Rational of_a(83, 121);
  const Rational of_b(73, 169);
  const Rational a = (Rational(1, 6) - of_b / Rational(3)) / (of_a - of_b);
  const double near_corners = a.to_double();
  const double near_sides = (Rational(1, 3) - a).to_double();
  return {near_corners, near_corners, near_corners, near_sides, near_sides, near_sides};
}

/// Errors in the mean and means of the iterated solution, by the rule over the check points.
void describe_means(const NodedSurface& level, std::span<const IteratedValue> values,
                    std::span<const double> u, IteratedReport& report) {
  const std::array<double, 6> weights = check_weights();
  std::vector<Barycentric<double>> reference;
  for (const Barycentric<Rational>& x : check_points())
    reference.push_back({{x.x[0].to_double(), x.x[1].to_double(), x.x[2].to_double()}});
  struct OfPiece {
    double area = 0;
    double value = 0;
    double error = 0;
  };
  const std::vector<std::string> names = level.surface.piece_names();
  std::vector<OfPiece> by_piece(names.size());
  double square = 0;
  for (std::size_t k = 0; k < level.triangulation.triangles.size(); ++k) {
    const ParameterTriangle& triangle = level.triangulation.triangles[k];
    const double half_parallelogram = std::abs(triangle.doubled_area()) / 2;
    const ChartIn<double>& chart = level.surface.charts[triangle.chart].in<double>();
    OfPiece& piece = by_piece[level.surface.piece_of(triangle.chart)];
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const std::size_t i = k * weights.size() + j;
      const double weight =
          weights[j] * half_parallelogram * area_element(chart.frame(triangle.at(reference[j].x)));
      piece.area += weight;
      piece.value += weight * values[i].value.value;
      if (u.empty()) continue;
      const double error = u[i] - values[i].value.value;
      piece.error += weight * error;
      square += weight * error * error;
    }
  }
  double largest = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    report.piece_means.emplace_back(names[i], by_piece[i].value / by_piece[i].area);
    largest = std::max(largest, std::abs(by_piece[i].error / by_piece[i].area));
  }
  if (u.empty()) return;
  report.l2_error = std::sqrt(square);
  report.mean_error = largest;
}

/// The polynomial of degree 2 through the values at the check points, at the corners.
/// Result    of each corner the factors of the six values
std::array<std::array<double, most_basis_functions>, 3> parabola_at_corners() {
  const std::vector<Barycentric<Rational>> six = check_points();
  const TriangleBasis<double> parabola = make_triangle_basis<double>(lagrange_functions(six).value());
  std::array<std::array<double, most_basis_functions>, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) {
    Barycentric<double> corner{{0, 0, 0}};
    corner.x[c] = 1;
    parabola.values(corner, out[c]);
  }
  return out;
}

/// The values at the corners of the elements, each point of a chart taken once.
void draw(const IteratedSolution& iterated, const NodedSurface& level,
          std::span<const double> at_check_points, std::vector<ElementValue>& elements) {
  constexpr std::size_t points_an_element = 6;
  const std::array<std::array<double, most_basis_functions>, 3> parabola = parabola_at_corners();
  std::map<std::tuple<std::size_t, double, double>, std::size_t> number;
  std::vector<CollocationPoint<double>> corners;
  for (const ParameterTriangle& triangle : level.triangulation.triangles)
    for (const ParameterPoint<double>& at : triangle.vertices) {
      if (lies_on_edge(level.surface, {triangle.chart, at})) continue;
      if (number.try_emplace({triangle.chart, at.s, at.t}, corners.size()).second)
        corners.push_back(collocation_point<double>(level.surface, {triangle.chart, at}));
    }
  const std::vector<IteratedValue> values = iterated.at(corners);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const ParameterTriangle& triangle = level.triangulation.triangles[k];
    std::array<double, 3> of_element{};
    for (std::size_t c = 0; c < 3; ++c) {
      const ParameterPoint<double>& at = triangle.vertices[c];
      const auto found = number.find({triangle.chart, at.s, at.t});
      if (found != number.end()) {
        of_element[c] = values[found->second].value.value;
        continue;
      }
      for (std::size_t j = 0; j < points_an_element; ++j)
        of_element[c] += parabola[c][j] * at_check_points[k * points_an_element + j];
    }
    elements[k].iterated = of_element;
  }
}

}  // namespace

bool lies_on_edge(const Surface& surface, const SurfacePoint<double>& p) {
  if (!surface.pieces_meet_at_angle && surface.charts_join_smoothly && !surface.mesh) return false;
  constexpr double near = 1e-12;
  const double least = surface.charts[p.chart].facts().domain == ChartDomain::unit_square
                           ? std::min({p.at.s, p.at.t, 1 - p.at.s, 1 - p.at.t})
                           : std::min({p.at.s, p.at.t, 1 - p.at.s - p.at.t});
  return least < near;
}

IteratedSolution::IteratedSolution(const Problem& problem, const NodedSurface& level,
                                   const TriangleBasis<double>& basis, std::span<const Approximation> u_n,
                                   const OperatorRoute& route)
    : problem_(problem), level_(level), basis_(basis), route_(route) {
  expects(!problem.geometry, "a problem on an exact geometry");
  for (const Approximation& value : u_n) {
    u_n_.push_back(value.value);
    node_radius_ = std::max(node_radius_, value.radius);
  }
}

EmissionAtPoints IteratedSolution::emission(std::span<const CollocationPoint<double>> points) const {
  const Surface& surface = level_.surface;
  if (problem_.emission) {
    EmissionAtPoints given;
    given.values = values_at_nodes(*problem_.emission, "/emission", surface, points);
    given.radii = radii_of(*problem_.emission, surface, points, given.values);
    return given;
  }
  const std::vector<double> rho = reflectivity_at_nodes(problem_.reflectivity, surface, points);
  const std::vector<double> rho_radius = radii_of(problem_.reflectivity, surface, points, rho);
  EmissionAtPoints made;
  made.values = values_at_nodes(*problem_.solution, "/solution", surface, points);
  made.radii = radii_of(*problem_.solution, surface, points, made.values);
  const OperatorAtNodes ku = apply_operator(problem_, surface, route_, points, rho);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double of_rho = rho[i] > 0 ? times(std::abs(ku.value[i]) / rho[i], rho_radius[i]) : 0;
    made.radii[i] += ku.radius[i] + of_rho + unit * (std::abs(made.values[i]) + 4 * std::abs(ku.value[i]));
    made.values[i] -= ku.value[i];
  }
  return made;
}

std::vector<IteratedValue> IteratedSolution::at(std::span<const CollocationPoint<double>> points) const {
  return at(points, emission(points));
}

std::vector<IteratedValue> IteratedSolution::at(std::span<const CollocationPoint<double>> points,
                                                const EmissionAtPoints& emission) const {
  const Surface& surface = level_.surface;
  const std::vector<double> rho = reflectivity_at_nodes(problem_.reflectivity, surface, points);
  const std::vector<double> rho_radius = radii_of(problem_.reflectivity, surface, points, rho);
  std::vector<double> u;
  if (problem_.solution) u = values_at_nodes(*problem_.solution, "/solution", surface, points);
  const std::vector<NodalIntegral> integrals =
      nodal_integrals(surface, level_.triangulation, basis_, u_n_, points,
                      Tolerance(problem_.quadrature.tolerance.to_double()));
  const double roundings = unit * static_cast<double>(u_n_.size() + 8);
  std::vector<IteratedValue> out(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const NodalIntegral& of_u_n = integrals[i];
    const double factor = rho[i] / pi<double>();
    const double k_u_n = factor * of_u_n.value;
    IteratedValue::Terms& terms = out[i].terms;
    terms.quadrature = factor * of_u_n.left_out;
    terms.nodes = times(factor * of_u_n.weight, node_radius_);
    terms.data = emission.radii[i] + times(std::abs(of_u_n.value) / pi<double>(), rho_radius[i]);
    terms.rounding = roundings * (std::abs(emission.values[i]) + factor * of_u_n.size);
    const double radius = terms.quadrature + terms.nodes + terms.data + terms.rounding;
    out[i].value = within(emission.values[i] + k_u_n, radius);
    // E = u - Ku: the sum without u is K u_n - K u; its rounding is within that of the data.
    if (!u.empty())
      out[i].error =
          within(std::abs(k_u_n - (u[i] - emission.values[i])), radius + 2 * unit * std::abs(u[i]));
  }
  return out;
}

Approximation value_in_element(const TriangleBasis<double>& basis, std::span<const Approximation> of_element,
                               double largest, const Barycentric<double>& x) {
  // A few roundings a term, and the coordinates' own.
  constexpr double roundings = 0x1p-46;
  std::array<double, most_basis_functions> functions{};
  basis.values(x, functions);
  double value = 0;
  double size = 0;
  double radius = 0;
  for (std::size_t j = 0; j < of_element.size(); ++j) {
    value += functions[j] * of_element[j].value;
    size += std::abs(functions[j]);
    radius = std::max(radius, of_element[j].radius);
  }
  return within(value, times(size, radius) + roundings * size * largest);
}

std::vector<Barycentric<Rational>> check_points() {
  std::vector<Barycentric<Rational>> out;
  for (const auto& [one, two] :
       {std::pair(Rational(9, 11), Rational(1, 11)), std::pair(Rational(1, 13), Rational(6, 13))})
    for (std::size_t c = 0; c < 3; ++c) {
      Barycentric<Rational> x{{two, two, two}};
      x.x[c] = one;
      out.push_back(x);
    }
  return out;
}

std::vector<CollocationPoint<double>> check_points_of(const NodedSurface& level) {
  std::vector<Barycentric<double>> reference;
  for (const Barycentric<Rational>& x : check_points())
    reference.push_back({{x.x[0].to_double(), x.x[1].to_double(), x.x[2].to_double()}});
  std::vector<CollocationPoint<double>> out;
  out.reserve(level.triangulation.triangles.size() * reference.size());
  for (const ParameterTriangle& triangle : level.triangulation.triangles)
    for (const Barycentric<double>& x : reference)
      out.push_back(collocation_point<double>(level.surface, {triangle.chart, triangle.at(x.x)}));
  return out;
}

void describe_iterated(const Problem& problem, const NodedSurface& level, const TriangleBasis<double>& basis,
                       const EmissionAtPoints& emission, const OperatorRoute& route, LevelOutcome& outcome) {
  std::vector<Approximation> u_n;
  double largest = 0;
  for (const NodeValue& node : outcome.nodes) {
    u_n.push_back(node.u_n);
    largest = std::max(largest, std::abs(node.u_n.value));
  }
  const IteratedSolution iterated(problem, level, basis, u_n, route);
  const std::vector<CollocationPoint<double>> points = check_points_of(level);
  const Stopwatch data;
  const EmissionAtPoints at_check_points = iterated.emission(points);
  if (problem.solution) outcome.timing.operator_seconds += data.seconds();
  const Stopwatch watch;
  const std::vector<IteratedValue> values = iterated.at(points, at_check_points);
  outcome.timing.iterated_seconds = watch.seconds();
  std::vector<Barycentric<double>> reference;
  for (const Barycentric<Rational>& x : check_points())
    reference.push_back({{x.x[0].to_double(), x.x[1].to_double(), x.x[2].to_double()}});

  IteratedReport report{.check_points = points.size(), .u_n_error = {}, .node_error = {}};
  std::vector<double> u;
  if (problem.solution) u = values_at_nodes(*problem.solution, "/solution", level.surface, points);
  std::optional<Approximation> difference;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t k = i / reference.size();
    const Approximation of_u_n =
        value_in_element(basis, std::span(u_n).subspan(k * basis.size(), basis.size()), largest,
                         reference[i % reference.size()]);
    take_larger(difference,
                within(values[i].value.value - of_u_n.value, values[i].value.radius + of_u_n.radius));
    if (u.empty()) continue;
    take_larger(outcome.result.iterated_error, *values[i].error);
    take_larger(report.u_n_error,
                within(u[i] - of_u_n.value, of_u_n.radius + values[i].terms.data + unit * std::abs(u[i])));
  }
  report.difference = *difference;
  if (problem.solution)
    for (const IteratedValue& at_node : iterated.at(level.nodes, emission))
      take_larger(report.node_error, *at_node.error);

  describe_means(level, values, u, report);
  outcome.result.iterated = report;

  std::vector<double> drawn;
  for (const IteratedValue& value : values) drawn.push_back(value.value.value);
  draw(iterated, level, drawn, outcome.elements);
}

}  // namespace radcert
