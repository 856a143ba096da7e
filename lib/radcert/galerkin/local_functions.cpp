// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/galerkin/local_functions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_modes.h"

namespace radcert {
namespace {

/// By how much the order of the finer of two rules is larger.
constexpr int finer_by = 3;

/// W_mn = Int w D_m D_n dS over an element.
Matrix<double> mass(const Surface& surface, const ParameterTriangle& triangle, int degree,
                    const SurfaceWeight& weight, int order) {
  const std::size_t count = mode_count(degree);
  const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
  const double parallelogram = triangle.doubled_area();
  const ChartIn<double>& chart = surface.charts[triangle.chart].in<double>();
  Matrix<double> out(count, count);
  std::vector<double> modes(count);
  for (std::size_t q = 0; q < rule.weights.size(); ++q) {
    const Frame<double> frame = chart.frame(triangle.at(rule.points[q].x));
    const double w = weight(triangle.chart, frame.point);
    expects(w > 0, "a positive weight", named("weight", w));
    const double at_point = rule.weights[q] * parallelogram * area_element(frame) * w;
    triangle_modes<double>(degree, rule.points[q], modes);
    for (std::size_t m = 0; m < count; ++m)
      for (std::size_t n = 0; n < count; ++n) out(m, n) += at_point * modes[m] * modes[n];
  }
  return out;
}

/// L of W = L L^T.
Matrix<double> cholesky(const Matrix<double>& w) {
  const std::size_t n = w.rows();
  Matrix<double> l(n, n);
  for (std::size_t j = 0; j < n; ++j) {
    double diagonal = w(j, j);
    for (std::size_t k = 0; k < j; ++k) diagonal -= l(j, k) * l(j, k);
    expects(diagonal > 0, "a positive definite mass matrix", named("pivot", diagonal));
    l(j, j) = std::sqrt(diagonal);
    for (std::size_t i = j + 1; i < n; ++i) {
      double entry = w(i, j);
      for (std::size_t k = 0; k < j; ++k) entry -= l(i, k) * l(j, k);
      l(i, j) = entry / l(j, j);
    }
  }
  return l;
}

/// L^-1 B, in place.
void solve_lower(const Matrix<double>& l, Matrix<double>& b) {
  for (std::size_t c = 0; c < b.columns(); ++c)
    for (std::size_t i = 0; i < l.rows(); ++i) {
      for (std::size_t k = 0; k < i; ++k) b(i, c) -= l(i, k) * b(k, c);
      b(i, c) /= l(i, i);
    }
}

/// The largest row sum of |L^-1 W L^-T - I|.
double distance_from_identity(const Matrix<double>& l, Matrix<double> w) {
  solve_lower(l, w);
  const std::size_t n = w.rows();
  Matrix<double> turned(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) turned(i, j) = w(j, i);
  solve_lower(l, turned);
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += std::abs(turned(i, j) - (i == j ? 1 : 0));
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace

LocalFunctions::LocalFunctions(const Surface& surface, const Triangulation& triangulation,
                               const TriangleBasis<double>& basis, const SurfaceWeight& weight)
    : basis_(basis), coefficients_(triangulation.triangles.size()), defects_(triangulation.triangles.size()) {
  const int degree = basis.degree();
  const std::size_t count = basis.size();
  const std::vector<Barycentric<double>> nodes = basis.nodes();
  Matrix<double> modes_at_nodes(count, count);
  for (std::size_t c = 0; c < count; ++c) triangle_modes<double>(degree, nodes[c], modes_at_nodes.column(c));
  parallel_for(coefficients_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const ParameterTriangle& triangle = triangulation.triangles[k];
      const Matrix<double> l =
          cholesky(mass(surface, triangle, degree, weight, mass_order(degree) + finer_by));
      Matrix<double> psi = modes_at_nodes;
      solve_lower(l, psi);
      coefficients_[k] = std::move(psi);
      defects_[k] = distance_from_identity(l, mass(surface, triangle, degree, weight, mass_order(degree)));
    }
  });
}

}  // namespace radcert
