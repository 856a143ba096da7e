// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/nodal_function.h"

#include <array>
#include <cmath>
#include <vector>

#include "radcert/polynomial/basis_limits.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/study/errors/piece_sums.h"

namespace radcert {
namespace {

constexpr int finer_mean_order = 16;

/// Area, and Int l_j of every function over an element.
struct Moments {
  double area = 0;
  std::array<double, most_basis_functions> functions{};
  std::array<double, most_basis_functions> sizes{};  ///< Int |l_j|
};

Moments moments(const NodalFunction& u_n, std::size_t k, const TriangleRule<double>& rule) {
  const ParameterTriangle& triangle = u_n.triangulation().triangles[k];
  const double parallelogram = triangle.doubled_area();
  const ChartIn<double>& chart = u_n.surface().charts[triangle.chart].in<double>();
  Moments found;
  std::array<double, most_basis_functions> values{};
  for (std::size_t q = 0; q < rule.weights.size(); ++q) {
    const double weight =
        rule.weights[q] * parallelogram * area_element(chart.frame(triangle.at(rule.points[q].x)));
    u_n.basis().values(rule.points[q], values);
    found.area += weight;
    for (std::size_t j = 0; j < u_n.basis().size(); ++j) {
      found.functions[j] += weight * values[j];
      found.sizes[j] += weight * std::abs(values[j]);
    }
  }
  return found;
}

}  // namespace

double NodalFunction::at(std::size_t element, const Barycentric<double>& x) const {
  std::array<double, most_basis_functions> functions;
  basis_.values(x, functions);
  double sum = 0;
  for (std::size_t j = 0; j < basis_.size(); ++j) sum += functions[j] * values_[element * basis_.size() + j];
  return sum;
}

ComputedFunction NodalFunction::computed() const {
  return {
      surface_, triangulation_,
      [this] { return [this](std::size_t element, const Barycentric<double>& x) { return at(element, x); }; },
      ranks_};
}

double radius_of_means(const NodalFunction& u_n, double node_radius) {
  const ComputedFunction computed = u_n.computed();
  const std::size_t functions = u_n.basis().size();
  const TriangleRule<double> rule = conical_rule<double>(nodal_mean_order, Grading::none);
  const TriangleRule<double> finer = conical_rule<double>(finer_mean_order, Grading::none);
  // Roundings of a term, of the sum over a rule, over the functions and over the elements.
  const double roundings = unit_roundoff<double>() *
                           static_cast<double>(rule.weights.size() + functions + all_elements(computed) + 64);
  // Area and Int u_n of a piece, each with its error.
  const auto sums = piece_sums<4>(computed, [&](const auto&, std::size_t k) {
    const ChartFacts& facts = u_n.surface().charts[u_n.triangulation().triangles[k].chart].facts();
    const Moments now = moments(u_n, k, rule);
    const Moments better = facts.plane ? now : moments(u_n, k, finer);
    std::array<double, 4> found{};
    auto& [area, area_error, integral, integral_error] = found;
    area = now.area;
    area_error = std::abs(better.area - now.area) + roundings * now.area;
    for (std::size_t j = 0; j < functions; ++j) {
      const double value = u_n.value(k, j);
      integral += now.functions[j] * value;
      integral_error += std::abs(now.functions[j]) * node_radius +
                        std::abs(better.functions[j] - now.functions[j]) * std::abs(value) +
                        roundings * now.sizes[j] * std::abs(value);
    }
    return found;
  });
  double largest = 0;
  for (const auto& [area, area_error, integral, integral_error] : sums) {
    const double mean = std::abs(integral) / area;
    const double radius = (integral_error + mean * area_error) / (area - area_error);
    largest = larger_bound(largest, radius);
  }
  return largest;
}

}  // namespace radcert
