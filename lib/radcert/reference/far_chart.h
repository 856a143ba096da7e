// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/reference/cubature/region.h"
#include "radcert/reference/cubature/square_maps.h"
#include "radcert/reference/density.h"
#include "radcert/surface/chart.h"

namespace radcert::reference {

/// J u and the points of one product rule over a whole chart, for the points P that are far from it.
/// Maths     points Q_ij = F(w(y_i, x_j)); normals n_Q J u |det Dw| there
/// Source    ours
/// Requires  u finite at the points, else ContractViolation; `points` a multiple of Pack::lanes
/// Result    region(): the sum over them of G u with its errors, on the unit square of the map; points of
///           space are subtracted, as in CurvedIntegrand
/// Limits    resolves G for P at a distance that the size of the rule fits, see Roughness
class FarSamples {
public:
  FarSamples(const Chart& chart, std::size_t index, const Map& map, std::size_t lines, std::size_t points,
             const Density& u);

  std::size_t lines() const { return lines_; }
  std::size_t points() const { return points_; }
  Region region(const Vector<double>& p, const Vector<double>& normal_p, double size_of_p) const;

private:
  std::size_t lines_;
  std::size_t points_;
  double reach_ = 0;             // what the points are rounded relatively to
  std::vector<double> numbers_;  // seven arrays: points, normals, sizes of the normals
};

/// The quantities of a chart that do not depend on P, for P off the chart.
/// Maths     a ball about F(centre of the domain) with the chart's corners and the middles of its sides in
///           it; the extents of the chart across and along the lines of its map; how much its normal turns
/// Result    rounded; what the ball leaves out costs points, no digits. Samples of several sizes, in `bytes`
///           bytes
/// Limits    no samples where the chart has a singular line
class FarChart {
public:
  FarChart(const Chart& chart, std::size_t index, const Density& u, std::size_t bytes);

  /// The smallest rule that is enough for P, or none.
  const FarSamples* samples_for(const Vector<double>& p) const;
  const Map& map() const { return map_; }
  /// Whether two flat charts may lie in one plane: a quick no, before the exact decision.
  friend bool may_lie_in_one_plane(const FarChart& a, const FarChart& b);

private:
  Vector<double> centre_;
  Vector<double> normal_;
  double radius_ = 0;
  double extent_across_ = 0;
  double extent_along_ = 0;
  double bend_ = 0;
  Map map_ = Collapse{};
  std::vector<FarSamples> samples_;  // from the smallest rule on
};

/// Whether two flat charts may lie in one plane; false is certain.
bool may_lie_in_one_plane(const FarChart& a, const FarChart& b);

}  // namespace radcert::reference
