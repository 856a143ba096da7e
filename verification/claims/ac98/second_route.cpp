// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/second_route.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/expression/batch.h"
#include "radcert/formats/result/level_record.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/triangulation/interpolated_surface.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/framework/stored_number.h"

namespace radcert::verification::ac98 {
namespace {

using Parameters = ParameterPoint<double>;

// Linear functions of the three barycentric coordinates, or the constant 1.
class PlainBasis {
public:
  explicit PlainBasis(const TriangleBasisChoice& choice)
      : degree_(choice.degree), alpha_(choice.degree == 0 ? 0 : choice.alpha.value().to_double()) {
    expects(degree_ == 0 || degree_ == 1, "degree 0 or 1", named("degree", degree_));
  }
  std::size_t size() const { return degree_ == 0 ? 1 : 3; }
  std::array<double, 3> node(std::size_t j) const {
    if (degree_ == 0) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
    std::array<double, 3> x{alpha_, alpha_, alpha_};
    x.at(j) = 1 - 2 * alpha_;
    return x;
  }
  double value(std::size_t j, const std::array<double, 3>& x) const {
    return degree_ == 0 ? 1 : (x.at(j) - alpha_) / (1 - 3 * alpha_);
  }

private:
  int degree_;
  double alpha_;
};

std::array<double, 3> barycentric(const ParameterTriangle& triangle, const Parameters& at) {
  const auto& v = triangle.vertices;
  const double area = cross(v[1] - v[0], v[2] - v[0]);
  const double x2 = cross(at - v[0], v[2] - v[0]) / area;
  const double x3 = cross(v[1] - v[0], at - v[0]) / area;
  return {1 - x2 - x3, x2, x3};
}

// What stands beside the functions l_j under the integral.
enum class Remainder {
  error,           // u - P_n u
  solution,        // u
  minus_projected  // -P_n u
};

// The level laid out: triangles, nodes, and the data at the nodes.
struct Level {
  Surface surface;
  std::vector<ParameterTriangle> triangles;
  PlainBasis basis;
  std::vector<SurfacePoint<double>> nodes;
  std::vector<double> u;       // by node
  std::vector<double> factor;  // rho/pi by node
  const Problem* problem;
  Remainder remainder = Remainder::error;
  std::vector<CompiledExpression> compiled;  // of the solution, by chart

  Level(const Problem& of, int level)
      : surface(surface_of(of)),
        triangles(triangulate(surface, level).triangles),
        basis(triangle_basis_of(of.method)),
        problem(&of) {
    expects(of.solution.has_value(), "a problem with a solution");
    expects(of.triangulation.pattern.empty() && of.triangulation.grading == Rational(1),
            "a triangulation without options");
    expects(!of.geometry || of.geometry->data == DataPoints::surface, "data on the surface");
    compile_solution();
    for (const ParameterTriangle& triangle : triangles)
      for (std::size_t j = 0; j < basis.size(); ++j) {
        const SurfacePoint<double> p{triangle.chart, triangle.at(basis.node(j))};
        const Vector<double> x = surface.charts[p.chart].in<double>().frame(p.at).point;
        nodes.push_back(p);
        u.push_back(solution(p.chart, x));
        factor.push_back(of.reflectivity.on(piece(p.chart)).evaluate<double>({x.x, x.y, x.z}) /
                         std::numbers::pi);
      }
  }

  // The same elements and nodes on the interpolant, with the data of S.
  Level interpolated(int degree) const {
    Level other = *this;
    InterpolatedSurface interpolant = interpolate(surface, {triangles}, degree);
    other.surface = std::move(interpolant.surface);
    other.triangles = std::move(interpolant.triangulation.triangles);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const ParameterTriangle& triangle = other.triangles[i / basis.size()];
      other.nodes[i] = {triangle.chart, triangle.at(basis.node(i % basis.size()))};
    }
    other.compile_solution();
    return other;
  }
  void compile_solution() {
    compiled.clear();
    for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
      compiled.emplace_back(problem->solution->on(piece(chart)));
  }
  const std::string& piece(std::size_t chart) const { return surface.charts[chart].facts().piece; }
  double solution(std::size_t chart, const Vector<double>& x) const {
    return problem->solution->on(piece(chart)).evaluate<double>({x.x, x.y, x.z});
  }
  const CompiledExpression& compiled_solution(std::size_t chart) const { return compiled[chart]; }
  bool blind(std::size_t node, std::size_t triangle) const {
    return in_one_plane(surface.charts[nodes[node].chart], surface.charts[triangles[triangle].chart]);
  }
};

// What is integrated against G over an element: the remainder, and behind it the basis functions l_j where
// they are asked for.
constexpr std::size_t most_densities = 4;
using Values = std::array<double, most_densities>;

// A point of a cubature rule on a triangle of the parameter plane.
struct Sample {
  Parameters at;
  Vector<double> point;
  Vector<double> weighted_normal;  // with the area element and the weight
  Values density;
};

// Two products of Gauss rules on the square, collapsed onto a triangle: what they differ by is the estimate.
constexpr std::size_t coarse_count = 36;
struct Samples {
  std::vector<Sample> all;  // the coarse rule, then the fine one
};

// Abscissas and weights on [0, 1].
template <unsigned count>
std::array<std::array<double, 2>, count> gauss_rule() {
  using Rule = boost::math::quadrature::gauss<double, count>;
  std::array<std::array<double, 2>, count> rule{};
  std::size_t filled = 0;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    const double x = Rule::abscissa()[i];
    const double w = Rule::weights()[i] / 2;
    rule.at(filled++) = {(1 + x) / 2, w};
    if (x != 0) rule.at(filled++) = {(1 - x) / 2, w};
  }
  return rule;
}

template <unsigned count>
void add_samples(const Level& level, std::size_t k, const std::array<Parameters, 3>& corners,
                 Samples& samples) {
  static const auto rule = gauss_rule<count>();
  const ParameterTriangle& element = level.triangles[k];
  const ChartIn<double>& chart = level.surface.charts[element.chart].in<double>();
  const double doubled_area = std::abs(cross(corners[1] - corners[0], corners[2] - corners[0]));
  const std::size_t m = level.basis.size();
  std::array<double, count * count> x{};
  std::array<double, count * count> y{};
  std::array<double, count * count> z{};
  std::array<double, count * count> u{};
  const std::size_t first = samples.all.size();
  for (const auto& [r, w] : rule)
    for (const auto& [side, v] : rule) {
      Sample sample{};
      sample.at = corners[0] + r * ((corners[1] - corners[0]) + side * (corners[2] - corners[1]));
      const Frame<double> frame = chart.frame(sample.at);
      sample.point = frame.point;
      sample.weighted_normal = (w * v * r * doubled_area) * frame.area_normal;
      const std::size_t here = samples.all.size() - first;
      x.at(here) = frame.point.x;
      y.at(here) = frame.point.y;
      z.at(here) = frame.point.z;
      samples.all.push_back(sample);
    }
  level.compiled_solution(element.chart).evaluate(x, y, z, u);
  for (std::size_t i = 0; i < u.size(); ++i) {
    Sample& sample = samples.all[first + i];
    const std::array<double, 3> barycentric_at = barycentric(element, sample.at);
    const bool projected = level.remainder != Remainder::solution;
    sample.density[0] = level.remainder == Remainder::minus_projected ? 0 : u.at(i);
    for (std::size_t j = 0; j < m; ++j) {
      sample.density.at(j + 1) = level.basis.value(j, barycentric_at);
      if (projected) sample.density[0] -= level.u[k * m + j] * sample.density.at(j + 1);
    }
  }
}

Samples samples_on(const Level& level, std::size_t k, const std::array<Parameters, 3>& corners) {
  Samples samples;
  samples.all.reserve(100);
  add_samples<6>(level, k, corners, samples);
  add_samples<8>(level, k, corners, samples);
  return samples;
}

// Integrals over one element with estimates of their errors.
struct Integrals {
  Values value{};
  Values radius{};
};

// The integrals over elements of G(P,Q) times each density, P a node.
class Cubature {
public:
  Cubature(const Level& level, bool with_basis)
      : level_(&level), densities_(with_basis ? 1 + level.basis.size() : 1) {
    for (std::size_t k = 0; k < level.triangles.size(); ++k) {
      elements_.push_back(samples_on(level, k, level.triangles[k].vertices));
      for (const Sample& sample : elements_.back().all)
        for (std::size_t c = 0; c < densities_; ++c)
          scale_.at(c) = std::max(scale_.at(c), std::abs(sample.density.at(c)));
    }
  }

  // rho/pi Int over element k.
  Integrals over(std::size_t node, std::size_t k) const {
    Integrals sum;
    if (level_->blind(node, k)) return sum;
    const SurfacePoint<double>& p = level_->nodes[node];
    const Frame<double> frame = level_->surface.charts[p.chart].in<double>().frame(p.at);
    const Observer observer{.at = p.at,
                            .point = frame.point,
                            .normal = unit_normal(frame),
                            .chart = p.chart == level_->triangles[k].chart
                                         ? &level_->surface.charts[p.chart].in<double>()
                                         : nullptr};
    add(observer, k, level_->triangles[k].vertices, elements_[k], 0, sum);
    for (std::size_t c = 0; c < densities_; ++c) {
      sum.value.at(c) *= level_->factor[node];
      sum.radius.at(c) *= level_->factor[node];
    }
    return sum;
  }

private:
  struct Observer {
    Parameters at;
    Vector<double> point;
    Vector<double> normal;
    const ChartIn<double>* chart;  // set where the element lies on the observer's own chart
  };
  static constexpr double tolerance = 1e-9;  // of area times the largest density
  static constexpr int deepest = 15;         // G is bounded, and what is left has 4^-15 of an element

  double kernel(const Observer& observer, const Sample& sample) const {
    if (observer.chart == nullptr)
      return geometric_kernel(observer.point, observer.normal, sample.point, sample.weighted_normal);
    const Parameters step = sample.at - observer.at;
    if (step.s == 0 && step.t == 0) return 0;
    return chord_kernel(observer.chart->chord(observer.at, step), observer.normal, sample.weighted_normal);
  }

  void add(const Observer& observer, std::size_t k, const std::array<Parameters, 3>& corners,
           const Samples& samples, int depth, Integrals& sum) const {
    Values coarse{};
    Values fine{};
    for (std::size_t i = 0; i < samples.all.size(); ++i) {
      const Sample& sample = samples.all[i];
      const double g = kernel(observer, sample);
      Values& rule = i < coarse_count ? coarse : fine;
      for (std::size_t c = 0; c < densities_; ++c) rule[c] += g * sample.density[c];
    }
    const double area = std::abs(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
    bool accepted = true;
    for (std::size_t c = 0; c < densities_; ++c)
      accepted = accepted && std::abs(fine.at(c) - coarse.at(c)) <= tolerance * area * scale_.at(c);
    if (accepted || depth == deepest) {
      for (std::size_t c = 0; c < densities_; ++c) {
        sum.value.at(c) += fine.at(c);
        sum.radius.at(c) += std::abs(fine.at(c) - coarse.at(c)) + 1e-15 * std::abs(fine.at(c));
      }
      return;
    }
    const std::array<Parameters, 3> middles{0.5 * (corners[1] + corners[2]), 0.5 * (corners[2] + corners[0]),
                                            0.5 * (corners[0] + corners[1])};
    const std::array<std::array<Parameters, 3>, 4> children{{{corners[0], middles[2], middles[1]},
                                                             {middles[2], corners[1], middles[0]},
                                                             {middles[1], middles[0], corners[2]},
                                                             {middles[0], middles[1], middles[2]}}};
    for (const std::array<Parameters, 3>& child : children)
      add(observer, k, child, samples_on(*level_, k, child), depth + 1, sum);
  }

  const Level* level_;
  std::size_t densities_;
  Values scale_{};
  std::vector<Samples> elements_;
};

// r_i = rho/pi Int G times the remainder, from node i, and, where asked for, A_ij = K l_j (v_i) row by row.
struct System {
  std::vector<Approximation> r;
  std::vector<Approximation> a;
};

System system_of(const Level& level, bool with_matrix) {
  const Cubature cubature(level, with_matrix);
  const std::size_t m = level.basis.size();
  const std::size_t size = level.nodes.size();
  System system{
      .r = std::vector<Approximation>(size, Approximation{.value = 0, .radius = 0}),
      .a = std::vector<Approximation>(with_matrix ? size * size : 0, Approximation{.value = 0, .radius = 0})};
  parallel_for(size, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t k = 0; k < level.triangles.size(); ++k) {
        const Integrals part = cubature.over(i, k);
        system.r[i].value += part.value[0];
        system.r[i].radius += part.radius[0];
        if (!with_matrix) continue;
        for (std::size_t j = 0; j < m; ++j)
          system.a[i * size + k * m + j] = {.value = part.value.at(j + 1), .radius = part.radius.at(j + 1)};
      }
  });
  return system;
}

// With interpolated geometry: r = Ku over S from v_i, less K~ P_n u over the interpolant from v~_i; A over
// the interpolant.
System system_of(const Problem& problem, int level, bool with_matrix) {
  Level exact(problem, level);
  if (!problem.geometry) return system_of(exact, with_matrix);
  Level interpolant = exact.interpolated(problem.geometry->degree);
  exact.remainder = Remainder::solution;
  interpolant.remainder = Remainder::minus_projected;
  System system = system_of(interpolant, with_matrix);
  const System solution = system_of(exact, false);
  for (std::size_t i = 0; i < system.r.size(); ++i) {
    system.r[i].value += solution.r[i].value;
    system.r[i].radius += solution.r[i].radius;
  }
  return system;
}

// x = b + A x by repetition, to machine precision; nothing where it does not converge.
std::optional<std::vector<double>> fixed_point(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> x = b;
  for (int step = 0; step < 2000; ++step) {
    double change = 0;
    double largest = 0;
    std::vector<double> next = b;
    for (std::size_t i = 0; i < b.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) next[i] += a[i * b.size() + j] * x[j];
      change = std::max(change, std::abs(next[i] - x[i]));
      largest = std::max(largest, std::abs(next[i]));
    }
    x = std::move(next);
    if (!std::isfinite(largest)) return std::nullopt;
    if (change <= 4 * std::numeric_limits<double>::epsilon() * largest) return x;
  }
  return std::nullopt;
}

double largest(const std::vector<double>& x) {
  double out = 0;
  for (const double each : x) out = std::max(out, std::abs(each));
  return out;
}

Approximation discretisation_error(const std::vector<Approximation>& r) {
  Approximation out{.value = 0, .radius = 0};
  for (const Approximation& each : r) {
    out.value = std::max(out.value, std::abs(each.value));
    out.radius = std::max(out.radius, each.radius);
  }
  return out;
}

Approximation node_error(const System& system) {
  const std::vector<Approximation>& r = system.r;
  const std::vector<Approximation>& entries = system.a;
  const std::size_t size = r.size();
  std::vector<double> a(entries.size());
  std::vector<double> moduli(entries.size());
  std::vector<double> b(size);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    a[i] = entries[i].value;
    moduli[i] = std::abs(entries[i].value) + entries[i].radius;
  }
  for (std::size_t i = 0; i < size; ++i) b[i] = r[i].value;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const auto e = fixed_point(a, b);
  const auto amplification = fixed_point(moduli, std::vector<double>(size, 1.0));
  if (!e || !amplification) return {.value = 0, .radius = unknown};
  // (I - A) delta e = delta r + (delta A) e, and (I - A)^-1 is at most (I - |A|)^-1 entry by entry.
  double disturbance = 0;
  for (std::size_t i = 0; i < size; ++i) {
    double sum = r[i].radius + 1e-15 * largest(*e);
    for (std::size_t j = 0; j < size; ++j) sum += entries[i * size + j].radius * std::abs((*e)[j]);
    disturbance = std::max(disturbance, sum);
  }
  return {.value = largest(*e), .radius = disturbance * largest(*amplification)};
}

}  // namespace

Approximation second_route(const Bench& bench, const Problem& problem, int level, const std::string& figure) {
  expects(figure == "discretisation_error" || figure == "node_error", "a figure that the second route knows",
          named("figure", figure));
  return stored(bench.store, "second route, " + figure + "\n" + level_key(problem, level), [&] {
    const bool solve = figure == "node_error";
    const System system = system_of(problem, level, solve);
    return solve ? node_error(system) : discretisation_error(system.r);
  });
}

}  // namespace radcert::verification::ac98
