// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/certificate/densities.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/certificate/scene.h"

namespace radcert::certificate {

/// The larger half axes of ellipses with the foci -1, 1 in which bounds are known.
inline constexpr std::array<double, 16> ellipse_axes{1.04, 1.1, 1.2, 1.32, 1.5, 1.75, 2.1, 2.6,
                                                     3.3,  4.5, 6.5, 10,   18,  40,   120, 1000};
using EllipseBounds = std::array<double, ellipse_axes.size()>;

/// What polynomials of degree N - 1 in one parameter leave of T w on a box of observers: [N - 1].
using PolynomialErrors = std::array<double, 40>;

/// The least of what the ellipses leave.
/// Maths     |f| <= M in the ellipse whose half axes sum to R leaves 2 M R^(1-N)/(R-1), see LineBounds
/// Result    rounded up
[[nodiscard]] PolynomialErrors polynomial_errors(const EllipseBounds& bounds);

/// The lines of a box of a triangle in one parameter.
struct BoxLines {
  Vector<double> from;  ///< their middles run from here
  Vector<double> to;
  double half = 0;  ///< |e| at most
};
[[nodiscard]] BoxLines box_lines(const SideTriangle& triangle, const Box& box, bool in_s);

/// T w next to an edge, without what the face beyond makes singular there.
/// Maths     T 1 = 1, so that T w = F + T_j (w - xi), F = sum_(i != j) T_i w + xi (1 - sum_(i != j) T_i 1);
///           the face beyond the edge is Q_j, and xi(s) = w in its element Y at the point x of the edge with
///           the parameter s of P. |P-x| <= R, P at most H over the plane of Q_j. The kernel is at most H/(pi
///           r^3) at the distance r, so that what is further than q sends M(q) = min(1, 2H/q) at most; up to
///           the distance d of x from the other sides of Y |w - xi| <= l |Q-x| <= l (R + |Q-P|), l a
///           Lipschitz constant on Y. Hence |T_j (w - xi)| <= l R + l Int_0^(d-R) M dq + sum (o_i - o_(i-1))
///           M(d_i - R), d_0 = d, o_i the largest |w - xi| on Y and on elements no further from x than d_i,
///           ascending, o_(-1) = 0 Beside an end x of Y that other elements of the edge have as well, xi = w
///           on Y at x alone, |P-x| <= R, and |w - xi| <= J + l |Q-x| on each element that x belongs to, J
///           the largest jump of w at x and d the distance of all others, so that J is added
struct EdgeClosing {
  std::size_t face = 0;     ///< Q_j
  std::size_t element = 0;  ///< Y
  std::vector<double> edge_sizes;
  double part = 1;                                 ///< the box' half length relative to that of Y
  double beside = 0;                               ///< the bound of |T_j (w - xi)|
  double jump = 0;                                 ///< J: what is left of it in the smallest box
  std::optional<BoundedDouble> at = std::nullopt;  ///< where on Y xi is constant: x in [-1,1]
};

/// How smooth T w is along the lines of a box of observers.
/// Maths     T_j w on the line c + z e, z in the ellipse with the foci -1, 1 and the half axes A and B, a = A
///           |e|, b = B |e|, c at the distance D or more from an element Y:
///             (1) |P-Q|^2 = (P-Q).(P-Q) has two conjugate zeros in z, hence at least (r-a)^2 in size, r =
///                 |c-Q|; n_P.(Q-P) stays as it is, since e lies in the plane of P; n_Q.(P-Q) grows by A
///                 |e.n_Q| at most. So |G(P,Q)| <= G(c,Q) (1 + A |e.n_Q|/h) (D/(D-a))^4, h the height of c
///                 over the plane of Y, and the integral of G(c,Q)/pi is at most 1 and at most |Y|
///                 min(h,D)/(pi D^3)
///                 The numerator is at most r (h + A |e.n_Q|) as well, so that |Y| (h + A |e.n_Q|)/(pi D^3)
///                 takes the place of the integral with its first factor
///             (2) where e is parallel to Q_j: P = p + i y e/|e|, Q moves to Q + i y phi e/|e|, phi = max(0,
///                 1 - |Q-p|/r), r at most the distance of p from all borders of elements on Q_j that are not
///                 parallel to e. Cauchy's theorem on each line along e, w being a polynomial between
///                 borders: T_j w stays. The scalar products with normals stay, dQ gets at most
///                 (1+theta^2)^(1/2), theta = y/r, and Im(P-Q) = y (1-phi) <= theta |p-Q|: |T_j w| <=
///                 (1+theta^2)^(1/2) (1-theta^2)^-2 sup |w| where Q has moved. r falls by at most the way of
///                 p: theta = b/(r^2 - a^2)^(1/2) on the ellipse, r taken at c. Q moves by no more than the
///                 distance from the borders: a real segment in its element is the diameter of the disk it
///                 moves in, whose image under the parameters x, y, affine or fractions of affine functions
///                 along the line, is a disk about a part of [-1,1], where |P_i| <= (1 + sqrt(2))^i
///           With |f| <= M in the ellipse whose half axes sum to R, truncation of the Chebyshev series, |a_k|
///           <= 2 M R^-k, leaves 2 M R^(1-N)/(R-1) of f. All of it holds for parts of
///           elements that are seen by all of the box (View) in place of elements: their borders are borders
///           in (2)
/// Source    ours; N. Trefethen, "Approximation Theory and Approximation Practice", theorem 8.1 for a_k
/// Requires  all of it outlives this
/// Result    rounded up, infinite where nothing is known
class LineBounds {
public:
  LineBounds(const PolyhedronCertificate& certificate, const Scene& scene, const Densities& densities);

  /// Of T w, or of F where there is a closing, along s = parameter 0 or t = parameter 1; of what the view
  /// has, where there is one, and F with a constant of at most this size in place of xi (Shade).
  [[nodiscard]] PolynomialErrors left(std::size_t element, const Box& box, bool in_s,
                                      const EdgeClosing* closing, const View* view = nullptr,
                                      double constant = 0) const;

  /// Of |T_j w_k| alone for any k on the ellipses of each line, with Q_j a face of another plane.
  [[nodiscard]] EllipseBounds on_ellipses(std::size_t element, const Box& box, bool in_s,
                                          std::size_t face) const;

  /// The closing of a box that touches its edge within the width of one element beyond; infinite `beside`
  /// where there is none yet.
  [[nodiscard]] std::optional<EdgeClosing> closing(std::size_t element, const Box& box) const;
  /// The same for the middle of the box' edge alone: what a short box there would have.
  [[nodiscard]] double short_beside(std::size_t element, const Box& box) const;
  /// The closing of a box that touches its edge at the end of an element beyond that is nearest to it, where
  /// there is one inside the edge.
  [[nodiscard]] std::optional<EdgeClosing> closing_at_end(std::size_t element, const Box& box) const;
  /// Where on the edge of an element that end is.
  [[nodiscard]] std::optional<double> nearest_end(std::size_t element, const Box& box) const;

  [[nodiscard]] const SideTriangle& triangle(std::size_t element) const {
    return scene_.triangles()[triangle_[element]];
  }
  [[nodiscard]] std::size_t triangle_place(std::size_t element) const { return triangle_[element]; }
  [[nodiscard]] const std::vector<std::size_t>& elements_of(std::size_t face) const { return of_face_[face]; }

private:
  /// What of a face is seen: all of it where none are named.
  [[nodiscard]] EllipseBounds bounds(std::size_t element, const Box& box, bool in_s, std::size_t face,
                                     std::span<const SourcePart> parts, const EllipseBounds& xi) const;
  [[nodiscard]] double beside(std::size_t element, const Box& box, std::size_t beyond, double half) const;
  [[nodiscard]] double lipschitz(std::size_t element) const;
  /// w_k at a point of the edge of an element.
  struct OnEdge {
    BoundedDouble place;  ///< x in [-1,1]
    std::vector<double> w;
    double error = 0;  ///< of each
  };
  [[nodiscard]] OnEdge on_edge(std::size_t element, double s) const;
  /// sup |w - xi| on an element and its distance from x, which is no less.
  struct Oscillation {
    double distance = 0;
    double size = 0;
  };
  /// l R + l Int_0^(d-R) M dq + sum (o_i - o_(i-1)) M(d_i - R) for the observers of a box.
  [[nodiscard]] double sent(std::size_t element, const Box& box, std::size_t face, double lipschitz,
                            double reach, double distance, std::vector<Oscillation> oscillations) const;
  /// sup |w - xi| on an element for xi with these values.
  [[nodiscard]] double oscillation(std::size_t element, std::span<const double> xi) const;
  [[nodiscard]] std::optional<std::size_t> element_beyond(std::size_t element, double s0, double s1) const;
  [[nodiscard]] double slide_reach(std::size_t triangle, std::size_t face, std::span<const SourcePart> parts,
                                   const Vector<double>& c) const;
  [[nodiscard]] double nearest_border(std::size_t triangle, const SourcePart& part,
                                      const Vector<double>& c) const;

  const PolyhedronCertificate& certificate_;
  const Scene& scene_;
  const Densities& densities_;
  std::vector<std::size_t> triangle_;              ///< of each element
  std::vector<std::vector<std::size_t>> of_face_;  ///< elements
  std::vector<Quadrilateral> quadrilaterals_;
  std::vector<double> area_;
  std::vector<double> size_;       ///< sup |w| of each element
  std::vector<double> mean_;       ///< of each element, by k: c_00 of w_k
  std::vector<double> rest_;       ///< and sum of the other |c_ij|
  std::vector<double> slid_size_;  ///< by face, where Q has moved
};

}  // namespace radcert::certificate
