// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/plane_element.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "radcert/closed_form/kernel_moments.h"
#include "radcert/closed_form/kernel_pieces.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/work_limit.h"
#include "radcert/geometry/double_double_vector.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/scalar/mpfr_real.h"

namespace radcert {

namespace {

using Wide = Mpfr<50>;

constexpr double unit = 0x1p-53;
const WorkLimit bits_of_an_element("closed_form/plane_element: bits of a ball", 1L << 14U,
                                   BallPrecision::smallest_bits, "refused: AccuracyNotReached");
const WorkLimit pieces_of_an_element("closed_form/plane_element: pieces of a rule", 200, 0,
                                     "no rule: balls serve");
/// The part of the error allowed that a rule's truncation may take.
constexpr double truncation_part = 0.05;
/// Bounds the length of a normal whose largest part is scaled to [1, 2).
constexpr double normal_reach = 4;
/// A corner's level counts as decided where it exceeds its error that often; otherwise the exact level is at
/// most so many errors.
constexpr double decided_errors = 4;
constexpr double undecided_errors = 5.01;

double largest_part(const std::array<double, 3>& a) {
  return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}

}  // namespace

class PlaneElement::Prepared {
public:
  Prepared(const PlanePolygon& polygon, std::vector<PlanePolynomial<Rational>> functions, double accuracy,
           std::span<const double> sizes);

  [[nodiscard]] std::size_t function_count() const { return functions_.size(); }
  Route integrals(const Vector<double>& p, const Vector<double>& normal, std::span<double> values) const;

private:
  struct Corner {
    DoubleDoubleVector at;
    double x = 0;  ///< about the centre
    double y = 0;
  };
  struct Edge {
    std::size_t start = 0;
    std::size_t end = 0;
    double length = 0;
    double direction_x = 0;
    double direction_y = 0;
    DoubleDoubleVector direction;
    DoubleDoubleVector inward;  ///< in the plane, to the left, unit length
  };
  struct Triangle {
    std::array<std::size_t, 3> corner{};
    double double_area = 0;  ///< signed by the orientation
  };
  struct Function {
    std::vector<double> coefficients;  ///< in x / x_scale and y / y_scale, as PlanePolynomial
        /// For every triangle of the fans: those of the products of degree_ barycentric coordinates, ordered
        /// as in PieceSums.
    std::vector<std::vector<double>> barycentric;
    double size = 0;     ///< largest Bernstein coefficient over all triangles: bounds |q| there
    double maximum = 0;  ///< a lower bound of max |q| over the polygon, or the size that was given
  };
  /// P and its normal as the corners see them.
  struct Eye {
    std::array<double, 3> p{};
    double reach = 0;  ///< three times the sum of the largest coordinates of P and of the corners
    DoubleDoubleVector normal;
    BoundedDouble normal_length;
    BoundedDouble height;
    BoundedDouble normal_z;
    std::vector<DoubleDoubleVector> differences;  ///< P - corner
    std::vector<DoubleDouble> levels;             ///< (corner - P) . n_P, or 0 where its sign is not known
    double level_error = 0;                       ///< of all of them
    double largest_level = 0;
    bool has_undecided = false;
  };

  void add_loops(const PlanePolygon& polygon);
  void add_functions(std::span<const double> sizes);
  [[nodiscard]] double largest_value(const PlanePolynomial<Rational>& q) const;
  void add_barycentric(const PlanePolynomial<Rational>& q, Function& function);

  [[nodiscard]] double hidden_part(const Eye& eye) const;
  [[nodiscard]] std::optional<BoundedDouble> lambert(const Eye& eye) const;
  template <int most>
  bool by_closed_form(const Eye& eye, std::span<double> values) const;
  /// Kept between the calls of a thread.
  struct Scratch {
    Eye eye;
    std::vector<FootEdge<BoundedDouble>> edges;
    std::vector<KernelPiece> left;
    std::vector<KernelPiece> pieces;
    std::vector<long double> results;
  };
  static Scratch& scratch() {
    thread_local Scratch kept;
    return kept;
  }
  /// How far a piece's radius may reach against its distance, and the roundings that are left for what is
  /// wrong with the geometry.
  struct Permitted {
    double ratio = 0;  ///< 0: rules are of no use
    double spare = 0;
  };
  /// What the pieces' geometry is off by; areas over fourth powers of distances.
  struct GeometryErrors {
    double level = 0;     ///< changes Int level / |Q-P|^4 by at most that
    double relative = 0;  ///< changes any summand by at most that part of it
  };
  [[nodiscard]] Permitted permitted(bool whole) const;
  bool cut_into_pieces(const Eye& eye, const Permitted& permitted, std::size_t most,
                       std::vector<KernelPiece>& pieces) const;
  [[nodiscard]] GeometryErrors geometry_errors(const Eye& eye, const std::vector<KernelPiece>& pieces,
                                               double ratio, double over_pieces) const;
  bool by_rule(const Eye& eye, bool whole, std::span<double> values) const;
  Route by_balls(const Vector<double>& p, const Vector<double>& normal, std::span<double> values) const;
  [[nodiscard]] bool foot_is_outside(const Eye& eye, const std::vector<FootEdge<BoundedDouble>>& edges) const;

  PlanePolygon polygon_;
  std::vector<PlanePolynomial<Rational>> exact_functions_;
  double accuracy_;  ///< the error allowed, over Int |G| dS max |q|
  int degree_ = 0;
  std::vector<Corner> corners_;
  std::vector<Edge> edges_;
  std::vector<Triangle> triangles_;  ///< fans over the loops
  std::vector<Function> functions_;
  DoubleDoubleVector axis_x_;
  DoubleDoubleVector axis_y_;
  DoubleDoubleVector axis_z_;
  Vector<Wide> wide_x_;
  Vector<Wide> wide_y_;
  Vector<Wide> wide_centre_;
  DoubleDoubleVector centre_;
  double x_scale_ = 1;
  double y_scale_ = 1;
  Permitted permitted_whole_;  ///< where every triangle is one piece
  Permitted permitted_parts_;
  double amplification_ = 1;  ///< largest Bernstein coefficient over the maximum, over all functions
  std::vector<double> multinomials_;
  double shortest_ = 0;     ///< edge, or the extent across the longest
  double reach_ = 0;        ///< bounds the corners' coordinates
  bool is_convex_ = false;  ///< then the foot is outside if it is to the right of an edge
};

namespace {

Vector<Wide> wide(const Vector<Rational>& a) { return {Wide(a.x), Wide(a.y), Wide(a.z)}; }

double as_double(const Wide& x) { return x.to_double(); }

/// q(at + i u + j v) as a polynomial in (i, j).
PlanePolynomial<Rational> substituted(const PlanePolynomial<Rational>& q, const ParameterPoint<Rational>& at,
                                      const ParameterPoint<Rational>& u, const ParameterPoint<Rational>& v) {
  const int degree = q.degree();
  using Local = PlanePolynomial<Rational>;
  const auto times = [degree](const Local& a, const Rational& constant, const Rational& first,
                              const Rational& second) {
    Local result(degree);
    for (int n = 0; n <= degree; ++n) {
      for (int j = 0; j <= n; ++j) {
        const Rational& c = a(n - j, j);
        if (c.sign() == 0) continue;
        result(n - j, j) += constant * c;
        if (n == degree) continue;
        result(n - j + 1, j) += first * c;
        result(n - j, j + 1) += second * c;
      }
    }
    return result;
  };
  // Horner's rule in s, and in t for every power of s.
  Local sum(degree);
  for (int i = degree; i >= 0; --i) {
    Local inner(degree);
    for (int j = degree - i; j >= 0; --j) {
      inner = times(inner, at.t, u.t, v.t);
      inner(0, 0) += q(i, j);
    }
    sum = times(sum, at.s, u.s, v.s);
    for (int n = 0; n <= degree; ++n) {
      for (int j = 0; j <= n; ++j) sum(n - j, j) += inner(n - j, j);
    }
  }
  return sum;
}

}  // namespace

PlaneElement::Prepared::Prepared(const PlanePolygon& polygon,
                                 std::vector<PlanePolynomial<Rational>> functions, double accuracy,
                                 std::span<const double> sizes)
    : polygon_(polygon), exact_functions_(std::move(functions)), accuracy_(accuracy) {
  expects(accuracy >= usual_accuracy && accuracy <= largest_accuracy, "1e-14 <= accuracy <= 1e-3",
          named("accuracy", accuracy));
  expects(!exact_functions_.empty(), "at least one function");
  expects(sizes.empty() || (sizes.size() == exact_functions_.size() &&
                            std::all_of(sizes.begin(), sizes.end(), [](double size) { return size > 0; })),
          "no sizes, or a positive one a function", named("sizes", sizes.size()));
  for (const PlanePolynomial<Rational>& q : exact_functions_) {
    expects(q.degree() <= largest_degree, "functions of degree at most 8", named("degree", q.degree()));
    degree_ = std::max(degree_, q.degree());
  }
  add_loops(polygon);
  add_functions(sizes);
}

void PlaneElement::Prepared::add_loops(const PlanePolygon& polygon) {
  // x along the longest edge: then a sliver's small moments are those that the recurrences start from.
  Rational longest;
  Vector<Rational> along;
  Vector<Rational> low = polygon.point(polygon.loops()[0][0]);
  Vector<Rational> high = low;
  for (const PolygonLoop& loop : polygon.loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vector<Rational> at = polygon.point(loop[k]);
      const Vector<Rational> edge = polygon.point(loop[(k + 1) % loop.size()]) - at;
      low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
      if (longest < dot(edge, edge)) {
        longest = dot(edge, edge);
        along = edge;
      }
    }
  }
  wide_centre_ = wide(Rational(1, 2) * (low + high));
  centre_ = double_double(wide_centre_);
  const Vector<Rational> plane_normal = polygon.normal();
  const auto normalised = [](const Vector<Rational>& a) {
    return reciprocal(sqrt(Wide(dot(a, a)))) * wide(a);
  };
  wide_x_ = normalised(along);
  const Vector<Wide> wide_z = normalised(plane_normal);
  wide_y_ = normalised(cross(plane_normal, along));
  axis_x_ = double_double(wide_x_);
  axis_y_ = double_double(wide_y_);
  axis_z_ = double_double(wide_z);

  double x_size = 0;
  double y_size = 0;
  for (const PolygonLoop& loop : polygon.loops()) {
    const std::size_t base = corners_.size();
    for (const auto& at : loop) {
      const Vector<Wide> point = wide(polygon.point(at));
      Corner corner;
      corner.at = double_double(point);
      corner.x = as_double(dot(point - wide_centre_, wide_x_));
      corner.y = as_double(dot(point - wide_centre_, wide_y_));
      x_size = std::max(x_size, std::abs(corner.x));
      y_size = std::max(y_size, std::abs(corner.y));

      reach_ = std::max(reach_, largest_part(corner.at.head));
      corners_.push_back(corner);
    }
    for (std::size_t k = 0; k < loop.size(); ++k) {
      Edge edge;
      edge.start = base + k;
      edge.end = base + (k + 1) % loop.size();
      const Vector<Rational> exact = polygon.point(loop[(k + 1) % loop.size()]) - polygon.point(loop[k]);
      const Vector<Wide> direction = normalised(exact);
      edge.length = as_double(sqrt(Wide(dot(exact, exact))));
      shortest_ = edges_.empty() ? edge.length : std::min(shortest_, edge.length);
      edge.direction = double_double(direction);
      edge.direction_x = as_double(dot(direction, wide_x_));
      edge.direction_y = as_double(dot(direction, wide_y_));
      edge.inward = double_double(normalised(cross(plane_normal, exact)));
      edges_.push_back(edge);
    }
    const Wide normal_length = sqrt(Wide(dot(plane_normal, plane_normal)));
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      const Rational part = cross(loop[k] - loop[0], loop[k + 1] - loop[0]);
      triangles_.push_back({{base, base + k, base + k + 1}, as_double(Wide(part) * normal_length)});
    }
  }

  x_scale_ = x_size;
  y_scale_ = y_size;
  shortest_ = std::min({shortest_, x_size, y_size});
  // A simple loop that turns left at every corner.
  is_convex_ = polygon.loops().size() == 1;
  const PolygonLoop& outer = polygon.loops()[0];
  for (std::size_t k = 0; k < outer.size() && is_convex_; ++k) {
    const auto& at = outer[(k + 1) % outer.size()];
    is_convex_ = cross(at - outer[k], outer[(k + 2) % outer.size()] - at).sign() >= 0;
  }
}

/// max |q| over points that lie in the polygon for certain: on its edges, and those of the fans' lattices
/// that lie inside.
double PlaneElement::Prepared::largest_value(const PlanePolynomial<Rational>& q) const {
  Rational largest;
  const auto look = [&](const ParameterPoint<Rational>& at) {
    largest = std::max(largest, abs(q.value(at.s, at.t)));
  };
  const bool triangle = polygon_.loops().size() == 1 && polygon_.loops()[0].size() == 3;
  constexpr int steps = 8;
  for (const PolygonLoop& loop : polygon_.loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto& from = loop[k];
      const auto edge = loop[(k + 1) % loop.size()] - from;
      for (int i = 0; i < steps; ++i) look(from + Rational(i, steps) * edge);
    }
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      for (int i = 1; i < steps; ++i) {
        for (int j = 1; i + j < steps; ++j) {
          const ParameterPoint<Rational> at = loop[0] + Rational(i, steps) * (loop[k] - loop[0]) +
                                              Rational(j, steps) * (loop[k + 1] - loop[0]);
          bool inside = triangle;
          if (!triangle) {
            int winding = 0;
            for (const PolygonLoop& around : polygon_.loops()) {
              for (std::size_t n = 0; n < around.size(); ++n) {
                const auto a = around[n] - at;
                const auto b = around[(n + 1) % around.size()] - at;
                const int side = cross(a, b).sign();
                if (a.t.sign() <= 0 && b.t.sign() > 0 && side > 0) ++winding;
                if (a.t.sign() > 0 && b.t.sign() <= 0 && side < 0) --winding;
              }
            }
            inside = winding != 0;
          }
          if (inside) look(at);
        }
      }
    }
  }
  // The nearest double may lie above.
  return largest.to_double() * (1 - 4 * unit);
}

void PlaneElement::Prepared::add_functions(std::span<const double> sizes) {
  // s = s_c + s_x X + s_y Y with X = x / x_scale, and so t: by the dual frame of the plane.
  const Vector<Rational> plane_normal = polygon_.normal();
  const Rational squared = dot(plane_normal, plane_normal);
  const Vector<Wide> dual_s = wide((Rational(1) / squared) * cross(polygon_.second(), plane_normal));
  const Vector<Wide> dual_t = wide((Rational(1) / squared) * cross(plane_normal, polygon_.first()));
  const auto affine = [&](const Vector<Wide>& dual) {
    return std::array{dot(dual, wide_centre_ - wide(polygon_.origin())), Wide(x_scale_) * dot(dual, wide_x_),
                      Wide(y_scale_) * dot(dual, wide_y_)};
  };
  using Local = PlanePolynomial<Wide>;
  const auto times = [this](const Local& a, const std::array<Wide, 3>& b) {
    Local result(degree_);
    for (int n = 0; n <= degree_; ++n) {
      for (int j = 0; j <= n; ++j) {
        const Wide& c = a(n - j, j);
        result(n - j, j) += b[0] * c;
        if (n == degree_) continue;
        result(n - j + 1, j) += b[1] * c;
        result(n - j, j + 1) += b[2] * c;
      }
    }
    return result;
  };
  const std::array<Wide, 3> s = affine(dual_s);
  const std::array<Wide, 3> t = affine(dual_t);
  std::vector<Local> sums(exact_functions_.size(), Local(degree_));
  Local row(degree_);
  row(0, 0) = 1;
  for (int i = 0; i <= degree_; ++i) {
    Local monomial = row;
    for (int j = 0; i + j <= degree_; ++j) {
      for (std::size_t k = 0; k < sums.size(); ++k) {
        const PlanePolynomial<Rational>& q = exact_functions_[k];
        if (i + j > q.degree() || q(i, j).sign() == 0) continue;
        const Wide c(q(i, j));
        for (int n = 0; n <= i + j; ++n) {
          for (int l = 0; l <= n; ++l) sums[k](n - l, l) += c * monomial(n - l, l);
        }
      }
      monomial = times(monomial, t);
    }
    row = times(row, s);
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    Function function;
    for (const Wide& c : sums[k].coefficients()) {
      function.coefficients.push_back(c.to_double());
    }
    add_barycentric(exact_functions_[k], function);
    function.maximum = sizes.empty() ? largest_value(exact_functions_[k]) : sizes[k];
    expects(function.maximum > 0, "functions that are not zero", named("function", k));
    amplification_ = std::max(amplification_, function.size / function.maximum);
    functions_.push_back(std::move(function));
  }
  permitted_whole_ = permitted(true);
  permitted_parts_ = permitted(false);
}

/// q on the fans' triangles in products of barycentric coordinates. lambda_1^i lambda_2^j has the Bernstein
/// coefficients b!/(b-i)! c!/(c-j)! (n-i-j)!/n! at lambda_0^a lambda_1^b lambda_2^c, n = a + b + c.
void PlaneElement::Prepared::add_barycentric(const PlanePolynomial<Rational>& q, Function& function) {
  const auto factorial = [](int n) {
    double product = 1;
    for (int k = 2; k <= n; ++k) product *= k;
    return product;
  };
  multinomials_.clear();
  for (int m = 0; m <= degree_; ++m) {
    for (int c = 0; c <= m; ++c) {
      multinomials_.push_back(factorial(degree_) /
                              (factorial(degree_ - m) * factorial(m - c) * factorial(c)));
    }
  }
  for (const PolygonLoop& loop : polygon_.loops()) {
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      const PlanePolynomial<Rational> local =
          substituted(q, loop[0], loop[k] - loop[0], loop[k + 1] - loop[0]);
      std::vector<double> coefficients;
      for (int m = 0; m <= degree_; ++m) {
        for (int c = 0; c <= m; ++c) {
          const int b = m - c;
          Wide sum;
          for (int i = 0; i <= b; ++i) {
            for (int j = 0; j <= c && i + j <= q.degree(); ++j) {
              const double quotient = factorial(b) / factorial(b - i) * (factorial(c) / factorial(c - j)) *
                                      factorial(degree_ - i - j);
              sum += Wide(local(i, j)) * Wide(quotient);
            }
          }
          sum /= Wide(factorial(degree_));
          function.size = std::max(function.size, std::abs(sum.to_double()));
          coefficients.push_back((sum * Wide(multinomials_[coefficients.size()])).to_double());
        }
      }
      function.barycentric.push_back(std::move(coefficients));
    }
  }
}

/// A bound of Int |G| dS over the part of the polygon behind the tangent plane, where no corner is certainly
/// there: its level is above -e, e some five times the error of a level.
double PlaneElement::Prepared::hidden_part(const Eye& eye) const {
  if (!eye.has_undecided) return 0;
  return integral_behind(4 * x_scale_ * y_scale_, undecided_errors * eye.level_error, eye.largest_level,
                         eye.height.smallest_size()) /
         eye.normal_length.smallest_size();
}

/// Int G dS = 1/2 sum [h (n_P . m) - (n_P . n) d] angle / a, m the edge's inward normal.
std::optional<BoundedDouble> PlaneElement::Prepared::lambert(const Eye& eye) const {
  const BoundedDouble squared_height = eye.height * eye.height;
  BoundedDouble sum;
  for (const Edge& edge : edges_) {
    const DoubleDoubleVector& from = eye.differences[edge.start];
    const BoundedDouble d = product(edge.inward, from, eye.reach);
    const BoundedDouble a2 = d * d + squared_height;
    const BoundedDouble a = sqrt(a2);
    const BoundedDouble start = -plain_product(edge.direction, from, eye.reach);
    const BoundedDouble end = -plain_product(edge.direction, eye.differences[edge.end], eye.reach);
    const BoundedDouble angle = atan2(a * BoundedDouble::rounded(edge.length), a2 + start * end);
    const BoundedDouble across = product(edge.inward, eye.normal, normal_reach);
    sum = sum + (eye.height * across - eye.normal_z * d) * angle / a;
  }
  sum = sum / (eye.normal_length + eye.normal_length);
  const double hidden = hidden_part(eye);
  // The product with the function's value rounds once more.
  if (sum.error() + hidden <= (accuracy_ - 5 * unit) * (sum.smallest_size() - hidden)) return sum;
  return std::nullopt;
}

/// Whether the foot certainly lies outside, and no nearer to a corner than P's height. Of a polygon that is
/// not convex the edges that cross the half-line to the right of the foot are counted; no corner's side of
/// that line may be in doubt.
bool PlaneElement::Prepared::foot_is_outside(const Eye& eye,
                                             const std::vector<FootEdge<BoundedDouble>>& edges) const {
  int winding = 0;
  bool right_of_one = false;
  const double height = std::abs(eye.height.value());
  for (const FootEdge<BoundedDouble>& edge : edges) {
    if (edge.distance_sign == 0) return false;
    if (std::hypot(edge.start_x.value(), edge.start_y.value()) < height) return false;
    right_of_one = right_of_one || edge.distance_sign < 0;
    if (is_convex_) continue;
    if (edge.start_y.smallest_size() == 0) return false;
    const bool from_above = edge.start_y.value() > 0;
    const bool to_above = edge.end_y.value() > 0;
    if (!from_above && to_above && edge.distance_sign > 0) ++winding;
    if (from_above && !to_above && edge.distance_sign < 0) --winding;
  }
  return is_convex_ ? right_of_one : winding == 0;
}

template <int most>
bool PlaneElement::Prepared::by_closed_form(const Eye& eye, std::span<double> values) const {
  using B = BoundedDouble;
  std::vector<FootEdge<B>>& edges = scratch().edges;
  edges.clear();
  const B squared_height = eye.height * eye.height;
  for (const Edge& edge : edges_) {
    const DoubleDoubleVector& from = eye.differences[edge.start];
    const DoubleDoubleVector& to = eye.differences[edge.end];
    FootEdge<B> seen;
    seen.direction_x = B::rounded(edge.direction_x);
    seen.direction_y = B::rounded(edge.direction_y);
    seen.distance = product(edge.inward, from, eye.reach);
    seen.slant = sqrt(seen.distance * seen.distance + squared_height);
    seen.length = B::rounded(edge.length);
    seen.start = -plain_product(edge.direction, from, eye.reach);
    seen.end = -plain_product(edge.direction, to, eye.reach);
    seen.start_x = -plain_product(axis_x_, from, eye.reach);
    seen.start_y = -plain_product(axis_y_, from, eye.reach);
    seen.end_x = -plain_product(axis_x_, to, eye.reach);
    seen.end_y = -plain_product(axis_y_, to, eye.reach);
    // Int |d| log(w/h^2) / (2 rho^2) dt <= pi |d| / |h|, and so |d| angle / a.
    if (seen.distance.smallest_size() > 0) {
      seen.distance_sign = seen.distance.value() < 0 ? -1 : 1;
    } else {
      seen.neglected = B(0, 7 * seen.distance.error() / eye.height.smallest_size());
    }
    // The formula is analytic across t = 0: either sign will do there.
    seen.start_sign = seen.start.value() < 0 ? -1 : 1;
    seen.end_sign = seen.end.value() < 0 ? -1 : 1;
    edges.push_back(seen);
  }
  FootView<B> view;
  view.height = eye.height;
  view.normal_x = product(axis_x_, eye.normal, normal_reach) / eye.normal_length;
  view.normal_y = product(axis_y_, eye.normal, normal_reach) / eye.normal_length;
  view.normal_z = eye.normal_z / eye.normal_length;
  view.foot_outside = foot_is_outside(eye, edges);
  KernelMoments<B, most> sums(view, degree_);
  for (const FootEdge<B>& edge : edges) sums.add(edge);
  typename KernelMoments<B, most>::Table table = sums.finish();
  const B whole = table[0][0];
  const double hidden = hidden_part(eye);
  const double least = accuracy_ * (whole.smallest_size() - hidden);
  if (!(whole.error() + hidden <= least)) return false;
  const DoubleDoubleVector from_centre = difference(eye.p, centre_);
  const B x_factor = B::rounded(1 / x_scale_);
  const B y_factor = B::rounded(1 / y_scale_);
  substitute(PlaneSubstitution<B>{.t_0 = product(axis_y_, from_centre, eye.reach) * y_factor,
                                  .t_y = y_factor,
                                  .s_0 = product(axis_x_, from_centre, eye.reach) * x_factor,
                                  .s_x = x_factor,
                                  .s_t = B(0)},
             degree_, table);
  for (std::size_t k = 0; k < functions_.size(); ++k) {
    B sum;
    std::size_t place = 0;
    for (int n = 0; n <= degree_; ++n) {
      for (int j = 0; j <= n; ++j) {
        sum = sum + B::rounded(functions_[k].coefficients[place++]) *
                        table[static_cast<std::size_t>(n - j)][static_cast<std::size_t>(j)];
      }
    }
    if (!(sum.error() + hidden * functions_[k].size <= least * functions_[k].maximum)) return false;
    values[k] = sum.value();
  }
  return true;
}

// The error of the rule route, over Int G dS max |q|, is the sum of these, none of which may exceed its part
// of the accuracy:
// - truncation: fitting_rule, piece by piece against a lower bound of Int G dS;
// - roundings of the summands G times weight, relative to each of them: they are positive, so that the sum's
// error is at most that
//   part of Int G dS max |q| (PieceSums::summand_roundings);
// - roundings of the sums and of products with Bernstein polynomials, in units of the largest coefficient
// (PieceSums::sum_roundings);
// - what the geometry is off by before the rule begins: P's height, the coordinates of the corners and their
// levels come out of
//   double-double products with an absolute error, which is small against them only where they are not small
//   against `reach` (geometry_errors). They are measured at every call, and refused where the spare roundings
//   do not cover them.

PlaneElement::Prepared::Permitted PlaneElement::Prepared::permitted(bool whole) const {
  constexpr double least_spare = 1;
  for (const double ratio : {0.4, 0.35, 0.3, 0.25, 0.2, 0.15, 0.1, 0.05, 0.02}) {
    const double taken =
        PieceSums::summand_roundings(ratio) + PieceSums::sum_roundings(degree_, whole) * amplification_;
    const double spare = (1 - truncation_part) * accuracy_ / unit - taken;
    if (spare >= least_spare) return {ratio, spare};
  }
  return {};
}

/// Cuts the visible part of the polygon into pieces, triangle by triangle; false if that takes too many.
bool PlaneElement::Prepared::cut_into_pieces(const Eye& eye, const Permitted& permitted, std::size_t most,
                                             std::vector<KernelPiece>& pieces) const {
  pieces.clear();
  const double squared_height = eye.height.value() * eye.height.value();
  std::vector<KernelPiece>& left = scratch().left;
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    KernelPiece triangle;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t corner = triangles_[k].corner[c];
      triangle.corner[c].x = product_in_double_double(axis_x_, eye.differences[corner]);
      triangle.corner[c].y = product_in_double_double(axis_y_, eye.differences[corner]);
      triangle.corner[c].level = eye.levels[corner];
      triangle.corner[c].barycentric[c] = 1;
    }
    triangle.double_area = triangles_[k].double_area;
    triangle.triangle = k;
    left.clear();
    append_visible(triangle, left);
    while (!left.empty()) {
      KernelPiece piece = left.back();
      left.pop_back();
      measure(piece, squared_height);
      if (piece.radius <= permitted.ratio * piece.distance) {
        pieces.push_back(piece);
        continue;
      }
      if (pieces.size() + left.size() + 4 > most) return false;
      append_quarters(piece, left);
    }
  }
  return true;
}

/// What the geometry is off by; `over_pieces` bounds the sum of the pieces' areas over the fourth powers of
/// their smallest distances. Levels: max(level, 0) changes by at most as much as the level, which is linear
/// between corners, whose levels are off by e at most, or were set to 0 and are at most 5 e and a little.
/// What the change uncovers of a triangle that is cut lies where the level is between -5 e and 0: by the
/// argument of integral_behind at most 2 (5 e) / L of its area, all of it where no corner is seen, and |Q-P|
/// >= |h|. Cuts: shifted by at most 2 e / l of a side, l the smallest level of a corner in size, which moves
/// what is seen by that part of the polygon's diameter: the summand changes by four times that over (1 -
/// ratio) D; areas change by 4 e / l at most, and every barycentric coordinate by 2 e / l of itself, beside
/// its roundings at the cut, at every halving, and of two differences. Height and coordinates: eta = 40
/// 2^-106 reach / |h| is the relative error of h beside its rounding. Coordinates are off by at most (40 +
/// 82) 2^-106 reach, of which the second part is for a cut and the halvings, whose errors are 16 2^-106 of
/// coordinates that come down to 1.4 D with the pieces. As D >= |h|, a distance of at least (1 - ratio) D
/// changes by at most 3.1 sqrt(2) / 0.6 eta < 7.4 eta of itself, its fourth power by 30 eta; h enters as a
/// factor, and in the fourth power by at most 2 eta: 33 eta in all.
PlaneElement::Prepared::GeometryErrors PlaneElement::Prepared::geometry_errors(
    const Eye& eye, const std::vector<KernelPiece>& pieces, double ratio, double over_pieces) const {
  GeometryErrors errors;
  const double height = eye.height.smallest_size();
  constexpr double rounding = 1.01;
  constexpr double by_height = 33;
  constexpr double by_largest = 1.4;  // which is off by a quarter at most
  errors.relative = by_height * rounding * product_error(eye.reach) / height;
  const double lowest = undecided_errors * eye.level_error;
  errors.level = lowest * over_pieces;
  double cut = 0;
  double cut_over_distance = 0;
  const double diameter = 2 * rounding * (x_scale_ + y_scale_);
  for (const KernelPiece& piece : pieces) {
    if (!piece.cut) continue;
    double smallest = std::numeric_limits<double>::infinity();
    for (const std::size_t c : triangles_[piece.triangle].corner) {
      const double level = std::abs(eye.levels[c].head);
      if (level > 0) smallest = std::min(smallest, level);
    }
    const double part = 2 * rounding * eye.level_error / smallest;
    cut = std::max(cut, part * (2 + degree_) + unit * (3 + piece.halvings) * degree_);
    cut_over_distance = std::max(cut_over_distance, part / piece.distance);
  }
  errors.relative += rounding * (cut + 4 * cut_over_distance * diameter / (1 - ratio));
  if (eye.has_undecided) {
    for (const Triangle& triangle : triangles_) {
      bool is_undecided = false;
      bool is_cut = false;
      double largest = 0;
      for (const std::size_t c : triangle.corner) {
        is_undecided = is_undecided || eye.levels[c].head == 0;
        is_cut = is_cut || eye.levels[c].head < 0;
        largest = std::max(largest, eye.levels[c].head);
      }
      if (!is_undecided || (!is_cut && largest > 0)) continue;
      const double part = largest > 0 ? std::min(1.0, 2 * lowest / largest) : 1;
      const double over_height = lowest / (height * height) * part;
      errors.level += by_largest * over_height * (std::abs(triangle.double_area) / (height * height));
    }
  }
  return errors;
}

bool PlaneElement::Prepared::by_rule(const Eye& eye, bool whole_triangles, std::span<double> values) const {
  const std::size_t many = pieces_of_an_element.count();
  const Permitted& permitted = whole_triangles ? permitted_whole_ : permitted_parts_;
  if (permitted.ratio == 0) return false;
  std::vector<KernelPiece>& pieces = scratch().pieces;
  if (!cut_into_pieces(eye, permitted, whole_triangles ? 0 : triangles_.size() + many, pieces)) return false;
  // A lower bound of Int G / h, from the largest distance; piece by piece where none counts negative.
  double average = 0;
  double by_pieces = 0;
  double over_pieces = 0;  // the sum of areas over fourth powers of distances
  double farthest = 0;
  double absolute_area = 0;
  bool positive = true;
  for (const KernelPiece& piece : pieces) {
    const auto& [a, b, c] = piece.corner;
    const double third = piece.double_area / 6;
    const double levels = a.level.head + b.level.head + c.level.head;
    const double reach = piece.distance + piece.radius;
    const double over_reach = third / ((reach * reach) * (reach * reach));
    average += third * levels;
    by_pieces += over_reach * levels;
    over_pieces += std::abs(over_reach);
    farthest = std::max(farthest, reach);
    absolute_area += std::abs(piece.double_area) / 2;
    positive = positive && piece.double_area >= 0;
  }
  constexpr double rounding = 0.99;
  const double least =
      rounding * (positive ? by_pieces : average / ((farthest * farthest) * (farthest * farthest)));
  if (!(least > 0)) return false;
  const double quotient = (1 + permitted.ratio) / (1 - permitted.ratio);
  const GeometryErrors errors =
      geometry_errors(eye, pieces, permitted.ratio,
                      3 / rounding * over_pieces * (quotient * quotient) * (quotient * quotient));
  const double geometry = (errors.level / least + errors.relative) * amplification_;
  if (!(geometry <= permitted.spare * unit)) return false;

  std::vector<long double>& results = scratch().results;
  results.assign(functions_.size(), 0);
  PieceSums sums(degree_);
  const double squared_height = eye.height.value() * eye.height.value();
  long double whole = 0;
  long double absolute = 0;
  for (std::size_t place = 0; place < pieces.size();) {
    const std::size_t triangle = pieces[place].triangle;
    sums.clear();
    for (; place < pieces.size() && pieces[place].triangle == triangle; ++place) {
      const KernelPiece& piece = pieces[place];
      const double needed =
          needed_tail(piece, truncation_part * accuracy_ * least, absolute_area, amplification_);
      if (std::isinf(needed)) continue;
      const PaddedRule* rule = fitting_rule(piece.radius / piece.distance, needed, degree_);
      if (rule == nullptr) return false;
      sums.add(piece, *rule, squared_height);
    }
    long double part = 0;
    for (std::size_t n = 0; n < sums.count(); ++n) {
      const long double moment = sums.moment(n);
      part += moment * static_cast<long double>(multinomials_[n]);
      for (std::size_t k = 0; k < functions_.size(); ++k) {
        results[k] += static_cast<long double>(functions_[k].barycentric[triangle][n]) * moment;
      }
    }
    whole += part;
    absolute += std::abs(part);
  }
  // What was taken for a lower bound, by sums that cancel where some areas are negative.
  if (!(static_cast<long double>(least) <= whole)) return false;
  // Triangles that stick out of the polygon and cancel: there the functions are bounded by the Bernstein
  // coefficients alone.
  if (!(absolute <= whole)) {
    const auto excess = static_cast<double>(absolute / whole);
    const double roundings =
        (PieceSums::summand_roundings(permitted.ratio) + PieceSums::sum_roundings(degree_, whole_triangles)) *
            amplification_ +
        geometry / unit;
    if (!(excess * roundings * unit <= (1 - truncation_part) * accuracy_)) return false;
  }
  const long double factor =
      static_cast<long double>(eye.height.value()) / static_cast<long double>(eye.normal_length.value());
  for (std::size_t k = 0; k < functions_.size(); ++k) values[k] = static_cast<double>(results[k] * factor);
  return true;
}

PlaneElement::Route PlaneElement::Prepared::by_balls(const Vector<double>& p, const Vector<double>& normal,
                                                     std::span<double> values) const {
  const auto exactly = [](const Vector<double>& a) {
    return Vector<Rational>{Rational::exactly(a.x), Rational::exactly(a.y), Rational::exactly(a.z)};
  };
  const Vector<Rational> exact_p = exactly(p);
  const Vector<Rational> exact_normal = exactly(normal);
  const Ball smallest_half = Ball(std::numeric_limits<double>::denorm_min()) / 2;
  constexpr long first_bits = 128;
  const long most_bits = bits_of_an_element.value();
  for (long bits = first_bits;; bits *= 2) {
    if (bits > most_bits)
      throw AccuracyNotReached(
          "the integral over a plane element",
          "not enclosed to its accuracy by balls of " + std::to_string(most_bits) + " bits");
    const BallPrecision precision(bits);
    const std::vector<Ball> moments =
        point_to_polygon_moments<Ball>(exact_p, exact_normal, polygon_, degree_);
    const double least = abs(moments[0]).lower_double();
    bool enough = true;
    bool zero = true;
    for (std::size_t k = 0; k < functions_.size() && enough; ++k) {
      Ball sum;
      const std::vector<Rational>& coefficients = exact_functions_[k].coefficients();
      for (std::size_t n = 0; n < coefficients.size(); ++n) {
        if (coefficients[n].sign() != 0) sum += Ball(coefficients[n]) * moments[n];
      }
      zero = zero && certainly_zero(sum);
      // Half for the radius; rounding to a double costs 2^-53 of the value, or 2^-1075.
      enough = sum.is_finite() && (sum.radius() <= accuracy_ / 2 * least * functions_[k].maximum ||
                                   certainly_at_most(sum.radius_ball(), smallest_half));
      if (enough) values[k] = sum.to_double();
    }
    if (enough) return zero ? Route::zero : Route::ball;
  }
}

PlaneElement::Route PlaneElement::Prepared::integrals(const Vector<double>& p, const Vector<double>& normal,
                                                      std::span<double> values) const {
  expects(std::isfinite(p.x + p.y + p.z) && std::isfinite(normal.x + normal.y + normal.z), "finite numbers",
          named("x", p.x), named("y", p.y), named("z", p.z));
  expects(values.size() == functions_.size(), "a value for every function", named("values", values.size()));
  Eye& eye = scratch().eye;
  eye.differences.clear();
  eye.levels.clear();
  eye.p = {p.x, p.y, p.z};
  eye.normal.head = {normal.x, normal.y, normal.z};
  eye.reach = 3 * (largest_part(eye.p) + reach_);
  const double normal_size = largest_part(eye.normal.head);
  expects(normal_size > 0, "a normal that is not zero");
  // Squares and fourth powers of lengths beyond these could leave the range of doubles; normals need not.
  constexpr double smallest = 1e-60;
  constexpr double largest = 1e60;
  if (normal_size < smallest || normal_size > largest || eye.reach < smallest || eye.reach > largest)
    return by_balls(p, normal, values);
  const double scale = std::ldexp(1.0, -std::ilogb(normal_size));
  for (double& part : eye.normal.head) part *= scale;
  eye.normal_length = bounded_length(eye.normal.head);
  eye.normal_z = product(axis_z_, eye.normal, normal_reach);

  int seen = 0;
  int unseen = 0;
  eye.has_undecided = false;
  eye.largest_level = 0;
  eye.level_error = product_error(normal_reach * eye.reach);
  for (const Corner& corner : corners_) {
    eye.differences.push_back(difference(eye.p, corner.at));
    DoubleDouble level = -product_in_double_double(eye.normal, eye.differences.back());
    if (std::abs(level.head) <= decided_errors * eye.level_error) {
      eye.has_undecided = true;
      level = {};
    } else {
      ++(level.head > 0 ? seen : unseen);
    }
    eye.largest_level = std::max(eye.largest_level, level.head);
    eye.levels.push_back(level);
  }
  eye.height = product(axis_z_, eye.differences[0], eye.reach);
  if (seen == 0 && !eye.has_undecided) {
    // Unless P lies on the polygon, where the ball's contract is asked; there a corner in front or on the
    // tangent plane exists.
    std::fill(values.begin(), values.end(), 0.0);
    return Route::zero;
  }
  if (eye.height.smallest_size() < smallest || shortest_ < smallest || seen == 0)
    return by_balls(p, normal, values);
  const bool whole = unseen == 0;
  if (whole && degree_ == 0) {
    if (const std::optional<BoundedDouble> value = lambert(eye)) {
      for (std::size_t k = 0; k < functions_.size(); ++k) {
        values[k] = functions_[k].coefficients[0] * value->value();
      }
      return Route::closed_form;
    }
  }
  // One piece a triangle: then the rule costs less than the closed form of higher degree.
  if (whole && by_rule(eye, true, values)) return Route::rule;
  if (whole) {
    const bool closed = degree_ <= 1   ? by_closed_form<1>(eye, values)
                        : degree_ == 2 ? by_closed_form<2>(eye, values)
                                       : by_closed_form<largest_degree>(eye, values);
    if (closed) return Route::closed_form;
  }
  return by_rule(eye, false, values) ? Route::rule : by_balls(p, normal, values);
}

PlaneElement::PlaneElement(const PlanePolygon& polygon, std::vector<PlanePolynomial<Rational>> functions,
                           double accuracy, std::span<const double> sizes)
    : prepared_(std::make_unique<const Prepared>(polygon, std::move(functions), accuracy, sizes)) {}
PlaneElement::PlaneElement(PlaneElement&&) noexcept = default;
PlaneElement& PlaneElement::operator=(PlaneElement&&) noexcept = default;
PlaneElement::~PlaneElement() = default;

std::size_t PlaneElement::function_count() const { return prepared_->function_count(); }

PlaneElement::Route PlaneElement::integrals(const Vector<double>& p, const Vector<double>& normal,
                                            std::span<double> values) const {
  return prepared_->integrals(p, normal, values);
}

}  // namespace radcert
