// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/symmetric_system.h"

#include <utility>

#include "radcert/scalar/dual.h"

namespace radcert {
namespace {

// e_2^two e_3^three.
struct Invariant {
  int two;
  int three;
};

std::vector<Invariant> invariants(int precision) {
  std::vector<Invariant> list;
  for (int two = 0; 2 * two <= precision; ++two)
    for (int three = 0; 2 * two + 3 * three <= precision; ++three) list.push_back({two, three});
  return list;
}

// Int_sigma e_2^i e_3^j, by the multinomial theorem and Int x_1^a x_2^b x_3^c = a! b! c!/(a + b + c + 2)!.
Rational integral(const Invariant& f) {
  Rational sum = 0;
  for (int p = 0; p <= f.two; ++p)
    for (int q = 0; p + q <= f.two; ++q) {
      const int t = f.two - p - q;
      const Rational terms = factorial(f.two) / (factorial(p) * factorial(q) * factorial(t));
      sum += terms * factorial(p + t + f.three) * factorial(p + q + f.three) * factorial(q + t + f.three);
    }
  return sum / factorial(2 * f.two + 3 * f.three + 2);
}

}  // namespace

Rational factorial(int n) {
  Rational product = 1;
  for (int k = 2; k <= n; ++k) product *= k;
  return product;
}

std::vector<Ball*> unknowns_of(SymmetricBox& box) {
  std::vector<Ball*> all;
  for (OrbitBox& orbit : box)
    for (Ball* unknown : orbit.unknowns()) all.push_back(unknown);
  return all;
}

BallResiduals symmetric_residuals(const SymmetricBox& box, int precision, std::size_t unknowns) {
  const std::vector<Invariant> list = invariants(precision);
  BallResiduals out{.values = {}, .derivatives = Matrix<Ball>(list.size(), unknowns)};
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Ball scale = Ball(1 / integral(list[k]));
    Ball sum(-1);
    std::size_t place = 0;
    for (const OrbitBox& orbit : box) {
      const Dual<Ball> a(orbit.a, Ball(1), Ball(0));
      const Dual<Ball> b(orbit.b, Ball(0), Ball(1));
      const auto x = orbit.coordinates(a, b);
      const Dual<Ball> e2 = x[0] * x[1] + x[1] * x[2] + x[2] * x[0];
      const Dual<Ball> e3 = x[0] * x[1] * x[2];
      const Dual<Ball> value = power(e2, list[k].two) * power(e3, list[k].three);
      const Ball factor = scale * Ball(orbit.size);
      sum += factor * orbit.weight * value.value;
      out.derivatives(k, place++) = factor * value.value;
      if (orbit.size >= 3 && !orbit.is_held) out.derivatives(k, place++) = factor * orbit.weight * value.by_s;
      if (orbit.size == 6) out.derivatives(k, place++) = factor * orbit.weight * value.by_t;
    }
    out.values.push_back(sum);
  }
  return out;
}

std::size_t pivot_row(const Matrix<Ball>& a, std::size_t p) {
  std::size_t best = p;
  for (std::size_t i = p + 1; i < a.rows(); ++i)
    if (certainly_less(abs(a(best, p)).midpoint(), abs(a(i, p)).midpoint())) best = i;
  return best;
}

void exchange_rows(Matrix<Ball>& a, std::size_t i, std::size_t k) {
  if (i == k) return;
  for (std::size_t j = 0; j < a.columns(); ++j) swap(a(i, j), a(k, j));
}

std::optional<Matrix<Ball>> approximate_inverse(Matrix<Ball> a) {
  const std::size_t n = a.rows();
  Matrix<Ball> inverse(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    inverse(i, i) = Ball(1);
    for (std::size_t j = 0; j < n; ++j) a(i, j) = a(i, j).midpoint();
  }
  for (std::size_t p = 0; p < n; ++p) {
    const std::size_t row = pivot_row(a, p);
    exchange_rows(a, p, row);
    exchange_rows(inverse, p, row);
    if (a(p, p).contains_zero()) return std::nullopt;
    const Ball scale = reciprocal(a(p, p));
    for (std::size_t j = 0; j < n; ++j) {
      a(p, j) = (a(p, j) * scale).midpoint();
      inverse(p, j) = (inverse(p, j) * scale).midpoint();
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == p) continue;
      const Ball factor = a(i, p);
      for (std::size_t j = 0; j < n; ++j) {
        a(i, j) = (a(i, j) - factor * a(p, j)).midpoint();
        inverse(i, j) = (inverse(i, j) - factor * inverse(p, j)).midpoint();
      }
    }
  }
  return inverse;
}

}  // namespace radcert
