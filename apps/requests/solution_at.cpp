// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/solution_at.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/reference/nearest_point.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/reference/polygon.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/surface/surface_function.h"

namespace radcert::app {

namespace {

/// Where a point lies.
struct Place {
  std::size_t element = 0;
  ParameterPoint<double> at;
  Vector<double> point;
  double distance = std::numeric_limits<double>::infinity();
};

/// The elements of a level with a ball about each.
class Elements {
public:
  explicit Elements(const NodedSurface& level) : level_(level) {
    Vector<double> low = level.nodes.front().point;
    Vector<double> high = low;
    for (const ParameterTriangle& triangle : level.triangulation.triangles) {
      const ChartIn<double>& chart = level.surface.charts[triangle.chart].in<double>();
      constexpr double third = 1.0 / 3;
      const Vector<double> centre = chart.frame(triangle.at({third, third, third})).point;
      double radius = 0;
      for (const ParameterPoint<double>& corner : triangle.vertices) {
        const Vector<double> p = chart.frame(corner).point;
        radius = std::max(radius, norm(p - centre));
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
      centres_.push_back(centre);
      radii_.push_back(radius);
    }
    extent_ = norm(high - low);
  }

  [[nodiscard]] double extent() const { return extent_; }

  [[nodiscard]] Place nearest(const Vector<double>& p) const {
    // A curved element may leave the ball about its corners: by no more than its radius again.
    constexpr double slack = 2;
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(centres_.size());
    for (std::size_t k = 0; k < centres_.size(); ++k)
      order.emplace_back(norm(p - centres_[k]) - slack * radii_[k], k);
    std::sort(order.begin(), order.end());
    Place best;
    for (const auto& [least, k] : order) {
      if (least > best.distance) break;
      const ParameterTriangle& triangle = level_.triangulation.triangles[k];
      const ChartIn<double>& chart = level_.surface.charts[triangle.chart].in<double>();
      const ParameterPoint<double> at =
          reference::nearest_to(p, chart, reference::counterclockwise(triangle.vertices));
      const Vector<double> point = chart.frame(at).point;
      const double distance = norm(point - p);
      if (distance < best.distance || (distance == best.distance && k < best.element))
        best = {.element = k, .at = at, .point = point, .distance = distance};
    }
    return best;
  }

private:
  const NodedSurface& level_;
  std::vector<Vector<double>> centres_;
  std::vector<double> radii_;
  double extent_ = 0;
};

/// A number with an estimated radius, or with none where that is infinite.
Approximation within(double value, double radius) {
  return std::isfinite(radius) ? Approximation::estimated(value, radius)
                               : Approximation::without_radius(value);
}

/// Barycentric coordinates of a parameter point in its triangle.
Barycentric<double> barycentric_in(const ParameterTriangle& triangle, const ParameterPoint<double>& at) {
  const auto& v = triangle.vertices;
  const auto cross = [](const ParameterPoint<double>& a, const ParameterPoint<double>& b) {
    return a.s * b.t - a.t * b.s;
  };
  const double whole = cross(v[1] - v[0], v[2] - v[0]);
  const double second = cross(at - v[0], v[2] - v[0]) / whole;
  const double third = cross(v[1] - v[0], at - v[0]) / whole;
  return {{1 - second - third, second, third}};
}

/// Whether a parameter point is on the border of its chart's domain, up to rounding.
bool on_border(const ParameterPoint<double>& at, ChartDomain domain) {
  constexpr double near = 1e-12;
  const double least = domain == ChartDomain::unit_square ? std::min({at.s, at.t, 1 - at.s, 1 - at.t})
                                                          : std::min({at.s, at.t, 1 - at.s - at.t});
  return least < near;
}

/// u_n from its values at the nodes.
class NodalValuesOf {
public:
  NodalValuesOf(const NodedSurface& level, TriangleBasis<double> basis, std::vector<double> values)
      : level_(level), basis_(std::move(basis)), values_(std::move(values)) {}

  /// The value at barycentric coordinates of an element, and sum |l_j| there.
  [[nodiscard]] std::pair<double, double> at(std::size_t element, const Barycentric<double>& x) const {
    std::vector<double> l(basis_.size());
    basis_.values(x, l);
    double value = 0;
    double size = 0;
    for (std::size_t j = 0; j < l.size(); ++j) {
      value += l[j] * values_[element * basis_.size() + j];
      size += std::abs(l[j]);
    }
    return {value, size};
  }
  /// As a density on one element.
  [[nodiscard]] reference::Density on(std::size_t element) const {
    return [this, element](const SurfacePoint<double>& q, const Vector<double>&) {
      return at(element, barycentric_in(level_.triangulation.triangles[element], q.at)).first;
    };
  }
  [[nodiscard]] double largest() const {
    double out = 0;
    for (const double value : values_) out = std::max(out, std::abs(value));
    return out;
  }

private:
  const NodedSurface& level_;
  TriangleBasis<double> basis_;
  std::vector<double> values_;
};

/// The data of the equation at points, and E + K u_n.
class Iterate {
public:
  Iterate(const Problem& problem, const NodedSurface& level, const NodalValuesOf& u_n, double node_radius)
      : level_(level),
        u_n_(u_n),
        node_radius_(node_radius),
        rho_(problem.reflectivity, level.surface),
        data_(problem.solution ? *problem.solution : *problem.emission, level.surface) {
    if (problem.solution) of_u_.emplace(level.surface, data_);
  }

  [[nodiscard]] Approximation at(const SurfacePoint<double>& p, const Vector<double>& point) const {
    constexpr double few_roundings = 0x1p-50;
    double sum = 0;
    double radius = 0;
    double size = 0;
    const auto add = [&](const Approximation& part, double sign) {
      sum += sign * part.value;
      radius += part.radius;
      size += std::abs(part.value);
    };
    for (std::size_t k = 0; k < level_.triangulation.triangles.size(); ++k) {
      throw_if_interrupted();
      const ParameterTriangle& triangle = level_.triangulation.triangles[k];
      add(reference::operator_integral(level_.surface, p, triangle.chart, triangle.vertices, u_n_.on(k)), 1);
    }
    if (of_u_) add((*of_u_)(p), -1);
    const double rho = rho_(p.chart, point);
    const double data = data_(p.chart, point);
    const double factor = rho / pi<double>();
    // Int G <= pi: nodal values within their radius move K u_n by no more than rho times that, and the
    // Lebesgue constant, which the radius that is passed in holds.
    const double moved = rho == 0 ? 0 : rho * node_radius_;
    return within(data + factor * sum,
                  factor * radius + moved + few_roundings * (std::abs(data) + factor * size));
  }

private:
  const NodedSurface& level_;
  const NodalValuesOf& u_n_;
  double node_radius_;
  SurfaceFunction rho_;
  SurfaceFunction data_;
  std::optional<reference::AppliedOperator> of_u_;
};

[[noreturn]] void refuse_point(std::size_t i, const Vector<double>& p, const std::string& problem,
                               const std::string& allowed) {
  throw InputError({.pointer = "points/" + std::to_string(i),
                    .value = "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")",
                    .problem = problem,
                    .allowed = allowed});
}

/// The largest of sum |l_j| over a lattice of the reference triangle: near the Lebesgue constant.
double largest_sum_of_functions(const TriangleBasis<double>& basis) {
  constexpr int cells = 32;
  std::vector<double> l(basis.size());
  double out = 1;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; i + j <= cells; ++j) {
      const double a = static_cast<double>(i) / cells;
      const double b = static_cast<double>(j) / cells;
      basis.values(Barycentric<double>{{a, b, 1 - a - b}}, l);
      double sum = 0;
      for (const double value : l) sum += std::abs(value);
      out = std::max(out, sum);
    }
  return out;
}

}  // namespace

std::vector<ValueAt> solution_at(const Solution& solution, std::size_t place,
                                 std::span<const Vector<double>> points, const AtChoice& choice,
                                 Progress& told) {
  const Problem& problem = solution.result.problem;
  const LevelOutcome& outcome = solution.levels.at(place);
  const auto* method = std::get_if<Collocation>(&problem.method);
  if (method == nullptr)
    throw InputError({.source = "at",
                      .problem = std::holds_alternative<Galerkin>(problem.method)
                                     ? "is not for Galerkin's method"
                                     : "is not for a meshless basis",
                      .allowed = "a basis of functions on triangles"});
  if (problem.geometry)
    throw InputError({.source = "at",
                      .problem = "is not for an interpolated geometry",
                      .allowed = "a problem without geometry"});
  const TriangleBasis<double> basis = triangle_basis(method->basis);
  const LevelGeometry geometry(problem, outcome.result.level, basis);
  const NodedSurface& level = geometry.data();
  if (choice.iterated && !level.surface.unoccluded)
    throw InputError({.source = "iterated",
                      .problem = "is not for a surface whose parts hide each other",
                      .allowed = "iterated=False"});
  const double tolerance = choice.tolerance;
  if (!(tolerance >= 0 && tolerance <= 1))
    throw InputError(
        {.source = "tolerance", .value = shortest(tolerance), .allowed = "a number from 0 to 1"});

  std::vector<double> nodal;
  double node_radius = 0;
  for (const NodeValue& node : outcome.nodes) {
    nodal.push_back(node.u_n.value);
    node_radius = std::max(node_radius, node.u_n.radius);
  }
  const NodalValuesOf u_n(level, basis, std::move(nodal));
  const Elements elements(level);
  std::optional<Iterate> iterate;
  if (choice.iterated) iterate.emplace(problem, level, u_n, node_radius * largest_sum_of_functions(basis));
  const Surface& surface = level.surface;
  const bool has_edges = surface.pieces_meet_at_angle || !surface.charts_join_smoothly || surface.mesh;

  std::vector<ValueAt> out(points.size());
  std::atomic<std::size_t> done = 0;
  parallel_for(points.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector<double>& p = points[i];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        refuse_point(i, p, "is not finite", "finite coordinates");
      const Place found = elements.nearest(p);
      if (!(found.distance <= tolerance * elements.extent()))
        refuse_point(i, p, "is off the surface, by " + shortest(found.distance),
                     "points within tolerance = " + shortest(tolerance) + " of its extent " +
                         shortest(elements.extent()));
      const ParameterTriangle& triangle = level.triangulation.triangles[found.element];
      const ChartFacts& facts = surface.charts[triangle.chart].facts();
      const auto [value, size] = u_n.at(found.element, barycentric_in(triangle, found.at));
      // A few roundings a term, and the coordinates' own.
      const double rounded = 0x1p-46 * size * u_n.largest();
      out[i] = {.point = found.point,
                .distance = found.distance,
                .piece = facts.piece,
                .u_n = within(value, node_radius * size + rounded)};
      if (iterate) {
        if (has_edges && on_border(found.at, facts.domain))
          refuse_point(i, p, "lies on an edge, where the iterate has no one value",
                       "points inside faces, or iterated=False");
        out[i].iterated = iterate->at({triangle.chart, found.at}, found.point);
      }
      told.say(static_cast<double>(++done) / static_cast<double>(points.size()), "points");
    }
  });
  return out;
}

}  // namespace radcert::app
