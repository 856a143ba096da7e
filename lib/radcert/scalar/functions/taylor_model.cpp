// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/functions/taylor_model.h"

#include <acb.h>
#include <acb_poly.h>
#include <algorithm>
#include <arb.h>
#include <cmath>
#include <optional>

#include "radcert/core/contract.h"
#include "radcert/scalar/complex_ball.h"

namespace radcert {

namespace {

constexpr int top = TaylorModel::highest_degree;
using Norms = std::array<double, static_cast<std::size_t>(top) + 1>;

/// Sums and products of fewer than a thousand numbers that are not negative err by less than this factor.
constexpr double up = 1 + 0x1p-40;
/// More than what underflow takes from all terms of one operation.
constexpr double underflow = 0x1p-1000;
/// The square of a number below it does not overflow, nor the sixth power of the reciprocal of one in the
/// range for divisors.
constexpr double largest = 1e150;
constexpr double largest_divisor = 1e45;

constexpr std::size_t place(int degree, int power_of_v) {
  return static_cast<std::size_t>(degree * (degree + 1) / 2 + power_of_v);
}

/// Squares below 2^-1022 lose digits: those of numbers below 2^-511.
double size_of(double real, double imag) { return std::sqrt(real * real + imag * imag) + 0x1p-500; }

const char* first_failure(const char* a, const char* b) { return a != nullptr ? a : b; }

/// Series around the centre: phi_k with the error of each as a part of `tail`, a bound of the terms from
/// degree 5 on.
struct Series {
  std::array<ComplexDouble, static_cast<std::size_t>(top) + 1> coefficients;
  std::array<double, static_cast<std::size_t>(top) + 1> errors;
  double tail;
};

}  // namespace

/// The inside of a model, for this source.
/// Limits    not for formulas
struct TaylorModelAccess {
  using T = TaylorModel;

  static const char* failure(const T& x) { return x.failure_; }

  /// By degree, sum of |c_ij|.
  static Norms norms(const T& x) {
    Norms result{};
    for (int d = 0; d <= x.degree_; ++d)
      for (int j = 0; j <= d; ++j) {
        const double re = x.real_[place(d, j)];
        const double im = x.imag_[place(d, j)];
        if (re != 0 || im != 0) result[static_cast<std::size_t>(d)] += size_of(re, im);
      }
    return result;
  }
  static double sum(const Norms& norms) {
    double result = 0;
    for (const double norm : norms) result += norm;
    return result;
  }

  static bool is_zero(const T& x) {
    if (x.failure_ != nullptr || x.remainder_ != 0) return false;
    for (std::size_t k = 0; k < place(x.degree_ + 1, 0); ++k)
      if (x.real_[k] != 0 || x.imag_[k] != 0) return false;
    return true;
  }

  /// The failure of numbers that have become too large, NaN among them.
  static T checked(T x, double norm) {
    if (!(norm + x.remainder_ < largest)) return T::failed("numbers beyond the range of double");
    return x;
  }

  static T constant(const ComplexDouble& value, double error) {
    T x;
    x.real_[0] = value.real;
    x.imag_[0] = value.imag;
    x.remainder_ = error;
    return x;
  }

  static T variable(const ComplexDouble& centre, double radius, int power_of_v) {
    expects(std::isfinite(centre.real) && std::isfinite(centre.imag) && std::isfinite(radius) && radius >= 0,
            "a finite centre, a finite radius >= 0", named("radius", radius));
    T x = constant(centre, 0);
    x.real_[place(1, power_of_v)] = radius;
    x.degree_ = 1;
    return x;
  }

  /// Knuth's two-sum.
  static double rounding_of_sum(double a, double b) {
    const double s = a + b;
    const double of_b = s - a;
    return std::abs((a - (s - of_b)) + (b - of_b));
  }

  static T sum(const T& a, const T& b) {
    const T& longer = a.degree_ >= b.degree_ ? a : b;
    const T& shorter = a.degree_ >= b.degree_ ? b : a;
    T result = longer;
    for (std::size_t k = 0; k < place(shorter.degree_ + 1, 0); ++k) {
      result.real_[k] += shorter.real_[k];
      result.imag_[k] += shorter.imag_[k];
    }
    const double norm = sum(norms(result));
    double rounding =
        0x1p-52 * norm;  // each part by 2^-53 of itself, together by less than 2^-52 of the coefficient
    if (result.degree_ == 0) {  // constants: exact sums stay exact
      rounding = rounding_of_sum(a.real_[0], b.real_[0]) + rounding_of_sum(a.imag_[0], b.imag_[0]);
    }
    result.remainder_ = (a.remainder_ + b.remainder_ + rounding) * up;
    return checked(std::move(result), norm);
  }

  static T product(const T& a, const T& b) {
    const Norms of_a = norms(a);
    const Norms of_b = norms(b);
    T result;
    result.degree_ = std::min(top, a.degree_ + b.degree_);
    double beyond = 0;
    for (int d = 0; d <= a.degree_; ++d) {
      for (int e = 0; e <= b.degree_; ++e) {
        if (d + e > top) {
          beyond += of_a[static_cast<std::size_t>(d)] * of_b[static_cast<std::size_t>(e)];
          continue;
        }
        const double* re_b = &b.real_[place(e, 0)];
        const double* im_b = &b.imag_[place(e, 0)];
        for (int i = 0; i <= d; ++i) {
          const double re = a.real_[place(d, i)];
          const double im = a.imag_[place(d, i)];
          double* re_out = &result.real_[place(d + e, i)];
          double* im_out = &result.imag_[place(d + e, i)];
          for (int j = 0; j <= e; ++j) {
            re_out[j] += re * re_b[j] - im * im_b[j];
            im_out[j] += re * im_b[j] + im * re_b[j];
          }
        }
      }
    }
    // A coefficient is a sum of at most 15 products of complex numbers: each part has at most 15 + 3
    // roundings, each of 2^-53 of the sum of the terms' sizes, so both together err by less than 2^-48 of
    // that, and all coefficients by 2^-47 of the norms.
    const double norm_a = sum(of_a);
    const double norm_b = sum(of_b);
    result.remainder_ = (beyond + norm_a * b.remainder_ + norm_b * a.remainder_ +
                         a.remainder_ * b.remainder_ + 0x1p-47 * norm_a * norm_b + underflow) *
                        up;
    return checked(std::move(result), norm_a * norm_b);
  }

  static T hull(const T& a, const T& b) {
    const T half = constant({0.5, 0}, 0);
    T middle = product(half, sum(a, b));
    const T spread = product(half, sum(a, -b));
    if (!middle.is_finite() || !spread.is_finite()) return T::failed("numbers beyond the range of double");
    // a = middle + spread, b = middle - spread, each with its own remainder inside the two.
    middle.remainder_ = (middle.remainder_ + sum(norms(spread)) + spread.remainder_) * up;
    return checked(std::move(middle), sum(norms(middle)));
  }

  /// sum_k phi_k (x - c)^k by Horner's rule.
  static T composed(const T& x, const Series& series) {
    T h = x;
    h.real_[0] = 0;
    h.imag_[0] = 0;
    const auto term = [&series](int k) {
      const auto at = static_cast<std::size_t>(k);
      return constant(series.coefficients[at], series.errors[at]);
    };
    T result = term(top);
    for (int k = top - 1; k >= 0; --k) {
      if (!result.is_finite()) return result;
      result = sum(product(result, h), term(k));
    }
    if (!result.is_finite()) return result;
    result.remainder_ = (result.remainder_ + series.tail) * up;
    return checked(std::move(result), 0);
  }
};

namespace {

using Access = TaylorModelAccess;

/// A complex ball as a double and a bound of its distance.
void store(const ComplexBall& value, ComplexDouble& number, double& error) {
  const Ball real = value.real();
  const Ball imag = value.imag();
  number = {real.to_double(), imag.to_double()};
  error = (value - ComplexBall(Ball(number.real), Ball(number.imag))).magnitude_bound() * up;
}

/// What a function of a model needs to know: c and |x - c|.
struct Argument {
  ComplexDouble c;
  double size;  ///< of c, rounded down
  double deviation;
  double ratio;  ///< deviation / size, rounded up
};

constexpr long working_bits = 64;

Argument argument_of(const TaylorModel& x) {
  const ComplexDouble c = x.centre();
  const double size = std::sqrt(c.real * c.real + c.imag * c.imag) / up;
  const double deviation = x.deviation();
  return {.c = c, .size = size, .deviation = deviation, .ratio = deviation / size * up};
}

ComplexBall ball(const ComplexDouble& c) { return ComplexBall(Ball(c.real), Ball(c.imag)); }

/// Whether c may be divided by, a power of its reciprocal included, and no value is 0.
bool is_divisor(const Argument& x) {
  return 1 / largest_divisor < x.size && x.size < largest_divisor && x.ratio < 1;
}

/// Whether the disk around c has a point on (-inf, 0].
bool touches_the_cut(const Argument& x) {
  return !is_divisor(x) || (x.c.real <= 0 && std::abs(x.c.imag) <= x.deviation * up);
}

ComplexDouble times(const ComplexDouble& a, const ComplexDouble& b) {
  return {a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real};
}

ComplexDouble inverse_of(const ComplexDouble& c) {
  const double square = c.real * c.real + c.imag * c.imag;
  return {c.real / square, -c.imag / square};
}

/// The principal root.
ComplexDouble root_of(const ComplexDouble& c) {
  const double larger = std::sqrt((std::sqrt(c.real * c.real + c.imag * c.imag) + std::abs(c.real)) / 2);
  const double smaller = std::abs(c.imag) / (2 * larger);
  return c.real >= 0 ? ComplexDouble{larger, std::copysign(smaller, c.imag)}
                     : ComplexDouble{smaller, std::copysign(larger, c.imag)};
}

/// c^a (1 + z)^a with phi_0 = c^a, phi_k = phi_0 binom(a, k) / c^k: for -1 <= a <= 1, |binom(a, k)| does not
/// grow from k = 1 on. phi_0 and 1/c err by less than 6 2^-53 of themselves (sums of positive numbers, roots,
/// quotients), a step by less than 12 more: phi_5 by less than 2^-46 of itself.
Series binomial_series(const Argument& x, const ComplexDouble& at_centre, double exponent) {
  Series series{};
  const ComplexDouble inverse = inverse_of(x.c);
  ComplexDouble term = at_centre;
  double size = 0;
  for (int k = 0; k <= top + 1; ++k) {
    size = size_of(term.real, term.imag);
    if (k > top) break;
    const auto at = static_cast<std::size_t>(k);
    series.coefficients[at] = term;
    series.errors[at] = 0x1p-46 * size;
    const double factor = (exponent - k) / (k + 1);
    term = times(term, {factor * inverse.real, factor * inverse.imag});
  }
  const double h = x.deviation;
  series.tail = size * (h * h * h * h * h) / (1 - x.ratio) * up;
  static_assert(top + 1 == 5, "the first power that is left out");
  return series;
}

/// Of exp, sin and cos: derivatives at c over k!, none of them larger than `size`.
Series entire_series(const Argument& x, const std::array<ComplexBall, 4>& derivatives, double size) {
  Series series{};
  Ball factorial(1);
  for (int k = 0; k <= top; ++k) {
    if (k > 0) factorial *= Ball(k);
    const auto at = static_cast<std::size_t>(k);
    store(derivatives[at % 4] / ComplexBall(factorial), series.coefficients[at], series.errors[at]);
  }
  const Ball h(x.deviation);
  series.tail = (Ball(size) * exp(h) * power(h, top + 1) / (factorial * Ball(top + 1))).upper_double();
  return series;
}

/// The derivative of the sine of that order, of x: 0 for the sine, 1 for the cosine.
TaylorModel circular(const TaylorModel& x, std::size_t order) {
  if (!x.is_finite()) return x;
  const BallPrecision inside(working_bits);
  const Argument at = argument_of(x);
  const ComplexBall centre = ball(at.c);
  std::array<ComplexBall, 4> derivatives{sin(centre), cos(centre), -sin(centre), -cos(centre)};
  std::rotate(derivatives.begin(), derivatives.begin() + static_cast<std::ptrdiff_t>(order),
              derivatives.end());
  const double size = exp(abs(centre.imag())).upper_double();
  if (!(size < largest)) return TaylorModel::failed("numbers beyond the range of double");
  return Access::composed(x, entire_series(at, derivatives, size));
}

}  // namespace

TaylorModel::TaylorModel(const Rational& value) {
  const BallPrecision inside(working_bits);
  *this = TaylorModel(Ball(value));
}

TaylorModel::TaylorModel(const Ball& value) {
  if (!value.is_finite()) {
    failure_ = value.failure().data();
    return;
  }
  real_[0] = value.to_double();
  if (!(std::abs(real_[0]) < largest)) {
    *this = failed("numbers beyond the range of double");
    return;
  }
  const Ball rest = value - Ball(real_[0]);
  remainder_ =
      certainly_zero(rest) ? 0 : std::max(std::abs(rest.lower_double()), std::abs(rest.upper_double()));
}

TaylorModel TaylorModel::variable_u(const ComplexDouble& centre, double radius) {
  return Access::variable(centre, radius, 0);
}

TaylorModel TaylorModel::variable_v(const ComplexDouble& centre, double radius) {
  return Access::variable(centre, radius, 1);
}

TaylorModel TaylorModel::failed(const char* reason) {
  expects(reason != nullptr && *reason != '\0', "a failure with a reason");
  TaylorModel result;
  result.remainder_ = HUGE_VAL;
  result.failure_ = reason;
  return result;
}

double TaylorModel::magnitude_bound() const {
  return is_finite() ? (Access::sum(Access::norms(*this)) + remainder_) * up : HUGE_VAL;
}

ComplexDouble TaylorModel::centre() const {
  expects(is_finite(), "a finite model", named("failure", failure()));
  return {real_[0], imag_[0]};
}

double TaylorModel::deviation() const {
  expects(is_finite(), "a finite model", named("failure", failure()));
  Norms norms = Access::norms(*this);
  norms[0] = 0;
  return (Access::sum(norms) + remainder_) * up;
}

ComplexDouble TaylorModel::coefficient(int i, int j) const {
  expects(i >= 0 && j >= 0 && i + j <= highest_degree, "0 <= i, j and i + j <= 4", named("i", i),
          named("j", j));
  return {real_[place(i + j, j)], imag_[place(i + j, j)]};
}

TaylorModel TaylorModel::operator-() const {
  TaylorModel result = *this;
  for (double& x : result.real_) x = -x;
  for (double& x : result.imag_) x = -x;
  return result;
}

TaylorModel operator+(const TaylorModel& a, const TaylorModel& b) {
  if (!a.is_finite() || !b.is_finite()) return TaylorModel::failed(first_failure(a.failure_, b.failure_));
  if (Access::is_zero(a)) return b;
  if (Access::is_zero(b)) return a;
  return Access::sum(a, b);
}

TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
  if (!a.is_finite() || !b.is_finite()) return TaylorModel::failed(first_failure(a.failure_, b.failure_));
  if (Access::is_zero(a)) return a;
  if (Access::is_zero(b)) return b;
  return Access::product(a, b);
}

TaylorModel reciprocal(const TaylorModel& x) {
  if (!x.is_finite()) return x;
  const Argument at = argument_of(x);
  if (!is_divisor(at)) return TaylorModel::failed("division by a model that may vanish");
  return Access::composed(x, binomial_series(at, inverse_of(at.c), -1));
}

TaylorModel sqrt(const TaylorModel& x) {
  if (!x.is_finite()) return x;
  const Argument at = argument_of(x);
  if (touches_the_cut(at)) return TaylorModel::failed("sqrt of a model that touches its cut");
  return Access::composed(x, binomial_series(at, root_of(at.c), 0.5));
}

TaylorModel exp(const TaylorModel& x) {
  if (!x.is_finite()) return x;
  const BallPrecision inside(working_bits);
  const Argument at = argument_of(x);
  const ComplexBall centre = ball(at.c);
  const ComplexBall value = exp(centre);
  if (!value.is_finite() || !(value.magnitude_bound() < largest)) {
    return TaylorModel::failed("numbers beyond the range of double");
  }
  return Access::composed(x, entire_series(at, {value, value, value, value}, value.magnitude_bound()));
}

TaylorModel log(const TaylorModel& x) {
  if (!x.is_finite()) return x;
  const BallPrecision inside(working_bits);
  const Argument at = argument_of(x);
  const ComplexBall centre = ball(at.c);
  if (touches_the_cut(at)) return TaylorModel::failed("log of a model that touches its cut");
  // log c + integral of 1/c (1 + z)^-1
  Series series{};
  store(log(centre), series.coefficients[0], series.errors[0]);
  ComplexBall term = reciprocal(centre);
  const ComplexBall ratio = -term;
  for (int k = 1; k <= top; ++k) {
    const auto place_of_term = static_cast<std::size_t>(k);
    store(term / ComplexBall(k), series.coefficients[place_of_term], series.errors[place_of_term]);
    term = term * ratio;
  }
  series.tail = term.magnitude_bound() * std::pow(at.deviation, top + 1) / (1 - at.deviation / at.size * up) /
                (top + 1) * up;
  return Access::composed(x, series);
}

TaylorModel sin(const TaylorModel& x) { return circular(x, 0); }

TaylorModel cos(const TaylorModel& x) { return circular(x, 1); }

TaylorModel tan(const TaylorModel& x) { return sin(x) / cos(x); }

TaylorModel atan(const TaylorModel& x) {
  if (!x.is_finite()) return x;
  const BallPrecision inside(working_bits);
  const Argument at = argument_of(x);
  const ComplexBall centre = ball(at.c);
  const bool at_the_axis = std::abs(at.c.real) <= at.deviation;
  if (at_the_axis && (std::abs(at.c.imag) + at.deviation) * up >= 1) {
    return TaylorModel::failed("atan of a model that touches its cut");
  }
  // The derivative is (1/(z - i) - 1/(z + i)) / (2i): its k-th coefficient is at most r^-(k+1), r the
  // distance to +-i.
  const ComplexBall i(Ball(0), Ball(1));
  const double r = std::sqrt(at.c.real * at.c.real + std::pow(1 - std::abs(at.c.imag), 2)) / up;
  const double ratio = at.deviation / r * up;
  if (!(ratio < 1)) return TaylorModel::failed("atan of a model that may meet its branch points");
  Series series{};
  store(atan(centre), series.coefficients[0], series.errors[0]);
  const ComplexBall a = -reciprocal(centre - i);
  const ComplexBall b = -reciprocal(centre + i);
  ComplexBall power_of_a = -a;
  ComplexBall power_of_b = -b;
  for (int k = 1; k <= top; ++k) {
    const auto place_of_term = static_cast<std::size_t>(k);
    store((power_of_a - power_of_b) / (ComplexBall(2 * k) * i), series.coefficients[place_of_term],
          series.errors[place_of_term]);
    power_of_a = power_of_a * a;
    power_of_b = power_of_b * b;
  }
  series.tail = std::pow(ratio, top + 1) / ((top + 1) * (1 - ratio)) * up;
  return Access::composed(x, series);
}

TaylorModel pow(const TaylorModel& x, const TaylorModel& y) {
  if (!x.is_finite() || !y.is_finite()) return TaylorModel::failed(first_failure(x.failure_, y.failure_));
  if (y.deviation() == 0 && y.imag_[0] == 0 && std::nearbyint(y.real_[0]) == y.real_[0] &&
      std::abs(y.real_[0]) < 0x1p31) {
    return power(x, static_cast<long>(y.real_[0]));
  }
  return exp(y * log(x));
}

TaylorModel abs(const TaylorModel& x) {
  if (!x.is_finite() || certainly_positive(x)) return x;
  if (certainly_negative(x)) return -x;
  return TaylorModel::failed("abs where the sign changes is not analytic");
}

TaylorModel min(const TaylorModel& a, const TaylorModel& b) { return select_less(b, a, b, a); }

TaylorModel max(const TaylorModel& a, const TaylorModel& b) { return select_less(a, b, b, a); }

TaylorModel hull(const TaylorModel& a, const TaylorModel& b) {
  if (!a.is_finite() || !b.is_finite()) return TaylorModel::failed(first_failure(a.failure_, b.failure_));
  return Access::hull(a, b);
}

bool certainly_positive(const TaylorModel& x) { return x.is_finite() && x.centre().real > x.deviation(); }

bool certainly_less(const TaylorModel& a, const TaylorModel& b) { return certainly_positive(b - a); }

bool certainly_zero(const TaylorModel& x) { return Access::is_zero(x); }

TaylorModel select_less(const TaylorModel& a, const TaylorModel& b, const TaylorModel& if_less,
                        const TaylorModel& otherwise) {
  if (!a.is_finite() || !b.is_finite()) return TaylorModel::failed(first_failure(a.failure_, b.failure_));
  if (certainly_less(a, b)) return if_less;
  if (certainly_less(b, a)) return otherwise;
  return TaylorModel::failed("a choice by an order that changes is not analytic");
}

namespace {

const TaylorModel& narrower(const TaylorModel& a, const TaylorModel& b) {
  if (!a.is_finite()) return b.is_finite() ? b : a;
  return b.is_finite() && b.remainder() < a.remainder() ? b : a;
}

}  // namespace

TaylorModel bend_of_power(const TaylorModel& a, const TaylorModel& b, const TaylorModel& d,
                          const TaylorModel& e) {
  const TaylorModel by_mean = e * (e - 1) * TaylorModel(0.5) * pow(hull(a, b), e - 2);
  if (!by_mean.is_finite()) return by_mean;
  return narrower(by_mean, (pow(b, e) - pow(a, e) - e * pow(a, e - 1) * d) / (d * d));
}

TaylorModel first_of_power(const TaylorModel& a, const TaylorModel& b, const TaylorModel& d,
                           const TaylorModel& e, const TaylorModel& bend) {
  const TaylorModel by_mean = e * pow(hull(a, b), e - 1);
  if (!by_mean.is_finite()) return by_mean;
  return narrower(narrower(by_mean, e * pow(a, e - 1) + d * bend), (pow(b, e) - pow(a, e)) / d);
}

}  // namespace radcert
