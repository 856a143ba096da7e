// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/cubature/roughness.h"

#include <algorithm>
#include <cmath>

#include "radcert/reference/cubature/gauss_rule.h"
#include "radcert/scalar/pack.h"

namespace radcert::reference {
namespace {

Cut cut(double roughness, double share, std::size_t multiple) {
  constexpr double longest = 4;  // from here on one region needs more points than two halves
  const double digits = std::max(25 + 0.6 * std::log(share), 0.0);
  const double regions = std::max(1.0, std::ceil(roughness / longest));
  const double b = 2 * regions / std::max(roughness, 1e-3);
  const double points = std::ceil(1 + digits / std::log(b + std::sqrt(1 + b * b)));
  const std::size_t rounded = (static_cast<std::size_t>(points) + multiple - 1) / multiple * multiple;
  return {static_cast<std::size_t>(regions),
          std::clamp(rounded, std::max(multiple, GaussRule::smallest), GaussRule::largest)};
}

}  // namespace

Cut cut_across(const Roughness& roughness) { return cut(roughness.across, roughness.share, 1); }
Cut cut_along(const Roughness& roughness) { return cut(roughness.along, roughness.share, Pack::lanes); }

}  // namespace radcert::reference
