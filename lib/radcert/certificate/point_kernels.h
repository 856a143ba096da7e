// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/certificate/ball_transport.h"
#include "radcert/certificate/densities.h"
#include "radcert/certificate/line_bounds.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/certificate/scene.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/bounded_double.h"

namespace radcert::certificate {

/// The kernels j_k = V G(P_k,.)/pi of a certificate of values, in the units of Scene and Densities; of means
/// none.
/// Maths     on a box of which P_k sees nothing j_k = 0; of which it sees a part, j_k is from 0 to G/pi, and
///           half of that is within half of it. G(P,Q) = [n_P.(Q-P)] [n_Q.(P-Q)] / |P-Q|^4, the height of Q
///           over the plane of P and that of P over the plane of Q; 0 where both are one plane. On the line m
///           + z e of Q's, z in the ellipse with half axes A and B, a = A |e|, r = |P-m| > a: (P-Q).(P-Q) has
///           two conjugate zeros in z and is at least (r-a)^2 in size, the height of Q is r + a at most, and
///           that of P stays: |G| <= (r+a) h/(r-a)^4, which falls with r. For real Q it is at most h/|P-Q|^3
/// Requires  surface_fault, points_fault, tiling_fault found nothing; scene, densities and sight outlive it
/// Result    bounds rounded up; infinite where nothing is known
class PointKernels {
public:
  PointKernels(const PolyhedronCertificate& certificate, const Scene& scene, const Densities& densities,
               const Sight& sight);

  [[nodiscard]] std::size_t count() const { return points_.size(); }
  /// What each point sees of a part of an element.
  [[nodiscard]] std::vector<Seen> seen(const SourcePart& part) const;
  /// Of |G/pi| on the ellipses of each line of a box in one parameter.
  [[nodiscard]] EllipseBounds on_ellipses(std::size_t k, std::size_t triangle, const Box& box,
                                          bool in_s) const;
  /// What polynomials in one parameter of a box leave of G/pi of any point that sees something.
  [[nodiscard]] PolynomialErrors left(std::size_t triangle, const Box& box, bool in_s,
                                      std::span<const Seen> seen) const;
  /// sup G/pi on a box.
  [[nodiscard]] double size(std::size_t k, std::size_t triangle, const Box& box) const;
  /// G/pi at a place of a triangle.
  [[nodiscard]] BoundedDouble at(std::size_t k, std::size_t triangle, const BoundedDouble& s,
                                 const BoundedDouble& t) const;
  /// Where point k lies in a triangle of its face.
  [[nodiscard]] Observers observers(std::size_t k) const;
  /// A box of that triangle that has point k.
  [[nodiscard]] const Box& box(std::size_t k) const { return points_[k].box; }

private:
  struct PlacedPoint {
    std::size_t face = 0;
    std::size_t triangle = 0;
    BoundedDouble s;
    BoundedDouble t;
    Box box;
    Vector<double> at;  ///< within displacement of the exact point
    double scale = 0;   ///< j_k is this times G, to the nearest
  };
  [[nodiscard]] BoundedDouble height_over(const PlacedPoint& point, std::size_t face) const {
    return scene_.heights(point.triangle, face).at(point.s, point.t);
  }
  const Scene& scene_;
  const Sight& sight_;
  std::vector<PlacedPoint> points_;
};

/// Whether each point lies inside its face, or of the faces of its plane together, exactly.
/// Requires  surface_fault found nothing
[[nodiscard]] std::optional<Refusal> points_fault(const PolyhedronCertificate& certificate);

/// u at each point from sums.
/// Maths     E(P) + rho(P) (T w_0(P) + products[k] +- (radii[k] + norms[0] norms[1+k]/(1 - max rho))). Of
///           T w_0(P) what P sees in part is replaced as Shade has it
/// Requires  as PointKernels
/// Result    enclosed
/// Limits    where what arrives jumps by 1 along the borders of what P sees, some 5e-5 of it stay unknown:
///           there are most_seen_parts parts at most
[[nodiscard]] std::vector<Ball> values_of(const PolyhedronCertificate& certificate, const Sums& sums,
                                          const Ball& gap);

}  // namespace radcert::certificate
