// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/hypotheses/front.h"
#include "radcert/scalar/rational.h"
#include "radcert/study/events/event_cut.h"
#include "radcert/study/guarantee.h"
#include "radcert/study/method.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_function.h"

namespace radcert {

/// A surface that is given as a whole: read from a mesh file, or of a program's own charts, as own_surface
/// makes it. The latter has no `surface->mesh`, and `file` says in words what it is; what proves refuses it.
struct MeshChoice {
  std::string file;                        ///< as the problem names it
  std::string digest;                      ///< of the file's bytes
  Rational angle;                          ///< in degrees, beyond which an edge is sharp
  std::vector<std::string> repair;         ///< what was to be mended
  std::vector<std::string> mended;         ///< what was, in words
  std::vector<std::string> remarks = {};   ///< what looks like a slip and was left as it is
  std::shared_ptr<const Surface> surface;  ///< one whose triangles do not cross
  FrontRule front = FrontRule::automatic;  ///< where its light is to be
};

/// The surface of a problem: a name of the catalogue and the values of its parameters, in the catalogue's
/// order; or a surface as a whole, whose file or words are the name then.
struct SurfaceChoice {
  std::string name;
  std::vector<SurfaceParameter> parameters;
  std::optional<MeshChoice> mesh = std::nullopt;
};

/// Which triangulations of the surface a problem runs over.
struct TriangulationChoice {
  std::vector<int> levels;  ///< numbers of symmetric refinements, strictly ascending
  /// By piece ("*" the rest); empty: the published one.
  std::vector<std::pair<std::string, Diagonal>> pattern;
  Rational grading = 1;  ///< vertices of unit squares moved towards the edges by this exponent, >= 1
  std::optional<EventCut> events = std::nullopt;  ///< along which the coarse triangulation is cut
};

/// Where a problem on an interpolated surface takes its data.
enum class DataPoints {
  /// Rho, E and u at the points v_i of S, Ku over S: the interpolant serves the collocation integrals alone
  surface,
  /// At the points v~_i of the interpolant, Ku over it: the problem is posed on the interpolant altogether
  interpolant,
};

/// The interpolant of S over which a problem's collocation integrals are taken.
struct InterpolatedGeometry {
  int degree = 2;  ///< 1 to 6
  DataPoints data = DataPoints::surface;
};

/// How the linear system of a level is solved, and how well.
struct SolverChoice {
  std::string name = "auto";  ///< of linear_solvers()
  /// Of a solver that iterates, relative to max |u_n|; absent: until rounding ends the descent
  std::optional<Rational> tolerance = std::nullopt;
};

/// How the collocation matrix is held.
struct OperatorChoice {
  /// Of operator_names(): all its entries, couplings of clusters beside near entries, or what suits a level
  std::string name = "auto";
  /// Of clusters: what couplings may leave out of a row, relative to the row of a closed surface
  Rational tolerance = Rational(1) / power(Rational(10), 12);

  bool operator==(const OperatorChoice&) const = default;
};

/// How well the collocation integrals are taken.
struct QuadratureChoice {
  Rational tolerance = Rational(1) / power(Rational(10), 13);  ///< of an entry, relative to its row's Int |G|
};

/// A problem as a user states it: one surface, one method, one pair of data, several levels.
/// Maths     u(P) - rho(P)/pi Int_S G(P,Q) u(Q) dS_Q = E(P); with `solution` u given, E = u - Ku
/// Source    [ac98, (1), (40)]; the file format is radcert/problem/1
/// Requires  exactly one of solution and emission; names of the catalogue; see `check`
/// Result    plain data, exact: decimals and fractions are kept as written
struct Problem {
  SurfaceChoice surface;
  TriangulationChoice triangulation;
  std::optional<InterpolatedGeometry> geometry =
      std::nullopt;  ///< absent: the collocation integrals are over S itself
  Method method;
  PiecewiseExpression reflectivity;
  std::optional<PiecewiseExpression> solution;
  std::optional<PiecewiseExpression> emission;
  QuadratureChoice quadrature = {};
  OperatorChoice matrix = {};
  SolverChoice solver;
  bool iterated = false;  ///< whether the iterated solution E + K u_n is taken too
  /// Where given, the solution of the equation itself is enclosed; what is said of triangulation, method,
  /// quadrature and solver does not matter then
  std::optional<Guarantee> guarantee = std::nullopt;
  std::string label = {};                      ///< a short name for tables and plots; empty: none
  std::optional<int> fit_from = std::nullopt;  ///< the first level of fitted orders; absent: see collect
};

/// The surface that a problem names, or its mesh. Requires the name of an unoccluded surface of the catalogue
/// and admissible parameters, else InputError below /surface.
Surface surface_of(const Problem& problem);

/// Everything about a problem that can be refused before any work, apart from its file's syntax.
/// Maths     levels >= 0 with checked counts; a plan within `memory_limit` bytes for every level; constant
///           reflectivities in [0,1]; on closed surfaces sup rho < 1; a tolerance that double can hold, for a
///           solver that has one; and what the method refuses
/// Source    lib/radcert/formats/README.md
/// Result    returns, or throws InputError with the JSON pointer, the value and what is allowed
/// Limits    what depends on a node (an expression that is not finite there) is refused when the node is
///           known
void check(const Problem& problem, std::uint64_t memory_limit);

}  // namespace radcert
