// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/continuous/graded_elements.h"
#include "radcert/continuous/sector.h"
#include "radcert/continuous/tensor_legendre.h"

namespace radcert {

/// Points of one panel, close together.
/// Requires  none on an edge of the polyhedron
struct ObserverGroup {
  std::size_t panel = 0;
  std::vector<Vector<double>> points;
};

/// T f at points, T = (1/pi) Int G . dS, for functions that are polynomials on elements.
/// Maths     tensor Gauss rules on dyadic parts of the elements. Q runs along a straight line with the half
///           length h in either parameter; for a complex parameter in the ellipse with the larger half axis
///           A, a = h A, and D the distance of the observer from the middle of the line, D > a: |P - Q(z)|^2
///           is a product of two factors of modulus >= D - a,  |n_P.(Q(z)-P)| <= D + a, and n_Q.(P-Q) is the
///           height of P over the plane of Q, so that  |G| <= (D+a) min(D,height) / (D-a)^4, which decreases
///           in D. A rule of n nodes is then off by (2 + 2/(4n^2-1)) rho^(-2n)/(1 - rho^-2) times this, the
///           area, and the bound of f on the ellipse (gauss_error_factor)
/// Source    the ellipse: N. Trefethen, "Approximation Theory and Approximation Practice", theorem 19.3; that
///           the kernel is holomorphic there: its denominator is (w.w) with w = P - Q(z), whose factors are
///           linear in z with conjugate zeros, each at least D/h from the middle
/// Requires  the scene and the elements outlive it
/// Result    the radius holds for all functions: truncation, rounding of points, of the kernel, of the
///           functions and of the sums. It is infinite nearer to another panel than least_kernel_distance
/// Limits    the tolerance is relative to the sizes of the functions, which should be alike; what is reached
///           is the radius
class Transport {
public:
  Transport(const SectorScene& scene, std::span<const SectorElement> elements,
            const SectorFunctions& functions);

  struct Values {
    std::vector<double> values;  ///< by point, function
    double radius = 0;
  };
  /// The panel `without` is left out.
  [[nodiscard]] Values operator()(const ObserverGroup& group, double tolerance,
                                  std::optional<std::size_t> without = std::nullopt) const;

  /// A bound of |f| for all functions.
  [[nodiscard]] double size() const { return size_; }

private:
  class Sum;
  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  std::size_t powers_;  ///< degree + 1
  std::size_t count_;
  std::size_t stride_;                      ///< count, filled up to whole packs
  std::vector<double> coefficients_;        ///< by element, i, j, function
  std::vector<PolynomialSizes> sizes_;      ///< of each element
  std::vector<std::size_t> first_element_;  ///< of each panel, and the number of all
  double size_ = 0;
};

/// The distance of a point from a segment, rounded.
[[nodiscard]] double distance(const Vector<double>& point, const Vector<double>& from,
                              const Vector<double>& to);

}  // namespace radcert
