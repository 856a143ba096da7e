// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/formats/table/points_csv.h"
#include "radcert/study/collocation/solution_level.h"
#include "requests/work.h"

namespace radcert::app {

/// How points of a surface are looked up.
struct AtChoice {
  double tolerance = 1e-9;  ///< how far from S a point may be, relative to the extent of S
  bool iterated = true;
};

/// Where points are on the surface of a level.
struct AskedPlaces {
  std::vector<SurfacePlace> places;
  std::vector<double> distances;  ///< of the points that were asked for; 0 by parameters
};

/// The places of points: by the parameters that they have, or nearest on S.
/// Maths     the point of S nearest to P is sought in each element that may hold one nearer than the best, by
///           reference::nearest_to; of several elements the first is taken
/// Requires  `tolerance`, how far from S a point may be, relative to the extent of S, from 0 to 1
/// Result    InputError at `where` for a point that is farther off S, with its distance, or not finite, for
///           parameters outside a chart, for a name that is none and for a piece of several charts
/// Limits    the nearest point of a curved element may be a local one: its distance is then too large, and
///           the point refused
[[nodiscard]] AskedPlaces places_of(const SolutionLevel& level, std::span<const AskedPoint> points,
                                    double tolerance, Progress& told);

/// The computed function and its iterate at points of the surface.
/// Maths     u_n = sum_j u_n(v_j) l_j; the iterate E + K u_n, with E = u - Ku where u is given
/// Source    ours; values as SolutionLevel has them
/// Requires  an outcome of that problem
/// Result    u_n with the radius of its nodal values times sum |l_j|; the iterate with the terms of its
///           radius, estimated. At a collocation node both are the same number but for these. InputError at
///           "points/3" as places_of says, and, for the iterate, on an edge at which charts meet at an angle;
///           at "at" for a method without functions on triangles and for an interpolated geometry
/// Limits    u_n has two values on the sides of elements
[[nodiscard]] std::vector<ValueAt> solution_at(const Problem& problem, const LevelOutcome& outcome,
                                               std::span<const Vector<double>> points, const AtChoice& choice,
                                               Progress& told);

}  // namespace radcert::app
