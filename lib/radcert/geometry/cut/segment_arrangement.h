// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// A segment of a parameter plane.
struct PlaneSegment {
  ParameterPoint<Rational> from;
  ParameterPoint<Rational> to;
};

/// Points, and segments between them that have nothing else in common.
struct SegmentArrangement {
  std::vector<ParameterPoint<Rational>> points;  ///< in lexicographic order, each once
  std::vector<std::pair<std::size_t, std::size_t>>
      segments;  ///< places of points, the smaller first; each once
};

/// Segments cut at all points that they have in common.
/// Maths     the union of the segments stays what it is; two of the result have at most an end in common
/// Requires  segments of a length, else ContractViolation
/// Result    exact, whatever the order of the segments
/// Limits    looks at all pairs of segments
[[nodiscard]] SegmentArrangement segment_arrangement(std::span<const PlaneSegment> segments);

}  // namespace radcert
