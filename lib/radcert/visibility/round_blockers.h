// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"

namespace radcert {

/// An opaque ball.
struct BallBlocker {
  Vector<double> centre;
  double radius = 0;
};

/// An opaque disk; the normal is not of unit length.
struct DiskBlocker {
  Vector<double> centre;
  Vector<double> normal;
  double radius = 0;
};

/// Whether a ball stands between two points.
/// Maths     the open segment PQ has a point X with |X - centre| < radius: touching from outside hides
///           nothing
/// Source    the minimum of |X - centre|^2 along the segment; signs in doubles with a bounded error, then in
///           rational numbers
/// Requires  numbers of at most Scene::largest_coordinate, radius >= 0, else ContractViolation
/// Result    exact for the given doubles; P = Q: whether P lies inside
[[nodiscard]] bool hides(const BallBlocker& ball, const Vector<double>& p, const Vector<double>& q);

/// Whether a disk stands between two points.
/// Maths     the open segment PQ meets the closed disk { X : normal . (X - centre) = 0, |X - centre| <=
///           radius }: an end on the disk hides nothing, grazing the rim hides, as with triangles
/// Source    as for balls
/// Requires  numbers as for balls, normal != 0, radius >= 0, else ContractViolation
/// Result    exact for the given doubles; P = Q: never
[[nodiscard]] bool hides(const DiskBlocker& disk, const Vector<double>& p, const Vector<double>& q);

}  // namespace radcert
