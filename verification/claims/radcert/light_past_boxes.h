// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/geometry/vector.h"

namespace radcert::verification::radcert {

/// A box with edges along the axes.
struct AxisBox {
  Vector<double> low;
  Vector<double> high;
};

/// A rectangle in a plane x_axis = constant.
struct AxisRectangle {
  int axis = 2;
  Vector<double> low;
  Vector<double> high;
};

/// The part of the light of a rectangle that arrives at a point past boxes.
/// Maths     1/pi Int cos cos'/r^2 over what the point sees of the rectangle: the rectangle less the shadows
///           of the boxes, each the convex hull of its corners as the point projects them into the plane of
///           the rectangle. What is left is cut into convex polygons; of each the integral is Lambert's sum
///           over its sides, 1/(2 pi) sum angle_i n . unit(r_i x r_(i+1))
/// Source    Lambert, Photometria, 1760
/// Requires  boxes strictly between the point and the plane of the rectangle, or in it at most with a face;
///           the rectangle in front of the point
/// Result    in doubles, about 15 digits. Shares nothing with `visibility` and `closed_form`
[[nodiscard]] double light_past_boxes(const Vector<double>& point, const Vector<double>& normal,
                                      const AxisRectangle& lamp, const std::vector<AxisBox>& boxes);

}  // namespace radcert::verification::radcert
