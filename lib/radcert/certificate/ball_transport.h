// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/certificate/densities.h"
#include "radcert/certificate/line_bounds.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/certificate/scene.h"
#include "radcert/core/work_limit.h"

namespace radcert::certificate {

extern const WorkLimit most_source_parts;

/// Points of one side's triangle, as parameters.
struct Observers {
  std::size_t triangle = 0;
  std::vector<BoundedDouble> s;
  std::vector<BoundedDouble> t;
};

/// T w_k at points, in balls whose midpoints are doubles.
/// Maths     T w_k = sum over elements of sum c_ij M_ij, M_ij = (1/pi) Int G P_i P_j the moments of the
///           kernel over the element, c_ij the coefficients of w_k: the search sums values of w_k over nodes
///           and has no moments. The moments are those of tensor Gauss rules on parts of the elements. On
///           the line m + z e of a part, z in the ellipse with half axes A and B, a = A |e|, r = |P-m| > a:
///           (P-Q).(P-Q) has two conjugate zeros in z and
///           is at least (r-a)^2, |n_P.(Q-P)| <= r + a, and n_Q.(P-Q) is the height h of P, |G| <= (r+a)
///           h/(r-a)^4, which falls with r. With |f| <= M in the ellipse whose half axes sum to R, f = sum
///           a_k T_k, |a_k| <= 2 M R^-k, a rule of n nodes is exact below T_2n, and |mean of T_k| + |rule of
///           T_k| <= 1 + 1/(4n^2-1) for even k >= 2n (0 for odd k): it is off by at most 3 M R^(-2n)/(1 -
///           R^-2) of the mean Rounding: P and Q are off by 2^-47 a coordinate, P-Q by e = 2^-44 in length,
///           n_P.(Q-P) by 2 e, h by its own bound e_h, |P-Q|^-4 by 4.1 e/r of its size where r >= 2^10 e; the
///           products by 10 * 2^-53. Together (8 e h/r^4 + 2 e_h/r^3). Sums of n terms and the tables of P_i
///           and P_j: relative to sum |c_ij| T 1, T 1 <= 1, for the terms are G P_i P_j, G not negative
/// Requires  all of it outlives this
class BallTransport {
public:
  BallTransport(const PolyhedronCertificate& certificate, const Scene& scene, const Densities& densities,
                const LineBounds& lines);

  struct Values {
    std::vector<double> values;  ///< by point, function: stride() of them, the constant after the others
    std::vector<double> radii;   ///< by point, for all functions
  };
  /// The face `without` is left out. The tolerance is wanted, the radius is what holds; it is infinite where
  /// a point is too near to another face. Of what the view has, where there is one: all of that is seen from
  /// the points.
  [[nodiscard]] Values operator()(const Observers& observers, double tolerance,
                                  std::optional<std::size_t> without, const View* view = nullptr) const;

private:
  class Sum;
  const PolyhedronCertificate& certificate_;
  const Scene& scene_;
  const Densities& densities_;
  const LineBounds& lines_;
};

}  // namespace radcert::certificate
