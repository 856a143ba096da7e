// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/collocation_model.h"

#include <algorithm>
#include <array>
#include <random>

#include "radcert/core/contract.h"

namespace radcert::verification::ac98 {
namespace {

using Coordinates = std::array<Rational, 3>;  // u, t, s

// The nodes first.
std::vector<Coordinates> points_of_a_triangle(const Rational& alpha) {
  const Rational far = 1 - 2 * alpha;
  const Rational half(1, 2);
  const Rational third(1, 3);
  return {{far, alpha, alpha},
          {alpha, far, alpha},
          {alpha, alpha, far},
          {half, half, 0},
          {half, Rational(1, 4), Rational(1, 4)},
          {third, third, third}};
}

}  // namespace

RationalMatrix identity(std::size_t size) {
  RationalMatrix result(size, size);
  for (std::size_t i = 0; i < size; ++i) result(i, i) = 1;
  return result;
}

RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b) {
  expects(a.columns() == b.rows(), "matrices that fit", named("columns", a.columns()),
          named("rows", b.rows()));
  RationalMatrix result(a.rows(), b.columns());
  for (std::size_t j = 0; j < b.columns(); ++j)
    for (std::size_t k = 0; k < b.rows(); ++k) {
      if (b(k, j).sign() == 0) continue;
      for (std::size_t i = 0; i < a.rows(); ++i) result(i, j) += a(i, k) * b(k, j);
    }
  return result;
}

RationalMatrix operator+(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix result = a;
  for (std::size_t j = 0; j < a.columns(); ++j)
    for (std::size_t i = 0; i < a.rows(); ++i) result(i, j) += b(i, j);
  return result;
}

RationalMatrix operator-(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix result = a;
  for (std::size_t j = 0; j < a.columns(); ++j)
    for (std::size_t i = 0; i < a.rows(); ++i) result(i, j) -= b(i, j);
  return result;
}

RationalVector operator*(const RationalMatrix& a, const RationalVector& x) {
  expects(a.columns() == x.size(), "a vector that fits", named("columns", a.columns()),
          named("values", x.size()));
  RationalVector result(a.rows());
  for (std::size_t j = 0; j < a.columns(); ++j)
    for (std::size_t i = 0; i < a.rows(); ++i) result[i] += a(i, j) * x[j];
  return result;
}

RationalVector operator+(RationalVector a, const RationalVector& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b.at(i);
  return a;
}

RationalVector operator-(RationalVector a, const RationalVector& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b.at(i);
  return a;
}

RationalMatrix inverse(const RationalMatrix& a) {
  const std::size_t n = a.rows();
  RationalMatrix left = a;
  RationalMatrix right = identity(n);
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t pivot = p;
    while (pivot < n && left(pivot, p).sign() == 0) ++pivot;
    expects(pivot < n, "a regular matrix", named("column", p));
    const Rational scale = 1 / left(pivot, p);
    for (std::size_t j = 0; j < n; ++j) {
      swap(left(p, j), left(pivot, j));
      swap(right(p, j), right(pivot, j));
      left(p, j) *= scale;
      right(p, j) *= scale;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Rational factor = left(i, p);
      if (i == p || factor.sign() == 0) continue;
      for (std::size_t j = 0; j < n; ++j) {
        left(i, j) -= factor * left(p, j);
        right(i, j) -= factor * right(p, j);
      }
    }
  }
  return right;
}

Rational norm(const RationalVector& x) {
  Rational largest = 0;
  for (const Rational& each : x) largest = std::max(largest, abs(each));
  return largest;
}

Rational norm(const RationalMatrix& a) {
  Rational largest = 0;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    Rational sum = 0;
    for (std::size_t j = 0; j < a.columns(); ++j) sum += abs(a(i, j));
    largest = std::max(largest, sum);
  }
  return largest;
}

Rational differing(const RationalVector& a, const RationalVector& b) {
  expects(a.size() == b.size(), "vectors of one size", named("a", a.size()), named("b", b.size()));
  long count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] == b[i] ? 0 : 1;
  return {count};
}

Rational differing(const RationalMatrix& a, const RationalMatrix& b) {
  expects(a.rows() == b.rows() && a.columns() == b.columns(), "matrices of one size",
          named("rows of a", a.rows()), named("rows of b", b.rows()));
  long count = 0;
  for (std::size_t j = 0; j < a.columns(); ++j)
    for (std::size_t i = 0; i < a.rows(); ++i) count += a(i, j) == b(i, j) ? 0 : 1;
  return {count};
}

RationalVector CollocationModel::node_values() const {
  const RationalMatrix system = identity(nodes.size()) - r * k * b;
  return inverse(system) * (r * emission);
}

CollocationModel collocation_model(const Rational& alpha, unsigned seed) {
  constexpr std::size_t triangles = 3;
  const std::vector<Coordinates> points = points_of_a_triangle(alpha);
  const std::size_t size = triangles * points.size();
  CollocationModel model;
  model.r = RationalMatrix(3 * triangles, size);
  model.b = RationalMatrix(size, 3 * triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      model.nodes.push_back(t * points.size() + i);
      model.r(3 * t + i, model.nodes.back()) = 1;
    }
    for (std::size_t m = 0; m < points.size(); ++m)
      for (std::size_t i = 0; i < 3; ++i)
        model.b(t * points.size() + m, 3 * t + i) = (points[m].at(i) - alpha) / (1 - 3 * alpha);
  }
  model.p = model.b * model.r;
  std::mt19937_64 random(seed);
  const auto whole = [&random](long largest) {
    return static_cast<long>(random() % static_cast<unsigned long>(2 * largest + 1)) - largest;
  };
  constexpr long largest_entry = 9;
  model.k = RationalMatrix(size, size);
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t i = 0; i < size; ++i)
      model.k(i, j) = Rational(whole(largest_entry), 4 * largest_entry * static_cast<long>(size));
  for (std::size_t i = 0; i < size; ++i) model.u.emplace_back(whole(largest_entry));
  model.emission = model.u - model.k * model.u;
  return model;
}

}  // namespace radcert::verification::ac98
