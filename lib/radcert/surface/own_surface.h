// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/scalar/real.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A map of the unit square into space that a program knows by its values in double alone.
/// Maths     points[i] = F(at[i]);  tangents[i] = (D_s F, D_t F) at at[i], left out where they are not known
/// Requires  `points`; called a few times, from the thread that asks, on up to 4225 points at once
struct OwnMap {
  using Points = std::span<Vector<double>>;
  using Tangents = std::span<std::array<Vector<double>, 2>>;
  std::function<void(std::span<const ParameterPoint<double>> at, Points points)> points;
  std::function<void(std::span<const ParameterPoint<double>> at, Tangents tangents)> tangents = nullptr;
};

/// Coefficients of products of Chebyshev polynomials.
/// Maths     row k has the c_jk, j = 0, 1, ..., of T_j(2s-1) T_k(2t-1)
/// Requires  two rows or more, the first of two coefficients or more, each of one or more, none of more than
///           ChebyshevMap::largest_degree + 1
using ChebyshevRows = std::vector<std::vector<Vector<double>>>;

/// A polynomial map of the unit square into space.
/// Maths     F(s,t) = sum_jk c_jk T_j(2s-1) T_k(2t-1)
/// Source    Trefethen, Approximation Theory and Approximation Practice, chapters 3 and 4
/// Result    rounded as R and T round
template <Field R>
class ChebyshevMap {
public:
  static constexpr int largest_degree = 64;

  explicit ChebyshevMap(std::shared_ptr<const ChebyshevRows> rows) : rows_(std::move(rows)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const ChebyshevRows& rows = *rows_;
    const Polynomials<T> in_s = polynomials(s, rows.front().size());
    const Polynomials<T> in_t = polynomials(t, rows.size());
    Vector<T> f = row(rows.front(), in_s);
    for (std::size_t k = 1; k < rows.size(); ++k) {
      if (rows[k].size() == 1) {
        const Vector<double>& c = rows[k].front();
        f = f + Vector<T>{R(c.x) * in_t[k], R(c.y) * in_t[k], R(c.z) * in_t[k]};
        continue;
      }
      const Vector<T> g = row(rows[k], in_s);
      f = f + Vector<T>{g.x * in_t[k], g.y * in_t[k], g.z * in_t[k]};
    }
    return f;
  }

private:
  template <class T>
  using Polynomials = std::array<T, static_cast<std::size_t>(largest_degree) + 1>;

  /// T_k(2x - 1), k = 1, 2, ...; the place of T_0 = 1 is not used.
  template <Field T>
  static Polynomials<T> polynomials(const T& x, std::size_t count) {
    Polynomials<T> out;
    out[1] = R(-1) + R(2) * x;
    if (count > 2) out[2] = R(-1) + R(2) * (out[1] * out[1]);
    for (std::size_t k = 3; k < count; ++k) out[k] = R(2) * (out[1] * out[k - 1]) - out[k - 2];
    return out;
  }

  template <Field T>
  static Vector<T> row(const std::vector<Vector<double>>& c, const Polynomials<T>& in_s) {
    Vector<T> f{R(c[1].x) * in_s[1], R(c[1].y) * in_s[1], R(c[1].z) * in_s[1]};
    for (std::size_t j = 2; j < c.size(); ++j)
      f = f + Vector<T>{R(c[j].x) * in_s[j], R(c[j].y) * in_s[j], R(c[j].z) * in_s[j]};
    return {R(c[0].x) + f.x, R(c[0].y) + f.y, R(c[0].z) + f.z};
  }

  std::shared_ptr<const ChebyshevRows> rows_;
};

/// The interpolant of a map, by which a surface stands for it.
/// Maths     the rows interpolate F on the grid of the extreme points of T_n in both parameters, n the first
///           of 8, 16, 32, 64 for which the last coefficients, and the differences from F at 101 points
///           between, are below 1e-13 of the extent; coefficients in the noise of double are left out
/// Result    residual, tangent_residual: the largest |F - interpolant| that was seen, relative to the extent
///           of the image, and the same of D_s F and D_t F where they are known: no bounds
struct OwnChart {
  std::string name;
  std::string piece;
  std::shared_ptr<const ChebyshevRows> rows;
  double residual = 0;
  std::optional<double> tangent_residual = std::nullopt;

  /// The largest degrees in s and t.
  [[nodiscard]] std::array<int, 2> degrees() const;
};

/// The interpolant of a map of a program's own.
/// Requires  names that are not empty
/// Result    InputError at /map where a value is not finite, or no degree to 64 is enough; at /jacobian where
///           its values are not finite, or more than 1e-6 of the extent off the interpolant's derivatives
[[nodiscard]] OwnChart interpolated_map(std::string name, std::string piece, const OwnMap& map);

/// A surface of charts of a program's own, in double alone.
/// Maths     the side of the light of each chart is that on which the other points lie. S counts as closed
///           where each side of a chart is one of another, point for point, within 1e-12 of the extent
/// Requires  `name`, 1 to 256 charts of different names
/// Result    unoccluded. Decided on 11 x 11 points a chart, proved of nothing: that the charts have normals,
///           that no point lies behind one of the tangent planes, that charts of a piece which share a side
///           have one normal there. InputError at /charts where one is not so. pieces_meet_at_angle wherever
///           there are two pieces
/// Limits    that no two charts overlap and none covers a part twice is not looked at. No arithmetic but
///           double and Pack: nothing on it is proved
[[nodiscard]] Surface own_surface(const std::string& name, std::span<const OwnChart> charts);

/// Whether each chart has a formula in balls, without which nothing on the surface is proved.
[[nodiscard]] bool is_known_in_balls(const Surface& surface);

}  // namespace radcert
