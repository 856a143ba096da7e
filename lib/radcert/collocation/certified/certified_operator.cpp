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

/// The sums over a chunk of elements.
struct Part {
  CertifiedSums sums;
  Outcome<void> found;
};

}  // namespace

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
  const std::size_t n = points.size();
  const std::size_t elements = triangulation.triangles.size();
  Part total = parallel_reduce_ordered(
      elements, default_grain(elements), Part{CertifiedSums(n), {}},
      [&](std::size_t begin, std::size_t end) {
        Part part{CertifiedSums(n), {}};
        std::vector<double> values(n);
        std::vector<double> radius(n);
        for (std::size_t k = begin; k < end && part.found; ++k) {
          part.found = sums.element(k, values, radius);
          part.sums.add(values, radius);
        }
        return part;
      },
      [](Part all, const Part& part) {
        if (all.found) all.found = part.found;
        all.sums.add(part.sums);
        return all;
      });
  if (!total.found) return because(total.found.reason());
  return std::move(total.sums).within(demand, elements);
}

}  // namespace radcert
