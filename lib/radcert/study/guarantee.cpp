// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/guarantee.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/hypotheses/convex_containment.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/collocation/operator_norm.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"

namespace radcert {
namespace {

constexpr const char* closed_polyhedra =
    "a closed convex polyhedron: cube, box, tetrahedron, octahedron, or a mesh";

[[noreturn]] void refuse_surface(const Problem& problem, const std::string& reason) {
  throw InputError({.pointer = problem.surface.mesh ? "/surface/file" : "/surface/name",
                    .value = problem.surface.name,
                    .problem = "has no enclosure of its solution: " + reason,
                    .allowed = closed_polyhedra});
}

std::vector<Panel> panels_of(const Problem& problem, const Surface& surface) {
  if (problem.geometry)
    throw InputError({.pointer = "/geometry",
                      .problem = "is an interpolant, whose solution is not that of the surface",
                      .allowed = "nothing here beside a guarantee"});
  if (!surface.closed) refuse_surface(problem, "it is not closed");
  if (!surface.unoccluded) refuse_surface(problem, "parts of it hide each other");
  Outcome<std::vector<Panel>> panels = convex_panels(surface);
  if (!panels) refuse_surface(problem, panels.reason());
  // That of a mesh has been decided when it was read.
  if (!surface.mesh) {
    const ConvexContainment containment = convex_containment(surface);
    if (containment.verdict != Containment::certified)
      refuse_surface(problem,
                     "it is not proved to lie in the boundary of a convex body: " + containment.reason);
  }
  return std::move(panels).value();
}

/// An expression on the panels, where it is a polynomial of a degree that is allowed.
std::vector<PlanePolynomial<Rational>> polynomials(const PiecewiseExpression& function,
                                                   const std::string& pointer, const Surface& surface,
                                                   const std::vector<Panel>& panels, int largest_degree) {
  const std::vector<std::string> names = surface.piece_names();
  const std::string kind = largest_degree == 0
                               ? "constant"
                               : "a polynomial of degree " + std::to_string(largest_degree) + " or less";
  std::vector<PlanePolynomial<Rational>> out;
  for (const Panel& panel : panels) {
    const Expression& f = function.on(names[panel.piece]);
    const std::vector<Vector<Rational>>& c = panel.corners;
    std::optional<PlanePolynomial<Rational>> polynomial =
        polynomial_on_plane(f, c[0], c[1] - c[0], c[2] - c[0], largest_degree);
    if (!polynomial)
      throw InputError({.pointer = pointer,
                        .value = f.text(),
                        .problem = "is not known to be " + kind + " on piece " + names[panel.piece],
                        .allowed = "with a guarantee: " + kind +
                                   " on each piece, from whole numbers, decimals and fractions by + - * /"});
    out.push_back(std::move(*polynomial));
  }
  return out;
}

/// A bound of |f| on a panel.
/// Maths     sum |c_ij| S^i T^j, S and T the largest parameters of the corners in size
Rational largest_on(const Panel& panel, const PlanePolynomial<Rational>& f) {
  Rational s = 0;
  Rational t = 0;
  for (const Vector<Rational>& corner : panel.corners) {
    const ParameterPoint<Rational> at = plane_coordinates(panel, corner);
    s = std::max(s, abs(at.s));
    t = std::max(t, abs(at.t));
  }
  PlanePolynomial<Rational> sizes(f.degree());
  for (int i = 0; i <= f.degree(); ++i)
    for (int j = 0; i + j <= f.degree(); ++j) sizes(i, j) = abs(f(i, j));
  return sizes.value(s, t);
}

/// Bounds are relative: numbers near the ends of double's range have none.
void require_normal(const Rational& value, const std::string& pointer) {
  if (value.sign() == 0) return;
  const Rational most = power(Rational(10), 60);
  if (abs(value) <= most && abs(value) * most >= Rational(1)) return;
  throw InputError({.pointer = pointer,
                    .value = nearest_text(value.to_double(), DecimalForm::general(6)),
                    .problem = "is too large or too small for a guarantee",
                    .allowed = "0, or a size from 1e-60 to 1e60"});
}

PolyhedronProblem polyhedron_problem(const Problem& problem, const Surface& surface,
                                     const Guarantee& guarantee) {
  if (!problem.emission)
    throw InputError({.pointer = "/solution",
                      .problem = "is given, and then u is known: there is nothing to enclose",
                      .allowed = "emission"});
  PolyhedronProblem out{.panels = panels_of(problem, surface), .reflectivity = {}, .emission = {}};
  for (const PlanePolynomial<Rational>& rho :
       polynomials(problem.reflectivity, "/reflectivity", surface, out.panels, 0))
    out.reflectivity.push_back(rho(0, 0));
  constexpr int largest_degree = 8;
  out.emission = polynomials(*problem.emission, "/emission", surface, out.panels, largest_degree);
  Rational largest = 0;
  Rational sup = 0;
  for (std::size_t j = 0; j < out.panels.size(); ++j) {
    const Rational& rho = out.reflectivity[j];
    if (rho.sign() < 0 || rho >= Rational(1))
      throw InputError({.pointer = "/reflectivity",
                        .value = rho.to_text(),
                        .problem = "is not below 1, or is negative",
                        .allowed = "from 0 to below 1"});
    const Rational emission = largest_on(out.panels[j], out.emission[j]);
    require_normal(rho, "/reflectivity");
    require_normal(emission, "/emission");
    for (const Vector<Rational>& corner : out.panels[j].corners)
      for (const Rational& coordinate : {corner.x, corner.y, corner.z})
        require_normal(coordinate, problem.surface.mesh ? "/surface/file" : "/surface/parameters");
    sup = std::max(sup, rho);
    largest = std::max(largest, emission);
  }
  const Rational least = Rational::exactly(least_relative_width) * largest / (Rational(1) - sup);
  if (guarantee.width < least || guarantee.width.sign() <= 0)
    throw InputError({.pointer = "/guarantee/width",
                      .value = guarantee.width.to_text(),
                      .problem = "is less than double can carry here",
                      .allowed = upper_text(least) + " or more"});
  return out;
}

std::string coordinates_text(const Vector<Rational>& p) {
  return "(" + p.x.to_text() + ", " + p.y.to_text() + ", " + p.z.to_text() + ")";
}

/// The points at which values are asked for, each with its panel.
std::vector<SolutionPoint> solution_points(const Guarantee& guarantee, const std::vector<Panel>& panels) {
  std::vector<SolutionPoint> out;
  if (guarantee.points.empty())
    for (std::size_t k = 0; k < panels.size(); ++k) out.push_back({k, panels[k].centre});
  for (std::size_t k = 0; k < guarantee.points.size(); ++k) {
    const std::size_t panel = panel_inside(panels, guarantee.points[k]);
    if (panel == panels.size())
      throw InputError({.pointer = "/guarantee/points/" + std::to_string(k),
                        .value = coordinates_text(guarantee.points[k]),
                        .problem = "does not lie inside a face of the surface",
                        .allowed = "a point of a face that is on none of its edges, exactly"});
    out.push_back({panel, guarantee.points[k]});
  }
  return out;
}

/// A problem that can be enclosed, as check_guarantee decides it.
struct Asked {
  Surface surface;
  PolyhedronProblem problem;
  std::vector<SolutionPoint> points;
};

Asked asked_of(const Problem& problem, const Guarantee& guarantee) {
  Asked out{.surface = surface_of(problem), .problem = {}, .points = {}};
  out.problem = polyhedron_problem(problem, out.surface, guarantee);
  if (guarantee.of == EnclosedQuantity::values)
    out.points = solution_points(guarantee, out.problem.panels);
  else if (!guarantee.points.empty())
    throw InputError({.pointer = "/guarantee/points",
                      .problem = "are for values, and means are asked for",
                      .allowed = "\"of\": \"values\" beside points"});
  return out;
}

}  // namespace

void check_guarantee(const Problem& problem, const Guarantee& guarantee) {
  static_cast<void>(asked_of(problem, guarantee));
}

std::pair<LevelResult, SolutionEnclosure> solve_within(
    const Problem& problem, const Guarantee& guarantee,
    const std::function<void(const GuaranteeProgress&)>& progress) {
  const Asked asked = asked_of(problem, guarantee);
  const std::vector<std::string> names = asked.surface.piece_names();
  const auto tell = [&](const EnclosureProgress& now) {
    if (progress)
      progress({.layers = now.layers,
                .degree = now.degree,
                .unknowns = now.unknowns,
                .samples = now.samples,
                .width = now.width});
  };
  // A double from below: what is reached is then within what was asked for.
  const double wanted = guarantee.width.to_double() * (1 - unit_roundoff<double>());
  const bool of_values = guarantee.of == EnclosedQuantity::values;
  const GoalEnclosure found = of_values ? enclose_values(asked.problem, asked.points, wanted, tell)
                                        : enclose_means(asked.problem, wanted, tell);
  if (!std::isfinite(found.width))
    throw AccuracyNotReached(of_values ? "the values of u" : "the means of u", found.hindrance);
  SolutionEnclosure enclosure{.wanted = guarantee, .width = found.width, .hindrance = found.hindrance};
  LevelResult level;
  level.level = found.last.layers;
  level.elements = found.last.elements;
  level.unknowns = found.last.unknowns;
  level.mesh_size = found.last.mesh_size;
  level.norm_K = norm_of_K(asked.surface, problem.reflectivity, {}, {});
  for (std::size_t k = 0; k < found.numbers.size(); ++k) {
    if (of_values) {
      const SolutionPoint& point = asked.points[k];
      enclosure.points.push_back(
          {names[asked.problem.panels[point.panel].piece], point.at, found.numbers[k]});
    } else {
      enclosure.pieces.emplace_back(names[k], found.numbers[k]);
      level.piece_means.emplace_back(names[k], found.numbers[k]);
    }
  }
  return {std::move(level), std::move(enclosure)};
}

}  // namespace radcert
