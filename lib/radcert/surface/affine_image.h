// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/exact_function.h"

namespace radcert {

/// F(s,t) = origin + s first + t second.
struct AffineImage {
  Vector<Rational> origin;
  Vector<Rational> first;
  Vector<Rational> second;
};

/// An affine chart by its exact formula.
/// Maths     (F(0,0), F(1,0), F(0,1)) give the three vectors
/// Requires  the image of an affine chart, see ExactImage
/// Result    exact; nothing where a coordinate is unknown, has roots, or is a quotient by 0 at one of these
[[nodiscard]] std::optional<AffineImage> affine_image(const Vector<ExactFunction>& image);

}  // namespace radcert
