// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated rows of closed surfaces, whose sum is pi at every node.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/text.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/smooth_components.h"
#include "radcert/quadrature/element_integrator.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/attack/attack.h"
#include "tests/attack/random_problem.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert::attack {
namespace {

/// What is wrong with a row's sum, which is made exactly; empty if nothing.
std::string fault_of_row(std::size_t row, std::span<const double> terms, const Ball& exact, double radius) {
  const BallPrecision precision(256);
  Ball off = -exact;
  for (const double term : terms) off += Ball(term);
  if (off.is_finite() && !certainly_less(Ball(radius), abs(off))) return {};
  return "row " + std::to_string(row) + " is off by " + off.to_text(5) + ", radius " + shortest(radius);
}

/// What is wrong with a few rows of a closed surface; empty if nothing.
/// Maths     sum_k sum_j Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q = pi
std::string fault_of_some_rows(const Surface& surface, int level, int degree, double alpha, double tolerance,
                               std::span<const std::size_t> places) {
  const Triangulation triangulation = triangulate(surface, level);
  const InsetBasis<double> basis(degree, alpha);
  const TriangleBasis<double> functions(basis);
  const auto nodes = collocation_nodes<double>(surface, triangulation, basis);
  const auto scheme =
      std::make_shared<const IntegrationScheme<double>>(surface, functions, Tolerance(tolerance));
  std::vector<ElementIntegrator<double>> elements;
  for (const ParameterTriangle& triangle : triangulation.triangles) elements.emplace_back(scheme, triangle);
  for (const std::size_t place : places) {
    const std::size_t row = place % nodes.size();
    std::vector<double> terms;
    double radius = 0;
    for (ElementIntegrator<double>& element : elements) {
      const ElementIntegral<double> integral = element.integrate(nodes[row]);
      for (std::size_t j = 0; j < functions.size(); ++j) {
        terms.push_back(integral.value[j]);
        radius += integral.radius[j];
      }
    }
    const std::string fault = fault_of_row(row, terms, Ball::pi(), radius);
    if (!fault.empty()) return fault;
  }
  return {};
}

/// What is wrong with the rows of a closed surface's matrix; empty if nothing.
std::string fault_of_rows(const Surface& surface, int level, int degree, double alpha, double tolerance) {
  const Triangulation triangulation = triangulate(surface, level);
  const InsetBasis<double> basis(degree, alpha);
  const auto nodes = collocation_nodes<double>(surface, triangulation, basis);
  const CollocationMatrix<double> matrix = assemble<double>(
      surface, triangulation, basis, nodes, std::vector<double>(nodes.size(), 1.0), Tolerance(tolerance));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::vector<double> terms;
    for (std::size_t j = 0; j < nodes.size(); ++j) terms.push_back(matrix.entries(i, j));
    const std::string fault = fault_of_row(i, terms, Ball(1), matrix.row_radius[i]);
    if (!fault.empty()) return fault;
  }
  return {};
}

struct Closed {
  RandomSurface surface;
  int level = 0;
  int degree = 0;
  double alpha = 0;
  double tolerance = 1e-13;
  std::array<std::size_t, 2> places{};  ///< of rows, where the matrix costs too much
};

Judgement judge(const Closed& c) {
  constexpr std::size_t few = 20;
  const Surface surface = c.surface.made();
  const std::size_t unknowns = triangulate(surface, c.level).triangles.size() *
                               static_cast<std::size_t>((c.degree + 1) * (c.degree + 2) / 2);
  // Without parameters nothing is extreme, and whole blocks of nodes cost little.
  const bool whole = unknowns <= few || (c.surface.values.empty() && unknowns <= 200);
  const std::string fault =
      whole ? fault_of_rows(surface, c.level, c.degree, c.alpha, c.tolerance)
            : fault_of_some_rows(surface, c.level, c.degree, c.alpha, c.tolerance, c.places);
  return fault.empty() ? Judgement::held() : Judgement::violated(fault);
}

TEST(ClosedRowsAttack, SumToPiWithinTheirRadii) {
  hold(Attack<Closed>{.name = "estimated rows of closed surfaces",
                      .usual_instances = 12,
                      .make =
                          [](Draw& draw) {
                            Closed c;
                            c.surface = random_surface(draw, true);
                            c.level = draw.below(5) == 0 ? 1 : 0;
                            c.degree = static_cast<int>(draw.below(4));
                            const double alphas[] = {1.0 / 6, 0.1, 0.3, 1e-2, 1e-5};
                            c.alpha = c.degree == 0 ? 0 : alphas[draw.below(5)];
                            c.tolerance = std::array{1e-13, 1e-13, 1e-7, 1e-4, 1e-2}[draw.below(5)];
                            c.places = {draw.below(1U << 20U), draw.below(1U << 20U)};
                            return c;
                          },
                      .judge = judge,
                      .text =
                          [](const Closed& c) {
                            return c.surface.text() + ", level " + std::to_string(c.level) + ", degree " +
                                   std::to_string(c.degree) + ", alpha " + shortest(c.alpha) +
                                   ", tolerance " + shortest(c.tolerance);
                          },
                      .smaller =
                          [](const Closed& c) {
                            std::vector<Closed> found;
                            if (c.level > 0) {
                              found.push_back(c);
                              found.back().level = 0;
                            }
                            for (int degree = 0; degree < c.degree; ++degree) {
                              found.push_back(c);
                              found.back().degree = degree;
                              if (degree == 0) found.back().alpha = 0;
                            }
                            return found;
                          }});
}

/// A closed mesh parts of which hide others, stretched.
struct Room {
  std::size_t shape = 0;
  Vector<double> stretch;
  Vector<double> place;  ///< of the inner cube
  double side = 0.5;
  int degree = 0;
  double alpha = 0.125;
};

sample::Polyhedron polyhedron_of(const Room& room) {
  sample::Polyhedron p = room.shape == 0   ? sample::l_shaped_room()
                         : room.shape == 1 ? sample::octahedron(-0.5)
                                           : sample::cube_in_cube(room.side, room.place);
  for (auto& v : p.vertices) v = {v.x * room.stretch.x, v.y * room.stretch.y, v.z * room.stretch.z};
  return p;
}

TEST(ClosedRowsAttack, SumToPiWhereSomethingHides) {
  hold(Attack<Room>{
      .name = "estimated rows of closed occluded meshes",
      .usual_instances = 12,
      .make =
          [](Draw& draw) {
            Room room;
            room.shape = draw.below(4);
            const auto stretch = [&draw] {
              return draw.below(2) == 0 ? 1.0
                                        : std::ldexp(1 + draw.unit(), static_cast<int>(draw.below(20)) - 10);
            };
            room.stretch = {stretch(), stretch(), stretch()};
            room.side = 0.125 + 0.5 * draw.unit();
            const auto place = [&] {
              const double rest = 1 - room.side;
              return draw.below(2) == 0 ? rest * draw.unit()
                                        : rest * std::ldexp(1.0, -static_cast<int>(draw.below(30)) - 1);
            };
            room.place = {place(), place(), place()};
            room.degree = draw.below(4) == 0 ? 1 + static_cast<int>(draw.below(2)) : 0;
            const double alphas[] = {0.125, 0.3, 1e-3};
            room.alpha = room.degree == 0 ? 0 : alphas[draw.below(3)];
            return room;
          },
      .judge =
          [](const Room& room) {
            const TriangleMesh mesh = sample::mesh_of(polyhedron_of(room));
            const SmoothComponents components = smooth_components(mesh, mesh_topology(mesh), 30);
            const Surface surface =
                mesh_surface("room", mesh, components.of_piece, piece_names(mesh, components),
                             {.orientation = Orientation::against_the_cross_product, .closed = true});
            const std::string fault = fault_of_rows(surface, 0, room.degree, room.alpha, 1e-13);
            return fault.empty() ? Judgement::held() : Judgement::violated(fault);
          },
      .text =
          [](const Room& room) {
            return "shape " + std::to_string(room.shape) + ", stretched by (" + shortest(room.stretch.x) +
                   ", " + shortest(room.stretch.y) + ", " + shortest(room.stretch.z) +
                   "), inner cube of side " + shortest(room.side) + " at (" + shortest(room.place.x) + ", " +
                   shortest(room.place.y) + ", " + shortest(room.place.z) + "), degree " +
                   std::to_string(room.degree) + ", alpha " + shortest(room.alpha);
          }});
}

}  // namespace
}  // namespace radcert::attack
