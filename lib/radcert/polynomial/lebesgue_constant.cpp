// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/lebesgue_constant.h"

#include <gmp.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/real_zeros.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

__extension__ using Whole = __int128;

Whole absolute(Whole x) { return x < 0 ? -x : x; }

Rational rational(Whole value) {
  const auto low = static_cast<std::uint64_t>(value);
  const auto high = static_cast<std::int64_t>(value >> 64);
  return Rational(high) * Rational(1UL << 63) * 2 + Rational(low);
}

// The largest whole number that is not above x 2^scale; below 2^126 in absolute value.
Whole floor_scaled(const Rational& x, long scale) {
  CValue<__mpz_struct, mpz_init, mpz_clear> numerator;
  CValue<__mpz_struct, mpz_init, mpz_clear> denominator;
  const auto* value = static_cast<mpq_srcptr>(x.gmp());
  mpz_set(numerator, mpq_numref(value));
  mpz_set(denominator, mpq_denref(value));
  if (scale >= 0) {
    mpz_mul_2exp(numerator, numerator, static_cast<mp_bitcnt_t>(scale));
  } else {
    mpz_mul_2exp(denominator, denominator, static_cast<mp_bitcnt_t>(-scale));
  }
  mpz_fdiv_q(numerator, numerator, denominator);
  const bool negative = mpz_sgn(numerator) < 0;
  mpz_abs(numerator, numerator);
  Whole result = static_cast<Whole>(mpz_getlimbn(numerator, 1)) << 64;
  result += static_cast<Whole>(mpz_getlimbn(numerator, 0));
  return negative ? -result : result;
}

// The least p with x <= 2^p.
long binary_exponent(const Rational& x) {
  long p = 0;
  while (Rational(x) > power(Rational(2), p)) ++p;
  while (Rational(x) <= power(Rational(2), p - 1)) --p;
  return p;
}

// A part of the triangle: its corners, and the Bernstein coefficients of all l_j on it.
struct Part {
  std::array<Barycentric<double>, 3> corners;
  std::vector<Whole> coefficients;  ///< those of all l_j for each k in turn, times 2^scale, rounded down
  Whole lost = 0;                   ///< a bound for what the roundings have taken from a coefficient
  Whole bound = 0;                  ///< of the Lebesgue function on the part
};

class Search {
public:
  Search(const LagrangeFunctions& functions, const Rational& tolerance)
      : degree_(functions.degree()),
        places_(polynomial_dimension(functions.degree())),
        count_(functions.size()) {
    Rational largest = 0;
    for (std::size_t j = 0; j < count_; ++j)
      for (const Rational& c : functions.bernstein_coefficients(j)) largest = std::max(largest, abs(c));
    // Sums of count_ coefficients stay below 2^124.
    scale_ = 123 - binary_exponent(largest * count_);
    tolerance_ = floor_scaled(std::min(tolerance, largest * count_), scale_);
    list_lines();
    list_corners();
    whole_.corners = {Barycentric<double>{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    whole_.coefficients.resize(places_ * count_);
    for (std::size_t j = 0; j < count_; ++j) {
      const std::span<const Rational> c = functions.bernstein_coefficients(j);
      for (std::size_t k = 0; k < places_; ++k)
        whole_.coefficients[k * count_ + j] = floor_scaled(c[k], scale_);
    }
    whole_.lost = 1;
  }

  LebesgueConstant run(long limit) {
    std::vector<Part> open;
    look_at(whole_);
    open.push_back(std::move(whole_));
    Whole upper = 0;
    while (!open.empty()) {
      Part part = std::move(open.back());
      open.pop_back();
      const bool lost_in_rounding = 2 * uncertainty(part) > tolerance_;  // halving would not help
      if (part.bound <= lower_ + tolerance_ || lost_in_rounding || looked_at_ >= limit) {
        upper = std::max(upper, part.bound);
        continue;
      }
      Part other;
      halve(part, other);
      look_at(part);
      look_at(other);
      if (part.bound > other.bound) std::swap(part, other);
      open.push_back(std::move(part));
      open.push_back(std::move(other));
    }
    const Rational unit = power(Rational(2), -scale_);
    return {.lower = rational(lower_) * unit,
            .upper = rational(upper) * unit,
            .near = near_,
            .triangles = looked_at_,
            .reached = upper <= lower_ + tolerance_};
  }

private:
  // For each side, the places of the coefficients along the lines parallel to it, from its first end to its
  // second.
  void list_lines() {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::size_t first = (side + 1) % 3;
      const std::size_t second = (side + 2) % 3;
      for (int opposite = 0; opposite <= degree_; ++opposite) {
        std::vector<std::size_t> line;
        for (int i = 0; i <= degree_ - opposite; ++i) {
          std::array<int, 3> k{};
          k[side] = opposite;
          k[first] = degree_ - opposite - i;
          k[second] = i;
          line.push_back(lattice_place(k));
        }
        lines_[side].push_back(std::move(line));
      }
    }
  }

  void list_corners() {
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<int, 3> k{};
      k[i] = degree_;
      corner_places_[i] = lattice_place(k);
    }
  }

  Whole absolute_sum(const Part& part, std::size_t k) const {
    Whole sum = 0;
    for (std::size_t j = 0; j < count_; ++j) sum += absolute(part.coefficients[k * count_ + j]);
    return sum;
  }

  // How far rounding may have moved a sum of absolute values.
  Whole uncertainty(const Part& part) const { return part.lost * static_cast<Whole>(count_); }

  void look_at(Part& part) {
    ++looked_at_;
    const Whole uncertain = uncertainty(part);
    part.bound = 0;
    for (std::size_t k = 0; k < places_; ++k)
      part.bound = std::max(part.bound, absolute_sum(part, k) + uncertain);
    for (std::size_t i = 0; i < 3; ++i) {
      const Whole value = absolute_sum(part, corner_places_[i]) - uncertain;
      if (value <= lower_) continue;
      lower_ = value;
      near_ = part.corners[i];
    }
  }

  // Cuts a part at the middle of its longest side; it keeps the half at the side's second end.
  void halve(Part& part, Part& other) const {
    const std::size_t side = longest_side(part);
    const std::size_t first = (side + 1) % 3;
    const std::size_t second = (side + 2) % 3;
    other = part;
    for (const std::vector<std::size_t>& line : lines_[side])
      for (std::size_t step = 1; step < line.size(); ++step) {
        for (std::size_t i = 0; i + step < line.size(); ++i) {
          Whole* const target = &part.coefficients[line[i] * count_];
          const Whole* const next = &part.coefficients[line[i + 1] * count_];
          for (std::size_t j = 0; j < count_; ++j) target[j] = (target[j] + next[j]) >> 1;
        }
        const auto from = part.coefficients.begin() + static_cast<std::ptrdiff_t>(line[0] * count_);
        std::copy_n(from, count_,
                    other.coefficients.begin() + static_cast<std::ptrdiff_t>(line[step] * count_));
      }
    part.lost += degree_;
    other.lost = part.lost;
    Barycentric<double> middle;
    for (std::size_t i = 0; i < 3; ++i)
      middle.x[i] = (part.corners[first].x[i] + part.corners[second].x[i]) / 2;
    part.corners[first] = middle;
    other.corners[second] = middle;
  }

  // By the lengths on an equilateral triangle. Only the order of the search depends on it.
  static std::size_t longest_side(const Part& part) {
    std::size_t longest = 0;
    double length = -1;
    for (std::size_t side = 0; side < 3; ++side) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = part.corners[(side + 1) % 3].x[i] - part.corners[(side + 2) % 3].x[i];
        sum += d * d;
      }
      if (sum > length) {
        length = sum;
        longest = side;
      }
    }
    return longest;
  }

  int degree_;
  std::size_t places_;  // of a function's coefficients
  std::size_t count_;   // of functions
  long scale_ = 0;
  Whole tolerance_ = 0;
  std::array<std::vector<std::vector<std::size_t>>, 3> lines_;
  std::array<std::size_t, 3> corner_places_{};
  Part whole_;
  Whole lower_ = 0;
  Barycentric<double> near_{};
  long looked_at_ = 0;
};

// The sign of a polynomial that has one on 0 < alpha < 1/3.
int sign_below_a_third(const RationalPolynomial& p) {
  const Rational third(1, 3);
  const int inside = zeros_between(p, 0, third) - (p(third).sign() == 0 ? 1 : 0);
  expects(inside == 0, "a polynomial with one sign on (0, 1/3)", named("polynomial", p));
  return p(Rational(1, 6)).sign();
}

}  // namespace

const WorkLimit most_lebesgue_triangles("polynomial/lebesgue_constant: triangles", 1'000'000, 1,
                                        "the enclosure is wider than the tolerance, and says so");

LebesgueConstant lebesgue_constant(const LagrangeFunctions& functions, const Rational& tolerance,
                                   long triangle_limit) {
  expects(tolerance.sign() > 0, "tolerance > 0", named("tolerance", tolerance));
  expects(triangle_limit >= 1, "triangle_limit >= 1", named("triangle_limit", triangle_limit));
  return Search(functions, tolerance).run(triangle_limit);
}

InsetFunction linear_lebesgue_constant() {
  const InsetFamily family(1);
  std::vector<InsetFunction> sums;
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    Barycentric<Rational> x;
    x.x[vertex] = 1;
    InsetFunction sum{.numerator = {}, .pole_order = 1};
    for (std::size_t j = 0; j < family.size(); ++j) {
      const InsetFunction l = family.value(j, x);
      expects(l.pole_order == 1, "l_j at a vertex has the pole 1/3", named("l", l));
      sum.numerator += RationalPolynomial(sign_below_a_third(l.numerator)) * l.numerator;
    }
    sums.push_back(sum);
  }
  expects(sums[0] == sums[1] && sums[0] == sums[2], "the same sum at each vertex", named("first", sums[0]),
          named("second", sums[1]), named("third", sums[2]));
  return sums[0];
}

}  // namespace radcert
