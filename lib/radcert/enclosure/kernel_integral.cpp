// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/kernel_integral.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/kernel/geometric_kernel.h"

namespace radcert {

namespace {

template <class R>
Vector<R> taken_into(const Vector<Ball>& v) {
  return {R(v.x), R(v.y), R(v.z)};
}

/// The integrand over one piece of a chart in one arithmetic.
template <Real R>
struct Integrand {
  const Chart* chart;
  std::size_t index;
  SquareMapIn<R> map;
  Vector<R> position;
  Vector<R> normal;
  bool from_the_observer;  ///< the apex is P
  std::function<R(const DensityPoint<R>&)> q;

  R operator()(const R& x, const R& y) const {
    const ChartIn<R>& formula = chart->in<R>();
    const ParameterPoint<R> at = map.point(x, y);
    const Frame<R> frame = formula.frame(at);
    const R kernel = from_the_observer ? chord_kernel(formula.chord_along(map.apex, map.direction(y), x),
                                                      normal, frame.area_normal)
                                       : geometric_kernel(position, normal, frame.point, frame.area_normal);
    return map.jacobian(x) * kernel * q({.chart = index, .at = at, .point = frame.point});
  }
};

double distance(const Vector<double>& a, const Vector<double>& b) { return norm(a - b); }

ParameterPoint<double> to_double(const ParameterPoint<Rational>& p) {
  return {p.s.to_double(), p.t.to_double()};
}

/// A point of the polygon near to P, if P is near to the chart compared with the polygon's size. It chooses
/// the cells and enters no value.
std::optional<ParameterPoint<Rational>> near_point(const Chart& chart, const ParameterPolygon& polygon,
                                                   const Vector<double>& p) {
  const ChartIn<double>& formula = chart.in<double>();
  const auto image = [&](const ParameterPoint<double>& at) { return formula.frame(at).point; };
  std::vector<ParameterPoint<double>> corners;
  for (const ParameterPoint<Rational>& corner : polygon) corners.push_back(to_double(corner));
  double size = 0;
  for (const ParameterPoint<double>& a : corners)
    size = std::max(size, distance(image(a), image(corners[0])));

  // Triangle by triangle, over a grid and then by steps that halve; (a, b) in the unit square squeezed onto
  // the triangle.
  ParameterPoint<double> best = corners[0];
  double least = HUGE_VAL;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const auto at = [&](double a, double b) {
      return corners[0] + a * ((corners[k] - corners[0]) + b * (corners[k + 1] - corners[k]));
    };
    double a = 0;
    double b = 0;
    double here = HUGE_VAL;
    const auto consider = [&](double other_a, double other_b) {
      const double d = distance(image(at(other_a, other_b)), p);
      if (!(d < here)) return false;
      here = d;
      a = other_a;
      b = other_b;
      return true;
    };
    constexpr int grid = 16;
    for (int i = 0; i <= grid; ++i)
      for (int j = 0; j <= grid; ++j) consider(static_cast<double>(i) / grid, static_cast<double>(j) / grid);
    for (double step = 1.0 / grid; step > 0x1p-30;) {
      bool better = false;
      for (const double da : {-step, 0.0, step})
        for (const double db : {-step, 0.0, step})
          better = consider(std::clamp(a + da, 0.0, 1.0), std::clamp(b + db, 0.0, 1.0)) || better;
      if (!better) step /= 2;
    }
    if (here < least) {
      least = here;
      best = at(a, b);
    }
  }
  constexpr double near = 0.75;
  if (least > near * size) return std::nullopt;
  // Onto a coarse lattice, so that corners and sides are hit and the numbers stay short.
  const auto rounded = [](double x) {
    return Rational::exactly(std::ldexp(std::nearbyint(std::ldexp(x, 24)), -24));
  };
  const ParameterPoint<Rational> apex{rounded(best.s), rounded(best.t)};
  if (!contains(polygon, apex)) return std::nullopt;
  return apex;
}

/// The part of a convex polygon on one side of the line s = c; empty if it has no area.
ParameterPolygon part_of(const ParameterPolygon& polygon, const Rational& c, bool beyond) {
  ParameterPolygon part;
  const auto inside = [&](const ParameterPoint<Rational>& p) { return beyond ? p.s >= c : p.s <= c; };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ParameterPoint<Rational>& here = polygon[k];
    const ParameterPoint<Rational>& next = polygon[(k + 1) % polygon.size()];
    if (inside(here)) part.push_back(here);
    if ((here.s - c).sign() * (next.s - c).sign() < 0) {
      part.push_back(here + ((c - here.s) / (next.s - here.s)) * (next - here));
    }
  }
  const bool has_area = std::any_of(part.begin(), part.end(), [&](const auto& p) { return p.s != c; });
  return has_area ? part : ParameterPolygon{};
}

bool touches_s_zero(const ParameterPolygon& polygon) {
  return std::any_of(polygon.begin(), polygon.end(), [](const auto& p) { return p.s.sign() <= 0; });
}

/// The functions on squares that an integral is the sum of, or why it has none.
class Parts {
public:
  Parts(const ExactObserver& observer, const Surface& surface, const DensityFormula& q)
      : observer_(observer),
        surface_(surface),
        q_(q),
        position_(observer.position(surface)),
        normal_(observer.normal(surface)) {}

  void add(std::size_t index, const ParameterPolygon& polygon) {
    expects(index < surface_.chart_count(), "a chart of the surface", named("chart", index));
    const Chart& chart = surface_.charts[index];
    const std::optional<ParameterPoint<Rational>> own = observer_.on_chart(index);
    if (own) {
      expects(contains(domain_polygon(chart), *own), "a name of P in the domain of its chart",
              named("s", own->s), named("t", own->t));
    }
    if (observer_.in_plane_of(surface_, index)) return;
    const bool singular = chart.facts().singular == SingularLine::s_zero && touches_s_zero(polygon);
    if (!own || !contains(polygon, *own)) {
      add_maps(index, singular ? square_maps(polygon) : around_near_point(chart, polygon), false);
    } else if (!singular) {
      add_maps(index, fan(polygon, *own), true);
    } else if (own->s.sign() == 0) {
      refusal_ = "P lies on the line s = 0, where the chart " + chart.facts().name + " is not analytic";
    } else {
      // The chord is analytic in a neighbourhood of P; up to the line the kernel itself will do.
      const Rational middle = own->s / 2;
      add_maps(index, fan(part_of(polygon, middle, true), *own), true);
      add_maps(index, square_maps(part_of(polygon, middle, false)), false);
    }
  }

  Enclosure integral(const Demand& demand) const {
    if (!refusal_.empty()) {
      return because(Undecided{.why = refusal_, .reached = Ball::failed("an integral that was not tried")});
    }
    return integral_over_squares(functions_, demand);
  }

private:
  std::vector<SquareMap> around_near_point(const Chart& chart, const ParameterPolygon& polygon) const {
    const Vector<double> p{position_.x.to_double(), position_.y.to_double(), position_.z.to_double()};
    const std::optional<ParameterPoint<Rational>> apex = near_point(chart, polygon, p);
    return apex ? fan(polygon, *apex) : square_maps(polygon);
  }

  void add_maps(std::size_t index, const std::vector<SquareMap>& maps, bool from_the_observer) {
    const Chart* chart = &surface_.charts[index];
    for (const SquareMap& map : maps) {
      functions_.push_back({.in_balls = Integrand<Ball>{chart, index, SquareMapIn<Ball>(map), position_,
                                                        normal_, from_the_observer, q_.in_balls},
                            .in_models = Integrand<TaylorModel>{chart, index, SquareMapIn<TaylorModel>(map),
                                                                taken_into<TaylorModel>(position_),
                                                                taken_into<TaylorModel>(normal_),
                                                                from_the_observer, q_.in_models}});
    }
  }

  const ExactObserver& observer_;
  const Surface& surface_;
  const DensityFormula& q_;
  Vector<Ball> position_;
  Vector<Ball> normal_;
  std::vector<SquareFunction> functions_;
  std::string refusal_;
};

}  // namespace

DensityFormula unit_density() {
  return {.in_balls = [](const DensityPoint<Ball>&) { return Ball(1); },
          .in_models = [](const DensityPoint<TaylorModel>&) { return TaylorModel(1); },
          .in_doubles = [](const DensityPoint<BoundedDouble>&) { return BoundedDouble(1); }};
}

ParameterPolygon domain_polygon(const Chart& chart) {
  if (chart.facts().domain == ChartDomain::unit_triangle) return {{0, 0}, {1, 0}, {0, 1}};
  return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}

Enclosure kernel_integral(const ExactObserver& observer, const Surface& surface, std::size_t chart,
                          const ParameterPolygon& polygon, const DensityFormula& q, const Demand& demand) {
  Parts parts(observer, surface, q);
  parts.add(chart, polygon);
  return parts.integral(demand);
}

Enclosure kernel_integral(const ExactObserver& observer, const Surface& surface, const DensityFormula& q,
                          const Demand& demand) {
  Parts parts(observer, surface, q);
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart) {
    parts.add(chart, domain_polygon(surface.charts[chart]));
  }
  return parts.integral(demand);
}

}  // namespace radcert
