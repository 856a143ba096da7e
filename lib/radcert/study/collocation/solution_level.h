// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/study/collocation/iterated_solution.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/study.h"

namespace radcert {

/// A point of a triangulated surface, as an element has it.
struct SurfacePlace {
  std::size_t element = 0;
  ParameterPoint<double> at;  ///< of the element's chart
};

/// What is known of a solution at a point of the surface.
struct ValueAt {
  Vector<double> point;  ///< of S
  double distance = 0;   ///< from the one that was asked for
  std::string piece;
  std::string chart;
  ParameterPoint<double> at;  ///< of the chart
  Approximation u_n = Approximation::without_radius(0);
  std::optional<IteratedValue> iterated = std::nullopt;
  std::optional<Approximation> u = std::nullopt;          ///< with `solution`
  std::optional<Approximation> u_n_error = std::nullopt;  ///< |u - u_n|
};

/// A finished level of collocation, ready to be asked for its values anywhere on S.
/// Maths     u_n = sum_j u_n(v_j) l_j on the element; E + K u_n
/// Source    ours
/// Requires  a level of that problem; both outlive this
/// Result    InputError at "at" for a method without functions on triangles and for an interpolated geometry
/// Limits    u_n has two values on the sides of elements: the place says which
class SolutionLevel {
public:
  SolutionLevel(const Problem& problem, const LevelOutcome& outcome);

  [[nodiscard]] const NodedSurface& surface() const { return geometry_.data(); }
  /// Whether a place is on the border of a chart where the charts of the surface may meet at an angle, up to
  /// rounding: there E + K u_n has no one value.
  [[nodiscard]] bool is_on_edge(const SurfacePlace& place) const;
  /// The place in its element's chart of parameters; the first element of several.
  /// Result    none where no element of the chart has them
  [[nodiscard]] std::optional<SurfacePlace> place_of(std::size_t chart,
                                                     const ParameterPoint<double>& at) const;
  /// As many points as asked for, spread over S by area.
  /// Maths     the k-th of N is at the part (k + 1/2)/N of the area of S, elements one after the other by the
  ///           area of the triangles through their corners; within an element the points of the sequence of
  ///           Kronecker with the steps 0.7548776662 and 0.5698402910, folded into the triangle
  /// Source    M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018, for the steps
  /// Result    the same on every run; none on the side of an element
  [[nodiscard]] std::vector<SurfacePlace> spread(std::size_t count) const;
  /// u_n at places, and E + K u_n where `iterated`, by the second route to Ku where u is given.
  /// Result    radii as value_in_element and IteratedSolution say; on an edge no iterated solution
  [[nodiscard]] std::vector<ValueAt> values_at(std::span<const SurfacePlace> places, bool iterated,
                                               const OperatorRoute& route) const;

private:
  const Problem& problem_;
  TriangleBasis<double> basis_;
  LevelGeometry geometry_;
  std::vector<Approximation> u_n_;
  double largest_ = 0;
};

}  // namespace radcert
