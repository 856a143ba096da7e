// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/restricted_chart.h"

#include <memory>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

using Corner = ParameterPoint<Rational>;

/// The map of the unit triangle onto a triangle.
/// Maths     x(s,t) = origin + s first + t second
struct AffineMap {
  Corner origin;
  Corner first;
  Corner second;

  template <Real R>
  ParameterPoint<R> linear(const ParameterPoint<R>& w) const {
    return {w.s * from_rational<R>(first.s) + w.t * from_rational<R>(second.s),
            w.s * from_rational<R>(first.t) + w.t * from_rational<R>(second.t)};
  }
  template <Real R>
  ParameterPoint<R> operator()(const ParameterPoint<R>& at) const {
    return ParameterPoint<R>{from_rational<R>(origin.s), from_rational<R>(origin.t)} + linear(at);
  }
};

/// A chart's formula after the map. Its constants are made at each call, inside the precision of the moment.
template <Real R>
class RestrictedIn final : public ChartIn<R> {
public:
  RestrictedIn(Chart chart, AffineMap map) : chart_(std::move(chart)), map_(std::move(map)) {}

  Frame<R> frame(const ParameterPoint<R>& at) const override {
    const Frame<R> whole = chart_.in<R>().frame(map_(at));
    const auto along = [&](const Corner& direction) {
      return from_rational<R>(direction.s) * whole.tangent_s +
             from_rational<R>(direction.t) * whole.tangent_t;
    };
    const R determinant = from_rational<R>(cross(map_.first, map_.second));
    return {.point = whole.point,
            .tangent_s = along(map_.first),
            .tangent_t = along(map_.second),
            .area_normal = determinant * whole.area_normal};
  }
  Chord<R> chord(const ParameterPoint<R>& p, const ParameterPoint<R>& w) const override {
    return chart_.in<R>().chord(map_(p), map_.linear(w));
  }
  Chord<R> chord_along(const ParameterPoint<R>& p, const ParameterPoint<R>& direction,
                       const R& step) const override {
    return chart_.in<R>().chord_along(map_(p), map_.linear(direction), step);
  }

private:
  Chart chart_;
  AffineMap map_;
};

bool is_in_domain(const Corner& corner, ChartDomain domain) {
  if (corner.s.sign() < 0 || corner.t.sign() < 0) return false;
  if (domain == ChartDomain::unit_triangle) return corner.s + corner.t <= Rational(1);
  return corner.s <= Rational(1) && corner.t <= Rational(1);
}

}  // namespace

Chart restricted_chart(const Chart& chart, const std::array<Corner, 3>& triangle, const std::string& name) {
  for (const Corner& corner : triangle)
    expects(is_in_domain(corner, chart.facts().domain), "a triangle in the domain of the chart",
            named("s", corner.s.to_text()), named("t", corner.t.to_text()));
  expects(chart.facts().singular == SingularLine::none, "a chart without a singular line",
          named("chart", chart.facts().name));
  const AffineMap map{triangle[0], triangle[1] - triangle[0], triangle[2] - triangle[0]};
  expects(cross(map.first, map.second).sign() > 0, "a triangle that runs counterclockwise",
          named("chart", chart.facts().name));
  ChartFacts facts = chart.facts();
  facts.name = name;
  facts.domain = ChartDomain::unit_triangle;
  facts.structure.ruling = std::nullopt;
  return {std::move(facts),
          std::make_shared<RestrictedIn<double>>(chart, map),
          std::make_shared<RestrictedIn<Pack>>(chart, map),
          std::make_shared<RestrictedIn<Mpfr<50>>>(chart, map),
          std::make_shared<RestrictedIn<Ball>>(chart, map),
          std::make_shared<RestrictedIn<ComplexBall>>(chart, map),
          std::make_shared<RestrictedIn<TaylorModel>>(chart, map)};
}

std::vector<Chart> charts_over(const Chart& chart, const PlaneTriangulation& domain) {
  std::vector<Chart> charts;
  for (const VertexTriple& triangle : domain.triangles)
    charts.push_back(restricted_chart(
        chart, {domain.vertices[triangle[0]], domain.vertices[triangle[1]], domain.vertices[triangle[2]]},
        chart.facts().name + "/" + std::to_string(charts.size())));
  return charts;
}

}  // namespace radcert
