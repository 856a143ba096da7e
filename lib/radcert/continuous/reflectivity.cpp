// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/reflectivity.h"

#include <algorithm>
#include <cmath>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/core/contract.h"

namespace radcert {
namespace {

double size_of(std::span<const double> coefficients) {
  double sum = 0;
  for (const double c : coefficients) sum += std::abs(c);
  return sum;
}

/// (1/2)(3/2)...(n-1/2)/n!
Rational half_binomial(int n) {
  Rational out = 1;
  for (int k = 1; k <= n; ++k) out *= Rational(2 * k - 1, 2 * k);
  return out;
}

std::size_t powers_of(std::span<const double> coefficients) {
  return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(coefficients.size()))));
}

}  // namespace

Reflectivity::Reflectivity(const std::vector<PanelReflectivity>& by_panel) {
  std::vector<PlanePolynomial<Rational>> polynomials;
  for (const PanelReflectivity& rho : by_panel) {
    largest_.push_back(rho.largest.to_double() * (rho.is_constant() ? 1 : upward));
    degree_ = std::max(degree_, rho.polynomial.degree());
    polynomials.push_back(rho.polynomial);
  }
  if (degree_ > 0)
    polynomials_ = std::make_shared<const std::vector<PlanePolynomial<Rational>>>(std::move(polynomials));
}

ElementReflectivity::ElementReflectivity(const Reflectivity& reflectivity, const SectorScene& scene,
                                         std::span<const SectorElement> elements)
    : functions_(elements.size(), 1, reflectivity.degree()) {
  expects(reflectivity.degree() < most_gauss_nodes, "a degree below most_gauss_nodes",
          named("degree", reflectivity.degree()));
  if (const auto* polynomials = reflectivity.polynomials())
    functions_ = plane_functions(*polynomials, scene, elements, 1, reflectivity.degree(), 0);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const double most = reflectivity.largest(scene.sectors()[elements[e].sector].panel);
    if (degree() == 0) {
      functions_.of(e, 0)[0] = most;
      largest_.push_back(most);
    } else {
      largest_.push_back(std::min(most, size_of(functions_.of(e, 0)) * upward));
    }
  }
  if (degree() == 0) return;
  const auto of_rho = static_cast<std::size_t>(degree() + 1);
  for (std::size_t of_f = 0; of_f + of_rho <= most_gauss_nodes + 1; ++of_f)
    linearisations_.push_back(linearisation(of_rho, of_f));
}

/// Maths     g_ail = A_(a-k) A_k A_(i-k) / A_(a+i-k) (2l+1)/(2a+2i-2k+1), l = a + i - 2k, A = half_binomial
/// Source    J. C. Adams, "On the expression of the product of any two Legendre's coefficients", 1878
std::vector<double> ElementReflectivity::linearisation(std::size_t of_rho, std::size_t of_f) {
  if (of_f == 0) return {};
  const std::size_t powers = of_rho + of_f - 1;
  std::vector<double> g(of_rho * of_f * powers);
  for (int a = 0; a < static_cast<int>(of_rho); ++a)
    for (int i = 0; i < static_cast<int>(of_f); ++i)
      for (int k = 0; k <= std::min(a, i); ++k) {
        const int l = a + i - 2 * k;
        const Rational exact = half_binomial(a - k) * half_binomial(k) * half_binomial(i - k) /
                               half_binomial(a + i - k) * Rational(2 * l + 1, 2 * (a + i - k) + 1);
        const auto row = static_cast<std::size_t>(a) * of_f + static_cast<std::size_t>(i);
        g[row * powers + static_cast<std::size_t>(l)] = exact.to_double();
      }
  return g;
}

void ElementReflectivity::add_product(std::size_t element, std::span<const double> f,
                                      std::span<double> to) const {
  const std::span<const double> c = functions_.of(element, 0);
  if (degree() == 0) {
    for (std::size_t i = 0; i < f.size(); ++i) to[i] += c[0] * f[i];
    return;
  }
  const std::size_t of_rho = powers_of(c);
  const std::size_t of_f = powers_of(f);
  const std::size_t powers = of_rho + of_f - 1;
  expects(to.size() == powers * powers, "room for the degree of the product", named("size", to.size()));
  const std::vector<double>& g = linearisations_[of_f];
  std::vector<double> inner(powers);
  for (std::size_t a = 0; a < of_rho; ++a)
    for (std::size_t i = 0; i < of_f; ++i) {
      std::fill(inner.begin(), inner.end(), 0.0);
      for (std::size_t b = 0; b < of_rho; ++b)
        for (std::size_t j = 0; j < of_f; ++j) {
          const double factor = c[a * of_rho + b] * f[i * of_f + j];
          if (factor == 0) continue;
          const double* const row = &g[(b * of_f + j) * powers];
          for (std::size_t m = b > j ? b - j : j - b; m <= b + j; m += 2) inner[m] += factor * row[m];
        }
      const double* const row = &g[(a * of_f + i) * powers];
      for (std::size_t l = a > i ? a - i : i - a; l <= a + i; l += 2)
        for (std::size_t m = 0; m < powers; ++m) to[l * powers + m] += row[l] * inner[m];
    }
}

double ElementReflectivity::rounding(std::size_t element, std::span<const double> emission,
                                     std::span<const double> f) const {
  const double r = degree() + 1;
  return (2 * r * r + 8) * unit_roundoff<double>() *
         (size_of(emission) + size_of(functions_.of(element, 0)) * size_of(f)) * upward;
}

}  // namespace radcert
