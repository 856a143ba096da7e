// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "radcert/closed_form/twofold.h"
#include "radcert/geometry/vector.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// Functions on the unit triangle, prepared once for all triangles that carry them.
/// Maths     q_k(s,t) on s, t >= 0, s + t <= 1
/// Source    -
/// Requires  at least one function, each of degree at most largest_degree and not zero, else
///           ContractViolation
/// Result    coefficients rounded to nearest; maximum <= max |q|, taken over a lattice; bound >= max |q|
/// Limits    -
class TriangleFunctions {
public:
  static constexpr int largest_degree = 3;
  struct Function {
    std::vector<double> coefficients;  ///< as PlanePolynomial, up to the largest degree of all functions
    double maximum = 0;
    double bound = 0;
  };

  explicit TriangleFunctions(const std::vector<PlanePolynomial<Rational>>& functions);

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] const std::vector<Function>& functions() const { return functions_; }

private:
  int degree_ = 0;
  std::vector<Function> functions_;
};

/// The radiosity integrals of a plane triangle for many points at a time, where the closed form in doubles
/// serves.
/// Maths     Int G(P,Q) q_k(Q) dS_Q over what P sees of the triangle, Q = c_0 + s (c_1 - c_0) + t (c_2 -
///           c_0); without 1/pi, negative where P lies behind the triangle (c_0, c_1, c_2 counterclockwise
///           seen from its front)
/// Source    KernelMoments in BoundedPack; the logarithmic part by the dilogarithm at z or 1 - z, its
///           errors by the integral's derivatives
/// Requires  finite numbers; 0 < accuracy
/// Result    a lane served has |result - exact| <= accuracy (Int |G| dS) max |q_k|, a bound computed with the
///           value; a lane not served has zeros. The same bits for a point alone and in any lane of any block
/// Limits    not served: points seen from a few diameters away, where the closed form cancels, very close to
///           an edge, on the triangle's plane, and triangles a million times longer than high. A rule of
///           quadrature or PlaneElement serves there
class PlaneTriangle {
public:
  using Corners = std::array<Vector<double>, 3>;
  static constexpr double usual_accuracy = 1e-14;

  PlaneTriangle(const Corners& corners, std::shared_ptr<const TriangleFunctions> functions,
                double accuracy = usual_accuracy);

  [[nodiscard]] std::size_t function_count() const { return functions_->functions().size(); }
  /// One integral a function, ContractViolation unless values has that size; whether it is served.
  [[nodiscard]] bool integrals(const Vector<double>& p, const Vector<double>& normal,
                               std::span<double> values) const;
  /// The same for the lanes of a block; the lanes served, lane k as the bit 2^k.
  [[nodiscard]] unsigned integrals(const Vector<Pack>& p, const Vector<Pack>& normal,
                                   std::span<Pack> values) const;

private:
  struct Edge {
    TwofoldVector direction;
    TwofoldVector inward;  ///< in the plane, to the left, unit length
    double direction_x = 0;
    double direction_y = 0;
    double length = 0;
  };
  struct Eye;
  struct Sums;

  [[nodiscard]] Eye look(const Vector<Pack>& p, const Vector<Pack>& normal) const;
  template <int degree>
  [[nodiscard]] unsigned served(const Vector<Pack>& p, const Vector<Pack>& normal,
                                std::span<Pack> values) const;
  template <int degree, bool is_cut>
  [[nodiscard]] unsigned closed_form(const Eye& eye, std::span<Pack> values) const;

  std::shared_ptr<const TriangleFunctions> functions_;
  double accuracy_;
  Corners corners_;
  bool is_fair_ = true;  ///< its sides and angles permit the bounds
  TwofoldVector axis_x_;
  TwofoldVector axis_y_;
  TwofoldVector axis_z_;
  std::array<Edge, 3> edges_;
  double apex_x_ = 0;  ///< c_2 - c_0
  double apex_y_ = 0;
};

}  // namespace radcert
