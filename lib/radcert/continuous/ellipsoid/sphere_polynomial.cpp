// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/ellipsoid/sphere_polynomial.h"

#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "radcert/continuous/upward.h"
#include "radcert/core/contract.h"
#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
/// No size is 0 where a coefficient is not.
constexpr double least_size = std::numeric_limits<double>::min();
/// Numbers of a formula: powers of powers grow without end.
constexpr std::size_t most_bits = 65536;

int degree_of(const SpacePolynomial& f) {
  int degree = 0;
  for (const auto& [powers, c] : f) degree = std::max(degree, powers[0] + powers[1] + powers[2]);
  return degree;
}

void add(SpacePolynomial& f, const std::array<int, 3>& powers, const Rational& c) {
  Rational& sum = f[powers];
  sum += c;
  if (sum.sign() == 0) f.erase(powers);
}

/// Of its largest numerator or denominator.
std::size_t bits_of(const SpacePolynomial& f) {
  std::size_t most = 0;
  for (const auto& [powers, c] : f) {
    const auto* const fraction = static_cast<mpq_srcptr>(c.gmp());
    most = std::max({most, mpz_sizeinbase(mpq_numref(fraction), 2), mpz_sizeinbase(mpq_denref(fraction), 2)});
  }
  return most;
}

SpacePolynomial sum_of(SpacePolynomial f, const SpacePolynomial& g, const Rational& factor) {
  for (const auto& [powers, c] : g) add(f, powers, factor * c);
  return f;
}

SpacePolynomial product_of(const SpacePolynomial& f, const SpacePolynomial& g) {
  SpacePolynomial out;
  for (const auto& [p, c] : f)
    for (const auto& [q, d] : g) add(out, {p[0] + q[0], p[1] + q[1], p[2] + q[2]}, c * d);
  return out;
}

SpacePolynomial constant_of(const Rational& c) {
  SpacePolynomial out;
  add(out, {0, 0, 0}, c);
  return out;
}

/// (X + 1)^i (X - 1)^j = sum_a e_a X^a.
/// Maths     x^i y^j = 2^-n (-i)^j sum_a e_a zeta^a conj(zeta)^(n-a), n = i + j, (-i)^j a power of the
///           imaginary unit
RationalPolynomial binomial_product(int i, int j) {
  RationalPolynomial out(1);
  const RationalPolynomial sum(std::vector<Rational>{1, 1});
  const RationalPolynomial difference(std::vector<Rational>{-1, 1});
  for (int k = 0; k < i; ++k) out *= sum;
  for (int k = 0; k < j; ++k) out *= difference;
  return out;
}

/// z f, both by their coefficients for Chebyshev's polynomials: z T_k = (T_(k+1) + T_(k-1)) / 2.
template <class R>
std::vector<R> times_z(const std::vector<R>& f, const R& half) {
  std::vector<R> out(f.size() + 1, R(0));
  for (std::size_t k = 0; k < f.size(); ++k) {
    if (k == 0) {
      out[1] += f[0];
      continue;
    }
    const R part = half * f[k];
    out[k + 1] += part;
    out[k - 1] += part;
  }
  return out;
}

/// By Horner's rule.
std::vector<Rational> chebyshev_coefficients(const RationalPolynomial& f) {
  std::vector<Rational> out{0};
  for (int k = f.degree(); k >= 0; --k) {
    if (k < f.degree()) out = times_z(out, Rational(1, 2));
    out[0] += f.coefficient(static_cast<std::size_t>(k));
  }
  return out;
}

}  // namespace

Outcome<SpacePolynomial> space_polynomial(const Expression& f) {
  const auto too_high = [] {
    return because("its degree is more than " + std::to_string(most_sphere_degree));
  };
  std::vector<SpacePolynomial> values;
  for (const ExpressionNode& node : f.nodes()) {
    const auto operand = [&](int place) -> const SpacePolynomial& {
      return values[static_cast<std::size_t>(place)];
    };
    SpacePolynomial made;
    switch (node.kind) {
      case ExpressionKind::literal: made = constant_of(node.literal); break;
      case ExpressionKind::variable: {
        std::array<int, 3> powers{};
        powers[static_cast<std::size_t>(node.variable)] = 1;
        add(made, powers, 1);
        break;
      }
      case ExpressionKind::negate: made = sum_of({}, operand(node.left), -1); break;
      case ExpressionKind::add: made = sum_of(operand(node.left), operand(node.right), 1); break;
      case ExpressionKind::subtract: made = sum_of(operand(node.left), operand(node.right), -1); break;
      case ExpressionKind::multiply:
        if (degree_of(operand(node.left)) + degree_of(operand(node.right)) > most_sphere_degree)
          return too_high();
        made = product_of(operand(node.left), operand(node.right));
        break;
      case ExpressionKind::divide: {
        const SpacePolynomial& by = operand(node.right);
        if (by.empty() || degree_of(by) > 0) return because("it divides by what is not a constant");
        made = sum_of({}, operand(node.left), Rational(1) / by.begin()->second);
        break;
      }
      case ExpressionKind::power: {
        if (!node.whole_exponent || *node.whole_exponent < 0)
          return because("an exponent is not a whole number");
        const SpacePolynomial& base = operand(node.left);
        if (*node.whole_exponent > most_sphere_degree ||
            degree_of(base) * *node.whole_exponent > most_sphere_degree)
          return too_high();
        made = constant_of(1);
        for (long k = 0; k < *node.whole_exponent && bits_of(made) <= most_bits; ++k)
          made = product_of(made, base);
        break;
      }
      default: return because("it is not written as a polynomial with rational coefficients");
    }
    if (bits_of(made) > most_bits)
      return because("it has a number of more than " + std::to_string(most_bits) + " bits");
    values.push_back(std::move(made));
  }
  return std::move(values.back());
}

void SpherePolynomial::allocate(int degree) {
  expects(degree >= 0 && degree <= most_sphere_degree, "0 <= degree <= most_sphere_degree",
          named("degree", degree));
  degree_ = degree;
  std::size_t count = 0;
  for (int m = 0; m <= degree; ++m) {
    first_.push_back(count);
    count += 2 * static_cast<std::size_t>(degree - m + 1);
  }
  coefficients_.assign(count, 0);
  sizes_.assign(static_cast<std::size_t>(degree + 1), 0);
}

/// `enclosing` bounds what all coefficients together are off.
void SpherePolynomial::bound_rounding(double enclosing) {
  constexpr double displaced = sphere_displacement / unit;
  double sum = 0;
  for (int m = 0; m <= degree_; ++m)
    for (int k = 0; k <= degree_ - m; ++k) {
      const double* const c = &coefficients_[place(m) + 2 * static_cast<std::size_t>(k)];
      const double of_chebyshev = (0.51 + displaced) * k * k;
      const double of_power = (2 + displaced) * m;
      const double of_sums = (degree_ - m + 1) + 2 * (degree_ + 1);
      sum += (std::abs(c[0]) + std::abs(c[1])) * (of_chebyshev + of_power + of_sums);
    }
  // Far more than what some thousand products may lose by underflow.
  constexpr double underflow = 1e-290;
  rounding_ = (unit * sum + enclosing) * (1 + 0x1p-20) + underflow;
}

SpherePolynomial::SpherePolynomial(const Rational& constant) {
  allocate(0);
  constant_ = constant.to_double();
  expects(std::isfinite(constant_), "a constant within the range of double");
  coefficients_[0] = constant_;
  sizes_[0] = abs(constant - Rational::exactly(constant_)).to_double() * upward;
  bound_rounding(sizes_[0]);
}

SpherePolynomial::SpherePolynomial(int degree, std::span<const double> harmonics) {
  allocate(degree);
  const auto powers = static_cast<std::size_t>(degree + 1);
  expects(harmonics.size() == powers * powers, "(degree + 1)^2 coefficients",
          named("coefficients", harmonics.size()));
  const Ball half(Rational(1, 2));
  double enclosing_radius = 0;
  Ball first(1);  // Y_mm / sin^m
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) first *= sqrt(Ball(m == 1 ? Rational(3) : Rational(2 * m + 1, 2 * m)));
    std::vector<Ball> cosines(static_cast<std::size_t>(degree - m + 1));
    std::vector<Ball> sines = cosines;
    std::vector<Ball> before;
    std::vector<Ball> now{first};
    Ball b_now;
    for (int l = m; l <= degree; ++l) {
      const auto at = static_cast<std::size_t>(l * l + l);
      const Ball c(harmonics[at + static_cast<std::size_t>(m)]);
      const Ball d(m == 0 ? 0.0 : harmonics[at - static_cast<std::size_t>(m)]);
      for (std::size_t k = 0; k < now.size(); ++k) {
        cosines[k] += c * now[k];
        sines[k] += d * now[k];
      }
      if (l == degree) break;
      const long n = l + 1;
      const Ball b_next = sqrt(Ball(Rational(n * n - static_cast<long>(m) * m, 4 * n * n - 1)));
      std::vector<Ball> next = times_z(now, half);
      for (std::size_t k = 0; k < before.size(); ++k) next[k] -= b_now * before[k];
      for (Ball& value : next) value /= b_next;
      before = std::exchange(now, std::move(next));
      b_now = b_next;
    }
    for (std::size_t k = 0; k < cosines.size(); ++k) {
      const Approximation a = enclosing(cosines[k]);
      const Approximation b = enclosing(sines[k]);
      coefficients_[place(m) + 2 * k] = a.value;
      coefficients_[place(m) + 2 * k + 1] = b.value;
      enclosing_radius += (a.radius + b.radius) * upward;
    }
  }
  constant_ = harmonics[0];
  for (int l = 1; l <= degree; ++l) {
    const std::span<const double> own =
        harmonics.subspan(static_cast<std::size_t>(l * l), static_cast<std::size_t>(2 * l + 1));
    // Over the largest, whose square may be beyond the range of double.
    double largest = 0;
    for (const double c : own) largest = std::isfinite(c) ? std::max(largest, std::abs(c)) : HUGE_VAL;
    if (largest == 0) continue;
    double squares = 0;
    for (const double c : own) squares += (c / largest) * (c / largest);
    sizes_[static_cast<std::size_t>(l)] =
        std::max(largest * std::sqrt((2 * l + 1) * squares) * upward, least_size);
  }
  bound_rounding(enclosing_radius);
}

Outcome<SpherePolynomial> SpherePolynomial::along(const Expression& f, const Vector<Rational>& half_axes) {
  const Outcome<SpacePolynomial> in_space = space_polynomial(f);
  if (!in_space) return because(in_space.reason());
  const int degree = degree_of(in_space.value());
  const auto count = static_cast<std::size_t>(degree + 1);
  std::vector<RationalPolynomial> cosines(count);
  std::vector<RationalPolynomial> sines(count);
  const RationalPolynomial height = RationalPolynomial::variable();
  const RationalPolynomial radius_squared = RationalPolynomial(1) - height * height;
  for (const auto& [powers, coefficient] : in_space.value()) {
    const auto [i, j, k] = powers;
    Rational scaled = coefficient * power(half_axes.x, i) * power(half_axes.y, j) * power(half_axes.z, k);
    const int n = i + j;
    for (int halving = 0; halving < n; ++halving) scaled = scaled * Rational(1, 2);
    if (j / 2 % 2 == 1) scaled = -scaled;
    RationalPolynomial in_height(scaled);
    for (int factor = 0; factor < k; ++factor) in_height *= height;
    const RationalPolynomial e = binomial_product(i, j);
    // The pair zeta^a conj(zeta)^(n-a) and its conjugate: 2 Re zeta^m for even j, 2 Im zeta^m for odd, m = 2a
    // - n, times (1 - z^2)^(n-a)
    for (int a = n; 2 * a >= n; --a) {
      const int m = 2 * a - n;
      const RationalPolynomial term =
          in_height *
          RationalPolynomial(e.coefficient(static_cast<std::size_t>(a)) * Rational(m == 0 ? 1 : 2));
      if (m > 0 || j % 2 == 0) (j % 2 == 0 ? cosines : sines)[static_cast<std::size_t>(m)] += term;
      in_height *= radius_squared;
    }
  }
  SpherePolynomial out;
  out.first_.clear();
  out.allocate(degree);
  double off = 0;
  for (int m = 0; m <= degree; ++m) {
    for (const bool is_sine : {false, true}) {
      const std::vector<Rational> c =
          chebyshev_coefficients((is_sine ? sines : cosines)[static_cast<std::size_t>(m)]);
      for (std::size_t k = 0; k < c.size(); ++k) {
        if (c[k].sign() == 0) continue;
        const double rounded = c[k].to_double();
        if (!std::isfinite(rounded)) return because("a coefficient is beyond the range of double");
        const double error = abs(c[k] - Rational::exactly(rounded)).to_double() * upward;
        out.coefficients_[out.place(m) + 2 * k + (is_sine ? 1 : 0)] = rounded;
        off += error;
        const bool is_constant = m == 0 && k == 0;
        out.sizes_[static_cast<std::size_t>(m) + k] += is_constant ? error : std::abs(rounded) + error;
        if (is_constant) out.constant_ = rounded;
      }
    }
  }
  for (double& size : out.sizes_) size *= upward;
  out.bound_rounding(off * upward);
  return out;
}

std::array<Pack, 2> SpherePolynomial::operator()(const SpherePoints& at) const {
  if (degree_ == 0) return {Pack(coefficients_[0]), Pack(coefficients_[0])};
  std::array<std::array<Pack, 2>, most_sphere_degree + 1> chebyshev;
  std::array<Pack, 2> x;
  std::array<Pack, 2> y;
  for (std::size_t i = 0; i < 2; ++i) {
    x[i] = at[i].x;
    y[i] = at[i].y;
    const Pack z = max(min(at[i].z, Pack(1.0)), Pack(-1.0));
    const Pack twice = z + z;
    chebyshev[0][i] = Pack(1.0);
    chebyshev[1][i] = z;
    for (std::size_t k = 1; k < static_cast<std::size_t>(degree_); ++k)
      chebyshev[k + 1][i] = fma(twice, chebyshev[k][i], -chebyshev[k - 1][i]);
  }
  std::array<Pack, 2> sum{Pack(0.0), Pack(0.0)};
  std::array<Pack, 2> cosine{Pack(1.0), Pack(1.0)};
  std::array<Pack, 2> sine{Pack(0.0), Pack(0.0)};
  for (int m = 0; m <= degree_; ++m) {
    const double* const c = &coefficients_[place(m)];
    const auto count = static_cast<std::size_t>(degree_ - m + 1);
    Pack a0(0.0);
    Pack a1(0.0);
    Pack b0(0.0);
    Pack b1(0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const Pack a(c[2 * k]);
      const Pack b(c[2 * k + 1]);
      a0 = fma(a, chebyshev[k][0], a0);
      a1 = fma(a, chebyshev[k][1], a1);
      b0 = fma(b, chebyshev[k][0], b0);
      b1 = fma(b, chebyshev[k][1], b1);
    }
    const std::array<Pack, 2> a{a0, a1};
    const std::array<Pack, 2> b{b0, b1};
    for (std::size_t i = 0; i < 2; ++i) {
      sum[i] = fma(cosine[i], a[i], fma(sine[i], b[i], sum[i]));
      const Pack turned = fma(x[i], cosine[i], -(y[i] * sine[i]));
      sine[i] = fma(x[i], sine[i], y[i] * cosine[i]);
      cosine[i] = turned;
    }
  }
  return sum;
}

double SpherePolynomial::variation(double tau) const {
  const double factor = std::exp(tau);
  double sum = 0;
  for (std::size_t l = sizes_.size(); l-- > 0;) sum = sum * factor + sizes_[l];
  return sum * upward;
}

double SpherePolynomial::largest() const { return (std::abs(constant_) + variation(0)) * upward; }

}  // namespace radcert
