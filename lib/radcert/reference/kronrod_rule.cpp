// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/kronrod_rule.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert::reference {
namespace {

using Samples = KronrodRule::Samples;

double dot(const Samples& f, const Samples& g) {
  double sum = 0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += f[i] * g[i];
  return sum;
}

}  // namespace

KronrodRule::KronrodRule() {
  using Table = boost::math::quadrature::gauss_kronrod<double, size>;
  constexpr std::size_t half = size / 2;
  const auto& abscissa = Table::abscissa();
  const auto& weight = Table::weights();
  for (std::size_t i = 0; i <= half; ++i) {
    nodes_[half + i] = 0.5 + 0.5 * abscissa[i];
    nodes_[half - i] = 0.5 - 0.5 * abscissa[i];
    weights_[half + i] = weights_[half - i] = 0.5 * weight[i];
  }
  // Compilers have spoilt these tables under -frounding-math.
  const double sum = dot(weights_, Samples{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
  expects(std::abs(sum - 1) < 1e-15, "the weights sum to the length of the interval", named("sum", sum));

  // Orthonormal polynomials at the nodes by Gram and Schmidt, twice for their rounding.
  std::array<Samples, size> basis{};
  for (std::size_t k = 0; k < basis.size(); ++k) {
    Samples& p = basis[k];
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = k == 0 ? 1 : (2 * nodes_[i] - 1) * basis[k - 1][i];
    const auto product = [this](const Samples& f, const Samples& g) {
      double result = 0;
      for (std::size_t i = 0; i < f.size(); ++i) result += weights_[i] * f[i] * g[i];
      return result;
    };
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t l = 0; l < k; ++l) {
        const double c = product(p, basis[l]);
        for (std::size_t i = 0; i < p.size(); ++i) p[i] -= c * basis[l][i];
      }
    const double length = std::sqrt(product(p, p));
    for (double& value : p) value /= length;
  }
  for (std::size_t k = 0; k < null_.size(); ++k)
    for (std::size_t i = 0; i < size; ++i) null_[k][i] = weights_[i] * basis[k + size - null_rules][i];
}

double KronrodRule::integral(const Samples& g) const { return dot(weights_, g); }

double KronrodRule::error(const Samples& g) const {
  // Two neighbouring degrees together: an even function has no odd coefficients.
  std::array<double, null_rules / 2> pair{};
  for (std::size_t k = 0; k < pair.size(); ++k)
    pair[k] = std::hypot(dot(null_[2 * k], g), dot(null_[2 * k + 1], g));
  double decay = 0;
  for (std::size_t k = 1; k < pair.size(); ++k)
    decay = std::max(decay, pair[k] < pair[k - 1] ? pair[k] / pair[k - 1] : 1.0);
  // c_14 q^10 with the slowest fall seen and a factor for the constant; without a clear fall nothing is extrapolated.
  if (decay > 0.3) return 4 * std::max(pair.back(), decay * pair[pair.size() - 2]);
  const double squared = decay * decay;
  return 4 * pair.back() * squared * squared * decay;
}

}  // namespace radcert::reference
