// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ellipsoid/sphere_function.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/scalar/ball_precision.h"

namespace radcert::certificate {
namespace {

constexpr double unit = 0x1p-53;
/// All of a bound's own roundings, of some ten thousand terms, and products of errors, are within this.
constexpr double generous = 1 + 0x1p-8;
/// More than all products below the normal numbers lose.
constexpr double underflow = 1e-280;

}  // namespace

double SphereSizes::rest(double tau) const {
  const double growth = std::exp(tau);
  double sum = 0;
  for (std::size_t n = of_degree.size(); n-- > 0;) sum = sum * growth + of_degree[n];
  return sum * (1 + 0x1p-30);
}

double SphereSizes::all(double tau) const { return (std::abs(constant) + rest(tau)) * (1 + 0x1p-30); }

TurnedPolynomial::TurnedPolynomial(int degree, std::span<const double> cosines, std::span<const double> sines)
    : degree_(degree), cosines_(cosines.begin(), cosines.end()), sines_(sines.begin(), sines.end()) {
  const std::size_t count = EllipsoidCertificate::count(degree);
  expects(degree >= 0 && degree <= most_sphere_powers && cosines.size() == count && sines.size() == count,
          "as many coefficients as the degree has", named("degree", degree));
  const auto n = static_cast<std::size_t>(degree);
  sizes_.of_degree.assign(n + 1, 0);
  sizes_.constant = cosines[0];
  std::size_t first = 0;
  std::vector<double> rows(n + 1);
  for (std::size_t m = 0; m <= n; ++m) {
    const std::size_t terms = n - m + 1;
    double from_here = 0;  // sum_(j >= k) |c_j|, and of those sums
    double b = 0;
    double before = 0;
    for (std::size_t k = terms; k-- > 0;) {
      const double size = std::abs(cosines[first + k]) + std::abs(sines[first + k]);
      from_here += size;
      const double beyond = before;  // of b_(k+2)
      before = b;
      b += from_here;
      rounding_ += unit * (size + beyond + 2 * b);
      slope_ += size * static_cast<double>(m + k * k);
      rows[m] += size;
      if (m + k > 0) sizes_.of_degree[m + k] += std::hypot(cosines[first + k], sines[first + k]);
    }
    first += terms;
  }
  double horner = 0;
  for (std::size_t m = n + 1; m-- > 0;) {
    horner += rows[m];
    rounding_ += 4 * unit * horner;
  }
  for (double& size : sizes_.of_degree) size *= generous;
}

Pack TurnedPolynomial::operator()(const Vector<Pack>& p) const {
  const Pack z = max(min(p.z, Pack(1.0)), Pack(-1.0));
  const Pack twice = z + z;
  Pack real(0.0);
  Pack imaginary(0.0);
  std::size_t end = cosines_.size();
  const auto n = static_cast<std::size_t>(degree_);
  for (std::size_t m = n + 1; m-- > 0;) {
    const std::size_t terms = n - m + 1;
    const std::size_t first = end - terms;
    Pack a(0.0);
    Pack a_before(0.0);
    Pack b(0.0);
    Pack b_before(0.0);
    for (std::size_t k = end; k-- > first + 1;) {
      const Pack a_next = fma(twice, a, Pack(cosines_[k]) - a_before);
      const Pack b_next = fma(twice, b, Pack(sines_[k]) - b_before);
      a_before = a;
      a = a_next;
      b_before = b;
      b = b_next;
    }
    a = fma(z, a, Pack(cosines_[first]) - a_before);
    b = fma(z, b, Pack(sines_[first]) - b_before);
    // a Re zeta^m + b Im zeta^m = Re (a - i b) zeta^m
    const Pack turned = fma(p.x, real, fma(-p.y, imaginary, a));
    imaginary = fma(p.x, imaginary, fma(p.y, real, -b));
    real = turned;
    end = first;
  }
  return real;
}

double TurnedPolynomial::error(double d) const { return (rounding_ + slope_ * d) * generous + underflow; }

Ball TurnedPolynomial::at(const Vector<Rational>& p) const {
  const BallPrecision precision(192);
  const Ball x(p.x);
  const Ball y(p.y);
  const Ball z(p.z);
  const auto n = static_cast<std::size_t>(degree_);
  std::vector<Ball> chebyshev{Ball(1), z};
  for (std::size_t k = 2; k <= n; ++k) chebyshev.push_back(Ball(2) * z * chebyshev[k - 1] - chebyshev[k - 2]);
  Ball real(1);
  Ball imaginary(0);
  Ball sum(0);
  std::size_t place = 0;
  for (std::size_t m = 0; m <= n; ++m) {
    for (std::size_t k = 0; m + k <= n; ++k, ++place)
      sum += (Ball(cosines_[place]) * real + Ball(sines_[place]) * imaginary) * chebyshev[k];
    const Ball turned = x * real - y * imaginary;
    imaginary = x * imaginary + y * real;
    real = turned;
  }
  return sum;
}

StretchedPolynomial::StretchedPolynomial(const std::vector<Monomial>& f, const Vector<Rational>& half_axes) {
  for (const Monomial& monomial : f) {
    const auto [i, j, k] = monomial.powers;
    degree_ = std::max(degree_, i + j + k);
  }
  expects(degree_ <= most_sphere_powers, "no more factors than most_sphere_powers", named("degree", degree_));
  sizes_.of_degree.assign(static_cast<std::size_t>(degree_) + 1, 0);
  for (const Monomial& monomial : f) {
    const auto [i, j, k] = monomial.powers;
    const Rational exact =
        monomial.coefficient * power(half_axes.x, i) * power(half_axes.y, j) * power(half_axes.z, k);
    const double coefficient = exact.to_double();
    is_finite_ = is_finite_ && std::isfinite(coefficient);
    const double size = std::abs(coefficient) * generous + underflow;
    const auto n = static_cast<std::size_t>(i + j + k);
    if (n == 0)
      sizes_.constant += coefficient;
    else
      sizes_.of_degree[n] += size;
    rounding_ += unit * size * static_cast<double>(n + f.size() + 8);
    slope_ += size * static_cast<double>(n);
    terms_.push_back({{static_cast<std::size_t>(i), static_cast<std::size_t>(j), static_cast<std::size_t>(k)},
                      coefficient});
  }
  // The constant, and its sum, to a few units.
  sizes_.of_degree[0] += rounding_;
}

Pack StretchedPolynomial::operator()(const Vector<Pack>& p) const {
  std::array<std::array<Pack, most_sphere_powers + 1>, 3> powers;
  const std::array<Pack, 3> at{p.x, p.y, p.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    powers[axis][0] = Pack(1.0);
    for (std::size_t k = 1; k <= static_cast<std::size_t>(degree_); ++k)
      powers[axis][k] = powers[axis][k - 1] * at[axis];
  }
  Pack sum(0.0);
  for (const Term& term : terms_)
    sum += Pack(term.coefficient) * powers[0][term.powers[0]] * powers[1][term.powers[1]] *
           powers[2][term.powers[2]];
  return sum;
}

double StretchedPolynomial::error(double d) const { return (rounding_ + slope_ * d) * generous + underflow; }

Rational value_of(const std::vector<Monomial>& f, const Vector<Rational>& at) {
  Rational sum = 0;
  for (const Monomial& monomial : f) {
    const auto [i, j, k] = monomial.powers;
    sum += monomial.coefficient * power(at.x, i) * power(at.y, j) * power(at.z, k);
  }
  return sum;
}

SphereDensity::SphereDensity(const EllipsoidCertificate& c)
    : emission(c.emission, c.half_axes),
      reflectivity(c.reflectivity, c.half_axes),
      q(c.degree, c.cosines, c.sines) {}

Pack SphereDensity::operator()(const Vector<Pack>& p) const {
  return fma(reflectivity(p), q(p), emission(p));
}

double SphereDensity::error(double d) const {
  const double of_rho = reflectivity.error(d);
  const double of_q = q.error(d);
  const double rho = reflectivity.sizes().all(0);
  const double size = q.sizes().all(0);
  return (emission.error(d) + rho * of_q + of_rho * (size + of_q) +
          2 * unit * (emission.sizes().all(0) + rho * size)) *
             generous +
         underflow;
}

double SphereDensity::constant() const {
  return std::fma(reflectivity.sizes().constant, q.sizes().constant, emission.sizes().constant);
}

double SphereDensity::rest(double tau) const {
  const double rho = std::abs(reflectivity.sizes().constant);
  return (emission.sizes().rest(tau) + rho * q.sizes().rest(tau) +
          reflectivity.sizes().rest(tau) * q.sizes().all(tau) + 4 * unit * std::abs(constant())) *
         generous;
}

}  // namespace radcert::certificate
