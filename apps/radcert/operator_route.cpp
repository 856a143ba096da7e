// SPDX-License-Identifier: GPL-3.0-or-later
#include "operator_route.h"

#include <span>

#include "radcert/reference/operator_integral.h"

namespace radcert::app {

OperatorRoute operator_route() {
  return [](const Surface& surface, const SurfaceFunction& u) -> AppliedOperator {
    const reference::Density density = [&u](const reference::PointBlock& q, std::span<double> values) {
      u.evaluate(q.chart, q.x, q.y, q.z, values);
    };
    return [applied =
                reference::AppliedOperator(surface, density, u.formulas())](const SurfacePoint<double>& p) {
      const reference::Estimate integral = applied(p);
      return OperatorValue{.value = integral.value, .radius = integral.radius};
    };
  };
}

}  // namespace radcert::app
