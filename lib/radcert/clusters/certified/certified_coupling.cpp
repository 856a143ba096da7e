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
#include "radcert/clusters/certified/enclosed_nodes.h"
#include "radcert/clusters/certified/interpolation_bounds.h"
#include "radcert/clusters/mode_products.h"
#include "radcert/clusters/mode_tables.h"
#include "radcert/core/lazy_table.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/scalar/pack.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Far more than the roundings of the few operations that follow a bound.
constexpr double up = 1 + 0x1p-40;
/// The unit roundoff of long double, and that of double.
static_assert(std::numeric_limits<long double>::digits >= 64);
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
  const BallPrecision precision(BallPrecision::default_bits);
  Nodes nodes;
  const auto rounded = [&nodes](const Vector<Ball>& v) {
    return std::array<long double, 3>{long_double_of(v.x, nodes.error), long_double_of(v.y, nodes.error),
                                      long_double_of(v.z, nodes.error)};
  };
  for (const EnclosedNode& node : enclosed_nodes(chart, triangle, degree)) {
    nodes.at.push_back(rounded(node.frame.point));
    nodes.normal.push_back(rounded(unit_normal(node.frame)));
    nodes.weight.push_back(long_double_of(node.weight, nodes.weight_error));
    for (const long double coordinate : nodes.at.back())
      nodes.size = std::max(nodes.size, static_cast<double>(std::abs(coordinate)) * up);
    nodes.largest_weight = std::max(nodes.largest_weight, static_cast<double>(nodes.weight.back()) * up);
  }
  return nodes;
}

/// Values of a kernel between nodes, rows those of one cluster, and what the values may be off by.
struct KernelValues {
  LongMatrix values;
  double error = infinity;
  double largest = 0;
};

/// G between nodes, rows those of a.
/// Maths     coordinates are off by 2^-64 of their size and the balls' radii, so that a difference of length
///           d is off by at most t d, with t as below where d is at least the least distance. Then the two
///           scalar products are off by 2t d, the squared distance by 3t d^2, and G by 12t / d^2, t < 2^-20,
///           the roundings of a few operations within t
KernelValues kernel_values(const Nodes& a, const Nodes& b) {
  KernelValues g;
  g.values.reserve(a.at.size() * b.at.size());
  long double least = std::numeric_limits<long double>::infinity();
  long double largest = 0;
  for (std::size_t i = 0; i < a.at.size(); ++i) {
    const std::array<long double, 3>& p = a.at[i];
    const std::array<long double, 3>& n = a.normal[i];
    for (std::size_t j = 0; j < b.at.size(); ++j) {
      const std::array<long double, 3>& q = b.at[j];
      const std::array<long double, 3>& m = b.normal[j];
      const std::array<long double, 3> d{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
      const long double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      const long double from_p = d[0] * n[0] + d[1] * n[1] + d[2] * n[2];
      const long double from_q = d[0] * m[0] + d[1] * m[1] + d[2] * m[2];
      least = std::min(least, squared);
      g.values.push_back(-from_p * from_q / (squared * squared));
      largest = std::max(largest, std::abs(g.values.back()));
    }
  }
  const double distance = std::sqrt(static_cast<double>(least)) * (1 - 0x1p-20);
  const double coordinates = (a.size + b.size) * 2 * long_unit + a.error + b.error;
  const double t = (4 * coordinates / distance + (a.error + b.error) * 4 + 64 * long_unit) * up;
  if (t < 0x1p-20) g.error = 12 * t / (distance * distance) * up;
  g.largest = static_cast<double>(largest) * up;
  return g;
}

KernelValues transposed(const KernelValues& g, std::size_t rows) {
  KernelValues result{.values = LongMatrix(g.values.size()), .error = g.error, .largest = g.largest};
  const std::size_t columns = g.values.size() / rows;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) result.values[j * rows + i] = g.values[i * columns + j];
  return result;
}

/// G J, the columns those of the cluster with the area element J.
/// Maths     products of numbers that are off by their errors and by their rounding to long double
KernelValues weighted(KernelValues g, const Nodes& columns) {
  long double largest = 0;
  for (std::size_t k = 0; k < g.values.size(); ++k) {
    g.values[k] *= columns.weight[k % columns.weight.size()];
    largest = std::max(largest, std::abs(g.values[k]));
  }
  const double weight = columns.largest_weight + columns.weight_error;
  g.error = (g.error * weight + g.largest * (columns.weight_error + 4 * long_unit * weight)) * up;
  g.largest = static_cast<double>(largest) * up;
  return g;
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

/// The values of h - c at the nodes of degree p', c the coupling of h; rows by node of the first cluster.
struct Differences {
  std::vector<double> values;
  double largest = 0;
  double error = 0;  ///< of each value
};

/// Maths     the factors W^T D are rounded to long double, c is summed by multiply_column: each value is off
///           by 32 units of long double of L_p^2 max |h|, and by L_p^2 times what h is off by
Differences differences(const KernelValues& fine, const KernelValues& coarse, int degree, int fine_degree) {
  const std::size_t k = mode_count(degree);
  const std::size_t f = mode_count(fine_degree);
  const DoubledMatrix& l = values_at_nodes(degree, fine_degree);
  DoubledMatrix between(k, k);
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = 0; b < k; ++b) between.set(a, b, coarse.values[a * k + b]);
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
      const long double coupling = static_cast<long double>(high[i]) + static_cast<long double>(low[i]);
      const auto difference = static_cast<double>(fine.values[i * f + j] - coupling);
      result.values[i * f + j] = difference;
      result.largest = std::max(result.largest, std::abs(difference));
    }
  }
  const double interpolation = interpolation_bounds(degree).stored;
  const double sizes = 1 + interpolation * interpolation;
  const double largest = std::max(fine.largest, coarse.largest);
  result.error =
      (sizes * (std::max(fine.error, coarse.error) + 32 * long_unit * largest) + unit * result.largest) * up;
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
  // Neighbourhoods up to where the kernel may be singular.
  constexpr std::array<double, 11> parts{0.1, 0.17, 0.25, 0.33, 0.4, 0.52, 0.62, 0.71, 0.79, 0.86, 0.92};
  struct Bound {
    double g;
    double of_kernel;
    double weight;
  };
  const auto bounds_of = [&](const ClusterRegion& seen, const ClusterRegion& from) {
    std::vector<Bound> bounds;
    const double farthest = std::min(from.least_distance(seen.centre()) / seen.radius(), seen.limit());
    for (const double part : parts) {
      if (!(farthest > 1)) break;
      const double g = 1 + (farthest - 1) * part;
      const double bound = kernel_bound(seen, from, g);
      if (!(bound < infinity)) break;
      bounds.push_back({g, bound, seen.at(g).weight});
    }
    return bounds;
  };
  const std::vector<Bound> of_a = bounds_of(in_a, in_b);
  const std::vector<Bound> of_b = bounds_of(in_b, in_a);
  /// How far G and G J, J the area element of the same cluster, are from polynomials.
  struct Distance {
    double of_kernel = infinity;
    double with_weight = infinity;
  };
  const auto least_of = [](const std::vector<Bound>& bounds, int degree) {
    Distance found;
    for (const Bound& bound : bounds) {
      const double distance = approximation_bound(bound.of_kernel, bound.g, degree);
      found.of_kernel = std::min(found.of_kernel, distance);
      found.with_weight = std::min(found.with_weight, distance * bound.weight * up);
    }
    return found;
  };
  const double weight_a = in_a.at(1).weight;
  const double weight_b = in_b.at(1).weight;
  // Beyond it Lebesgue constants and work grow faster than the rest falls.
  constexpr int largest_looked = 18;
  // A quarter of the share; the rest is for what is measured.
  constexpr double part = 0.25;
  for (int degree = least; degree <= largest_looked; ++degree) {
    const double constant = interpolation_bounds(degree).exact;
    const Distance in_x = least_of(of_a, degree);
    const Distance in_y = least_of(of_b, degree);
    const Rest found{.degree = degree,
                     .a = (1 + constant) * (in_x.of_kernel * weight_b + constant * in_y.with_weight) * up,
                     .b = (1 + constant) * (in_y.of_kernel * weight_a + constant * in_x.with_weight) * up};
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
  const KernelValues fine_rows_a = weighted(fine, fine_b);
  const KernelValues fine_rows_b = weighted(transposed(fine, fine_a.at.size()), fine_a);
  const double factor = demand_.functions_size * std::numbers::inv_pi * up;
  constexpr int more_degrees = 3;
  const int most = std::min({left->degree, demand_.largest_degree, guess->degree + more_degrees});
  for (int degree = guess->degree; degree <= most; ++degree) {
    const Nodes& in_a = outlines_.nodes(a, degree);
    const Nodes& in_b = outlines_.nodes(b, degree);
    const KernelValues coarse = kernel_values(in_a, in_b);
    const Differences rows_a = differences(fine_rows_a, weighted(coarse, in_b), degree, left->degree);
    CouplingDegree found{.degree = degree};
    found.error_a = factor * (measured(rows_a, left->degree) + left->a) * up;
    if (!(found.error_a <= demand_.share)) continue;
    const Differences rows_b =
        differences(fine_rows_b, weighted(transposed(coarse, in_a.at.size()), in_a), degree, left->degree);
    found.error_b = factor * (measured(rows_b, left->degree) + left->b) * up;
    if (found.error_b <= demand_.share) return found;
  }
  return std::nullopt;
}

}  // namespace radcert
