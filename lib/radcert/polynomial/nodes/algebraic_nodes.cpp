// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/algebraic_nodes.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/matrix.h"
#include "radcert/polynomial/rules/product_precision.h"

namespace radcert {
namespace {

using Polynomial = PlanePolynomial<Rational>;

// s^a t^b and their coefficients, one after the other.
template <class Visit>
void each_term(const Polynomial& p, const Visit& visit) {
  for (int total = 0; total <= p.degree(); ++total)
    for (int b = 0; b <= total; ++b) visit(total - b, b, p(total - b, b));
}

Polynomial product(const Polynomial& p, const Polynomial& q) {
  Polynomial out(p.degree() + q.degree());
  each_term(p, [&](int a, int b, const Rational& c) {
    if (c != 0) each_term(q, [&](int i, int j, const Rational& d) { out(a + i, b + j) += c * d; });
  });
  return out;
}

Polynomial sum(Polynomial p, const Polynomial& q) {
  each_term(q, [&](int a, int b, const Rational& c) { p(a, b) += c; });
  return p;
}

// (s - centre)^m.s (t - centre)^m.t.
Polynomial about(const Rational& centre, const Monomial& m) {
  Polynomial out;
  out(0, 0) = 1;
  Polynomial s(1);
  s(1, 0) = 1;
  s(0, 0) = -centre;
  Polynomial t(1);
  t(0, 1) = 1;
  t(0, 0) = -centre;
  for (int k = 0; k < m.s; ++k) out = product(out, s);
  for (int k = 0; k < m.t; ++k) out = product(out, t);
  return out;
}

// What the rule on both triangles of a parallelogram sees of s^a t^b: p + p(1 - s, 1 - t), the latter being
// (-1)^(a + b) times the monomial about 1.
Polynomial of_region(Region region, const Monomial& m) {
  const Polynomial p = about(0, m);
  if (region == Region::triangle) return p;
  Polynomial image = about(1, m);
  if (m.degree() % 2 == 1) each_term(about(1, m), [&](int a, int b, const Rational& c) { image(a, b) = -c; });
  return sum(p, image);
}

// Int_sigma p; Int s^a t^b = a! b!/(a + b + 2)!.
Rational integral(const Polynomial& p) {
  Rational total = 0;
  each_term(p, [&](int a, int b, const Rational& c) {
    if (c == 0) return;
    Rational value = 1 / (Rational(a + b + 1) * Rational(a + b + 2));
    for (int k = 1; k <= b; ++k) value *= Rational(k, a + k);
    total += c * value;
  });
  return total;
}

Ball value(const Polynomial& p, const Barycentric<Ball>& x) { return p.value<Ball>(x.x[2], x.x[1]); }

// F = (f_m(q_j)) as a product of triangles, in balls, with pivots that are certainly not zero.
class Decomposition {
public:
  // No value where a pivot may be zero.
  static std::optional<Decomposition> of(Matrix<Ball> a) {
    Decomposition out;
    out.order_.resize(a.rows());
    for (std::size_t i = 0; i < a.rows(); ++i) out.order_[i] = i;
    out.determinant_ = Ball(1);
    for (std::size_t p = 0; p < a.rows(); ++p) {
      std::size_t best = p;
      for (std::size_t i = p + 1; i < a.rows(); ++i)
        if (certainly_less(abs(a(best, p)).midpoint(), abs(a(i, p)).midpoint())) best = i;
      if (best != p) {
        for (std::size_t j = 0; j < a.columns(); ++j) swap(a(best, j), a(p, j));
        std::swap(out.order_[best], out.order_[p]);
        out.determinant_ = -out.determinant_;
      }
      out.determinant_ *= a(p, p);
      if (!a(p, p).is_finite() || a(p, p).contains_zero()) return std::nullopt;
      for (std::size_t i = p + 1; i < a.rows(); ++i) {
        a(i, p) /= a(p, p);
        for (std::size_t j = p + 1; j < a.columns(); ++j) a(i, j) -= a(i, p) * a(p, j);
      }
    }
    out.triangles_ = std::move(a);
    return out;
  }

  [[nodiscard]] const Ball& determinant() const { return determinant_; }

  // The x with F x = b.
  [[nodiscard]] std::vector<Ball> solve(std::span<const Rational> b) const {
    const std::size_t n = triangles_.rows();
    std::vector<Ball> x;
    for (std::size_t i = 0; i < n; ++i) {
      x.emplace_back(b[order_[i]]);
      for (std::size_t k = 0; k < i; ++k) x[i] -= triangles_(i, k) * x[k];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) x[i] -= triangles_(i, k) * x[k];
      x[i] /= triangles_(i, i);
    }
    return x;
  }

private:
  Matrix<Ball> triangles_;
  std::vector<std::size_t> order_;
  Ball determinant_;
};

// Heights that do not depend on the precision, each times the degree of the field.
class Heights {
public:
  explicit Heights(const AlgebraicNodes& nodes) : field_(&nodes.field), count_(nodes.nodes.size()) {
    const Ball log_three = field_->degree() * log(Ball(3));
    points_ = Ball(0);
    for (const std::array<AlgebraicExpression, 3>& x : nodes.nodes) {
      const std::array<Ball, 3> h{x[0].height(*field_), x[1].height(*field_), x[2].height(*field_)};
      // max(1, |s|, |t|) for s = x_3, t = x_2; either is 1 minus the sum of the two other coordinates.
      points_ += min(h[1] + h[2], log_three + h[0] + min(h[1], h[2]));
    }
    for (const Polynomial& f : nodes.space) add_coefficients(f, coefficients_, degree_, terms_);
  }

  // Of det [f_m(q_j), p(q_j); L(f_m), L(p)], L given by its values.
  [[nodiscard]] Ball of_defect(const Polynomial& p, std::span<const Rational> moments,
                               const Rational& of_p) const {
    std::vector<Rational> coefficients = coefficients_;
    int degree = degree_;
    std::size_t terms = terms_;
    add_coefficients(p, coefficients, degree, terms);
    std::vector<Rational> last(moments.begin(), moments.end());
    last.push_back(of_p);
    return of_rows(count_ + 1, coefficients, degree, terms) + field_->height(last);
  }

  // Of det (f_m(q_j)) with one row in place of which the moments stand.
  [[nodiscard]] Ball of_weight(std::span<const Rational> moments) const {
    return of_rows(count_, coefficients_, degree_, terms_) + field_->height(moments);
  }

private:
  static void add_coefficients(const Polynomial& p, std::vector<Rational>& coefficients, int& degree,
                               std::size_t& terms) {
    coefficients.insert(coefficients.end(), p.coefficients().begin(), p.coefficients().end());
    degree = std::max(degree, p.degree());
    terms = std::max(terms, p.coefficients().size());
  }

  [[nodiscard]] Ball of_rows(std::size_t rows, std::span<const Rational> coefficients, int degree,
                             std::size_t terms) const {
    Ball factorial(1);
    for (std::size_t k = 2; k <= rows; ++k) factorial *= Ball(k);
    const Ball each = field_->height(coefficients) + field_->degree() * log(Ball(terms));
    return field_->degree() * log(factorial) + Ball(count_) * each + Ball(degree) * points_;
  }

  const AlgebraicField* field_;
  std::size_t count_;
  Ball points_;
  std::vector<Rational> coefficients_;
  int degree_ = 0;
  std::size_t terms_ = 1;
};

// Everything at one precision. What could not be decided says how many bits it wants.
class Attempt {
public:
  Attempt(const AlgebraicNodes& nodes, const Heights& heights)
      : nodes_(&nodes), heights_(&heights), points_(nodes.values()) {
    const std::size_t n = points_.size();
    Matrix<Ball> f(n, n);
    for (std::size_t m = 0; m < n; ++m)
      for (std::size_t j = 0; j < n; ++j) f(m, j) = value(nodes.space[m], points_[j]);
    decomposition_ = Decomposition::of(std::move(f));
  }

  [[nodiscard]] bool is_solved() const { return decomposition_.has_value(); }
  [[nodiscard]] long wanted_bits() const { return wanted_; }
  [[nodiscard]] const std::vector<Barycentric<Ball>>& points() const { return points_; }

  // L(f_m) for L(g) = Int q g.
  [[nodiscard]] std::vector<Rational> moments(const Polynomial& q) const {
    std::vector<Rational> out;
    for (const Polynomial& f : nodes_->space) out.push_back(integral(product(q, f)));
    return out;
  }

  // Signs of the weights w_j = Int l_j; no value where one is not decided.
  std::optional<std::vector<int>> weight_signs() {
    const std::vector<Rational> of_space = moments(about(0, {}));
    const Ball height = heights_->of_weight(of_space);
    std::vector<int> signs;
    bool decided = true;
    for (const Ball& weight : decomposition_->solve(of_space)) {
      const std::optional<bool> zero = looked_at(weight, height);
      decided = decided && zero.has_value();
      signs.push_back(zero != false ? 0 : certainly_positive(weight) ? 1 : -1);
    }
    if (!decided) return std::nullopt;
    return signs;
  }

  // The degree of precision of the rule, which is `proved` at least.
  std::optional<EnclosedPrecision> precision(Region region, int proved) {
    const std::vector<Rational> of_space = moments(about(0, {}));
    const std::vector<Ball> weights = decomposition_->solve(of_space);
    bool open_below = false;  // whether a defect of a lower degree is not decided
    for (int degree = proved + 1; degree <= most_degrees(); ++degree) {
      // A polynomial of odd degree is one of lower degree and one that is odd about the centre, on which both
      // sides are 0.
      if (region == Region::parallelogram && degree % 2 == 1) continue;
      bool open = open_below;
      for (int t = 0; t <= degree; ++t) {
        const Monomial monomial{degree - t, t};
        const Polynomial p = of_region(region, monomial);
        const Rational exact = integral(p);
        const Ball missed = defect(weights, p, exact);
        const std::optional<bool> zero = looked_at(missed, heights_->of_defect(p, of_space, exact));
        if (zero == false && open_below) return std::nullopt;
        if (zero == false)
          return EnclosedPrecision{.degree = degree - 1, .first_failure = monomial, .defect = missed};
        open = open || !zero;
      }
      open_below = open;
    }
    return std::nullopt;
  }

  // The largest d with Int q (p - P p) = 0 for all degrees that add up to d: see product_precision.
  std::optional<int> products(Region region) {
    bool open = false;
    for (int total = 0; total <= most_degrees(); ++total) {
      if (region == Region::parallelogram && total % 2 == 1) continue;
      const std::optional<bool> zero = products_vanish(total);
      if (zero == false && open) return std::nullopt;
      if (zero == false) return total - 1;
      open = open || !zero;
    }
    return std::nullopt;
  }

private:
  // No rule of so many points is exact so far: the product of the squared distances from them is positive.
  [[nodiscard]] int most_degrees() const { return 2 * static_cast<int>(points_.size()) + 2; }

  // Whether Int_sigma q (p - P p) = 0 for all pairs of monomials about the centre whose degrees add up to
  // `total`.
  std::optional<bool> products_vanish(int total) {
    const Rational half(1, 2);
    bool open = false;
    for (int of_q = 0; of_q <= total; ++of_q)
      for (int t = 0; t <= of_q; ++t) {
        const Polynomial q = about(half, {of_q - t, t});
        const std::vector<Rational> of_space = moments(q);
        const std::vector<Ball> weights = decomposition_->solve(of_space);
        for (int u = 0; u <= total - of_q; ++u) {
          const Polynomial p = about(half, {total - of_q - u, u});
          const Rational exact = integral(product(q, p));
          const std::optional<bool> zero =
              looked_at(defect(weights, p, exact), heights_->of_defect(p, of_space, exact));
          if (zero == false) return false;
          open = open || !zero;
        }
      }
    if (open) return std::nullopt;
    return true;
  }

  [[nodiscard]] Ball defect(std::span<const Ball> weights, const Polynomial& p, const Rational& exact) const {
    Ball rest = -Ball(exact);
    for (std::size_t j = 0; j < weights.size(); ++j) rest += weights[j] * value(p, points_[j]);
    return rest;
  }

  // Whether a quotient by the determinant is zero.
  std::optional<bool> looked_at(const Ball& quotient, const Ball& height) {
    if (quotient.is_finite() && !quotient.contains_zero()) return false;
    const std::optional<bool> zero = is_zero(quotient * decomposition_->determinant(), height);
    if (!zero) wanted_ = std::max(wanted_, bits_for(height));
    return zero;
  }

  const AlgebraicNodes* nodes_;
  const Heights* heights_;
  std::vector<Barycentric<Ball>> points_;
  std::optional<Decomposition> decomposition_;
  long wanted_ = 0;
};

}  // namespace

std::vector<Barycentric<Ball>> AlgebraicNodes::values() const {
  const std::vector<Ball> numbers = field.values();
  std::vector<Barycentric<Ball>> out;
  for (const std::array<AlgebraicExpression, 3>& x : nodes)
    out.push_back({{x[0].value(numbers), x[1].value(numbers), x[2].value(numbers)}});
  return out;
}

std::vector<PlanePolynomial<Rational>> monomials(int degree) {
  std::vector<PlanePolynomial<Rational>> out;
  for (int total = 0; total <= degree; ++total)
    for (int t = 0; t <= total; ++t) out.push_back(about(0, {total - t, t}));
  return out;
}

Outcome<BasisFacts> basis_facts(const LagrangeFunctions& rounded, const AlgebraicNodes& nodes,
                                const Rational& tolerance, long most_bits) {
  expects(rounded.size() == nodes.nodes.size() && rounded.size() == nodes.space.size(),
          "as many nodes as functions", named("nodes", nodes.nodes.size()),
          named("functions", nodes.space.size()), named("rounded", rounded.size()));
  BasisFacts facts = basis_facts(rounded, tolerance);
  const Heights heights(nodes);
  constexpr long first_bits = 512;
  for (long bits = std::min(first_bits, most_bits);;) {
    const BallPrecision scope(bits);
    Attempt attempt(nodes, heights);
    if (attempt.is_solved()) {
      const auto signs = attempt.weight_signs();
      const auto triangle = attempt.precision(Region::triangle, facts.reproduced);
      const auto parallelogram = attempt.precision(Region::parallelogram, facts.reproduced);
      const bool by_products =
          facts.reproduced < facts.degree ||
          (triangle && parallelogram && !products_follow(triangle->degree, parallelogram->degree));
      const auto on_triangle = by_products ? attempt.products(Region::triangle) : std::optional(0);
      const auto on_both = by_products ? attempt.products(Region::parallelogram) : std::optional(0);
      if (signs && triangle && parallelogram && on_triangle && on_both) {
        for (std::size_t j = 0; j < signs->size(); ++j) {
          if ((*signs)[j] == 0) facts.weights[j] = 0;
          if (facts.weights[j].sign() != (*signs)[j])
            return because("weight " + std::to_string(j) + " is too small for the digits that are kept");
        }
        facts.triangle = *triangle;
        facts.parallelogram = *parallelogram;
        facts.products.reset();
        if (by_products)
          facts.products = ProductPrecision{.triangle = *on_triangle, .parallelogram = *on_both};
        facts.proof = PrecisionProof::algebraic;
        return at_true_nodes(std::move(facts), rounded, attempt.points());
      }
    }
    const long next = more_bits(bits, attempt.wanted_bits());
    if (next > most_bits)
      return because("more than " + std::to_string(most_bits) +
                     " bits would be needed to decide for which degrees the rule is exact");
    bits = next;
  }
}

}  // namespace radcert
