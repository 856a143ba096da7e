// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/lagrange_functions.h"

#include <flint/fmpq.h>
#include <flint/fmpz_mat.h>

#include <algorithm>

#include "radcert/core/c_value.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

using Integer = CValue<fmpz, fmpz_init, fmpz_clear>;

class IntegerMatrix {
public:
  IntegerMatrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  IntegerMatrix(const IntegerMatrix&) = delete;
  IntegerMatrix& operator=(const IntegerMatrix&) = delete;
  ~IntegerMatrix() { fmpz_mat_clear(value_); }
  operator fmpz_mat_struct*() { return value_; }
  fmpz* at(std::size_t row, std::size_t column) {
    return fmpz_mat_entry(value_, static_cast<slong>(row), static_cast<slong>(column));
  }

private:
  fmpz_mat_t value_;
};

void set(fmpz* target, const Rational& whole) {
  fmpz_set_mpz(target, mpq_numref(static_cast<mpq_srcptr>(whole.gmp())));
}

Rational quotient(const fmpz* numerator, const fmpz* denominator) {
  CValue<__mpq_struct, mpq_init, mpq_clear> value;
  fmpz_get_mpz(mpq_numref(value), numerator);
  fmpz_get_mpz(mpq_denref(value), denominator);
  mpq_canonicalize(value);
  return Rational::from_gmp(value);
}

Rational whole(const fmpz* value) {
  Integer one;
  fmpz_one(one);
  return quotient(value, one);
}

// The least D > 0 for which D x has whole coordinates.
Rational common_denominator(const Barycentric<Rational>& x) {
  Rational common = 1;
  for (const Rational& coordinate : x.x) common *= (common * coordinate).denominator();
  return common;
}

// B_k(x) for all k.
std::vector<Rational> bernstein_values(int degree, const Barycentric<Rational>& x) {
  std::array<std::vector<Rational>, 3> divided_powers;  // x_i^m / m!
  for (std::size_t i = 0; i < 3; ++i) {
    divided_powers[i].push_back(1);
    for (int m = 1; m <= degree; ++m) divided_powers[i].push_back(divided_powers[i].back() * x.x[i] / m);
  }
  Rational factorial = 1;
  for (int m = 2; m <= degree; ++m) factorial *= m;
  std::vector<Rational> values;
  values.reserve(polynomial_dimension(degree));
  for (const std::array<int, 3>& k : lattice_indices(degree)) {
    Rational value = factorial;
    for (std::size_t i = 0; i < 3; ++i) value *= divided_powers[i][static_cast<std::size_t>(k[i])];
    values.push_back(value);
  }
  return values;
}

// D_j^r B_k(q_j), whole numbers, and the D_j^r.
std::vector<Rational> fill(IntegerMatrix& matrix, int degree, std::span<const Barycentric<Rational>> nodes) {
  std::vector<Rational> scales;
  scales.reserve(nodes.size());
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const Rational denominator = common_denominator(nodes[j]);
    Barycentric<Rational> scaled = nodes[j];
    for (Rational& coordinate : scaled.x) coordinate *= denominator;
    const std::vector<Rational> values = bernstein_values(degree, scaled);
    for (std::size_t k = 0; k < values.size(); ++k) set(matrix.at(j, k), values[k]);
    scales.push_back(power(denominator, degree));
  }
  return scales;
}

NotUnisolvent counterexample(IntegerMatrix& matrix, std::span<const Barycentric<Rational>> nodes) {
  NotUnisolvent reason;
  for (std::size_t j = 0; j < nodes.size() && !reason.repeated; ++j)
    for (std::size_t i = 0; i < j && !reason.repeated; ++i)
      if (nodes[i] == nodes[j]) reason.repeated = {i, j};
  IntegerMatrix kernel(nodes.size(), nodes.size());
  fmpz_mat_nullspace(kernel, matrix);
  Integer content;
  for (std::size_t k = 0; k < nodes.size(); ++k) fmpz_gcd(content, content, kernel.at(k, 0));
  for (std::size_t k = 0; k < nodes.size(); ++k)
    reason.vanishing.push_back(quotient(kernel.at(k, 0), content));
  return reason;
}

void expect_barycentric(std::span<const Barycentric<Rational>> nodes) {
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const Rational sum = nodes[j].x[0] + nodes[j].x[1] + nodes[j].x[2];
    expects(sum == 1, "barycentric coordinates with the sum 1", named("node", j), named("sum", sum));
  }
}

Rational scalar_product(std::span<const Rational> a, std::span<const Rational> b) {
  Rational sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

// sum_m a_m f_m by its Bernstein coefficients.
std::vector<Rational> combined(const PolynomialSpace& space, std::span<const Rational> a) {
  std::vector<Rational> out(polynomial_dimension(space.degree));
  for (std::size_t m = 0; m < a.size(); ++m)
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += a[m] * space.functions[m][k];
  return out;
}

// f_m(q_j), each row times a number that makes it whole; the numbers.
std::vector<Rational> fill(IntegerMatrix& matrix, const PolynomialSpace& space,
                           std::span<const Barycentric<Rational>> nodes) {
  std::vector<Rational> scales;
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const std::vector<Rational> bernstein = bernstein_values(space.degree, nodes[j]);
    std::vector<Rational> row;
    Rational scale = 1;
    for (const std::vector<Rational>& f : space.functions) {
      row.push_back(scalar_product(f, bernstein));
      scale *= (scale * row.back()).denominator();
    }
    for (std::size_t m = 0; m < row.size(); ++m) set(matrix.at(j, m), row[m] * scale);
    scales.push_back(scale);
  }
  return scales;
}

// Whether interpolation gives back the monomials x_2^b x_3^a of a degree.
bool reproduces(const LagrangeFunctions& functions, int degree) {
  const std::vector<Barycentric<Rational>> places = inset_nodes(functions.degree(), Rational(0));
  std::vector<Rational> values(functions.size());
  for (const Barycentric<Rational>& x : places) {
    functions.values(x, values);
    for (int a = 0; a <= degree; ++a) {
      const auto p = [&](const Barycentric<Rational>& q) {
        return power(q.x[1], degree - a) * power(q.x[2], a);
      };
      Rational rest = -p(x);
      for (std::size_t j = 0; j < values.size(); ++j) rest += p(functions.nodes()[j]) * values[j];
      if (rest != 0) return false;
    }
  }
  return true;
}

}  // namespace

std::string NotUnisolvent::to_text() const {
  if (repeated)
    return "nodes " + std::to_string(repeated->first) + " and " + std::to_string(repeated->second) +
           " are the same point";
  if (!combination.empty()) {
    const bool dependent =
        std::all_of(vanishing.begin(), vanishing.end(), [](const Rational& c) { return c == 0; });
    std::string terms;
    for (std::size_t m = 0; m < combination.size(); ++m) {
      if (combination[m].sign() == 0) continue;
      terms += (terms.empty() ? "" : " + ") + combination[m].to_text() + " f_" + std::to_string(m);
    }
    return dependent ? "the functions of the space are linearly dependent, " + terms + " = 0"
                     : "a function of the space other than zero vanishes at all " +
                           std::to_string(combination.size()) + " nodes, " + terms;
  }
  const int degree = degree_of_dimension(vanishing.size()).value_or(0);
  const std::vector<std::array<int, 3>> indices = lattice_indices(degree);
  std::string text = "a polynomial of degree " + std::to_string(degree) +
                     " other than zero vanishes at all " + std::to_string(vanishing.size()) +
                     " nodes, with the Bernstein coefficients";
  for (std::size_t k = 0; k < vanishing.size(); ++k) {
    if (vanishing[k].sign() == 0) continue;
    text += " " + vanishing[k].to_text() + " at (" + std::to_string(indices[k][0]) + "," +
            std::to_string(indices[k][1]) + "," + std::to_string(indices[k][2]) + ")";
  }
  return text;
}

std::span<const Rational> LagrangeFunctions::bernstein_coefficients(std::size_t j) const {
  expects(j < size(), "the number of a function", named("function", j), named("functions", size()));
  const std::size_t count = polynomial_dimension(degree_);
  return std::span<const Rational>(coefficients_).subspan(j * count, count);
}

void LagrangeFunctions::values(const Barycentric<Rational>& x, std::span<Rational> out) const {
  expects(out.size() == size(), "a place for each function", named("places", out.size()),
          named("functions", size()));
  expects(x.x[0] + x.x[1] + x.x[2] == 1, "barycentric coordinates with the sum 1");
  const std::vector<Rational> bernstein = bernstein_values(degree_, x);
  for (std::size_t j = 0; j < size(); ++j) out[j] = scalar_product(bernstein_coefficients(j), bernstein);
}

Outcome<LagrangeFunctions, NotUnisolvent> lagrange_functions(std::span<const Barycentric<Rational>> nodes) {
  const std::optional<int> degree = degree_of_dimension(nodes.size());
  expects(degree.has_value(), "(r + 1)(r + 2)/2 nodes for some degree r", named("nodes", nodes.size()));
  expect_barycentric(nodes);

  const std::size_t n = nodes.size();
  IntegerMatrix matrix(n, n);
  const std::vector<Rational> scales = fill(matrix, *degree, nodes);
  IntegerMatrix inverse(n, n);
  Integer denominator;
  if (fmpz_mat_inv(inverse, denominator, matrix) == 0) return because(counterexample(matrix, nodes));

  LagrangeFunctions functions;
  functions.degree_ = functions.reproduced_degree_ = *degree;
  functions.nodes_.assign(nodes.begin(), nodes.end());
  Integer determinant;
  fmpz_mat_det(determinant, matrix);
  functions.determinant_ = whole(determinant);
  for (const Rational& scale : scales) functions.determinant_ /= scale;
  functions.coefficients_.reserve(n * n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k)
      functions.coefficients_.push_back(quotient(inverse.at(k, j), denominator) * scales[j]);
  return functions;
}

Outcome<LagrangeFunctions, NotUnisolvent> lagrange_functions(const PolynomialSpace& space,
                                                             std::span<const Barycentric<Rational>> nodes) {
  const std::size_t n = nodes.size();
  expects(n > 0 && space.functions.size() == n, "as many nodes as functions, one at least", named("nodes", n),
          named("functions", space.functions.size()));
  for (const std::vector<Rational>& f : space.functions)
    expects(f.size() == polynomial_dimension(space.degree),
            "the Bernstein coefficients of the space's degree", named("coefficients", f.size()),
            named("degree", space.degree));
  expect_barycentric(nodes);

  IntegerMatrix matrix(n, n);
  const std::vector<Rational> scales = fill(matrix, space, nodes);
  IntegerMatrix inverse(n, n);
  Integer denominator;
  if (fmpz_mat_inv(inverse, denominator, matrix) == 0) {
    NotUnisolvent reason = counterexample(matrix, nodes);
    reason.combination = std::move(reason.vanishing);
    reason.vanishing = combined(space, reason.combination);
    return because(std::move(reason));
  }

  LagrangeFunctions functions;
  functions.degree_ = space.degree;
  functions.nodes_.assign(nodes.begin(), nodes.end());
  Integer determinant;
  fmpz_mat_det(determinant, matrix);
  functions.determinant_ = whole(determinant);
  for (const Rational& scale : scales) functions.determinant_ /= scale;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<Rational> a;
    for (std::size_t m = 0; m < n; ++m) a.push_back(quotient(inverse.at(m, j), denominator) * scales[j]);
    const std::vector<Rational> c = combined(space, a);
    functions.coefficients_.insert(functions.coefficients_.end(), c.begin(), c.end());
  }
  functions.reproduced_degree_ = -1;
  while (functions.reproduced_degree_ < space.degree &&
         reproduces(functions, functions.reproduced_degree_ + 1))
    ++functions.reproduced_degree_;
  return functions;
}

}  // namespace radcert
