// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/guarantee.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/continuous/mean_enclosure.h"
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

/// The values of an expression on the panels, where it is constant on each.
std::vector<Rational> constants(const PiecewiseExpression& function, const std::string& pointer,
                                const Surface& surface, const std::vector<Panel>& panels) {
  const std::vector<std::string> names = surface.piece_names();
  std::vector<Rational> values;
  for (const Panel& panel : panels) {
    const Expression& f = function.on(names[panel.piece]);
    const Vector<Rational>& origin = panel.corners[0];
    const std::optional<PlanePolynomial<Rational>> constant =
        polynomial_on_plane(f, origin, panel.corners[1] - origin, panel.corners[2] - origin, 0);
    if (!constant)
      throw InputError({.pointer = pointer,
                        .value = f.text(),
                        .problem = "is not known to be constant on piece " + names[panel.piece],
                        .allowed =
                            "with a guarantee: a constant on each piece, from whole numbers, decimals and "
                            "fractions by + - * /"});
    values.push_back((*constant)(0, 0));
  }
  return values;
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

PolyhedronProblem polyhedron_problem(const Problem& problem, const Guarantee& guarantee) {
  if (!problem.emission)
    throw InputError({.pointer = "/solution",
                      .problem = "is given, and then u is known: there is nothing to enclose",
                      .allowed = "emission"});
  const Surface surface = surface_of(problem);
  PolyhedronProblem out{.panels = panels_of(problem, surface), .reflectivity = {}, .emission = {}};
  out.reflectivity = constants(problem.reflectivity, "/reflectivity", surface, out.panels);
  out.emission = constants(*problem.emission, "/emission", surface, out.panels);
  Rational largest = 0;
  Rational sup = 0;
  for (std::size_t j = 0; j < out.panels.size(); ++j) {
    const Rational& rho = out.reflectivity[j];
    if (rho.sign() < 0 || rho >= Rational(1))
      throw InputError({.pointer = "/reflectivity",
                        .value = rho.to_text(),
                        .problem = "is not below 1, or is negative",
                        .allowed = "from 0 to below 1"});
    require_normal(rho, "/reflectivity");
    require_normal(out.emission[j], "/emission");
    for (const Vector<Rational>& corner : out.panels[j].corners)
      for (const Rational& coordinate : {corner.x, corner.y, corner.z})
        require_normal(coordinate, "/surface");
    sup = std::max(sup, rho);
    largest = std::max(largest, abs(out.emission[j]));
  }
  const Rational least = Rational::exactly(least_relative_width) * largest / (Rational(1) - sup);
  if (guarantee.width < least || guarantee.width.sign() <= 0)
    throw InputError({.pointer = "/guarantee/width",
                      .value = guarantee.width.to_text(),
                      .problem = "is less than double can carry here",
                      .allowed = upper_text(least) + " or more"});
  return out;
}

}  // namespace

void check_guarantee(const Problem& problem, const Guarantee& guarantee) {
  static_cast<void>(polyhedron_problem(problem, guarantee));
}

std::pair<LevelResult, SolutionEnclosure> solve_within(
    const Problem& problem, const Guarantee& guarantee,
    const std::function<void(const GuaranteeProgress&)>& progress) {
  const PolyhedronProblem polyhedron = polyhedron_problem(problem, guarantee);
  const Surface surface = surface_of(problem);
  const std::vector<std::string> names = surface.piece_names();
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
  const MeanEnclosure found = enclose_means(polyhedron, wanted, tell);
  if (!std::isfinite(found.width)) throw AccuracyNotReached("the means of u", found.hindrance);
  SolutionEnclosure enclosure{
      .wanted = guarantee, .width = found.width, .pieces = {}, .hindrance = found.hindrance};
  LevelResult level;
  level.level = found.last.layers;
  level.elements = found.last.elements;
  level.unknowns = found.last.unknowns;
  level.mesh_size = found.last.mesh_size;
  level.norm_K = norm_of_K(surface, problem.reflectivity, {}, {});
  for (std::size_t k = 0; k < names.size(); ++k) {
    enclosure.pieces.emplace_back(names[k], found.means[k]);
    level.piece_means.emplace_back(names[k], found.means[k]);
  }
  return {std::move(level), std::move(enclosure)};
}

}  // namespace radcert
