// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/polynomial/barycentric.h"
#include "radcert/scalar/pack.h"
#include "radcert/surface/chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// Points of clusters as structure of arrays, one set of points after the other.
/// Maths     Q = F(x), n_Q the unit inner normal, weight = |D_s F x D_t F| times the area of the cluster in
///           the parameter plane: the mean over the cluster of G(P,Q) weight f is its part of Int G f dS
/// Result    sets begin at whole packs; what pads a set is its last point again, with weight 0
class ClusterPoints {
public:
  /// Room for so many more points, padded; gives the place of the first.
  std::size_t add(std::size_t count);
  /// Places a set of points, rounded.
  void place(std::size_t first, const Chart& chart, const ParameterTriangle& cluster,
             std::span<const Barycentric<double>> points);
  void clear() { resize(0); }

  [[nodiscard]] std::size_t size() const { return x_.size(); }
  /// The points from a place on.
  [[nodiscard]] Vector<Pack> points(std::size_t at) const {
    return {Pack::load(&x_[at]), Pack::load(&y_[at]), Pack::load(&z_[at])};
  }
  [[nodiscard]] Vector<Pack> normals(std::size_t at) const {
    return {Pack::load(&normal_x_[at]), Pack::load(&normal_y_[at]), Pack::load(&normal_z_[at])};
  }
  [[nodiscard]] Pack weights(std::size_t at) const { return Pack::load(&weight_[at]); }
  [[nodiscard]] Vector<double> point(std::size_t at) const { return {x_[at], y_[at], z_[at]}; }
  [[nodiscard]] Vector<double> normal(std::size_t at) const {
    return {normal_x_[at], normal_y_[at], normal_z_[at]};
  }
  [[nodiscard]] double weight(std::size_t at) const { return weight_[at]; }
  /// Bytes a point.
  static constexpr std::size_t bytes_each = 7 * sizeof(double);

private:
  void resize(std::size_t size);

  std::vector<double> x_, y_, z_;
  std::vector<double> normal_x_, normal_y_, normal_z_;
  std::vector<double> weight_;
};

/// The area of a triangle in the parameter plane.
[[nodiscard]] double parameter_area(const ParameterTriangle& triangle);

}  // namespace radcert
