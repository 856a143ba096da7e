// SPDX-License-Identifier: GPL-3.0-or-later

// Bases on a triangle: weights, degrees of precision, norm and condition, of rational nodes and of algebraic
// ones. The judge solves for the Lagrange functions by its own elimination in monomials, integrates by its
// own formula, and evaluates the Lebesgue function where it likes; it shares nothing with the layer
// `polynomial` but the rational numbers and balls.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "radcert/polynomial/basis_facts.h"
#include "radcert/polynomial/nodes/algebraic_nodes.h"
#include "radcert/scalar/real.h"
#include "tests/attack/attack.h"

namespace radcert::attack {
namespace {

// s^a t^b, in the order 1, s, t, s^2, s t, t^2, ...
std::vector<std::array<int, 2>> exponents(int degree) {
  std::vector<std::array<int, 2>> out;
  for (int total = 0; total <= degree; ++total)
    for (int b = 0; b <= total; ++b) out.push_back({total - b, b});
  return out;
}

template <class Number>
Number raised(const Number& x, int n) {
  Number out(1);
  for (int k = 0; k < n; ++k) out = out * x;
  return out;
}

Rational of_triangle(int a, int b) {  // a! b!/(a + b + 2)!
  Rational value = 1;
  for (int k = 1; k <= a; ++k) value *= Rational(k, b + k);
  return value / (Rational(a + b + 1) * Rational(a + b + 2));
}

bool is_pivot(const Rational& x) { return x != 0; }
bool is_pivot(const Ball& x) { return x.is_finite() && !x.contains_zero(); }

// The inverse of (phi_m(q_j)), rows by function, as rows by node; empty where there is none.
template <class Number>
std::vector<std::vector<Number>> lagrange(const std::vector<std::array<Number, 2>>& points, int degree) {
  const auto powers = exponents(degree);
  const std::size_t n = points.size();
  std::vector<std::vector<Number>> a(n, std::vector<Number>(2 * n, Number(0)));
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t m = 0; m < n; ++m)
      a[j][m] = raised(points[j][0], powers[m][0]) * raised(points[j][1], powers[m][1]);
    a[j][n + j] = Number(1);
  }
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t row = p;
    while (row < n && !is_pivot(a[row][p])) ++row;
    if (row == n) return {};
    std::swap(a[row], a[p]);
    const Number scale = Number(1) / a[p][p];
    for (Number& x : a[p]) x = x * scale;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == p) continue;
      const Number factor = a[i][p];
      for (std::size_t k = p; k < 2 * n; ++k) a[i][k] = a[i][k] - factor * a[p][k];
    }
  }
  // Columns n + j hold the coefficients of l_j.
  std::vector<std::vector<Number>> out(n, std::vector<Number>(n));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t m = 0; m < n; ++m) out[j][m] = a[m][n + j];
  return out;
}

template <class Number>
std::vector<Number> weights(const std::vector<std::vector<Number>>& functions, int degree) {
  const auto powers = exponents(degree);
  std::vector<Number> out;
  for (const std::vector<Number>& c : functions) {
    Number sum(0);
    for (std::size_t m = 0; m < c.size(); ++m)
      sum = sum + c[m] * Number(of_triangle(powers[m][0], powers[m][1]));
    out.push_back(sum);
  }
  return out;
}

template <class Number>
Number defect(const std::vector<std::array<Number, 2>>& points, const std::vector<Number>& w, Region region,
              int a, int b) {
  const bool both = region == Region::parallelogram;
  Number sum = -Number(both ? 1 / (Rational(a + 1) * Rational(b + 1)) : of_triangle(a, b));
  for (std::size_t j = 0; j < points.size(); ++j) {
    const auto& [s, t] = points[j];
    sum = sum + w[j] * raised(s, a) * raised(t, b);
    if (both) sum = sum + w[j] * raised(Number(1) - s, a) * raised(Number(1) - t, b);
  }
  return sum;
}

struct RationalBasis {
  int degree = 1;
  std::vector<std::array<Rational, 2>> points;
};

Rational fraction(Draw& draw, long denominator) {
  return Rational(static_cast<long>(draw.below(static_cast<std::size_t>(denominator) + 1)), denominator);
}

// Within the triangle: on a lattice (so that lines and conics carry many), anywhere, at corners and sides,
// close to another.
std::array<Rational, 2> point(Draw& draw, const RationalBasis& basis) {
  while (true) {
    std::array<Rational, 2> p;
    switch (draw.below(5)) {
      case 0: {
        const long n = 1 + static_cast<long>(draw.below(6));
        p = {fraction(draw, n), fraction(draw, n)};
        break;
      }
      case 1: p = {Rational::exactly(draw.unit()), Rational::exactly(draw.unit())}; break;
      case 2: p = {Rational(0), Rational::exactly(draw.unit())}; break;
      case 3: p = {1 / power(Rational(10), 1 + static_cast<int>(draw.below(40))), fraction(draw, 7)}; break;
      default: {
        if (basis.points.empty()) continue;
        p = basis.points[draw.below(basis.points.size())];
        const Rational off = 1 / power(Rational(10), 1 + static_cast<int>(draw.below(30)));
        if (draw.below(2) == 0)
          p[0] += off;
        else
          p[1] -= off;
      }
    }
    if (p[0].sign() >= 0 && p[1].sign() >= 0 && p[0] + p[1] <= 1) return p;
  }
}

RationalBasis rational_basis(Draw& draw) {
  RationalBasis basis;
  basis.degree = static_cast<int>(draw.below(draw.below(8) == 0 ? 4 : 3));
  const std::size_t n = exponents(basis.degree).size();
  if (draw.below(3) == 0) {  // symmetric orbits: rules of higher precision, and weights that vanish
    while (basis.points.size() + 3 <= n) {
      const Rational a = draw.below(2) == 0 ? fraction(draw, 2 * (1 + static_cast<long>(draw.below(9)))) / 2
                                            : Rational::exactly(draw.unit()) / 2;
      basis.points.push_back({a, a});
      basis.points.push_back({1 - 2 * a, a});
      basis.points.push_back({a, 1 - 2 * a});
    }
    if (basis.points.size() < n) basis.points.push_back({Rational(1, 3), Rational(1, 3)});
  }
  while (basis.points.size() < n) basis.points.push_back(point(draw, basis));
  return basis;
}

std::string text(const RationalBasis& basis) {
  std::string out = "degree " + std::to_string(basis.degree) + ", nodes (s, t):";
  for (const auto& [s, t] : basis.points) out += " (" + s.to_text() + ", " + t.to_text() + ")";
  return out;
}

Judgement judge_precision(const RationalBasis& basis, const std::vector<Rational>& w,
                          const EnclosedPrecision& found, Region region) {
  for (int degree = 0; degree <= found.degree + 1; ++degree)
    for (int b = 0; b <= degree; ++b) {
      const Rational missed = defect(basis.points, w, region, degree - b, b);
      if (missed == 0) continue;
      if (degree != found.degree + 1 || found.first_failure != Monomial{degree - b, b} ||
          !found.defect.contains(missed))
        return Judgement::violated("precision " + std::to_string(found.degree) + ", but s^" +
                                   std::to_string(degree - b) + " t^" + std::to_string(b) + " is missed by " +
                                   missed.to_text());
      return Judgement::held();
    }
  return Judgement::violated("precision " + std::to_string(found.degree) +
                             ", but the next degree is exact too");
}

// The Lebesgue function at a point.
Rational lebesgue(const std::vector<std::vector<Rational>>& functions, int degree, const Rational& s,
                  const Rational& t) {
  const auto powers = exponents(degree);
  Rational sum = 0;
  for (const std::vector<Rational>& c : functions) {
    Rational value = 0;
    for (std::size_t m = 0; m < c.size(); ++m)
      value += c[m] * raised(s, powers[m][0]) * raised(t, powers[m][1]);
    sum += abs(value);
  }
  return sum;
}

Judgement judge(const RationalBasis& basis) {
  std::vector<Barycentric<Rational>> nodes;
  for (const auto& [s, t] : basis.points) nodes.push_back({{1 - s - t, t, s}});
  const auto functions = lagrange(basis.points, basis.degree);
  const auto found = lagrange_functions(nodes);
  if (found.has_value() != !functions.empty()) return Judgement::violated("unisolvent, or not");
  if (!found) return Judgement::refused();
  const Rational tolerance(1, 50);
  const BasisFacts facts = basis_facts(*found, tolerance);
  const std::vector<Rational> w = weights(functions, basis.degree);
  if (facts.weights != w) return Judgement::violated("weights");
  for (const Region region : {Region::triangle, Region::parallelogram}) {
    Judgement precision =
        judge_precision(basis, w, region == Region::triangle ? facts.triangle : facts.parallelogram, region);
    if (precision.kind != Judgement::Kind::held) return precision;
  }
  // The norm: no value of the Lebesgue function exceeds the upper bound, and beside the place that is named
  // it attains the lower one.
  constexpr int steps = 6;
  Rational largest = 0;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j)
      largest = std::max(largest, lebesgue(functions, basis.degree, Rational(i, steps), Rational(j, steps)));
  if (largest > facts.norm.upper)
    return Judgement::violated("norm at most " + facts.norm.upper.to_text() + ", but " + largest.to_text());
  const Rational near_s = Rational::exactly(facts.norm.near.x[2]);
  const Rational near_t = Rational::exactly(facts.norm.near.x[1]);
  const Rational there = lebesgue(functions, basis.degree, near_s, near_t);
  // The place has rounded coordinates: what 2^-50 in each changes is bounded by the sum of the coefficients.
  Rational slope = 0;
  for (const std::vector<Rational>& c : functions)
    for (const Rational& x : c) slope += abs(x);
  if (facts.norm.lower > there + slope * (2 * basis.degree + 1) / power(Rational(2), 50))
    return Judgement::violated("norm at least " + facts.norm.lower.to_text() + ", but " + there.to_text() +
                               " there");
  if (facts.norm.reached && facts.norm.upper - facts.norm.lower > tolerance)
    return Judgement::violated("tolerance");
  if (facts.norm.lower > facts.condition) return Judgement::violated("condition below norm");
  return Judgement::held();
}

std::vector<RationalBasis> smaller(const RationalBasis& basis) {
  std::vector<RationalBasis> out;
  for (std::size_t j = 0; j < basis.points.size(); ++j)
    for (const Rational& to : {Rational(0), Rational(1, 2), Rational(1, 3)})
      for (std::size_t i = 0; i < 2; ++i) {
        RationalBasis other = basis;
        if (other.points[j][i].to_text().size() <= to.to_text().size()) continue;
        other.points[j][i] = to;
        if (other.points[j][0] + other.points[j][1] <= 1) out.push_back(std::move(other));
      }
  return out;
}

TEST(BasisAttack, OfRationalNodes) {
  const Attack<RationalBasis> attack{.name = "bases of rational nodes",
                                     .usual_instances = 250,
                                     .make = rational_basis,
                                     .judge = judge,
                                     .text = text,
                                     .smaller = smaller};
  EXPECT_EQ(hold(attack).violated, 0U);
}

// Sets of which the judge knows what they are: orbits with algebraic coordinates in one disguise or another,
// pushed by a little.
struct AlgebraicBasis {
  enum class Kind { six_nodes, ten_nodes, three_nodes, centroid } kind = Kind::six_nodes;
  int disguise = 0;
  int push = 0;  ///< 10^-push, or 0
  int sign = 1;
};

RationalPolynomial whole(std::vector<Rational> c) { return RationalPolynomial(std::move(c)); }

AlgebraicNumber number(const RationalPolynomial& p, const Rational& from, const Rational& to, int digits) {
  return {p, real_zeros(p, from, to, 1 / power(Rational(10), digits)).at(0)};
}

// The same polynomial with other zeros, elsewhere, or repeated ones, or another scale.
RationalPolynomial disguised(const RationalPolynomial& p, int disguise) {
  switch (disguise % 4) {
    case 1: return p * whole({-7, 0, 1});
    case 2: return p * p * Rational(3, 7);
    case 3: return p * whole({5, 1}) * Rational(1000003);
    default: return p;
  }
}

AlgebraicNodes nodes_of(const AlgebraicBasis& basis) {
  using A = AlgebraicExpression;
  const Rational push = basis.push == 0 ? Rational(0) : basis.sign / power(Rational(10), basis.push);
  const int digits = 20 + basis.disguise;
  AlgebraicNodes out{.field = AlgebraicField({}), .nodes = {}, .space = {}};
  const auto orbit = [&](const A& a) {
    const A other = Rational(1) - Rational(2) * a;
    out.nodes.push_back({other, a, a});
    out.nodes.push_back({a, other, a});
    out.nodes.push_back({a, a, other});
  };
  switch (basis.kind) {
    case AlgebraicBasis::Kind::six_nodes: {
      const RationalPolynomial p = disguised(whole({1, -20, 120, -240, 135}), basis.disguise);
      out.field = AlgebraicField({number(p, Rational(9, 100), Rational(1, 10), digits),
                                  number(p, Rational(44, 100), Rational(45, 100), digits)});
      out.space = monomials(2);
      orbit(A::number(0) + push);
      orbit(A::number(1));
      break;
    }
    case AlgebraicBasis::Kind::ten_nodes: {  // inset (7 - sqrt 34)/15: by sqrt 34, or by its own polynomial
      const bool root = basis.disguise % 2 == 0;
      const RationalPolynomial p =
          disguised(root ? whole({-34, 0, 1}) : whole({1, -14, 15}), basis.disguise / 2);
      out.field = AlgebraicField(
          {root ? number(p, 5, 6, digits) : number(p, Rational(7, 100), Rational(8, 100), digits)});
      const A alpha = (root ? (Rational(7) - A::number(0)) / Rational(15) : A::number(0)) + push;
      out.space = monomials(3);
      for (int i = 3; i >= 0; --i)
        for (int j = 3 - i; j >= 0; --j) {
          const auto x = [&](int k) { return alpha + (Rational(1) - Rational(3) * alpha) * Rational(k, 3); };
          out.nodes.push_back({x(i), x(j), x(3 - i - j)});
        }
      break;
    }
    case AlgebraicBasis::Kind::three_nodes: {  // 1/6 as sqrt 2/(3 sqrt 8)
      out.field = AlgebraicField({number(disguised(whole({-2, 0, 1}), basis.disguise), 1, 2, digits),
                                  number(whole({-8, 0, 1}), 2, 3, digits)});
      out.space = monomials(1);
      orbit(A::number(0) / (Rational(3) * A::number(1)) + push);
      break;
    }
    case AlgebraicBasis::Kind::centroid: {  // 1/3 as x^3/6, x^3 = 2
      out.field = AlgebraicField({number(disguised(whole({-2, 0, 0, 1}), basis.disguise), 1, 2, digits)});
      const A x = A::number(0);
      const A third = x * x * x / Rational(6) + push;
      out.space = monomials(0);
      out.nodes.push_back({Rational(1) - third - third, third, third});
      break;
    }
  }
  return out;
}

std::string text(const AlgebraicBasis& basis) {
  return "kind " + std::to_string(static_cast<int>(basis.kind)) + ", disguise " +
         std::to_string(basis.disguise) + ", pushed by " +
         (basis.push == 0 ? "0" : std::to_string(basis.sign) + "e-" + std::to_string(basis.push));
}

int degree_of(AlgebraicBasis::Kind kind) {
  return kind == AlgebraicBasis::Kind::six_nodes     ? 2
         : kind == AlgebraicBasis::Kind::ten_nodes   ? 3
         : kind == AlgebraicBasis::Kind::three_nodes ? 1
                                                     : 0;
}

// What is known of these sets: the rules of Strang and Fix, of the inset (7 - sqrt 34)/15, of 1/6, of the
// centroid; those that are pushed keep the degree of every symmetric set, or of the pushed point.
std::array<int, 2> truth(const AlgebraicBasis& basis) {
  switch (basis.kind) {
    case AlgebraicBasis::Kind::six_nodes: return basis.push == 0 ? std::array{4, 5} : std::array{2, 3};
    case AlgebraicBasis::Kind::ten_nodes: return basis.push == 0 ? std::array{4, 5} : std::array{3, 3};
    case AlgebraicBasis::Kind::three_nodes: return basis.push == 0 ? std::array{2, 3} : std::array{1, 1};
    default: return basis.push == 0 ? std::array{1, 1} : std::array{0, 1};
  }
}

Judgement judge(const AlgebraicBasis& basis) {
  const AlgebraicNodes nodes = nodes_of(basis);
  std::vector<Barycentric<Rational>> rounded;
  std::vector<std::array<Ball, 2>> points;
  std::vector<Ball> w;
  const BallPrecision scope(2400);
  for (const Barycentric<Ball>& q : nodes.values()) {
    points.push_back({q.x[2], q.x[1]});
    const Rational s = Rational::parse(q.x[2].decimal(70).midpoint).value();
    const Rational t = Rational::parse(q.x[1].decimal(70).midpoint).value();
    rounded.push_back({{1 - s - t, t, s}});
  }
  const int degree = degree_of(basis.kind);
  w = weights(lagrange(points, degree), degree);
  const auto functions = lagrange_functions(rounded);
  if (!functions) return Judgement::refused();
  const Outcome<BasisFacts> facts = basis_facts(*functions, nodes, Rational(1, 10));
  if (!facts) return Judgement::refused();
  const std::array<int, 2> expected = truth(basis);
  if (facts->triangle.degree != expected[0] || facts->parallelogram.degree != expected[1])
    return Judgement::violated("precision " + std::to_string(facts->triangle.degree) + ", " +
                               std::to_string(facts->parallelogram.degree) + " in place of " +
                               std::to_string(expected[0]) + ", " + std::to_string(expected[1]));
  for (const Region region : {Region::triangle, Region::parallelogram}) {
    const EnclosedPrecision& found = region == Region::triangle ? facts->triangle : facts->parallelogram;
    const Ball missed = defect(points, w, region, found.first_failure.s, found.first_failure.t);
    if (missed.contains_zero() || !overlaps(missed, found.defect))
      return Judgement::violated("the defect of " + found.first_failure.to_text() + " is " +
                                 missed.to_text());
    for (int d = 0; d <= found.degree; ++d)
      for (int b = 0; b <= d; ++b)
        if (!defect(points, w, region, d - b, b).contains_zero())
          return Judgement::violated("s^" + std::to_string(d - b) + " t^" + std::to_string(b) + " is missed");
  }
  for (std::size_t j = 0; j < w.size(); ++j)
    if (abs(w[j] - Ball(facts->weights[j])).lower_double() > 1e-55 ||
        (facts->weights[j] == 0 && !w[j].contains_zero()))
      return Judgement::violated("weight " + std::to_string(j));
  return Judgement::held();
}

TEST(BasisAttack, OfAlgebraicNodes) {
  const Attack<AlgebraicBasis> attack{
      .name = "bases of algebraic nodes",
      .usual_instances = 25,
      .make =
          [](Draw& draw) {
            AlgebraicBasis basis;
            basis.kind = static_cast<AlgebraicBasis::Kind>(draw.below(4));
            basis.disguise = static_cast<int>(draw.below(16));
            basis.push = draw.below(2) == 0 ? 0 : 3 + static_cast<int>(draw.below(300));
            basis.sign = draw.below(2) == 0 ? 1 : -1;
            return basis;
          },
      .judge = [](const AlgebraicBasis& basis) { return judge(basis); },
      .text = [](const AlgebraicBasis& basis) { return text(basis); },
  };
  EXPECT_EQ(hold(attack).violated, 0U);
}

// Signs of expressions in algebraic numbers: exact zeros in disguise, and numbers that are nearly zero.
struct Sign {
  int first = 2;
  int second = 3;
  int push = 0;
  int sign = 1;
  std::size_t form = 0;
};

Judgement judge(const Sign& s) {
  using A = AlgebraicExpression;
  const auto root = [](int n) { return number(whole({-n, 0, 1}), 0, n, 30); };
  const AlgebraicField field({root(s.first), root(s.second), root(s.first * s.second)});
  const A x = A::number(0), y = A::number(1), xy = A::number(2);
  const std::array<A, 6> zeros{x * y - xy,
                               xy / x - y,
                               (x + y) * (x + y) - Rational(s.first + s.second) - Rational(2) * xy,
                               Rational(1) / (x + y) - (x - y) / Rational(s.first - s.second),
                               (x + y) * (x - y) + Rational(s.second - s.first),
                               x * x * x * y - Rational(s.first) * xy};
  A a = zeros[s.form];
  int expected = 0;
  if (s.push > 0) {
    a = a + Rational(s.sign) / power(Rational(10), s.push);
    expected = s.sign;
  }
  const Outcome<int> sign = field.sign(a);
  if (!sign) return Judgement::refused();
  if (*sign != expected) return Judgement::violated("sign " + std::to_string(*sign));
  // Half of the bits that it took must not be enough to call a number zero that is none: whatever is answered
  // is right.
  for (const long bits : {128L, 160L, 256L, 400L, 1000L}) {
    const Outcome<int> limited = field.sign(a, bits);
    if (limited && *limited != expected) return Judgement::violated("with " + std::to_string(bits) + " bits");
  }
  return Judgement::held();
}

TEST(BasisAttack, OfSignsOfAlgebraicNumbers) {
  const Attack<Sign> attack{
      .name = "signs of algebraic numbers",
      .usual_instances = 150,
      .make =
          [](Draw& draw) {
            constexpr std::array primes{2, 3, 5, 7, 11, 13, 10007};
            const std::size_t first = draw.below(primes.size());
            return Sign{.first = primes[first],
                        .second = primes[(first + 1 + draw.below(primes.size() - 1)) % primes.size()],
                        .push = draw.below(2) == 0 ? 0 : 1 + static_cast<int>(draw.below(400)),
                        .sign = draw.below(2) == 0 ? 1 : -1,
                        .form = draw.below(6)};
          },
      .judge = [](const Sign& s) { return judge(s); },
      .text =
          [](const Sign& s) {
            return "roots of " + std::to_string(s.first) + ", " + std::to_string(s.second) + ", form " +
                   std::to_string(s.form) + ", pushed by " + std::to_string(s.sign) + "e-" +
                   std::to_string(s.push);
          },
  };
  EXPECT_EQ(hold(attack).violated, 0U);
}

}  // namespace
}  // namespace radcert::attack
