// SPDX-License-Identifier: GPL-3.0-or-later

// With alpha = 0 the nodes are the vertices, which S and its interpolant share. Each element there has a
// normal of its own, (89); in the place of n_P stands the mean of them, of unit length. It is off by some
// angle from the normal of every element at P, so that cos(theta_P) does not vanish in the limit Q -> P, and
// G grows like that angle times the curvature over |P-Q|: too fast to be bounded, slowly enough to be
// integrated in triangles that collapse at P, whose Jacobian has the factor |P-Q|.
//
// Checked      section_4_2_averaged_normals: the order of the node error on the sphere, r = 1 at quick, 1 and
//              2 at standard, 1 to 4 at full, against min(2, r); and that Int G differs from pi by O(h^(2r))
//              for r = 2, which an integral over the node's own elements that is off by any
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
#include "radcert/solve/direct.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/interpolated_surface.h"
#include "verification/claims/ac98/collocation/curved_element.h"
#include "verification/framework/check.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

double exponential(const Vector<double>& point) { return std::exp(point.x); }

/// An element of the interpolant, with the numbers of its vertices.
struct Element {
  CurvedElement surface;
  std::array<std::size_t, 3> vertex;
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
    constexpr int order_of_rules = 6;
    elements.push_back({{chart, triangle.vertices, exponential, order_of_rules}, numbers});
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

/// The integrals over an element from a vertex, around it where it is one of the element's own.
ElementSums sums_from(const FromPoint& from, std::size_t node, const Element& element) {
  for (std::size_t apex = 0; apex < 3; ++apex)
    if (element.vertex.at(apex) == node) {
      std::array<double, 3> x{};
      x.at(apex) = 1;
      return from.around(element.surface, x, 2 * element.surface.order());
    }
  return from.over(element.surface);
}

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
      const ElementSums sums = sums_from(from, i, element);
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
  const bool quick = bench.budget == Budget::quick;
  const int largest_degree = quick ? 1 : bench.budget == Budget::standard ? 2 : 4;
  // With curved elements the order shows from finer levels on.
  const std::vector<int> levels = quick ? levels_from(2, 4) : levels_from(3, 5);
  const auto order_of = [&](const std::vector<VertexErrors>& errors, double VertexErrors::*which) {
    std::size_t next = 0;
    return observed_order(over_levels(levels, [&](int) { return figure(errors.at(next++).*which); }));
  };
  Finding finding;
  for (int degree = 1; degree <= largest_degree; ++degree) {
    const std::string with = ", alpha = 0, means of the normals, sphere, r = " + std::to_string(degree);
    std::vector<VertexErrors> errors;
    for (const int level : levels) errors.push_back(vertex_errors(level, degree, NodeNormals::means));
    const ObservedOrder order = order_of(errors, &VertexErrors::of_solution);
    finding.require("order of the node error" + with, Order::at_least(std::min(2, degree)), order);
    // From P the interpolant fills the solid angle of a half space but for a rim as wide as the normals are
    // off, on which the cosine is as small.
    if (degree == 2)
      finding.require("order of the largest |Int G - pi| over the nodes" + with, Order::at_least(2 * degree),
                      order_of(errors, &VertexErrors::of_pi));
    // A plane element has one normal: the means do not make up for the degree of the interpolant.
    if (degree == 1)
      finding.control("order of the largest |Int G - pi| over the nodes against that of r = 2" + with,
                      Order::at_least(4), order_of(errors, &VertexErrors::of_pi));
    finding.show(order.exponent);
    finding.remark(
        "its quotient by that with the normals of the sphere" + with,
        Approximation{.value = errors.back().of_solution /
                               vertex_errors(levels.back(), degree, NodeNormals::of_the_sphere).of_solution,
                      .radius = 0});
  }
  return finding;
}

}  // namespace radcert::verification::ac98
