// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/section_3/interpolation_error.h"

#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"

namespace radcert::verification::m06 {
namespace {

// x^a y^b.
template <class R>
R monomial(const R& x, const R& y, const Monomial& exponents) {
  R product(1);
  for (int i = 0; i < exponents.s; ++i) product = product * x;
  for (int i = 0; i < exponents.t; ++i) product = product * y;
  return product;
}

// (1 - 3 alpha)^n.
RationalPolynomial pole(int n) {
  RationalPolynomial result = 1;
  for (int i = 0; i < n; ++i) result *= 1 - 3 * RationalPolynomial::variable();
  return result;
}

}  // namespace

InterpolationError::InterpolationError(int degree) : degree_(degree), family_(degree) {
  expects(degree <= 8, "degree <= 8", named("degree", degree));
  const InsetFamily lattice(degree + 3);
  points_ = inset_nodes<Rational>(degree + 3, 0);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    weights_.push_back(lattice.weight(p)(0));
    values_.emplace_back();
    for (std::size_t j = 0; j < family_.size(); ++j) {
      const InsetFunction value = family_.value(j, points_[p]);
      values_.back().push_back(value.numerator * pole(degree - value.pole_order));
    }
  }
}

std::vector<InterpolationError::Half> InterpolationError::halves(Over region) {
  const Rational half(1, 2);
  if (region == Over::square) return {{1, 1, -half}, {-1, -1, half}};
  if (region == Over::kite) return {{1, 1, 0}, {-1, 1, 0}};
  return {{1, 1, 0}};
}

std::vector<InterpolationError::OfFunctions> InterpolationError::of_functions(Over region,
                                                                              const Monomial& phi) const {
  std::vector<OfFunctions> all;
  for (const Half& half : halves(region)) {
    OfFunctions functions{half, std::vector<RationalPolynomial>(family_.size())};
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const Rational factor =
          weights_[p] * monomial<Rational>(half.x_sign * points_[p].x[2] + half.shift,
                                           half.y_sign * points_[p].x[1] + half.shift, phi);
      for (std::size_t j = 0; j < family_.size(); ++j) functions.integrals[j] += factor * values_[p][j];
    }
    all.push_back(std::move(functions));
  }
  return all;
}

RationalPolynomial InterpolationError::error(const std::vector<OfFunctions>& functions, const Monomial& phi,
                                             const Monomial& g) const {
  RationalPolynomial error;
  for (const auto& [half, integrals] : functions) {
    Rational whole = 0;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const Rational x = half.x_sign * points_[p].x[2] + half.shift;
      const Rational y = half.y_sign * points_[p].x[1] + half.shift;
      whole += weights_[p] * monomial(x, y, phi) * monomial(x, y, g);
    }
    error += whole * pole(degree_);
    for (std::size_t j = 0; j < family_.size(); ++j) {
      const std::array<RationalPolynomial, 3> node = family_.node(j);
      const RationalPolynomial x = half.x_sign * node[2] + half.shift;
      const RationalPolynomial y = half.y_sign * node[1] + half.shift;
      error -= monomial(x, y, g) * integrals[j];
    }
  }
  return error;
}

RationalPolynomial InterpolationError::operator()(Over region, const Monomial& phi, const Monomial& g) const {
  expects(phi.degree() <= 1 && g.degree() <= degree_ + 2, "Phi of degree <= 1, g of degree <= r + 2",
          named("Phi", phi.degree()), named("g", g.degree()));
  return error(of_functions(region, phi), phi, g);
}

Rational InterpolationError::coefficients_left(Over region, int of_phi, int of_g,
                                               const RationalPolynomial& modulus) const {
  expects(of_phi <= 1 && of_g <= degree_ + 2, "Phi of degree <= 1, g of degree <= r + 2",
          named("Phi", of_phi), named("g", of_g));
  long count = 0;
  for (int a = 0; a <= of_phi; ++a) {
    const Monomial phi{of_phi - a, a};
    const std::vector<OfFunctions> functions = of_functions(region, phi);
    for (int b = 0; b <= of_g; ++b) {
      const RationalPolynomial whole = error(functions, phi, {of_g - b, b});
      const RationalPolynomial rest = modulus.is_zero() ? whole : divide(whole, modulus).remainder;
      for (int k = 0; k <= rest.degree(); ++k)
        if (rest.coefficient(static_cast<std::size_t>(k)) != 0) ++count;
    }
  }
  return {count};
}

}  // namespace radcert::verification::m06
