// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "radcert/certificate/enclosure.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert::certificate {

/// A convex polygon of the surface, and the data on it.
/// Maths     corners counterclockwise as seen from the inside; emission[i][j] is the coefficient of x^i y^j
///           in E at corners[0] + x (corners[1] - corners[0]) + y (corners[2] - corners[0]), and so are those
///           of rho where it is no constant
struct Face {
  std::size_t piece = 0;
  std::vector<Vector<Rational>> corners;
  Rational reflectivity;  ///< at least sup rho; rho itself where it is a constant
  std::vector<std::vector<Rational>> emission;
  std::vector<std::vector<Rational>> varying_reflectivity = {};  ///< none: a constant
};

/// Towards the inside, of any length.
[[nodiscard]] inline Vector<Rational> normal_of(const Face& face) {
  return cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
}

/// A part of a face on which the functions are polynomials.
/// Maths     a + s (1-t) (b-a) + t (c-a), [s0,s1] x [t0,t1], from the side a b of the face to its centre c,
///           the mean of its corners: side k runs from corners[k] to the next one
struct Element {
  std::size_t face = 0;
  std::size_t side = 0;
  double s0 = 0;
  double s1 = 1;
  double t0 = 0;
  double t1 = 1;
};

/// A point inside a face, or between faces of one plane, at which the solution is enclosed.
struct Point {
  std::size_t face = 0;
  Vector<Rational> at;
};

/// What is claimed of the residuals on one element X.
/// Maths     norms[k] >= (Int_X rho t_k^2)^(1/2), k = 0, ..., n;  |products[k] - Int_X w_(1+k) t_0| <=
///           radii[k], k = 0, ..., n - 1, n the number of goals. Of a function: largest >= sup_X rho |t_0|,
///           and nothing else
struct Claim {
  std::vector<double> norms = {};
  std::vector<double> products = {};
  std::vector<double> radii = {};
  double largest = 0;
};

/// The sums over all elements: norms, and of the products midpoint and radius.
struct Sums {
  std::vector<double> norms;
  std::vector<double> products;
  std::vector<double> radii;
};

/// |u - w_0| <= sup at points that are `outside` or more from every corner of a face.
struct BoundAtDistance {
  Rational outside;
  Rational sup;
};

/// Of a certificate.
inline constexpr std::size_t most_distances = 400;

/// What encloses the means of the solution of a radiosity equation, its values or itself, to be checked
/// again.
/// Maths     u = E + rho T u, T u(P) = (1/pi) Int V(P,Q) G(P,Q) u(Q) dS_Q, G 0 behind either face, V = 1
///           where the open segment from P to Q meets no face, else 0. q_0, ..., q_n are polynomials on
///           elements: q_k = sum c_ij P_i(x) P_j(y), x = (2s - s0 - s1)/(s1 - s0), y alike, P_i Legendre's.
///           w_0 = E + rho q_0, t_0 = T w_0 - q_0. Goals are J_k(u) = Int j_k u. Of means: j_k = 1 on piece
///           k, else 0; w_k = rho (j_k + q_k), t_k = T w_k - q_k. Of values u(P_k) = E + rho J_k(u) at P_k:
///           j_k = V G(P_k,.)/pi; w_k = rho q_k, t_k = T w_k + j_k - q_k. In both |J_k(u) -
///           J_k(w_0) - Int w_k t_0| <= (Int rho t_0^2)^(1/2) (Int rho t_k^2)^(1/2) / (1 - max rho). Of the
///           function w_0 itself: no goals, q_0 alone, and function_fault
/// Source    lib/radcert/certificate/check.h
/// Result    plain data; nothing here is known to be true
struct PolyhedronCertificate {
  std::vector<std::string> pieces;
  std::vector<Face> faces;
  std::vector<Point> points;  ///< of values alone
  /// Of the function alone: distances descending, down to 0.
  std::vector<BoundAtDistance> by_distance = {};
  Rational outside = 0;  ///< of the function: the width is twice the bound at this distance
  std::vector<Element> elements;
  int degree = 0;
  std::vector<double> coefficients;  ///< by function, element, i, j
  std::vector<Claim> claims;         ///< by element
  Sums sums;
  std::vector<Enclosure> enclosures;  ///< by piece; or the values by point
  Rational width;                     ///< twice the largest radius of them or the bound, or more

  [[nodiscard]] bool of_values() const { return !points.empty(); }
  [[nodiscard]] bool of_function() const { return !by_distance.empty(); }
  [[nodiscard]] std::size_t goals() const {
    return of_function() ? 0 : of_values() ? points.size() : pieces.size();
  }
  [[nodiscard]] std::size_t functions() const { return goals() + 1; }
  [[nodiscard]] std::size_t powers() const { return static_cast<std::size_t>(degree) + 1; }
  [[nodiscard]] double coefficient(std::size_t k, std::size_t element, std::size_t i, std::size_t j) const {
    return coefficients[((k * elements.size() + element) * powers() + i) * powers() + j];
  }
};

}  // namespace radcert::certificate
