// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/certified_chart_entries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "radcert/collocation/certified/lagrange_on_elements.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/quadrature/certified/certified_kernel_sums.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();

/// The functions of the elements, and a density divided by a power of two.
class LagrangeAndDensity final : public ElementFunctions {
public:
  LagrangeAndDensity(const LagrangeFunctions& functions, const DensityFormula& u, double scale)
      : functions_(functions), u_(u), inverse_scale_(1 / scale) {}

  std::size_t size() const override { return functions_.size() + 1; }
  void values(const ElementPoint<BoundedDouble>& at, std::span<BoundedDouble> out) const override {
    functions_.values(at, out.first(functions_.size()));
    out.back() = BoundedDouble::exactly(inverse_scale_) * u_.in_doubles({at.chart, at.at, at.point});
  }
  double bound(const ElementPoint<TaylorModel>& at) const override {
    const double of_density = u_.in_models({at.chart, at.at, at.point}).magnitude_bound();
    return std::max(functions_.bound(at), inverse_scale_ * of_density);
  }
  /// |u| / scale is at most 1 or so on the surface, however large it is beside it.
  double allowed(const ElementPoint<TaylorModel>& at, double bound) const override {
    return std::min(bound, functions_.bound(at));
  }

private:
  LagrangeOnElements functions_;
  const DensityFormula& u_;
  double inverse_scale_;
};

/// An integral and its radius times rho/pi. Zeros are exact.
void scale_by_reflectivity(double reflectivity, double& value, double& radius) {
  const bool vanishes = reflectivity == 0 || (value == 0 && radius == 0);
  const Approximation entry =
      vanishes ? Approximation::exact(0) : certified_entry(reflectivity, value, radius);
  value = entry.value;
  radius = entry.radius;
}

CertifiedEntries entries_to_be(std::size_t n) {
  return {.entries = Matrix<double>::uninitialised(n, n), .radius = Matrix<double>::uninitialised(n, n)};
}

/// Whether the radii of every row sum up to at most demand |rho|.
Outcome<void> rows_within(const CertifiedEntries& found, std::span<const double> reflectivity,
                          double demand) {
  const std::size_t n = reflectivity.size();
  std::vector<double> rows(n, 0.0);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) rows[i] += found.radius(i, j);
  for (std::size_t i = 0; i < n; ++i) {
    const double reached = rows[i] * (1 + 2 * static_cast<double>(n) * unit);
    if (!(reached <= demand * std::abs(reflectivity[i])))
      return because("the radii of a row sum to " + upper_text(reached, DecimalForm::general(4)) +
                     ", more than the " + shortest(demand * std::abs(reflectivity[i])) +
                     " demanded: roundings in double are wider");
  }
  return {};
}

}  // namespace

std::vector<SurfacePoint<Rational>> exact_collocation_nodes(const Triangulation& triangulation,
                                                            const LagrangeFunctions& functions) {
  std::vector<SurfacePoint<Rational>> nodes;
  nodes.reserve(triangulation.triangles.size() * functions.size());
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    std::array<ParameterPoint<Rational>, 3> v;
    for (std::size_t i = 0; i < 3; ++i)
      v[i] = {Rational::exactly(triangle.vertices[i].s), Rational::exactly(triangle.vertices[i].t)};
    for (const Barycentric<Rational>& q : functions.nodes())
      nodes.push_back({triangle.chart, q.x[0] * v[0] + q.x[1] * v[1] + q.x[2] * v[2]});
  }
  return nodes;
}

Outcome<CertifiedEntries> certified_chart_entries(const Surface& surface, const Triangulation& triangulation,
                                                  const LagrangeFunctions& functions,
                                                  std::span<const double> reflectivity, double demand) {
  const std::size_t p = functions.size();
  const std::size_t n = triangulation.triangles.size() * p;
  expects_collocation_data(functions, n, reflectivity);
  const LagrangeOnElements on_elements(functions);
  const std::vector<SurfacePoint<Rational>> nodes = exact_collocation_nodes(triangulation, functions);
  const CertifiedKernelSums sums(surface, triangulation, on_elements, nodes, demand);

  CertifiedEntries result = entries_to_be(n);
  std::vector<Outcome<void>> found(triangulation.triangles.size());
  parallel_for(triangulation.triangles.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::span<double> values(&result.entries(0, k * p), n * p);
      const std::span<double> radius(&result.radius(0, k * p), n * p);
      found[k] = sums.element(k, values, radius);
      if (!found[k]) continue;
      for (std::size_t j = 0; j < p; ++j)
        for (std::size_t i = 0; i < n; ++i)
          scale_by_reflectivity(reflectivity[i], values[j * n + i], radius[j * n + i]);
    }
  });
  for (const Outcome<void>& of_element : found)
    if (!of_element) return because(of_element.reason());
  if (const Outcome<void> narrow = rows_within(result, reflectivity, demand); !narrow)
    return because(narrow.reason());
  return result;
}

Outcome<CertifiedCollocation> certified_collocation(const Surface& surface,
                                                    const Triangulation& triangulation,
                                                    const LagrangeFunctions& functions,
                                                    const DensityFormula& u, double size, double demand) {
  expects(size > 0 && std::isfinite(size), "0 < size", named("size", size));
  const std::size_t p = functions.size();
  const std::size_t elements = triangulation.triangles.size();
  const std::size_t n = elements * p;
  const std::vector<double> ones(n, 1.0);
  expects_collocation_data(functions, n, ones);
  const double scale = std::ldexp(1.0, std::ilogb(size) + 1);
  const LagrangeAndDensity on_elements(functions, u, scale);
  const std::vector<SurfacePoint<Rational>> nodes = exact_collocation_nodes(triangulation, functions);
  const CertifiedKernelSums sums(surface, triangulation, on_elements, nodes, demand);

  CertifiedEntries matrix = entries_to_be(n);
  Outcome<CertifiedSums> total = CertifiedSums::over_elements(
      sums, elements, p + 1, n,
      [&](std::size_t k, std::span<const double> values, std::span<const double> radius) {
        for (std::size_t j = 0; j < p; ++j)
          for (std::size_t i = 0; i < n; ++i) {
            double& value = matrix.entries(i, k * p + j) = values[j * n + i];
            double& r = matrix.radius(i, k * p + j) = radius[j * n + i];
            scale_by_reflectivity(1, value, r);
          }
      });
  if (!total) return because(total.reason());
  if (const Outcome<void> narrow = rows_within(matrix, ones, demand); !narrow)
    return because(narrow.reason());
  Outcome<CertifiedValues> integrals =
      (*std::move(total)).within(std::numbers::pi * (size / scale) * demand, elements);
  if (!integrals) return because(integrals.reason());
  for (double& value : integrals->values) value *= scale;
  for (double& radius : integrals->radius) radius *= scale;
  return CertifiedCollocation{.matrix = std::move(matrix), .integrals = std::move(*integrals)};
}

}  // namespace radcert
