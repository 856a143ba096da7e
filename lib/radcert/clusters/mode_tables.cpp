// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/mode_tables.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "radcert/clusters/interpolation_nodes.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/pack.h"

namespace radcert {
namespace {

using Corners = std::array<Barycentric<double>, 3>;

constexpr Corners whole{Barycentric<double>{{1, 0, 0}}, Barycentric<double>{{0, 1, 0}},
                        Barycentric<double>{{0, 0, 1}}};

Barycentric<double> middle(const Barycentric<double>& a, const Barycentric<double>& b) {
  Barycentric<double> m;
  for (std::size_t i = 0; i < 3; ++i) m.x[i] = (a.x[i] + b.x[i]) / 2;
  return m;
}

/// The point of a part that has the coordinates y there.
Barycentric<double> point_in(const Corners& corners, const Barycentric<double>& y) {
  Barycentric<double> x;
  for (std::size_t i = 0; i < 3; ++i)
    x.x[i] = y.x[0] * corners[0].x[i] + y.x[1] * corners[1].x[i] + y.x[2] * corners[2].x[i];
  return x;
}

/// The parts that some symmetric refinements make of a triangle, in the order of Triangulation.
std::vector<Corners> refined_parts(int refinements) {
  std::vector<Corners> parts{whole};
  for (int k = 0; k < refinements; ++k) {
    std::vector<Corners> finer;
    for (const Corners& part : parts)
      for (const Corners& child : children_of_triangle(part)) finer.push_back(child);
    parts = std::move(finer);
  }
  return parts;
}

/// The inverse of a square matrix of long doubles, stored by rows, by elimination with partial pivoting.
std::vector<long double> inverse(std::vector<long double> a, std::size_t n) {
  std::vector<long double> b(n * n);
  for (std::size_t i = 0; i < n; ++i) b[i * n + i] = 1;
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t largest = p;
    for (std::size_t i = p + 1; i < n; ++i)
      if (std::abs(a[i * n + p]) > std::abs(a[largest * n + p])) largest = i;
    if (largest != p)
      for (std::size_t j = 0; j < n; ++j) {
        std::swap(a[p * n + j], a[largest * n + j]);
        std::swap(b[p * n + j], b[largest * n + j]);
      }
    const long double scale = 1 / a[p * n + p];
    for (std::size_t j = 0; j < n; ++j) {
      a[p * n + j] *= scale;
      b[p * n + j] *= scale;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const long double factor = a[i * n + p];
      if (i == p || factor == 0) continue;
      for (std::size_t j = p; j < n; ++j) a[i * n + j] -= factor * a[p * n + j];
      for (std::size_t j = 0; j < n; ++j) b[i * n + j] -= factor * b[p * n + j];
    }
  }
  return b;
}

ModeInterpolation make_interpolation(int degree) {
  ModeInterpolation result{};
  result.nodes = interpolation_nodes(degree);
  const std::size_t k = result.nodes.size();
  std::vector<long double> values(k * k);
  for (std::size_t a = 0; a < k; ++a) {
    Barycentric<long double> x;
    for (std::size_t i = 0; i < 3; ++i) x.x[i] = result.nodes[a].x[i];
    triangle_modes<long double>(degree, x, std::span(values).subspan(a * k, k));
  }
  const std::vector<long double> modes = inverse(std::move(values), k);
  const std::size_t rows = padded<double>(k);
  result.modes_of_values = Matrix<double>(rows, k);
  result.values_of_modes_transposed = Matrix<double>(rows, k);
  for (std::size_t n = 0; n < k; ++n)
    for (std::size_t a = 0; a < k; ++a)
      result.modes_of_values(n, a) = result.values_of_modes_transposed(a, n) =
          static_cast<double>(modes[n * k + a]);
  return result;
}

/// Sizes of basis functions are taken on the parts of so many refinements, by rules of this degree.
constexpr int cuts_of_sizes = 4;
constexpr int degree_of_sizes = 3;

/// A rule of weights that sum to 1, exact for polynomials of a degree.
TriangleRule<double> mean_rule(int degree) {
  TriangleRule<double> rule = conical_rule<double>(degree / 2 + 1, Grading::none);
  for (double& weight : rule.weights) weight *= 2;
  return rule;
}

}  // namespace

std::array<std::array<Barycentric<double>, 3>, 4> children_of_triangle(const Corners& corners) {
  const auto& [v1, v2, v3] = corners;
  const Barycentric<double> m12 = middle(v1, v2);
  const Barycentric<double> m23 = middle(v2, v3);
  const Barycentric<double> m31 = middle(v3, v1);
  return {Corners{v1, m12, m31}, Corners{m12, v2, m23}, Corners{m31, m23, v3}, Corners{m23, m31, m12}};
}

const ModeTables& ModeTables::instance() {
  static const ModeTables tables;
  return tables;
}

ModeTables::ModeTables() {
  for (int degree = 0; degree <= largest_mode_degree; ++degree)
    interpolations_.push_back(make_interpolation(degree));

  const std::size_t modes = mode_count(largest_mode_degree);
  const std::size_t rows = padded<double>(modes);
  std::vector<double> in_parent(modes);
  std::vector<double> in_child(modes);
  std::vector<std::size_t> first_of_degree;  // by mode
  for (std::size_t degree = 0; degree <= largest_mode_degree; ++degree)
    first_of_degree.insert(first_of_degree.end(), degree + 1, degree * (degree + 1) / 2);
  const TriangleRule<double> rule = mean_rule(2 * largest_mode_degree);
  const auto children = children_of_triangle(whole);
  for (std::size_t c = 0; c < children.size(); ++c) {
    Matrix<double>& up = to_parent_[c] = Matrix<double>(rows, modes);
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      triangle_modes<double>(largest_mode_degree, point_in(children[c], rule.points[q]), in_parent);
      triangle_modes<double>(largest_mode_degree, rule.points[q], in_child);
      for (std::size_t m = 0; m < modes; ++m) {
        const double factor = rule.weights[q] * in_child[m];
        double* column = up.column(m).data();
        for (std::size_t n = first_of_degree[m]; n < modes; ++n) column[n] += factor * in_parent[n];
      }
    }
    Matrix<double>& down = to_child_[c] = Matrix<double>(rows, modes);
    for (std::size_t n = 0; n < modes; ++n)
      for (std::size_t m = 0; m < modes; ++m) down(m, n) = up(n, m);
  }
}

std::vector<Barycentric<double>> points_of_parts(int refinements,
                                                 std::span<const Barycentric<double>> points) {
  std::vector<Barycentric<double>> found;
  for (const Corners& part : refined_parts(refinements))
    for (const Barycentric<double>& x : points) found.push_back(point_in(part, x));
  return found;
}

LeafTables::LeafTables(std::size_t number, int degree)
    : unknowns(number),
      moments(padded<double>(mode_count(degree)), unknowns),
      absolute_moments(padded<double>(mode_count(degree)), unknowns),
      values(padded<double>(unknowns), mode_count(degree)),
      moments_of_one{1} {}

LeafTables::LeafTables(const TriangleBasis<double>& basis, int refinements, int degree)
    : LeafTables((std::size_t{1} << static_cast<unsigned>(2 * refinements)) * basis.size(), degree) {
  const std::vector<Corners> elements = refined_parts(refinements);
  const double share = 1 / static_cast<double>(elements.size());
  const std::size_t p = basis.size();
  const std::vector<Barycentric<double>> nodes = basis.nodes();
  std::vector<double> modes(mode_count(degree));
  std::vector<double> functions(p);

  const TriangleRule<double> exact = mean_rule(degree + basis.degree());
  const std::vector<Corners> parts = refined_parts(cuts_of_sizes);
  const TriangleRule<double> positive = mean_rule(degree_of_sizes);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    for (std::size_t q = 0; q < exact.points.size(); ++q) {
      basis.values(exact.points[q], functions);
      triangle_modes<double>(degree, point_in(elements[k], exact.points[q]), modes);
      for (std::size_t j = 0; j < p; ++j)
        for (std::size_t n = 0; n < modes.size(); ++n)
          moments(n, k * p + j) += share * exact.weights[q] * functions[j] * modes[n];
    }
    for (std::size_t j = 0; j < p; ++j) {
      triangle_modes<double>(degree, point_in(elements[k], nodes[j]), modes);
      for (std::size_t n = 0; n < modes.size(); ++n) values(k * p + j, n) = modes[n];
    }
    for (const Corners& part : parts)
      for (std::size_t q = 0; q < positive.points.size(); ++q) {
        const double weight = positive.weights[q] / static_cast<double>(parts.size());
        const Barycentric<double> x = point_in(part, positive.points[q]);
        basis.values(x, functions);
        triangle_modes<double>(degree, point_in(elements[k], x), modes);
        for (std::size_t j = 0; j < p; ++j)
          for (std::size_t n = 0; n < modes.size(); ++n)
            absolute_moments(n, k * p + j) += share * weight * std::abs(functions[j]) * modes[n];
      }
  }
}

double size_of_functions(const TriangleBasis<double>& basis) {
  const std::vector<Corners> parts = refined_parts(cuts_of_sizes);
  const TriangleRule<double> positive = mean_rule(degree_of_sizes);
  std::vector<double> functions(basis.size());
  double squares = 0;
  for (const Corners& part : parts)
    for (std::size_t q = 0; q < positive.points.size(); ++q) {
      basis.values(point_in(part, positive.points[q]), functions);
      double sum = 0;
      for (const double value : functions) sum += std::abs(value);
      squares += positive.weights[q] * sum * sum;
    }
  return std::sqrt(squares / static_cast<double>(parts.size()));
}

}  // namespace radcert
