// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "radcert/meshless/interpolation_system.h"
#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/sampling.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

RadialBasis basis_on(const Surface& surface, double separation) {
  return RadialBasis::make(poisson_disk_sites(surface, {separation, 1}).value(), lehtinen_basis()).value();
}

Case sites() {
  return {.limit = "meshless/sampling: cells", .answer = [] {
            const auto found = poisson_disk_sites(sphere(), {0.3, 1});
            return found ? verdict(std::to_string(found->size()) + " sites") : refusal(found.reason());
          }};
}

Case integrals() {
  return {.limit = "meshless/weights: points of an integration", .answer = [] {
            const BasisIntegrals found = integrate_basis(basis_on(sphere(), 0.8), sphere());
            std::vector<Ball> all;
            for (std::size_t j = 0; j < found.weights.size(); ++j)
              all.push_back(number(found.weights[j], found.errors[j]));
            all.push_back(number(found.area, found.area_error));
            return numbers(all, std::to_string(found.points));
          }};
}

/// Equal weights whose sum is the area: 4 pi.
Case mean_density() {
  return {.limit = "meshless/light_solution: points for an area",
          .answer =
              [] {
                const RadialBasis basis = basis_on(sphere(), 0.6);
                const LightWeights found = light_weights(basis, sphere(), WeightRule::mean_density).value();
                const double n = static_cast<double>(basis.size());
                // What errors that are not independent do to the sum.
                return numbers({number(n * found.weights[0], std::sqrt(n) * found.errors[0])});
              },
          .truth = [] { return std::vector<Ball>{4 * Ball::pi()}; }};
}

/// A bound from below: up to a number that no condition of so small a system reaches.
Case condition() {
  return {.limit = "meshless/interpolation_system: corners that a condition is sought at", .answer = [] {
            const InterpolationSystem system = InterpolationSystem::make(basis_on(sphere(), 0.5)).value();
            const double condition = system.condition();
            return numbers({hull(Ball(condition), Ball(1e12))}, std::to_string(condition));
          }};
}

}  // namespace

std::vector<Case> meshless_cases() { return {sites(), integrals(), mean_density(), condition()}; }

}  // namespace radcert::limits
