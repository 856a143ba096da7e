// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "radcert/certificate/ellipsoid/ellipsoid_certificate.h"
#include "radcert/certificate/part.h"
#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert::certificate {

/// A certificate of any surface.
using Certificate = std::variant<PolyhedronCertificate, EllipsoidCertificate>;

/// One number that a certificate encloses: a mean over a piece, or a value at a point of it.
struct CertifiedNumber {
  std::string piece;
  std::optional<Vector<Rational>> at;
  Enclosure enclosure;
};
[[nodiscard]] std::vector<CertifiedNumber> numbers(const Certificate& certificate);

/// A bound of |u - w|, w the function of the certificate if it is of one, at points that are `outside` or
/// more from every corner of a face; everywhere where that is 0, as on an ellipsoid.
[[nodiscard]] std::optional<BoundAtDistance> function_bound(const Certificate& certificate);

/// How many parts a check can look at: elements of a polyhedron, rows of points on an ellipsoid.
[[nodiscard]] std::size_t part_count(const Certificate& certificate);

/// check of the kind that it is.
[[nodiscard]] Report check(const Certificate& certificate, const Part& part,
                           const CheckListener& progress = {});

}  // namespace radcert::certificate
