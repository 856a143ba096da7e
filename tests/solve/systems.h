// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/matrix.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/catalogue.h"

namespace radcert::test {

using Values = std::vector<double>;

inline Matrix<double> matrix(std::size_t n, const std::function<double(std::size_t, std::size_t)>& entry) {
  Matrix<double> a(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) a(i, j) = entry(i, j);
  return a;
}

/// Between -1 and 1.
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; }

inline Values random_values(std::mt19937_64& random, std::size_t n) {
  Values values(n);
  for (double& value : values) value = uniform(random);
  return values;
}

/// Random entries of both signs or of one, some rows empty; the sums of the sizes of the other rows are
/// `row_sum`, about.
inline Matrix<double> random_matrix(std::mt19937_64& random, std::size_t n, double row_sum, bool positive) {
  Matrix<double> k = matrix(
      n, [&](std::size_t, std::size_t) { return positive ? std::abs(uniform(random)) : uniform(random); });
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += std::abs(k(i, j));
    const double factor = random() % 5 == 0 ? 0 : row_sum / sum;
    for (std::size_t j = 0; j < n; ++j) k(i, j) *= factor;
  }
  return k;
}

/// (I - K) u = e by Gauss's elimination with pivoting in an arithmetic finer than double; nothing if I - K is
/// singular.
template <class R, class FromDouble, class Size>
std::optional<std::vector<R>> eliminated(const Matrix<double>& k, const Values& e, FromDouble number,
                                         Size size) {
  const std::size_t n = k.rows();
  std::vector<std::vector<R>> a(n, std::vector<R>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) a[i][j] = number(i == j ? 1.0 : 0.0) - number(k(i, j));
    a[i][n] = number(e[i]);
  }
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t i = c; i < n; ++i)
      if (size(a[pivot][c]) < size(a[i][c])) pivot = i;
    if (a[pivot][c] == R(0)) return std::nullopt;
    std::swap(a[c], a[pivot]);
    for (std::size_t i = c + 1; i < n; ++i) {
      const R factor = a[i][c] / a[c][c];
      for (std::size_t j = c; j <= n; ++j) a[i][j] -= factor * a[c][j];
    }
  }
  std::vector<R> u(n);
  for (std::size_t i = n; i-- > 0;) {
    u[i] = a[i][n];
    for (std::size_t j = i + 1; j < n; ++j) u[i] -= a[i][j] * u[j];
    u[i] /= a[i][i];
  }
  return u;
}

inline std::optional<std::vector<Rational>> exact_solution(const Matrix<double>& k, const Values& e) {
  return eliminated<Rational>(
      k, e, [](double x) { return Rational::exactly(x); }, [](const Rational& x) { return abs(x); });
}

/// The solution in long double, whose own error is some 2^-11 of what double may hope for.
inline std::vector<long double> long_solution(const Matrix<double>& k, const Values& e) {
  return eliminated<long double>(
             k, e, [](double x) { return static_cast<long double>(x); },
             [](long double x) { return std::abs(x); })
      .value();
}

/// What the rounding of long double may add to its own solution, for matrices with ||K|| <= theta in some
/// norm.
inline double long_rounding(double theta, double size) { return 0x1p-58 / (1 - theta) * size; }

/// max_i |u_i - v_i|
inline double largest_error(const std::vector<long double>& u, const Values& v) {
  long double error = 0;
  for (std::size_t i = 0; i < v.size(); ++i)
    error = std::max(error, std::abs(u[i] - static_cast<long double>(v[i])));
  return static_cast<double>(error);
}

inline double max_abs(const Values& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// A collocation matrix of the catalogue's surface (two_piece with p = 2) with a constant reflectivity.
inline CollocationMatrix<double> collocation_matrix(const std::string& name, int level, int degree,
                                                    double reflectivity, double alpha = 0.1) {
  const SurfaceDescription& description = *find_surface(name);
  const Surface surface = description.make(std::vector<Rational>(description.parameters.size(), Rational(2)));
  const Triangulation triangulation = triangulate(surface, level);
  const InsetBasis<double> basis(degree, alpha);
  const std::vector<CollocationPoint<double>> nodes = collocation_nodes(surface, triangulation, basis);
  const Values rho(nodes.size(), reflectivity);
  return assemble<double>(surface, triangulation, basis, nodes, rho);
}

}  // namespace radcert::test
