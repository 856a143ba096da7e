// SPDX-License-Identifier: GPL-3.0-or-later

// With alpha = 0 the nodes are the vertices, which S and its interpolant share. Each element there has a
// normal of its own, (89); in the place of n_P stands the mean of them, of unit length. It is off by some
// angle from the normal of every element at P, so that cos(theta_P) does not vanish in the limit Q -> P, and
// G grows like that angle times the curvature over |P-Q|: too fast to be bounded, slowly enough to be
// integrated in triangles that collapse at P, whose Jacobian has the factor |P-Q|.
//
// Checked      section_4_2_averaged_normals: the order of the node error on the sphere, r = 1 to 4, against
//              that of alpha = 0 with the normals of S itself, and against h^r; and that Int G differs from
//              pi by O(h^(2r)) for r = 2, which an integral over the node's own elements that is off by any
//              power of h would not leave. On the sphere G = 1/4, so that E = u - Ku needs no quadrature.
// Not checked  surfaces other than the sphere; u other than exp(x).

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/core/parallel.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/solve/direct.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/interpolated_surface.h"
#include "verification/claims/ac98/collocation/observed_order.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

/// A point of an element, with what a rule needs of it.
struct Sample {
  std::array<double, 3> x{};  ///< barycentric coordinates in the element: the values of the linear functions
  Vector<double> point;
  Vector<double> normal;  ///< inner, with the length of the rule's weight times the area element
};

using Corners =
    std::array<std::array<double, 3>, 3>;  ///< of a triangle, in barycentric coordinates of an element
constexpr Corners whole{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// An element of the interpolant.
class Element {
public:
  Element(const ChartIn<double>& chart, const std::array<ParameterPoint<double>, 3>& triangle,
          const std::array<std::size_t, 3>& vertices)
      : vertex(vertices), chart_(&chart), triangle_(triangle) {
    samples = by(whole, plain_rule());
    for (std::size_t i = 0; i < 3; ++i)
      diameter = std::max(diameter, norm(at(whole.at(i)).point - at(whole.at((i + 1) % 3)).point));
  }

  Frame<double> at(const std::array<double, 3>& x) const {
    return chart_->frame(x[0] * triangle_[0] + x[1] * triangle_[1] + x[2] * triangle_[2]);
  }

  /// The samples of a rule on a part of it.
  std::vector<Sample> by(const Corners& corners, const TriangleRule<double>& rule) const {
    const auto& [a, b, c] = corners;
    const double part = std::abs(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                                 a[2] * (b[0] * c[1] - b[1] * c[0]));
    const double jacobian = part * std::abs(cross(triangle_[1] - triangle_[0], triangle_[2] - triangle_[0]));
    std::vector<Sample> all;
    all.reserve(rule.points.size());
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      Sample sample;
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) sample.x.at(k) += rule.points[i].x.at(j) * corners.at(j).at(k);
      const Frame<double> frame = at(sample.x);
      sample.point = frame.point;
      sample.normal = jacobian * rule.weights[i] * frame.area_normal;
      all.push_back(sample);
    }
    return all;
  }

  static const TriangleRule<double>& plain_rule() {
    static const TriangleRule<double> rule = conical_rule<double>(6, Grading::none);
    return rule;
  }

  std::array<std::size_t, 3> vertex;  ///< numbers
  double diameter = 0;
  std::vector<Sample> samples;  ///< of the plain rule on all of it

private:
  const ChartIn<double>* chart_;
  std::array<ParameterPoint<double>, 3> triangle_;
};

struct Vertex {
  Vector<double> point;
  Vector<double> mean_normal{0, 0, 0};
};

/// The sphere's interpolant of a degree, with its vertices numbered.
class VertexMesh {
public:
  VertexMesh(int level, int degree)
      : sphere_(sphere()), interpolant_(interpolate(sphere_, triangulate(sphere_, level), degree)) {
    for (const ParameterTriangle& triangle : interpolant_.triangulation.triangles) add(triangle);
    for (Vertex& each : vertices) each.mean_normal = (1 / norm(each.mean_normal)) * each.mean_normal;
  }

  std::vector<Element> elements;
  std::vector<Vertex> vertices;

private:
  void add(const ParameterTriangle& triangle) {
    const ChartIn<double>& chart = interpolant_.surface.charts[triangle.chart].in<double>();
    std::array<std::size_t, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Frame<double> frame = chart.frame(triangle.vertices.at(i));
      numbers.at(i) = number_of(frame.point);
      Vertex& vertex = vertices[numbers.at(i)];
      vertex.mean_normal = vertex.mean_normal + unit_normal(frame);
    }
    elements.emplace_back(chart, triangle.vertices, numbers);
  }

  // Keys are coordinates in units far below the distance of vertices and far above rounding.
  std::size_t number_of(const Vector<double>& point) {
    constexpr double unit = 1e-9;
    const auto rounded = [](double x) { return std::lround(x / unit); };
    const auto [place, is_new] =
        numbers_.try_emplace({rounded(point.x), rounded(point.y), rounded(point.z)}, vertices.size());
    if (is_new) vertices.push_back({.point = point});
    return place->second;
  }

  Surface sphere_;
  InterpolatedSurface interpolant_;
  std::map<std::tuple<long, long, long>, std::size_t> numbers_;
};

using Sums = std::array<double, 3>;  ///< Int G x_i over an element, x_i the linear functions of its vertices

/// Int G x_i dS over elements from one point with a given normal there.
class FromPoint {
public:
  FromPoint(const Vector<double>& point, const Vector<double>& normal) : point_(point), normal_(normal) {}

  Sums over(const Element& element, std::size_t node) const {
    for (std::size_t apex = 0; apex < 3; ++apex)
      if (element.vertex.at(apex) == node) {
        const Corners corners{whole.at(apex), whole.at((apex + 1) % 3), whole.at((apex + 2) % 3)};
        return sum(element.by(corners, collapsed_at_first()));
      }
    const double distance = norm(element.at({1.0 / 3, 1.0 / 3, 1.0 / 3}).point - point_);
    return distance >= element.diameter ? sum(element.samples) : divided(element, whole, element.diameter);
  }

private:
  // In (l, t) with x = (1 - l, l (1 - t), l t) the product of G and the Jacobian's factor l is analytic up to
  // l = 0; G alone is not, so that l belongs to the integrand and not to the weight.
  static const TriangleRule<double>& collapsed_at_first() {
    static const TriangleRule<double> rule = [] {
      const IntervalRule<double> gauss = gauss_rule<double>(12, IntervalWeight::one);
      TriangleRule<double> product;
      for (std::size_t i = 0; i < gauss.nodes.size(); ++i)
        for (std::size_t j = 0; j < gauss.nodes.size(); ++j) {
          const double l = gauss.nodes[i];
          const double t = gauss.nodes[j];
          product.points.push_back({{1 - l, l * (1 - t), l * t}});
          product.weights.push_back(gauss.weights[i] * gauss.weights[j] * l);
        }
      return product;
    }();
    return rule;
  }

  // Divided until a triangle is no larger than its distance.
  Sums divided(const Element& element, const Corners& corners, double diameter) const {
    const auto middle = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
      return std::array<double, 3>{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    };
    std::array<double, 3> centre{};
    for (const auto& corner : corners)
      for (std::size_t i = 0; i < 3; ++i) centre.at(i) += corner.at(i) / 3;
    if (norm(element.at(centre).point - point_) >= diameter)
      return sum(element.by(corners, Element::plain_rule()));
    const std::array<double, 3> a = middle(corners[1], corners[2]);
    const std::array<double, 3> b = middle(corners[2], corners[0]);
    const std::array<double, 3> c = middle(corners[0], corners[1]);
    Sums sums{};
    for (const Corners& part : {Corners{corners[0], c, b}, Corners{c, corners[1], a},
                                Corners{b, a, corners[2]}, Corners{a, b, c}}) {
      const Sums of_part = divided(element, part, diameter / 2);
      for (std::size_t i = 0; i < 3; ++i) sums.at(i) += of_part.at(i);
    }
    return sums;
  }

  Sums sum(const std::vector<Sample>& samples) const {
    Sums sums{};
    for (const Sample& each : samples) {
      const double value = geometric_kernel(point_, normal_, each.point, each.normal);
      for (std::size_t k = 0; k < 3; ++k) sums[k] += value * each.x[k];
    }
    return sums;
  }

  Vector<double> point_;
  Vector<double> normal_;
};

/// Whose normals stand at the nodes.
enum class NodeNormals { means, of_the_sphere };

struct VertexErrors {
  double of_solution = 0;  ///< max |u(v_i) - u_n(v_i)|
  double of_pi = 0;        ///< max |Int G - pi|
};

/// For u = exp(x) and rho = 1/2 on the sphere: Ku is rho times the mean of u, sinh(1)/2.
VertexErrors vertex_errors(int level, int degree, NodeNormals normals) {
  constexpr double rho = 0.5;
  const VertexMesh mesh(level, degree);
  const std::size_t count = mesh.vertices.size();
  Matrix<double> k(count, count);
  const auto fill_row = [&](std::size_t i) {
    const Vertex& node = mesh.vertices[i];
    const FromPoint from(
        node.point, normals == NodeNormals::means ? node.mean_normal : -1.0 / norm(node.point) * node.point);
    for (const Element& element : mesh.elements) {
      const Sums sums = from.over(element, i);
      for (std::size_t j = 0; j < 3; ++j) k(i, element.vertex.at(j)) += rho * sums.at(j) / std::numbers::pi;
    }
  };
  parallel_for(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fill_row(i);
  });
  std::vector<double> emission;
  for (const Vertex& each : mesh.vertices) emission.push_back(std::exp(each.point.x) - rho * std::sinh(1.0));
  const std::vector<double> u = DirectSolver(k).solve(emission);
  VertexErrors largest;
  for (std::size_t i = 0; i < count; ++i) {
    double row = 0;
    for (std::size_t j = 0; j < count; ++j) row += k(i, j);
    largest.of_pi = std::max(largest.of_pi, std::numbers::pi * std::abs(row / rho - 1));
    largest.of_solution = std::max(largest.of_solution, std::abs(u[i] - std::exp(mesh.vertices[i].point.x)));
  }
  return largest;
}

// The rules of twice the order move no error by more than a thousandth of it at the levels taken.
Approximation figure(double error) { return {.value = error, .radius = error / 1000}; }

}  // namespace

Finding section_4_2_averaged_normals(const Bench& bench) {
  const int finest = bench.budget == Budget::full ? 5 : 4;
  const int largest_degree = bench.budget == Budget::quick ? 2 : 4;
  const auto bound_of = [](int order) {
    return Bound{.order = order * 1.0, .slack = 0.4, .why = "elements of size 1/8 and 1/16"};
  };
  Finding finding;
  for (int degree = 1; degree <= largest_degree; ++degree) {
    const std::string with = ", alpha = 0, means of the normals, sphere, r = " + std::to_string(degree);
    const VertexErrors coarse = vertex_errors(finest - 1, degree, NodeNormals::means);
    const VertexErrors fine = vertex_errors(finest, degree, NodeNormals::means);
    const Approximation order = order_between(figure(coarse.of_solution), figure(fine.of_solution));
    finding.require("order of the node error" + with, bound_of(std::min(2, degree)), order);
    // From P the interpolant fills the solid angle of a half space but for a rim as wide as the normals are
    // off, on which the cosine is as small.
    if (degree == 2) {
      finding.require("order of the largest |Int G - pi| over the nodes" + with, bound_of(2 * degree),
                      order_between(figure(coarse.of_pi), figure(fine.of_pi)));
      finding.show(order);
    }
    finding.remark(
        "its quotient by that with the normals of the sphere" + with,
        Approximation{
            .value = fine.of_solution / vertex_errors(finest, degree, NodeNormals::of_the_sphere).of_solution,
            .radius = 0});
  }
  finding.control("order of the node error against 4, alpha = 0, normals of the sphere, r = 4", bound_of(4),
                  order_between(figure(vertex_errors(finest - 1, 4, NodeNormals::of_the_sphere).of_solution),
                                figure(vertex_errors(finest, 4, NodeNormals::of_the_sphere).of_solution)));
  return finding;
}

}  // namespace radcert::verification::ac98
