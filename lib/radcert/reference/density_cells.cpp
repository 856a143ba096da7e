// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/density_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/expression/batch.h"
#include "radcert/reference/box_value.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/scalar/dual.h"

namespace radcert::reference {
namespace {

const WorkLimit most_halvings("reference/density_cells: halvings", 2000, 0,
                              "how far u is from a polynomial on the cells left goes into the radius");

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr long bits = 64;
constexpr double narrowest = 0x1p-40;  // of a parameter; a cell so narrow is not halved
constexpr double goal = 0x1p-44;       // of Int |u|

/// An interval of one coordinate.
struct Range {
  double low = infinite;
  double high = -infinite;

  void include(const Ball& x) {
    low = std::min(low, x.lower_double());
    high = std::max(high, x.upper_double());
  }
  double middle() const { return low + (high - low) / 2; }
  /// No end is farther from the middle.
  double half() const { return std::nextafter(std::max(high - middle(), middle() - low), infinite); }
};

struct SpaceBox {
  Range x, y, z;
};

/// The ball from one end of an interval, exact there, to the other or a little farther: a root may end at
/// that end.
Ball from_end(const Range& x, bool from_low) {
  if (x.low == x.high) return Ball(x.low);
  int exponent = 0;
  constexpr int digits = 20;  // so few that a ball's radius holds them
  const double mantissa = std::frexp(x.high - x.low, &exponent);
  const double width = std::ldexp(std::ceil(std::ldexp(mantissa, digits)) + 1,
                                  exponent - digits);  // the difference is rounded
  const Ball half = Ball(width / 2);
  return widened(from_low ? Ball(x.low) + half : Ball(x.high) - half, half);
}

/// The complex square about the disk of `growth` times the radius about an interval.
ComplexBall disk_about(const Range& x, double growth) {
  const Ball radius = Ball(growth) * Ball(x.half());
  const Ball across = widened(Ball(0), radius);
  return {Ball(x.middle()) + across, across};
}

BoxValue value_on(const Expression& f, const SpaceBox& box, bool from_low, double growth) {
  const auto of = [&](const Range& x) { return BoxValue(from_end(x, from_low), disk_about(x, growth)); };
  return f.evaluate<BoxValue>({of(box.x), of(box.y), of(box.z)});
}

/// How far f is on a box from a polynomial of degree < 64.
double deviation_on(const Expression& f, const SpaceBox& box) {
  constexpr int degree = 64;
  constexpr double rounding = 1 + 0x1p-40;
  double least = infinite;
  for (const double growth : {2.0, 3.0, 5.0 / 3})
    for (const bool from_low : {true, false}) {
      const BoxValue value = value_on(f, box, from_low, growth);
      if (!value.on_box.is_finite()) continue;
      const double m = value.on_disks.magnitude_bound();
      least = std::min(
          {least, value.on_box.radius(), rounding * m / (std::pow(growth, degree - 1) * (growth - 1))});
      if (least <= 0x1p-60 * abs(value.on_box).upper_double()) return least;
      break;
    }
  return least;
}

/// A box that is nowhere much thinner than it is wide.
SpaceBox fattened(const SpaceBox& box) {
  const double least = 0x1p-10 * std::max({box.x.half(), box.y.half(), box.z.half()});
  const auto fat = [least](const Range& x) -> Range {
    return {std::min(x.low, x.middle() - least), std::max(x.high, x.middle() + least)};
  };
  return {fat(box.x), fat(box.y), fat(box.z)};
}

/// A bound of sum_i |D_i f| off_i on a box: where |f| <= m on disks of `growth` times its radii h_i, |D_i f|
/// is at most m / ((growth - 1) h_i) by Cauchy.
double change_by_disks(const Expression& f, const SpaceBox& box, const Vector<double>& off, double growth) {
  const double m = value_on(f, box, true, growth).on_disks.magnitude_bound();
  const Ball sum =
      Ball(off.x) / Ball(box.x.half()) + Ball(off.y) / Ball(box.y.half()) + Ball(off.z) / Ball(box.z.half());
  const Ball change = Ball(m) * sum / (Ball(growth) - Ball(1));
  return change.is_finite() ? change.upper_double() : infinite;
}

/// The same by an enclosure of the slopes on the box.
double change_by_slopes(const Expression& f, const Variables<Ball>& box, const Vector<double>& off) {
  using Slope = Dual<Ball>;
  const Ball zero(0);
  const Ball one(1);
  const Slope by_xy = f.evaluate<Slope>({Slope(box.x, one, zero), Slope(box.y, zero, one), Slope(box.z)});
  const Slope by_z = f.evaluate<Slope>({Slope(box.x), Slope(box.y), Slope(box.z, one, zero)});
  const Ball change =
      abs(by_xy.by_s) * Ball(off.x) + abs(by_xy.by_t) * Ball(off.y) + abs(by_z.by_s) * Ball(off.z);
  return change.is_finite() ? change.upper_double() : infinite;
}

/// What rounding may do to f on a box whose points are off by `off`: no more than f changes there.
double rounding_on(const Expression& f, const SpaceBox& box, const Vector<double>& off) {
  double least = infinite;
  for (const double growth : {2.0, 3.0, 5.0 / 3})
    least = std::min(least, change_by_disks(f, fattened(box), off, growth));
  for (const bool from_low : {true, false}) {
    const Variables<Ball> balls{from_end(box.x, from_low), from_end(box.y, from_low),
                                from_end(box.z, from_low)};
    const Ball value = f.evaluate<Ball>(balls);
    if (value.is_finite()) least = std::min(least, 2 * value.radius());
    least = std::min(least, change_by_slopes(f, balls, off));
  }
  return least;
}

void include(SpaceBox& box, const Vector<Ball>& q) {
  box.x.include(q.x);
  box.y.include(q.y);
  box.z.include(q.z);
}

/// A box about F(polygon): about the corners of a plane one, else about the images of rectangles of
/// parameters.
SpaceBox box_about(const Chart& chart, const Polygon& polygon) {
  const ChartIn<Ball>& formula = chart.in<Ball>();
  SpaceBox box;
  if (chart.facts().plane) {
    for (std::size_t i = 0; i < polygon.count; ++i)
      include(box, formula.frame({Ball(polygon[i].s), Ball(polygon[i].t)}).point);
    return box;
  }
  Range s;
  Range t;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    s.include(Ball(polygon[i].s));
    t.include(Ball(polygon[i].t));
  }
  const int parts = std::max(s.high - s.low, t.high - t.low) > 0.125 ? 4 : 2;  // a wide one loses more
  const auto part = [parts](const Range& x, int i) -> Range {
    const double step = (x.high - x.low) / parts;
    return {i == 0 ? x.low : x.low + i * step, i + 1 == parts ? x.high : x.low + (i + 1) * step};
  };
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      const Range of_s = part(s, i);
      const Range of_t = part(t, j);
      if (chart.facts().domain == ChartDomain::unit_triangle && of_s.low + of_t.low > 1) continue;
      include(box, formula.frame({from_end(of_s, true), from_end(of_t, true)}).point);
    }
  return box;
}

Parameters middle_of(const Polygon& polygon) {
  Parameters sum{0, 0};
  for (std::size_t i = 0; i < polygon.count; ++i) sum = sum + polygon[i];
  return (1 / static_cast<double>(polygon.count)) * sum;
}

double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.count; ++i)
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return std::abs(twice) / 2;
}

/// A cell at work.
struct Open {
  DensityCell cell;
  double share = 0;     // deviation times area
  double integral = 0;  // of |u|, by the value in the middle
  double extent = 0;    // half the diagonal of its box
  bool is_final = false;
};

/// Infinite shares first, then the larger ones; the wider of two that are alike.
bool is_less_urgent(const Open& a, const Open& b) {
  return std::tuple(!a.is_final, a.share, a.extent) < std::tuple(!b.is_final, b.share, b.extent);
}

/// The cells of one density.
class Cells {
public:
  Cells(const Surface& surface, std::span<const Expression> formulas)
      : surface_(surface), formulas_(formulas) {
    for (const Expression& f : formulas) values_.emplace_back(f);
  }

  std::vector<DensityCell> found() && {
    for (std::size_t chart = 0; chart < surface_.chart_count(); ++chart)
      put(opened(chart, whole_domain(surface_.charts[chart].facts().domain), true));
    const std::size_t most = most_halvings.count();
    for (std::size_t k = 0; k < most && !is_enough(); ++k) {
      std::pop_heap(cells_.begin(), cells_.end(), is_less_urgent);
      const Open cell = std::move(cells_.back());
      cells_.pop_back();
      for (Open& part : halved(cell)) put(std::move(part));
    }
    std::sort(cells_.begin(), cells_.end(), [](const Open& a, const Open& b) {
      const auto place = [](const Open& x) {
        return std::tuple(x.cell.chart, x.cell.polygon[0].s, x.cell.polygon[0].t, x.cell.polygon[1].s,
                          x.cell.polygon[1].t);
      };
      return place(a) < place(b);
    });
    std::vector<DensityCell> result;
    result.reserve(cells_.size());
    for (const Open& open : cells_) result.push_back(open.cell);
    for (std::size_t first = 0; first < result.size();) {
      std::size_t end = first;
      while (end < result.size() && result[end].chart == result[first].chart) ++end;
      set_rounding(std::span(result).subspan(first, end - first));
      first = end;
    }
    return result;
  }

private:
  /// Sets `rounding` of all cells of one chart, whose points are off by eight roundings of the largest
  /// coordinate.
  void set_rounding(std::span<DensityCell> cells) const {
    const Expression& f = formulas_[cells.front().chart];
    if (f.is_constant()) return;
    Vector<double> off;
    const auto include = [](double& largest, double centre, double half) {
      if (std::isfinite(half)) largest = std::max(largest, 0x1p-50 * (std::abs(centre) + half));
    };
    for (const DensityCell& cell : cells) {
      include(off.x, cell.centre.x, cell.half.x);
      include(off.y, cell.centre.y, cell.half.y);
      include(off.z, cell.centre.z, cell.half.z);
    }
    for (DensityCell& cell : cells)
      if (!surface_.charts[cell.chart].is_known_in_balls())
        cell.rounding = infinite;
      else if (std::isfinite(cell.deviation))
        cell.rounding = rounding_on(f, box_about(surface_.charts[cell.chart], cell.polygon), off);
  }

  Open opened(std::size_t index, const Polygon& polygon, bool is_whole) const {
    const Chart& chart = surface_.charts[index];
    const Expression& f = formulas_[index];
    Open open{.cell = {.chart = index, .polygon = polygon, .is_whole = is_whole}};
    const Parameters middle = middle_of(polygon);
    const Frame<double> frame = chart.in<double>().frame(middle);
    double stretch = area_element(frame);
    if (!chart.facts().plane)
      for (std::size_t i = 0; i < polygon.count; ++i)
        stretch = std::max(stretch, area_element(chart.in<double>().frame(polygon[i])));
    open.cell.area = stretch * area_of(polygon);
    const double value = values_[index].at(frame.point.x, frame.point.y, frame.point.z);
    if (std::isfinite(value)) open.integral = std::abs(value) * open.cell.area;
    if (f.is_constant()) {
      open.is_final = true;
      return open;
    }
    open.cell.deviation = infinite;
    open.cell.centre = frame.point;
    open.cell.half = {infinite, infinite, infinite};
    if (chart.is_known_in_balls()) {
      const SpaceBox box = box_about(chart, polygon);
      open.cell.centre = {box.x.middle(), box.y.middle(), box.z.middle()};
      open.cell.half = {box.x.half(), box.y.half(), box.z.half()};
      open.extent = norm(open.cell.half);
      if (std::isfinite(open.extent)) open.cell.deviation = deviation_on(f, box);
    } else {
      open.is_final = true;
    }
    open.share = open.cell.deviation == 0 ? 0 : open.cell.deviation * open.cell.area;
    if (open.share == 0) open.is_final = true;
    return open;
  }

  /// Two halves of a cell, and what they leave.
  struct Halves {
    std::vector<Open> parts;
    int without_bound = 0;
    double share = 0;   // of those with a bound
    double extent = 0;  // of the larger one, in space
  };

  Halves halves(const DensityCell& cell, const Parameters& normal) const {
    Range along;
    for (std::size_t i = 0; i < cell.polygon.count; ++i) {
      const double here = normal.s * cell.polygon[i].s + normal.t * cell.polygon[i].t;
      along.low = std::min(along.low, here);
      along.high = std::max(along.high, here);
    }
    Halves result;
    if (along.high - along.low < narrowest) return result;
    for (const double side : {1.0, -1.0}) {
      const Polygon part = clipped(cell.polygon, normal, along.middle(), side);
      if (part.count == 0) return {};
      result.parts.push_back(opened(cell.chart, part, false));
      const Open& half = result.parts.back();
      if (std::isfinite(half.share)) {
        result.share += half.share;
      } else {
        ++result.without_bound;
      }
      result.extent = std::max(result.extent, half.extent);
    }
    return result;
  }

  /// The halves of least extent, or those that leave far less: towards a line on which u is not analytic
  /// cells become thin. The cell itself, if it is too narrow.
  std::vector<Open> halved(const Open& cell) const {
    const auto is_rounder = [](const Halves& a, const Halves& b) {
      return std::tuple(a.extent, a.without_bound, a.share) < std::tuple(b.extent, b.without_bound, b.share);
    };
    const auto leaves_less = [](const Halves& a, const Halves& b) {
      return std::tuple(a.without_bound, a.share, a.extent) < std::tuple(b.without_bound, b.share, b.extent);
    };
    Halves round;
    Halves least;
    for (const Parameters& normal :
         {Parameters{1, 0}, Parameters{0, 1}, Parameters{1, 1}, Parameters{1, -1}}) {
      const Halves found = halves(cell.cell, normal);
      if (found.parts.empty()) continue;
      if (round.parts.empty() || is_rounder(found, round)) round = found;
      if (least.parts.empty() || leaves_less(found, least)) least = found;
    }
    if (round.parts.empty()) {
      Open last = cell;
      last.is_final = true;
      return {last};
    }
    constexpr double far_less = 0.6;  // r^b leaves 2^-(1+b)
    const bool is_worth_it =
        least.without_bound < round.without_bound ||
        (least.without_bound == round.without_bound && least.share < far_less * round.share);
    return is_worth_it ? least.parts : round.parts;
  }

  void put(Open open) {
    cells_.push_back(std::move(open));
    std::push_heap(cells_.begin(), cells_.end(), is_less_urgent);
  }

  bool is_enough() const {
    if (cells_.front().is_final) return true;
    double share = 0;
    double integral = 0;
    for (const Open& open : cells_) {
      share += open.share;
      integral += open.integral;
    }
    return share <= goal * integral;
  }

  const Surface& surface_;
  std::span<const Expression> formulas_;
  std::vector<CompiledExpression> values_;
  std::vector<Open> cells_;
};

}  // namespace

std::vector<DensityCell> density_cells(const Surface& surface, std::span<const Expression> formulas) {
  expects(formulas.size() == surface.chart_count(), "a formula for each chart",
          named("formulas", formulas.size()));
  const BallPrecision precision(bits);
  return Cells(surface, formulas).found();
}

double deviation_at(const DensityCell& cell, const Vector<double>& p) {
  const auto beyond = [](double x, double half) { return std::max(std::abs(x) - half, 0.0); };
  const Vector<double> d = p - cell.centre;
  const double distance =
      norm(Vector<double>{beyond(d.x, cell.half.x), beyond(d.y, cell.half.y), beyond(d.z, cell.half.z)});
  const double most = distance > 0 ? std::min(pi<double>(), cell.area / (distance * distance)) : pi<double>();
  return (2 * cell.deviation + cell.rounding) * most;
}

}  // namespace radcert::reference
