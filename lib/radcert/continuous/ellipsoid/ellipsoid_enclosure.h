// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>

#include "radcert/continuous/ellipsoid/ellipsoid_transport.h"
#include "radcert/core/outcome.h"
#include "radcert/expression/expression.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// Largest degree of a reflectivity on an ellipsoid.
inline constexpr int most_reflectivity_degree = 16;

/// The radiosity equation u = E + rho T u inside an ellipsoid about the origin.
/// Maths     T u(P) = (1/pi) Int G(P,Q) u(Q) dS_Q on the surface (x/a)^2 + (y/b)^2 + (z/c)^2 = 1
/// Source    [ac98, (1)-(2)]
/// Requires  rho and E written as polynomials in x, y, z of the degrees most_reflectivity_degree and
///           most_sphere_degree at most; 0 <= rho < 1 on the surface
struct EllipsoidProblem {
  Vector<Rational> half_axes;
  Expression reflectivity;
  Expression emission;
};

/// What is known of rho.
struct ReflectivityBound {
  double largest = 0;  ///< at least sup |rho|
  double gap = 1;      ///< at most 1 - sup |rho|, positive
  double seen = 0;     ///< at most sup |rho|
};

/// A bound of |E| over the surface, and of rho.
/// Result    refused where the formula is not a polynomial, or of too high a degree, or where rho is not
///           shown to lie in [0,1)
[[nodiscard]] Outcome<double> emission_bound(const EllipsoidProblem& problem);
[[nodiscard]] Outcome<ReflectivityBound> reflectivity_bound(const EllipsoidProblem& problem);

/// How far a search for an enclosure has come.
struct EllipsoidProgress {
  int degree = 0;                                          ///< of q
  std::size_t nodes = 0;                                   ///< of the rule for T v at a point
  std::size_t samples = 0;                                 ///< points at which the residual was bounded
  double residual = 0;                                     ///< the largest |T v - q| seen at points, no bound
  double bound = std::numeric_limits<double>::infinity();  ///< of |u - v|; infinite before one is proved
};

/// An approximation of the solution itself, with a bound of its error everywhere on the surface.
struct EllipsoidEnclosure {
  EllipsoidDensity v;                                      ///< E + rho q
  double bound = std::numeric_limits<double>::infinity();  ///< |u - v| <= bound, proved
  Approximation mean = {};                                 ///< of u over the surface, proved
  EllipsoidProgress last = {};
  std::string hindrance = {};  ///< where the bound is not the wanted one: what stood in the way

  /// u at A p/|p|, A the diagonal matrix of the half axes.
  /// Requires  a finite p of a size between 1/2 and 2, else ContractViolation
  /// Result    proved
  [[nodiscard]] Approximation at(const Vector<double>& p) const;
};

/// Encloses u everywhere on an ellipsoid.
/// Maths     v = E + rho q with any polynomial q, t = T v - q, s = sup |rho| < 1: u - v = rho t + rho T (u -
///           v) and |T f| <= sup |f|, since G >= 0 and T 1 = 1 on a closed convex surface, so that |u - v| <=
///           s sup |t| / (1 - s). sup |t|: let L be the part of t up to the degree M >= degree of q, and e =
///           harmonic_tail of degree M, |t - L| <= e. With |t| <= X at points that cover the sphere,
///           bound_between bounds L by X + e at them. Mean: Int T f dS = Int f dS, so that for a constant rho
///           the mean of u is that of E over 1 - rho; otherwise that of v within the bound
/// Source    ours
/// Requires  wanted > 0, else ContractViolation
/// Result    proved; the same bits for any number of threads. Refused: half axes that are not positive,
///           formulas that are not polynomials, or of too high a degree, a reflectivity that is not below 1
/// Limits    an ellipsoid with one half axis much shorter than another needs high degrees: what is reached
///           where the wanted bound is not is given with its reason
[[nodiscard]] Outcome<EllipsoidEnclosure> enclose_on_ellipsoid(
    const EllipsoidProblem& problem, double wanted,
    const std::function<void(const EllipsoidProgress&)>& progress = {});

/// A bound of |u - v| over the whole surface, and the work that it took.
struct ErrorBound {
  double bound = 0;
  std::size_t samples = 0;  ///< points at which the residual was bounded
  std::size_t nodes = 0;    ///< of the rule at each
};

/// The bound for any v = E + rho q.
/// Maths     as enclose_on_ellipsoid has it
/// Requires  target > 0: the degree M and the rules are chosen so that what they miss is a small part of it;
///           rho.largest > 0
/// Result    proved; refused where the work is too much
[[nodiscard]] Outcome<ErrorBound> bound_of_error(const EllipsoidShape& shape, const EllipsoidDensity& v,
                                                 const ReflectivityBound& rho, double target);

}  // namespace radcert
