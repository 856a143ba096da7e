// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/plane_entries.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <utility>

#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/collocation/certified/exact_nodes.h"
#include "radcert/collocation/certified/exchanged_corners.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball_precision.h"

namespace radcert {
namespace {

constexpr int largest_degree = 8;
/// Far below the rounding of an entry to double: no entry that is seen is smaller than its element's solid
/// angle.
constexpr double wanted_bits = 60;
constexpr long least_bits = 128;
const WorkLimit most_bits("collocation/plane_entries: bits of an entry", 4096, 64,
                          "refused: an entry is not enclosed");

bool is_reversed(const PlaneChart& element) {
  return element.orientation == Orientation::against_the_cross_product;
}

std::vector<PlaneNode> nodes_of(std::span<const PlaneChart> elements, const LagrangeFunctions& functions) {
  std::vector<PlaneNode> nodes;
  for (const PlaneChart& element : elements)
    for (const Barycentric<Rational>& q : functions.nodes())
      nodes.push_back({element.point({q.x[1], q.x[2]}), element.normal()});
  return nodes;
}

/// 1/pi times the integrals of polynomials over one polygon; nothing if the precision does not suffice.
std::optional<std::vector<Approximation>> integrals_at(const PlaneNode& node, const PlanePolygon& polygon,
                                                       std::span<const PlanePolynomial<Rational>> functions,
                                                       int degree) {
  const std::vector<Ball> moments = point_to_polygon_moments<Ball>(node.point, node.normal, polygon, degree);
  std::vector<Approximation> integrals;
  for (const PlanePolynomial<Rational>& q : functions) {
    Ball sum = 0;
    for (std::size_t m = 0; m < q.coefficients().size(); ++m) sum += Ball(q.coefficients()[m]) * moments[m];
    sum = sum / Ball::pi();
    const bool narrow = sum.is_finite() &&
                        (certainly_zero(sum) || sum.accurate_bits() > wanted_bits || sum.radius() < 0x1p-80);
    if (!narrow) return std::nullopt;
    integrals.push_back(enclosing(sum));
  }
  return integrals;
}

std::optional<std::vector<Approximation>> integrals(const PlaneNode& node, const PlanePolygon& polygon,
                                                    std::span<const PlanePolynomial<Rational>> functions,
                                                    int degree) {
  const long most = most_bits.value();
  for (long bits = least_bits; bits <= most; bits *= 2) {
    const BallPrecision scope(bits);
    if (auto found = integrals_at(node, polygon, functions, degree)) return found;
  }
  return std::nullopt;
}

}  // namespace

Outcome<CertifiedEntries> plane_entries_in_balls(std::span<const PlaneChart> elements,
                                                 const LagrangeFunctions& functions) {
  expects(functions.degree() <= largest_degree, "functions of degree at most 8",
          named("degree", functions.degree()));
  const std::size_t p = functions.size();
  const std::size_t n = elements.size() * p;
  const std::vector<PlaneNode> nodes = nodes_of(elements, functions);
  const std::vector<PlanePolynomial<Rational>> polynomials = by_monomials(functions);
  CertifiedEntries result{.entries = Matrix<double>::uninitialised(n, n),
                          .radius = Matrix<double>::uninitialised(n, n)};
  std::atomic<bool> all_narrow = true;
  parallel_for(elements.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const PlanePolygon polygon = polygon_of(elements[k], {{0, 0}, {1, 0}, {0, 1}});
      std::vector<PlanePolynomial<Rational>> on_polygon;
      for (const PlanePolynomial<Rational>& q : polynomials)
        on_polygon.push_back(on_polygon_of(elements[k], q));
      for (std::size_t i = 0; i < n; ++i) {
        const auto values = integrals(nodes[i], polygon, on_polygon, functions.degree());
        if (!values) {
          all_narrow = false;
          return;
        }
        for (std::size_t j = 0; j < p; ++j) {
          result.entries(i, k * p + j) = (*values)[j].value;
          result.radius(i, k * p + j) = (*values)[j].radius;
        }
      }
    }
  });
  if (!all_narrow)
    return because("an entry of the collocation matrix is not found with " +
                   std::to_string(most_bits.value()) + " bits");
  return result;
}

Outcome<CertifiedEntries> certified_plane_entries(std::span<const PlaneChart> elements,
                                                  const LagrangeFunctions& functions) {
  // The bound of certified_entries takes the functions to have the sum 1.
  if (functions.reproduced_degree() < 0) return plane_entries_in_balls(elements, functions);
  const bool some_reversed = std::any_of(elements.begin(), elements.end(), is_reversed);
  const auto exchanged = places_when_exchanged(functions);
  if (some_reversed && !exchanged) return plane_entries_in_balls(elements, functions);
  std::vector<ExactTriangle> triangles;
  for (const PlaneChart& element : elements) {
    const Vector<Rational> second = element.origin + element.first;
    const Vector<Rational> third = element.origin + element.second;
    triangles.push_back(is_reversed(element) ? ExactTriangle{element.origin, third, second}
                                             : ExactTriangle{element.origin, second, third});
  }
  Outcome<CertifiedEntries> found =
      certified_entries(triangles, functions, std::vector<double>(elements.size() * functions.size(), 1.0));
  if (!found) return plane_entries_in_balls(elements, functions);
  if (!some_reversed) return found;
  std::vector<bool> reversed;
  for (const PlaneChart& element : elements) reversed.push_back(is_reversed(element));
  return reordered(*found, reversed, *exchanged);
}

std::vector<Ball> plane_operator(std::span<const PlaneChart> charts, std::span<const ChartDomain> domains,
                                 std::span<const PlanePolynomial<Rational>> density,
                                 std::span<const PlaneNode> points) {
  expects(domains.size() == charts.size() && density.size() == charts.size(),
          "one domain and one polynomial a chart", named("charts", charts.size()),
          named("domains", domains.size()), named("polynomials", density.size()));
  std::vector<PlanePolygon> polygons;
  std::vector<PlanePolynomial<Rational>> on_polygons;
  for (std::size_t j = 0; j < charts.size(); ++j) {
    PolygonLoop domain = domains[j] == ChartDomain::unit_square ? PolygonLoop{{0, 0}, {1, 0}, {1, 1}, {0, 1}}
                                                                : PolygonLoop{{0, 0}, {1, 0}, {0, 1}};
    polygons.push_back(polygon_of(charts[j], std::move(domain)));
    on_polygons.push_back(on_polygon_of(charts[j], density[j]));
  }
  std::vector<Ball> result(points.size());
  const long bits = BallPrecision::current();
  parallel_for(points.size(), 1, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(bits);
    for (std::size_t i = begin; i < end; ++i) {
      Ball sum = 0;
      for (std::size_t j = 0; j < charts.size(); ++j)
        sum += point_to_polygon(points[i].point, points[i].normal, polygons[j], on_polygons[j]);
      result[i] = sum;
    }
  });
  return result;
}

}  // namespace radcert
