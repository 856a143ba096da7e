// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/chart_inverse.h"

#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

const WorkLimit most_steps(
    "quadrature/chart_inverse: steps", 30, 0,
    "no parameters: P counts as off the element, and all that the element may hold joins the radius");

}  // namespace

template <Real R>
bool contains(const ElementPart<R>& cell, const ParameterPoint<R>& at) {
  const auto& v = cell.vertices;
  const R whole = cross(v[1] - v[0], v[2] - v[0]);
  for (std::size_t i = 0; i < 3; ++i)
    if (cross(v[(i + 1) % 3] - at, v[(i + 2) % 3] - at) < R(-1e-12) * whole) return false;
  return true;
}

template <Real R>
std::optional<ParameterPoint<R>> parameters_on(const Chart& chart, const ElementPart<R>& cell,
                                               const Vector<R>& point, const R& extent) {
  const ChartIn<R>& formula = chart.in<R>();
  const auto& v = cell.vertices;
  const R third = R(1) / R(3);
  ParameterPoint<R> x = third * (v[0] + v[1] + v[2]);
  const R close = R(64) * unit_roundoff<R>() * extent;
  for (long step = 0; step < most_steps.value(); ++step) {
    const Frame<R> frame = formula.frame(x);
    const Vector<R> rest = point - frame.point;
    const R ss = dot(frame.tangent_s, frame.tangent_s);
    const R st = dot(frame.tangent_s, frame.tangent_t);
    const R tt = dot(frame.tangent_t, frame.tangent_t);
    const R determinant = ss * tt - st * st;
    if (!(determinant > R(0))) return std::nullopt;
    const R by_s = dot(frame.tangent_s, rest);
    const R by_t = dot(frame.tangent_t, rest);
    const ParameterPoint<R> change{(tt * by_s - st * by_t) / determinant,
                                   (ss * by_t - st * by_s) / determinant};
    const bool found = norm(rest) <= close;
    x = x + change;  // once more when it is close already: then x is as good as P
    if (found) return x;
  }
  return std::nullopt;
}

template std::optional<ParameterPoint<double>> parameters_on<double>(const Chart&, const ElementPart<double>&,
                                                                     const Vector<double>&, const double&);
template bool contains<double>(const ElementPart<double>&, const ParameterPoint<double>&);

template std::optional<ParameterPoint<Mpfr<50>>> parameters_on<Mpfr<50>>(const Chart&,
                                                                         const ElementPart<Mpfr<50>>&,
                                                                         const Vector<Mpfr<50>>&,
                                                                         const Mpfr<50>&);
template bool contains<Mpfr<50>>(const ElementPart<Mpfr<50>>&, const ParameterPoint<Mpfr<50>>&);

}  // namespace radcert
