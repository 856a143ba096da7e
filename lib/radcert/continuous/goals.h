// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/panel.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/continuous/reflectivity.h"
#include "radcert/continuous/trial.h"
#include "radcert/scalar/approximation.h"

namespace radcert {

/// How far functions of goals are from what they stand for.
/// Maths     E_k stands for rho j_kh, j_kh a polynomial on elements near j_k
struct DualErrors {
  std::vector<double> left;  ///< by k, at least (Int rho (j_k - j_kh)^2)^(1/2)
  /// Of all E_k in the maximum norm, beyond that of each coefficient to the nearest.
  double rounding = 0;
  /// The j_kh and, by element and k, what they leave of j_k there; none where j_kh = j_k is known otherwise.
  std::optional<SectorFunctions> polynomials = std::nullopt;
  std::vector<double> left_on_elements = {};
};

/// Numbers that depend linearly on the solution u of the radiosity equation.
/// Maths     number k is a_k + b_k J_k(u), J_k(u) = Int j_k u. Functions of a Trial: first those of
///           emissions, then, as many as there are numbers, those of the j_k
class Goals {
public:
  Goals() = default;
  Goals(const Goals&) = delete;
  Goals& operator=(const Goals&) = delete;
  Goals(Goals&&) = delete;
  Goals& operator=(Goals&&) = delete;
  virtual ~Goals() = default;

  [[nodiscard]] virtual std::size_t count() const = 0;
  /// Whether any b_k is not 0.
  [[nodiscard]] virtual bool depend_on_u() const = 0;
  /// The least r/b_k, r the radius that is wanted for the numbers; infinite where it is beyond double.
  [[nodiscard]] virtual double radius(double wanted) const = 0;
  /// j_k is taken 2^-exponent(k) times.
  [[nodiscard]] virtual int exponent(std::size_t k) const = 0;
  /// The least degree that suits the j_k.
  [[nodiscard]] virtual int least_degree() const = 0;
  /// Elements cut until polynomials of this degree leave no more than about `allowed` of any rho j_k.
  [[nodiscard]] virtual std::vector<SectorElement> refined(std::vector<SectorElement> elements, int degree,
                                                           double allowed) const = 0;
  /// Puts rho j_kh, j_kh near j_k, in the place of the last functions.
  /// Requires  functions of the degree of q and that of rho together
  virtual DualErrors put_duals(std::span<const SectorElement> elements, SectorFunctions& emissions) const = 0;
  /// J_k(w), w that of an emission.
  /// Result    proved; within `allowed` where that can be had
  [[nodiscard]] virtual std::vector<Approximation> of_density(const Trial& trial, double allowed,
                                                              std::size_t emission = 0) const = 0;
  /// a_k + b_k times an enclosure of J_k(u), of an emission.
  /// Result    proved where that is
  [[nodiscard]] virtual Approximation number(std::size_t k, const Approximation& functional,
                                             std::size_t emission = 0) const = 0;
};

/// The means of u over the pieces of the surface.
/// Maths     J_k(u) = Int u over piece k, b_k = 1/area
/// Requires  the scene outlives it
[[nodiscard]] std::unique_ptr<Goals> piece_means(const SectorScene& scene, const Reflectivity& reflectivity);

/// A point at which u is asked for, and the data there.
struct ValueGoal {
  SolutionPoint point;
  std::vector<Approximation> emissions;  ///< each E
  double reflectivity = 0;               ///< rho to the nearest
};

/// The values of u at points.
/// Maths     u(P) = E(P) + rho(P) T u(P): j(Q) = G(P,Q)/pi, b = rho(P). On an element j is holomorphic around
///           the lines of either parameter (kernel_in_ellipse), so that its interpolant j_h at tensor Gauss
///           nodes is off by 2 |X|^(1/2) (e_s + e_t) in L2 on the element X, e = 2 M rho^(1-n)/(rho-1) for n
///           nodes. Where panels hide each other, j = V G/pi is 0 on elements that P does not see; on those
///           seen in part half of the interpolant stands for it, off by half of sup |j| and half of that
/// Requires  the scene outlives it; points inside their panels, or on sides at which parts of one plane meet
[[nodiscard]] std::unique_ptr<Goals> point_values(const SectorScene& scene, const Reflectivity& reflectivity,
                                                  const std::vector<ValueGoal>& points);

}  // namespace radcert
