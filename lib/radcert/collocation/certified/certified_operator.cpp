// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/certified_operator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/quadrature/certified/certified_kernel_sums.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();

/// The density as the one function of every element.
class DensityOnElements final : public ElementFunctions {
public:
  explicit DensityOnElements(const DensityFormula& u) : u_(u) {}
  std::size_t size() const override { return 1; }
  void values(const ElementPoint<BoundedDouble>& q, std::span<BoundedDouble> out) const override {
    out[0] = u_.in_doubles({q.chart, q.at, q.point});
  }
  double bound(const ElementPoint<TaylorModel>& q) const override {
    return u_.in_models({q.chart, q.at, q.point}).magnitude_bound();
  }
  /// The demand is absolute, wherever u is small or large.
  double allowed(const ElementPoint<TaylorModel>& /*q*/, double /*bound*/) const override { return 1; }

private:
  const DensityFormula& u_;
};

}  // namespace

Outcome<CertifiedSums> CertifiedSums::over_elements(
    const CertifiedKernelSums& sums, std::size_t elements, std::size_t functions, std::size_t points,
    const std::function<void(std::size_t, std::span<const double>, std::span<const double>)>& use) {
  struct Part {
    CertifiedSums sums;
    Outcome<void> found;
  };
  Part total = parallel_reduce_ordered(
      elements, default_grain(elements), Part{CertifiedSums(points), {}},
      [&](std::size_t begin, std::size_t end) {
        Part part{CertifiedSums(points), {}};
        std::vector<double> values(functions * points);
        std::vector<double> radius(functions * points);
        for (std::size_t k = begin; k < end && part.found; ++k) {
          part.found = sums.element(k, values, radius);
          if (use) use(k, values, radius);
          part.sums.add(std::span(values).last(points), std::span(radius).last(points));
        }
        return part;
      },
      [](Part all, const Part& part) {
        if (all.found) all.found = part.found;
        all.sums.add(part.sums);
        return all;
      });
  if (!total.found) return because(total.found.reason());
  return std::move(total.sums);
}

void CertifiedSums::add(std::span<const double> values, std::span<const double> radius) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums_.values[i] += values[i];
    sums_.radius[i] += radius[i] + unit * std::abs(sums_.values[i]);
  }
}

Outcome<CertifiedValues> CertifiedSums::within(double demand, std::size_t elements) && {
  for (double& radius : sums_.radius) {
    // The radii were added with fewer roundings than elements, twice.
    radius *= 1 + 4 * (static_cast<double>(elements) + 4) * unit;
    if (!(radius <= demand))
      return because("a radius of " + upper_text(radius, DecimalForm::general(4)) +
                     " was reached, more than the " + shortest(demand) +
                     " demanded: roundings in double are wider");
  }
  return std::move(sums_);
}

Outcome<CertifiedValues> certified_operator(const Surface& surface, const Triangulation& triangulation,
                                            const DensityFormula& u,
                                            std::span<const SurfacePoint<Rational>> points, double demand) {
  const DensityOnElements density(u);
  const CertifiedKernelSums sums(surface, triangulation, density, points, demand);
  const std::size_t elements = triangulation.triangles.size();
  Outcome<CertifiedSums> total = CertifiedSums::over_elements(sums, elements, 1, points.size());
  if (!total) return because(total.reason());
  return (*std::move(total)).within(demand, elements);
}

}  // namespace radcert
