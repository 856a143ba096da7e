// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/sample_points.h"

namespace radcert::verification::ac98 {

Vector<Rational> sphere_point(const Rational& u, const Rational& v) {
  const Rational inverse = 1 / (1 + u * u + v * v);
  return {2 * u * inverse, 2 * v * inverse, (1 - u * u - v * v) * inverse};
}

}  // namespace radcert::verification::ac98
