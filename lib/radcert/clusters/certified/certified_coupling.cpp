// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/certified_coupling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "radcert/clusters/certified/approximation_bound.h"
#include "radcert/clusters/certified/interpolation_bounds.h"
#include "radcert/clusters/mode_products.h"
#include "radcert/clusters/mode_tables.h"
#include "radcert/clusters/triangle_modes.h"
#include "radcert/core/lazy_table.h"
#include "radcert/core/parallel.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/pack.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Far more than the roundings of the few operations that follow a bound.
constexpr double up = 1 + 0x1p-40;
/// The unit roundoff of long double, and that of double.
constexpr double long_unit = 0x1p-64;
constexpr double unit = 0x1p-53;

using LongMatrix = std::vector<long double>;  ///< by rows

/// The midpoint of a ball to about the unit roundoff of long double, and what it may be off by beside that.
long double long_double_of(const Ball& x, double& error) {
  const Approximation head = enclosing(x);
  const Approximation tail = enclosing(x - Ball(head.value));
  error = std::max(error, tail.radius);
  return static_cast<long double>(head.value) + static_cast<long double>(tail.value);
}

using Nodes = CertifiedOutlines::Nodes;

Nodes nodes_of(const Chart& chart, const ParameterTriangle& triangle, int degree) {
  Nodes nodes;
  nodes.least_weight = infinity;
  const ChartIn<Ball>& formula = chart.in<Ball>();
  const auto corner = [&](std::size_t i) {
    return ParameterPoint<Ball>{Ball(triangle.vertices[i].s), Ball(triangle.vertices[i].t)};
  };
  const ParameterPoint<Ball> origin = corner(0);
  const ParameterPoint<Ball> first = corner(1) - origin;
  const ParameterPoint<Ball> second = corner(2) - origin;
  const Ball area = abs(cross(first, second)) / Ball(2);
  for (const ParameterPoint<double>& x : exact_interpolation_nodes(degree)) {
    const Frame<Ball> frame = formula.frame(origin + Ball(x.s) * first + Ball(x.t) * second);
    const Ball length = norm(frame.area_normal);
    const Vector<Ball> normal = (Ball(1) / length) * frame.area_normal;
    const std::array<Ball, 7> balls{frame.point.x, frame.point.y, frame.point.z, normal.x,
                                    normal.y,      normal.z,      area * length};
    std::array<long double, 7> numbers{};
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (!balls[i].is_finite()) {
        nodes.error = infinity;
        return nodes;
      }
      numbers[i] = long_double_of(balls[i], nodes.error);
    }
    for (std::size_t i = 0; i < 3; ++i)
      nodes.size = std::max(nodes.size, static_cast<double>(std::abs(numbers[i])) * up);
    nodes.weight = std::max(nodes.weight, static_cast<double>(numbers[6]) * up);
    nodes.least_weight = std::min(nodes.least_weight, static_cast<double>(numbers[6]) / up);
    nodes.at.push_back(numbers);
  }
  return nodes;
}

/// G between nodes, rows those of a, and what its values may be off by.
/// Maths     coordinates are off by 2^-62 size, with the balls' radii, a difference of length d by four times
///           that and its own rounding: by t d, with t as below where d is at least the least distance. Then
///           the two scalar products are off by 2t d, the squared distance by 3t d^2, and G by 12t / d^2, t <
///           2^-20, beside a few roundings
struct KernelValues {
  LongMatrix values;
  double error = infinity;
};

KernelValues kernel_values(const Nodes& a, const Nodes& b) {
  KernelValues g;
  if (!(a.error < infinity && b.error < infinity)) return g;
  g.values.reserve(a.at.size() * b.at.size());
  long double least = std::numeric_limits<long double>::infinity();
  for (const auto& p : a.at)
    for (const auto& q : b.at) {
      const std::array<long double, 3> d{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
      const long double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      const long double from_p = d[0] * p[3] + d[1] * p[4] + d[2] * p[5];
      const long double from_q = d[0] * q[3] + d[1] * q[4] + d[2] * q[5];
      least = std::min(least, squared);
      g.values.push_back(-from_p * from_q / (squared * squared));
    }
  const double distance = std::sqrt(static_cast<double>(least)) * (1 - 0x1p-20);
  const double coordinates = (a.size + b.size) * 2 * long_unit + a.error + b.error;
  const double t = (4 * coordinates / distance + (a.error + b.error) * 4 + 64 * long_unit) * up;
  if (t < 0x1p-20) g.error = 12 * t / (distance * distance) * up;
  return g;
}

/// Of a square number.
std::size_t square_root(std::size_t n) {
  return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
}

KernelValues transposed(const KernelValues& g) {
  KernelValues result{LongMatrix(g.values.size()), g.error};
  const std::size_t n = square_root(g.values.size());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) result.values[j * n + i] = g.values[i * n + j];
  return result;
}

/// A matrix of sums of two doubles, its rows padded by zeros to whole packs.
struct DoubledMatrix {
  DoubledMatrix(std::size_t rows, std::size_t columns)
      : high(padded<double>(rows), columns), low(padded<double>(rows), columns) {}
  void set(std::size_t i, std::size_t j, long double value) {
    high(i, j) = static_cast<double>(value);
    low(i, j) = static_cast<double>(value - static_cast<long double>(high(i, j)));
  }
  Matrix<double> high;
  Matrix<double> low;
};

/// Column j of a b, or of a b^T: rows of a by packs.
/// Maths     as Ogita, Rump, Oishi (2005), algorithm Dot2, with the low parts as factors of the high ones:
///           off by less than 2^-80 of the sum of the products' sizes, for up to 300 terms
template <class Factor>
void multiply_column(const DoubledMatrix& a, std::size_t terms, const Factor& factor, double* high,
                     double* low) {
  for (std::size_t i = 0; i < a.high.rows(); i += Pack::lanes) {
    Pack sum(0.0);
    Pack rest(0.0);
    for (std::size_t t = 0; t < terms; ++t) {
      const auto [b_high, b_low] = factor(t);
      const Pack a_high = Pack::load(a.high.column(t).data() + i);
      const Pack a_low = Pack::load(a.low.column(t).data() + i);
      const Pack product = a_high * Pack(b_high);
      const Pack after = sum + product;
      const Pack back = after - sum;
      const Pack lost = fma(a_high, Pack(b_high), -product) + ((sum - (after - back)) + (product - back));
      rest += lost + fma(a_high, Pack(b_low), a_low * Pack(b_high));
      sum = after;
    }
    const Pack total = sum + rest;
    total.store(high + i);
    (rest - (total - sum)).store(low + i);
  }
}

/// (W^T D)_a at the exact nodes of degree `fine`, W of the degree `coarse`; rows by node.
const DoubledMatrix& values_at_nodes(int coarse, int fine) {
  constexpr std::size_t degrees = largest_mode_degree + 1;
  static LazyTable<DoubledMatrix, degrees * degrees> tables;
  return tables.at(static_cast<std::size_t>(coarse) * degrees + static_cast<std::size_t>(fine), [&] {
    const Matrix<double>& w = ModeTables::instance().interpolation(coarse).modes_of_values;
    const std::size_t k = mode_count(coarse);
    std::vector<Ball> modes(k);
    DoubledMatrix table(mode_count(fine), k);
    double error = 0;
    std::size_t row = 0;
    for (const ParameterPoint<double>& x : exact_interpolation_nodes(fine)) {
      triangle_modes<Ball>(coarse, barycentric_of<Ball>({Ball(x.s), Ball(x.t)}), modes);
      for (std::size_t a = 0; a < k; ++a) {
        Ball value = 0;
        for (std::size_t n = 0; n < k; ++n) value += Ball(w(n, a)) * modes[n];
        table.set(row, a, long_double_of(value, error));
      }
      ++row;
    }
    expects(error < 0x1p-90, "values that balls enclose narrowly", named("radius", error));
    return table;
  });
}

/// The values of h - c at the nodes of degree p'; rows by node of the first cluster.
struct Differences {
  std::vector<double> values;
  double largest = 0;
  double error = 0;  ///< of each value
};

/// Maths     the factors W^T D are rounded to long double, c is summed by multiply_column: each value is off
///           by 32 units of long double of L_p^2 max |h|, and by L_p^2 times what h is off by
Differences differences(const KernelValues& fine, const Nodes& fine_sources, const KernelValues& coarse,
                        const Nodes& coarse_sources, int degree, int fine_degree) {
  const std::size_t k = mode_count(degree);
  const std::size_t f = mode_count(fine_degree);
  const DoubledMatrix& l = values_at_nodes(degree, fine_degree);
  long double largest_h = 0;
  DoubledMatrix between(k, k);
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = 0; b < k; ++b) {
      const long double value = coarse.values[a * k + b] * coarse_sources.at[b][6];
      largest_h = std::max(largest_h, std::abs(value));
      between.set(a, b, value);
    }
  DoubledMatrix half(f, k);
  for (std::size_t b = 0; b < k; ++b)
    multiply_column(
        l, k, [&](std::size_t a) { return std::pair(between.high(a, b), between.low(a, b)); },
        half.high.column(b).data(), half.low.column(b).data());
  Differences result;
  result.values.resize(f * f);
  std::vector<double> high(half.high.rows());
  std::vector<double> low(half.high.rows());
  for (std::size_t j = 0; j < f; ++j) {
    multiply_column(
        half, k, [&](std::size_t b) { return std::pair(l.high(j, b), l.low(j, b)); }, high.data(),
        low.data());
    for (std::size_t i = 0; i < f; ++i) {
      const long double value = fine.values[i * f + j] * fine_sources.at[j][6];
      largest_h = std::max(largest_h, std::abs(value));
      const double difference =
          static_cast<double>((value - static_cast<long double>(high[i])) - static_cast<long double>(low[i]));
      result.values[i * f + j] = difference;
      result.largest = std::max(result.largest, std::abs(difference));
    }
  }
  const double interpolation = interpolation_bounds(degree).stored;
  const double squared = interpolation * interpolation;
  const double weight = std::max(fine_sources.weight, coarse_sources.weight);
  const double least_weight = std::min(fine_sources.least_weight, coarse_sources.least_weight);
  const double weights_off = (fine_sources.error + coarse_sources.error) / least_weight + 2 * long_unit;
  const double h = static_cast<double>(largest_h) * up;
  const double h_off = (std::max(fine.error, coarse.error) * weight + weights_off * h) * up;
  result.error = ((1 + squared) * h_off + 32 * long_unit * (squared + 1) * h + unit * result.largest) * up;
  return result;
}

/// The same with the two clusters exchanged, the constant area elements in that ratio.
Differences exchanged(const Differences& e, double ratio) {
  // The ratio is off by less than 2^-38 of itself.
  const double larger = ratio * (1 + 0x1p-37);
  Differences result{.values = std::vector<double>(e.values.size()),
                     .largest = e.largest * larger,
                     .error = (e.error + 0x1p-36 * e.largest) * larger};
  const std::size_t n = square_root(e.values.size());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) result.values[j * n + i] = ratio * e.values[i * n + j];
  return result;
}

/// A bound of the largest over x of the root of the mean over y of I_x I_y (h - c)^2, x the variable of the
/// rows; see CertifiedLook.
double measured(const Differences& e, int degree) {
  const ModeInterpolation& interpolation = ModeTables::instance().interpolation(degree);
  const InterpolationBounds& bounds = interpolation_bounds(degree);
  const Matrix<double>& w = interpolation.modes_of_values;
  const std::size_t f = mode_count(degree);
  const std::size_t rows = w.rows();
  double sizes = 0;
  for (const double size : bounds.mean_size) sizes += size;
  const double gamma = 2 * static_cast<double>(f) * unit;

  // The modes over y of each row.
  std::vector<double> over_y(f * rows, 0.0);
  std::vector<const double*> from;
  std::vector<double*> to;
  for (std::size_t i = 0; i < f; ++i) {
    from.push_back(&e.values[i * f]);
    to.push_back(&over_y[i * rows]);
  }
  add_mode_product(w, rows, f, from, to);
  double largest_row = 0;
  for (std::size_t i = 0; i < f; ++i) {
    double squares = 0;
    for (std::size_t m = 0; m < f; ++m) squares += over_y[i * rows + m] * over_y[i * rows + m];
    largest_row = std::max(largest_row, std::sqrt(squares) * up);
  }

  // The modes over x of these.
  std::vector<double> columns(f * f);
  std::vector<double> over_both(f * rows, 0.0);
  for (std::size_t m = 0; m < f; ++m) {
    for (std::size_t i = 0; i < f; ++i) columns[m * f + i] = over_y[i * rows + m];
    from[m] = &columns[m * f];
    to[m] = &over_both[m * rows];
  }
  add_mode_product(w, rows, f, from, to);
  double by_modes = 0;
  double roots = 0;
  for (std::size_t d = 0, n = 0; d <= static_cast<std::size_t>(degree); ++d) {
    double squares = 0;
    for (std::size_t i = 0; i <= d; ++i, ++n)
      for (std::size_t m = 0; m < f; ++m) squares += over_both[m * rows + n] * over_both[m * rows + n];
    const double root = std::pow(static_cast<double>(d + 1), 1.5) * up;
    by_modes += root * std::sqrt(squares) * up;
    roots += root;
  }
  // The modes over x are off by gamma sum_a ||W_a|| ||row a|| in the root of their squares.
  by_modes += gamma * roots * sizes * largest_row;
  const double off = e.error + (3 * bounds.inverse + 2 * gamma) * e.largest;
  return (std::min(bounds.exact * largest_row, by_modes) + off * bounds.exact * sizes) * up;
}

/// What interpolation of a degree leaves out of h at most: the least over the neighbourhoods.
double interpolation_rest(double largest_constant, std::span<const double> in_x, std::span<const double> in_y,
                          int degree) {
  double of_x = infinity;
  double of_y = infinity;
  for (std::size_t s = 1; s < in_x.size(); ++s) {
    of_x = std::min(of_x, approximation_bound(in_x[s], ClusterRegion::sizes[s], degree));
    of_y = std::min(of_y, approximation_bound(in_y[s], ClusterRegion::sizes[s], degree));
  }
  return (1 + largest_constant) * (of_x + largest_constant * of_y) * up;
}

}  // namespace

struct CertifiedOutlines::Cluster {
  Cluster(const Chart& chart, const ParameterTriangle& triangle) : region(chart, triangle) {}
  ClusterRegion region;
  LazyTable<Nodes, largest_mode_degree + 1> nodes;
};

CertifiedOutlines::CertifiedOutlines(const std::vector<Chart>& charts,
                                     const std::vector<ParameterTriangle>& clusters)
    : charts_(charts), triangles_(clusters), clusters_(clusters.size()) {
  parallel_for(clusters.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      clusters_[i] = std::make_unique<Cluster>(charts[clusters[i].chart], clusters[i]);
  });
}

CertifiedOutlines::~CertifiedOutlines() = default;

const ClusterRegion& CertifiedOutlines::region(std::size_t cluster) const {
  return clusters_[cluster]->region;
}

const CertifiedOutlines::Nodes& CertifiedOutlines::nodes(std::size_t cluster, int degree) const {
  const ParameterTriangle& triangle = triangles_[cluster];
  return clusters_[cluster]->nodes.at(static_cast<std::size_t>(degree),
                                      [&] { return nodes_of(charts_[triangle.chart], triangle, degree); });
}

std::optional<CertifiedLook::Rest> CertifiedLook::rest(std::size_t a, std::size_t b, int least) const {
  const ClusterRegion& in_a = outlines_.region(a);
  const ClusterRegion& in_b = outlines_.region(b);
  constexpr std::size_t count = ClusterRegion::sizes.size();
  // Bounds of h on the neighbourhoods, by the cluster that is complex and by the one that is the source.
  std::array<double, count> a_source_b;
  std::array<double, count> a_source_a;
  std::array<double, count> b_source_b;
  std::array<double, count> b_source_a;
  const double real_a = in_a.neighbourhoods().front().weight;
  const double real_b = in_b.neighbourhoods().front().weight;
  for (std::size_t s = 0; s < count; ++s) {
    const double seen_a = kernel_bound(in_a, in_b, s);
    const double seen_b = kernel_bound(in_b, in_a, s);
    const bool has_a = seen_a < infinity;
    const bool has_b = seen_b < infinity;
    a_source_b[s] = has_a ? seen_a * in_a.neighbourhoods()[s].normal * real_b * up : infinity;
    a_source_a[s] = has_a ? seen_a * in_a.neighbourhoods()[s].weight * up : infinity;
    b_source_b[s] = has_b ? seen_b * in_b.neighbourhoods()[s].weight * up : infinity;
    b_source_a[s] = has_b ? seen_b * in_b.neighbourhoods()[s].normal * real_a * up : infinity;
  }
  // A quarter of the share; the rest is for what is measured.
  constexpr double part = 0.25;
  for (int degree = least; degree <= largest_mode_degree; ++degree) {
    const double constant = interpolation_bounds(degree).exact;
    const Rest found{.degree = degree,
                     .a = interpolation_rest(constant, a_source_b, b_source_b, degree),
                     .b = interpolation_rest(constant, b_source_a, a_source_a, degree)};
    if (std::max(found.a, found.b) * demand_.functions_size / std::numbers::pi <= part * demand_.share)
      return found;
  }
  return std::nullopt;
}

std::optional<CouplingDegree> CertifiedLook::operator()(std::size_t a, std::size_t b) {
  const std::optional<CouplingDegree> guess = estimate_(a, b);
  if (!guess) return std::nullopt;
  constexpr int least_looked = 2;
  const std::optional<Rest> left = rest(a, b, std::max(least_looked, guess->degree));
  if (!left) return std::nullopt;
  const Nodes& fine_a = outlines_.nodes(a, left->degree);
  const Nodes& fine_b = outlines_.nodes(b, left->degree);
  const KernelValues fine = kernel_values(fine_a, fine_b);
  const double factor = demand_.functions_size * std::numbers::inv_pi * up;
  const bool plane = outlines_.region(a).is_plane() && outlines_.region(b).is_plane();
  constexpr int more_degrees = 3;
  const int most = std::min({left->degree, demand_.largest_degree, guess->degree + more_degrees});
  for (int degree = guess->degree; degree <= most; ++degree) {
    const Nodes& coarse_a = outlines_.nodes(a, degree);
    const Nodes& coarse_b = outlines_.nodes(b, degree);
    const KernelValues coarse = kernel_values(coarse_a, coarse_b);
    const Differences rows_a = differences(fine, fine_b, coarse, coarse_b, degree, left->degree);
    CouplingDegree found{.degree = degree,
                         .error_a = factor * (measured(rows_a, left->degree) + left->a) * up};
    if (!(found.error_a <= demand_.share)) continue;
    // With a as source: G is symmetric, the area elements differ, by a factor where both are constant.
    const Differences rows_b =
        plane ? exchanged(rows_a, fine_a.weight / fine_b.weight)
              : differences(transposed(fine), fine_a, transposed(coarse), coarse_a, degree, left->degree);
    found.error_b = factor * (measured(rows_b, left->degree) + left->b) * up;
    if (found.error_b <= demand_.share) return found;
  }
  return std::nullopt;
}

}  // namespace radcert
