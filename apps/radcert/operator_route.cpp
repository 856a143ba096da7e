// SPDX-License-Identifier: GPL-3.0-or-later
#include "operator_route.h"

#include "radcert/reference/operator_integral.h"

namespace radcert::app {

OperatorRoute operator_route() {
  return [](const Surface& surface, const std::function<double(std::size_t, const Vector<double>&)>& u,
            const SurfacePoint<double>& p) {
    const reference::Density density = [&u](const SurfacePoint<double>& q, const Vector<double>& point) {
      return u(q.chart, point);
    };
    const reference::Estimate integral = reference::operator_integral(surface, p, density);
    return OperatorValue{.value = integral.value, .radius = integral.radius};
  };
}

}  // namespace radcert::app
