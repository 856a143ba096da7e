// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/scalar/rational.h"

namespace radcert::certificate {

/// A number that is claimed to lie within a radius of another one.
struct Enclosure {
  Rational midpoint;
  Rational radius;
};

/// What in a certificate does not hold.
struct Refusal {
  std::string pointer;  ///< the place in the file
  std::string says;
};

}  // namespace radcert::certificate
