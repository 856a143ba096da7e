// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified_operator.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "radcert/collocation/certified_kernel_sums.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();

/// The density as the one function of every element.
class DensityOnElements final : public ElementFunctions {
public:
  explicit DensityOnElements(const Density& u) : u_(u) {}
  std::size_t size() const override { return 1; }
  void values(const ElementPoint<Ball>& at, std::span<Ball> out) const override {
    out[0] = u_.in_balls(at.on_surface);
  }
  double bound(const ElementPoint<TaylorModel>& at) const override {
    return u_.in_models(at.on_surface).magnitude_bound();
  }

private:
  const Density& u_;
};

/// The sums over a chunk of elements.
struct Part {
  std::vector<double> values;
  std::vector<double> radius;
  std::string refusal;
};

}  // namespace

Outcome<CertifiedValues> certified_operator(const Surface& surface, const Triangulation& triangulation,
                                            const Density& u, std::span<const SurfacePoint<Rational>> points,
                                            double demand) {
  const DensityOnElements density(u);
  const CertifiedKernelSums sums(surface, triangulation, density, points, demand);
  const std::size_t n = points.size();
  const std::size_t elements = triangulation.triangles.size();
  const auto add = [n](Part& total, std::span<const double> values, std::span<const double> radius) {
    for (std::size_t i = 0; i < n; ++i) {
      total.values[i] += values[i];
      total.radius[i] += radius[i] + unit * std::abs(total.values[i]);
    }
  };
  const auto zero = [n] { return Part{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0), {}}; };
  Part total = parallel_reduce_ordered(
      elements, default_grain(elements), zero(),
      [&](std::size_t begin, std::size_t end) {
        Part part = zero();
        std::vector<double> values(n);
        std::vector<double> radius(n);
        for (std::size_t k = begin; k < end && part.refusal.empty(); ++k) {
          part.refusal = sums.element(k, values, radius);
          add(part, values, radius);
        }
        return part;
      },
      [&](Part all, const Part& part) {
        if (all.refusal.empty()) all.refusal = part.refusal;
        add(all, part.values, part.radius);
        return all;
      });
  if (!total.refusal.empty()) return because(std::move(total.refusal));
  CertifiedValues result{.values = std::move(total.values), .radius = std::move(total.radius)};
  for (double& radius : result.radius) {
    // The radii were added with fewer roundings than elements, twice.
    radius *= 1 + 4 * (static_cast<double>(elements) + 4) * unit;
    if (!(radius <= demand))
      return because("a radius of " + shortest(radius) + " was reached, more than the " + shortest(demand) +
                     " demanded: roundings in double are wider");
  }
  return result;
}

}  // namespace radcert
