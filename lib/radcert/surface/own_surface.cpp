// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/own_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/catalogue/rectangle.h"

namespace radcert {
namespace {

using Parameters = ParameterPoint<double>;

constexpr double unit = 0x1p-53;

std::string place_text(const Parameters& at) { return "(" + shortest(at.s) + ", " + shortest(at.t) + ")"; }

bool is_finite(const Vector<double>& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

double largest(const Vector<double>& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

[[noreturn]] void refuse_not_finite(const std::string& pointer, const Parameters& at) {
  throw InputError({.pointer = pointer,
                    .problem = "is not finite at (s, t) = " + place_text(at),
                    .allowed = "finite numbers on the whole unit square, its sides and corners too"});
}

std::vector<Vector<double>> values_of(const OwnMap& map, const std::vector<Parameters>& at) {
  std::vector<Vector<double>> values(at.size());
  map.points(at, values);
  for (std::size_t i = 0; i < at.size(); ++i)
    if (!is_finite(values[i])) refuse_not_finite("/map", at[i]);
  return values;
}

/// Points that lie evenly on the square, and off every grid of Chebyshev's.
std::vector<Parameters> points_between() {
  constexpr int count = 101;
  constexpr double plastic = 1.32471795724474602596;
  std::vector<Parameters> points;
  for (int i = 1; i <= count; ++i) {
    const double s = i / plastic;
    const double t = i / (plastic * plastic);
    points.push_back({s - std::floor(s), t - std::floor(t)});
  }
  return points;
}

/// How large an image is, and how far from the origin.
struct Size {
  double extent = 0;
  double farthest = 0;
};

Size size_of(const std::vector<Vector<double>>& points) {
  Vector<double> low = points.front();
  Vector<double> high = points.front();
  Size size;
  for (const Vector<double>& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    size.farthest = std::max(size.farthest, largest(p));
  }
  size.extent = norm(high - low);
  return size;
}

/// The extreme points (1 - cos(pi i / n)) / 2 of T_n, both ends exact.
std::vector<double> extreme_points(int n) {
  std::vector<double> points;
  for (int i = 0; i <= n; ++i) {
    const double half = std::sin(std::numbers::pi * i / (2 * n));
    points.push_back(i == n ? 1.0 : half * half);
  }
  return points;
}

/// The coefficients of the polynomial that has the given values on the extreme points, in their order.
/// Maths     c_j = (2/n) sum''_i f_i T_j(x_i), the first and the last term and coefficient halved
std::vector<Vector<double>> coefficients_of(const std::vector<Vector<double>>& values) {
  const int n = static_cast<int>(values.size()) - 1;
  const auto halved_at_ends = [n](int i) { return i == 0 || i == n ? 0.5 : 1.0; };
  std::vector<Vector<double>> out;
  for (int j = 0; j <= n; ++j) {
    Vector<double> sum{};
    for (int i = 0; i <= n; ++i) {
      // T_j(2x - 1) = cos(j (pi - pi i / n)); the whole turns are taken off exactly.
      const int turn = (j * (n - i)) % (2 * n);
      sum = sum +
            halved_at_ends(i) * std::cos(std::numbers::pi * turn / n) * values[static_cast<std::size_t>(i)];
    }
    out.push_back(halved_at_ends(j) * 2 / n * sum);
  }
  return out;
}

/// Row k has the coefficients of T_j(2s-1) T_k(2t-1).
ChebyshevRows interpolant_on_grid(const OwnMap& map, int n, Size& size) {
  const std::vector<double> x = extreme_points(n);
  std::vector<Parameters> grid;
  for (const double t : x)
    for (const double s : x) grid.push_back({s, t});
  const std::vector<Vector<double>> values = values_of(map, grid);
  size = size_of(values);
  const std::size_t side = x.size();
  ChebyshevRows in_s;
  for (std::size_t k = 0; k < side; ++k) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(k * side);
    in_s.push_back(coefficients_of({from, from + static_cast<std::ptrdiff_t>(side)}));
  }
  ChebyshevRows rows(side, std::vector<Vector<double>>(side));
  for (std::size_t j = 0; j < side; ++j) {
    std::vector<Vector<double>> column;
    for (std::size_t k = 0; k < side; ++k) column.push_back(in_s[k][j]);
    column = coefficients_of(column);
    for (std::size_t k = 0; k < side; ++k) rows[k][j] = column[k];
  }
  return rows;
}

/// The largest coefficient with one of the two largest indices.
double last_coefficients(const ChebyshevRows& rows) {
  const std::size_t n = rows.size();
  double most = 0;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      if (k + 2 >= n || j + 2 >= n) most = std::max(most, largest(rows[k][j]));
  return most;
}

/// Leaves out coefficients in the noise, and what is zero beyond the last that is not.
ChebyshevRows without_noise(ChebyshevRows rows, double noise) {
  for (std::vector<Vector<double>>& row : rows) {
    for (Vector<double>& c : row)
      for (double* x : {&c.x, &c.y, &c.z})
        if (std::abs(*x) <= noise) *x = 0;
    while (row.size() > 1 && largest(row.back()) == 0) row.pop_back();
  }
  while (rows.size() > 2 && rows.back().size() == 1 && largest(rows.back().front()) == 0) rows.pop_back();
  std::size_t longest = 2;
  for (const std::vector<Vector<double>>& row : rows) longest = std::max(longest, row.size());
  rows.front().resize(longest);  // by which it is known how many polynomials there are
  return rows;
}

struct Difference {
  double most = 0;
  Parameters at{0, 0};
};

Difference difference(const ChebyshevRows& rows, const std::vector<Parameters>& at,
                      const std::vector<Vector<double>>& values) {
  const ChebyshevMap<double> map(std::make_shared<const ChebyshevRows>(rows));
  Difference found;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double here = norm(map(at[i].s, at[i].t) - values[i]);
    if (here > found.most) found = {here, at[i]};
  }
  return found;
}

/// What the map's own tangents and those of the interpolant differ by, relative to the extent.
double tangents_held_against(const OwnMap& map, const ChebyshevRows& rows, double extent) {
  std::vector<Parameters> at = points_between();
  for (const double s : {0.0, 1.0})
    for (const double t : {0.0, 1.0}) at.push_back({s, t});
  std::vector<std::array<Vector<double>, 2>> tangents(at.size());
  map.tangents(at, tangents);
  const ChartOf<double, ChebyshevMap<double>> interpolant(
      ChebyshevMap<double>(std::make_shared<const ChebyshevRows>(rows)),
      Orientation::along_the_cross_product);
  constexpr double allowed = 1e-6;
  double most = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (const Vector<double>& tangent : tangents[i])
      if (!is_finite(tangent)) refuse_not_finite("/jacobian", at[i]);
    const Frame<double> frame = interpolant.frame(at[i]);
    const double off =
        std::max(norm(tangents[i][0] - frame.tangent_s), norm(tangents[i][1] - frame.tangent_t)) / extent;
    if (off > allowed)
      throw InputError({.pointer = "/jacobian",
                        .problem = "is no derivative of the map at (s, t) = " + place_text(at[i]) +
                                   ": off by " + nearest_text(off * extent, DecimalForm::general(3)),
                        .allowed = "D_s F and D_t F, within 1e-6 of the extent of the image"});
    most = std::max(most, off);
  }
  return most;
}

}  // namespace

std::array<int, 2> OwnChart::degrees() const {
  return {static_cast<int>(rows->front().size()) - 1, static_cast<int>(rows->size()) - 1};
}

OwnChart interpolated_map(std::string name, std::string piece, const OwnMap& map) {
  expects(!name.empty() && !piece.empty() && map.points != nullptr, "a name, a piece and a map");
  const std::vector<Parameters> between = points_between();
  const std::vector<Vector<double>> values = values_of(map, between);
  constexpr double wanted = 1e-13;
  Difference off;
  for (int n = 8; n <= ChebyshevMap<double>::largest_degree; n *= 2) {
    Size size;
    const ChebyshevRows rows = interpolant_on_grid(map, n, size);
    if (size.extent == 0)
      throw InputError({.pointer = "/map", .problem = "has one value", .allowed = "a chart of a surface"});
    const double rounding = 4 * unit * (size.extent + size.farthest);
    const double tolerance = wanted * size.extent + 8 * rounding;
    ChebyshevRows kept = without_noise(rows, rounding);
    off = difference(kept, between, values);
    off.most /= size.extent;
    const bool fits = last_coefficients(rows) <= tolerance && off.most * size.extent <= tolerance;
    if (!fits || !std::isfinite(tolerance * size.extent)) continue;
    OwnChart chart{.name = std::move(name), .piece = std::move(piece), .rows = nullptr, .residual = off.most};
    if (map.tangents) chart.tangent_residual = tangents_held_against(map, kept, size.extent);
    chart.rows = std::make_shared<const ChebyshevRows>(std::move(kept));
    return chart;
  }
  throw InputError(
      {.pointer = "/map",
       .problem = "is not smooth enough: interpolated by polynomials of degree 64 it is off by " +
                  nearest_text(off.most, DecimalForm::general(3)) +
                  " of its extent, at (s, t) = " + place_text(off.at),
       .allowed = "a map that is analytic on the closed unit square; cut it where it is not"});
}

namespace {

constexpr int points_a_side = 11;

[[noreturn]] void refuse_chart(std::size_t chart, const std::string& name, const std::string& problem,
                               const std::string& allowed) {
  throw InputError(
      {.pointer = "/charts/" + std::to_string(chart), .value = name, .problem = problem, .allowed = allowed});
}

/// A chart at a grid of points, its normals D_s F x D_t F for now.
struct Sampled {
  std::vector<Parameters> at;
  std::vector<Frame<double>> frames;
};

Sampled sampled(const OwnChart& chart) {
  const ChartOf<double, ChebyshevMap<double>> formula(ChebyshevMap<double>(chart.rows),
                                                      Orientation::along_the_cross_product);
  Sampled out;
  for (int j = 0; j < points_a_side; ++j)
    for (int i = 0; i < points_a_side; ++i) {
      const Parameters at{static_cast<double>(i) / (points_a_side - 1),
                          static_cast<double>(j) / (points_a_side - 1)};
      out.at.push_back(at);
      out.frames.push_back(formula.frame(at));
    }
  return out;
}

/// Both tangents are there at each point, and do not fall together.
void require_normals(std::size_t number, const OwnChart& chart, const Sampled& points) {
  double longest = 0;
  for (const Frame<double>& frame : points.frames)
    longest = std::max({longest, norm(frame.tangent_s), norm(frame.tangent_t)});
  for (std::size_t i = 0; i < points.at.size(); ++i)
    if (!(norm(points.frames[i].area_normal) > 1e-6 * longest * longest))
      refuse_chart(number, chart.name, "has no normal at (s, t) = " + place_text(points.at[i]),
                   "charts whose tangents D_s F and D_t F are independent up to the corners");
}

/// The side of a chart's tangent planes on which all points lie.
Orientation side_of_the_light(std::size_t number, const OwnChart& chart, const Sampled& points,
                              const std::vector<Vector<double>>& all, double tolerance) {
  struct Side {
    double farthest = 0;
    Parameters at{0, 0};
  };
  Side before;
  Side behind;
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    const Frame<double>& frame = points.frames[i];
    const Vector<double> normal = unit_normal(frame);
    for (const Vector<double>& q : all) {
      const double height = dot(q - frame.point, normal);
      if (height > before.farthest) before = {height, points.at[i]};
      if (-height > behind.farthest) behind = {-height, points.at[i]};
    }
  }
  const Side& less = before.farthest < behind.farthest ? before : behind;
  if (less.farthest > tolerance)
    refuse_chart(
        number, chart.name,
        "has points of the surface on both sides of its tangent plane at (s, t) = " + place_text(less.at) +
            ", the nearer side " + nearest_text(less.farthest, DecimalForm::general(3)) + " away",
        "charts in the boundary of a convex body, on which nothing hides anything; else a mesh");
  return before.farthest < behind.farthest ? Orientation::against_the_cross_product
                                           : Orientation::along_the_cross_product;
}

/// One side of the square of a chart, as points in its order, and the unit normals there.
struct ChartSide {
  std::size_t chart = 0;
  std::vector<Vector<double>> points;
  std::vector<Vector<double>> normals;
  bool is_met = false;
};

std::vector<ChartSide> sides_of(std::size_t chart, const Sampled& points, double sign) {
  std::vector<ChartSide> sides(4, {.chart = chart, .points = {}, .normals = {}});
  constexpr int last = points_a_side - 1;
  for (int i = 0; i <= last; ++i) {
    const std::array<int, 4> places{i, i + last * points_a_side, i * points_a_side, i * points_a_side + last};
    for (std::size_t side = 0; side < 4; ++side) {
      const Frame<double>& frame = points.frames[static_cast<std::size_t>(places.at(side))];
      sides[side].points.push_back(frame.point);
      sides[side].normals.push_back(sign * unit_normal(frame));
    }
  }
  return sides;
}

/// Whether two sides have the same points, in either order.
std::optional<bool> are_one(const ChartSide& a, const ChartSide& b, double tolerance) {
  for (const bool turned : {false, true}) {
    bool same = true;
    for (std::size_t i = 0; same && i < a.points.size(); ++i)
      same = norm(a.points[i] - b.points[turned ? a.points.size() - 1 - i : i]) <= tolerance;
    if (same) return turned;
  }
  return std::nullopt;
}

/// Marks the sides that are one of another. InputError where charts of a piece meet there at an angle.
void join(std::vector<ChartSide>& sides, std::span<const OwnChart> charts, double tolerance) {
  constexpr double most = 1e-6;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const std::optional<bool> turned = are_one(sides[i], sides[j], tolerance);
      if (!turned) continue;
      sides[i].is_met = sides[j].is_met = true;
      const std::size_t a = sides[i].chart;
      const std::size_t b = sides[j].chart;
      if (charts[a].piece != charts[b].piece) continue;
      const std::size_t last = sides[i].points.size() - 1;
      for (std::size_t k = 0; k <= last; ++k)
        if (norm(sides[i].normals[k] - sides[j].normals[*turned ? last - k : k]) > most)
          refuse_chart(b, charts[b].name,
                       "meets " + charts[a].name + " at an angle, in one piece, " + charts[a].piece,
                       "pieces of their own, or one normal along the common side");
    }
}

/// The chart itself; an affine one knows its plane, in which G vanishes.
Chart chart_of(const OwnChart& own, Orientation orientation) {
  ChartFacts facts{.name = own.name, .piece = own.piece, .orientation = orientation};
  const ChebyshevRows& rows = *own.rows;
  const bool is_affine = rows.size() == 2 && rows[0].size() == 2 && rows[1].size() == 1;
  if (is_affine) {
    const auto exact = [](const Vector<double>& p) {
      return Vector<Rational>{Rational::exactly(p.x), Rational::exactly(p.y), Rational::exactly(p.z)};
    };
    const Vector<Rational> first = Rational(2) * exact(rows[0][1]);
    const Vector<Rational> second = Rational(2) * exact(rows[1][0]);
    const Vector<Rational> origin = exact(rows[0][0]) - exact(rows[0][1]) - exact(rows[1][0]);
    facts.plane = Plane(origin, first, second);
    return {facts,
            std::make_shared<ChartOf<double, Rectangle<double>>>(Rectangle<double>(origin, first, second),
                                                                 orientation),
            std::make_shared<ChartOf<Pack, Rectangle<Pack>>>(Rectangle<Pack>(origin, first, second),
                                                             orientation)};
  }
  return {
      facts,
      std::make_shared<ChartOf<double, ChebyshevMap<double>>>(ChebyshevMap<double>(own.rows), orientation),
      std::make_shared<ChartOf<Pack, ChebyshevMap<Pack>>>(ChebyshevMap<Pack>(own.rows), orientation)};
}

}  // namespace

Surface own_surface(const std::string& name, std::span<const OwnChart> charts) {
  constexpr std::size_t most_charts = 256;
  if (charts.empty() || charts.size() > most_charts)
    throw InputError(
        {.pointer = "/charts", .value = std::to_string(charts.size()), .allowed = "1 to 256 charts"});
  std::set<std::string> names;
  std::vector<Sampled> points;
  std::vector<Vector<double>> all;
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (!names.insert(charts[k].name).second)
      refuse_chart(k, charts[k].name, "is the name of two charts", "a name for each");
    points.push_back(sampled(charts[k]));
    require_normals(k, charts[k], points.back());
    for (const Frame<double>& frame : points.back().frames) all.push_back(frame.point);
  }
  const Size size = size_of(all);
  const double tolerance = 1e-12 * size.extent + 64 * unit * size.farthest;
  Surface surface;
  surface.name = name;
  std::vector<ChartSide> sides;
  for (std::size_t k = 0; k < charts.size(); ++k) {
    const Orientation orientation = side_of_the_light(k, charts[k], points[k], all, tolerance);
    surface.charts.push_back(chart_of(charts[k], orientation));
    const double sign = orientation == Orientation::along_the_cross_product ? 1 : -1;
    for (ChartSide& side : sides_of(k, points[k], sign)) sides.push_back(std::move(side));
  }
  join(sides, charts, tolerance);
  surface.diagonals.assign(charts.size(), Diagonal::main);
  surface.closed = std::all_of(sides.begin(), sides.end(), [](const ChartSide& side) { return side.is_met; });
  surface.unoccluded = true;
  surface.pieces_meet_at_angle = surface.piece_names().size() > 1;
  return surface;
}

bool is_known_in_balls(const Surface& surface) {
  return std::all_of(surface.charts.begin(), surface.charts.end(),
                     [](const Chart& chart) { return chart.is_known_in_balls(); });
}

}  // namespace radcert
